//! Output of periodic motion: a period of the columns, their harmonics, and the multipliers.

mod files;
mod harmonics;
mod plot;
mod tables;
mod text;

pub use files::PeriodicFiles;
pub use harmonics::rotor_harmonics_text;
pub use plot::MultiplierPlot;
pub use text::{PERIODIC_CONVENTION, periodic_text};
