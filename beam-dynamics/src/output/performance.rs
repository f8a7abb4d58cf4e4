//! Output of the performance of rotors.

mod columns;
mod curves;
mod files;
mod loads;
mod map;
mod tables;
mod text;

pub use files::write_performance;
pub use map::MapPlot;
pub use tables::{performance_csv, span_load_csv};
pub use text::performance_text;
