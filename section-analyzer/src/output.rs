//! Reports, property files and figures. Output reads; it never computes what a
//! user could call a result.

mod engineering;
mod fiber_plot;
mod files;
mod mesh_plot;
mod outline;
mod plane;
mod properties;
mod quality;
mod report;
mod text;
mod warping_plot;

pub use engineering::{EngineeringValue, engineering_values};
pub use fiber_plot::FiberPlot;
pub use files::OutputFiles;
pub use mesh_plot::MeshPlot;
pub use properties::properties;
pub use report::{failure_report, input_report, report};
pub use warping_plot::WarpingPlot;
