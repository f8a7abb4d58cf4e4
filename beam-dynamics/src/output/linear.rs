//! Output of a linear model: one JSON file for programs, one table, and the report.

mod files;
mod json;
mod table;
mod text;

pub use files::write_linear;
pub use json::linear_json;
pub use table::linear_csv;
pub use text::linear_text;
