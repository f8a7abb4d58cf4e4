//! Output of critical loads.

mod fields;
mod files;
mod plot;
mod text;

pub use files::write_buckling;
pub use plot::BucklingPlot;
pub use text::{BUCKLING_CONVENTION, buckling_csv, buckling_text};
