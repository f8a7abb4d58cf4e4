//! Output of a load path.

mod deformed;
mod fields;
mod files;
mod floors;
mod forces;
mod names;
mod path;
mod sweep;
mod sweep_files;
mod tables;
mod text;

pub use deformed::DeformedPlot;
pub use files::write_static;
pub use forces::ForcePlot;
pub use path::PathPlot;
pub use sweep::{sweep_csv, sweep_text};
pub use sweep_files::write_sweep;
pub use tables::{displacement_csv, electrode_csv, force_csv, reaction_csv, static_air_csv};
pub use text::{STATIC_CONVENTION, static_text};
