//! First lines of every export: program and version, input, frame, order, reference
//! point.

use crate::blade::Blade;

use super::frame::Convention;

/// The statement of an export.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header {
    lines: Vec<String>,
}

impl Header {
    /// Header of `blade` written in the axes of `convention`, about `point`, a text.
    pub fn new(blade: &Blade, convention: Convention, point: &str) -> Self {
        let hash = &blade.provenance.input_hash;
        let input = if hash.is_empty() {
            "written by hand"
        } else {
            hash
        };
        Self {
            lines: vec![
                format!("written by Helicoid {}", env!("CARGO_PKG_VERSION")),
                format!("input: {input}"),
                format!("frame: {}", convention.axes_in_words()),
                format!("order: {}", convention.order().join(", ")),
                format!("reference point: {point}"),
            ],
        }
    }

    /// The statements as lines that begin with `mark`.
    pub fn lines(&self, mark: &str) -> String {
        let line = |text: &String| format!("{mark}{text}\n");
        self.lines.iter().map(line).collect()
    }

    /// The statements on one line.
    pub fn one_line(&self) -> String {
        self.lines.join("; ")
    }
}
