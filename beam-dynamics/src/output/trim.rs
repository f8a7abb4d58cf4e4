//! Output of a trim: controls and targets, over the sweep.

mod files;
mod json;
mod table;
mod text;

pub use files::write_trim;
pub use json::trim_json;
pub use table::trim_csv;
pub use text::{trim_failure, trim_text};
