//! Reports, property files and figures. Output reads; it never computes what a
//! user could call a result.

mod engineering;
mod field_plot;
mod files;
mod measures;
mod mesh_plot;
mod outline;
mod plane;
mod properties;
mod report;
mod stress_plots;
mod text;
mod vtu;
mod warping_plot;

#[cfg(test)]
mod samples;

pub use engineering::{EngineeringValue, engineering_values};
pub use field_plot::FieldPlot;
pub use files::OutputFiles;
pub use mesh_plot::MeshPlot;
pub use properties::properties;
pub use report::{failure_report, input_report, report};
pub use stress_plots::stress_plots;
pub use vtu::{FieldFile, stress_vtu, warping_vtu};
pub use warping_plot::WarpingPlot;
