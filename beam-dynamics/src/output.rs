//! Output of results: tables for people and for programs, the comparison with measurements, and the
//! fan plot. Output only reads results; it computes nothing.

mod air;
mod airfoil_plot;
mod airfoil_text;
mod blade_comparison;
mod blade_text;
mod buckling;
mod color_bar;
mod comparison;
mod critical_table;
mod decaying;
mod fan;
mod files;
mod folder;
mod grid;
mod identification;
mod linear;
mod mode_units;
mod performance;
mod periodic;
mod rows;
mod shapes;
mod span_forces;
mod stability;
mod statics;
mod structure;
mod table_changes;
mod table_csv;
mod table_fixed;
mod table_modes;
mod table_text;
mod text;
mod transient;
mod trim;
mod views;

#[cfg(test)]
mod samples;

pub use air::DiskPlot;
pub use airfoil_plot::AirfoilPlot;
pub use airfoil_text::airfoil_text;
pub use blade_comparison::blade_comparison;
pub use blade_text::{blade_text, list};
pub use buckling::{
    BUCKLING_CONVENTION, BucklingPlot, buckling_csv, buckling_text, write_buckling,
};
pub use comparison::{comparison_csv, comparison_text};
pub use critical_table::critical_csv;
pub use decaying::decaying_csv;
pub use fan::FanPlot;
pub use files::{result_text, write};
pub use folder::{ResultLocation, Written};
pub use identification::{identification_csv, identification_text};
pub use linear::{linear_csv, linear_json, linear_text, write_linear};
pub use performance::{
    MapPlot, performance_csv, performance_text, span_load_csv, write_performance,
};
pub use periodic::{
    MultiplierPlot, PERIODIC_CONVENTION, PeriodicFiles, periodic_text, rotor_harmonics_text,
};
pub use shapes::{ShapePlot, write_shapes};
pub use stability::{boundary_csv, stability_csv, stability_text, write_stability};
pub use statics::{
    DeformedPlot, ForcePlot, PathPlot, STATIC_CONVENTION, displacement_csv, force_csv,
    reaction_csv, static_text, sweep_csv, sweep_text, write_static, write_sweep,
};
pub use table_csv::frequency_csv;
pub use table_fixed::{campbell_csv, fixed_text};
pub use table_modes::mode_csv;
pub use table_text::{CONVENTION, convention, frequency_text};
pub use transient::{
    Heading, RunFileProblem, RunFiles, TimePlot, TimeTable, effort_text, not_drawn_text,
    parse_snapshot, read_snapshot, write_snapshot,
};
pub use trim::{trim_csv, trim_failure, trim_json, trim_text, write_trim};
