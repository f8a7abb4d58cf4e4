//! Output of stability over a parameter: boundaries, roots, and their figure.

mod files;
mod looks;
mod plot;
mod table;
mod text;

pub use files::write_stability;
pub use table::{boundary_csv, stability_csv};
pub use text::stability_text;
