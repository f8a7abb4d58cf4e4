//! Reports, property files and figures. Output reads; it never computes what a
//! user could call a result.

mod areas;
mod comparison;
mod distributed;
mod electric_plots;
mod electric_states;
mod end_effects;
mod engineering;
mod fiber_plot;
mod field_plot;
mod figure_parts;
mod files;
mod imposed;
mod mesh_plot;
mod outline;
mod outside;
mod parts;
mod piezo;
mod plane;
mod prestress;
mod properties;
mod property_report;
mod quality;
mod record;
mod report;
mod restrained;
mod results;
mod sensitivity;
mod strengths;
mod stress_plots;
mod stress_report;
mod stress_tables;
mod text;
mod undeformed;
mod vtu;
mod warping_plot;

#[cfg(test)]
mod samples;

pub use areas::areas_csv;
pub use comparison::{Named, comparison};
pub use distributed::distributed_load;
pub use electric_plots::{ElectricPlot, electric_plots};
pub use end_effects::end_effects;
pub use engineering::{EngineeringValue, engineering_values, engineering_values_of};
pub use fiber_plot::FiberPlot;
pub use field_plot::FieldPlot;
pub use files::OutputFiles;
pub use imposed::imposed_report;
pub use mesh_plot::MeshPlot;
pub use outside::{outside_properties, outside_warping_csv};
pub use piezo::{electrodes_csv, piezo_report};
pub use prestress::prestress_report;
pub use properties::{add_prestress, properties};
pub use property_report::{property_axes, property_centers, property_report};
pub use record::AnalysisRecord;
pub use report::{checks, failure_report, input_report, report};
pub use restrained::constants_csv;
pub use results::ResultWriter;
pub use sensitivity::{sensitivity_json, sensitivity_table};
pub use stress_plots::{failure_indices_of_cells, stress_plots};
pub use stress_report::stress_report;
pub use stress_tables::{stress_cells_csv, stress_nodes_csv, stress_points_csv};
pub use vtu::{outside_warping_vtu, stress_vtu, warping_vtu};
pub use warping_plot::WarpingPlot;
