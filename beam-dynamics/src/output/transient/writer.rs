//! Tables that grow by rows: headings of their columns, their interface, their problems.

use std::path::Path;

use shared_geom::files::OutputProblem;

use super::problem::RunFileProblem;
use crate::case::Column;

/// The heading of a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// Name.
    pub name: String,
    /// Unit; `1` for pure numbers.
    pub unit: String,
    /// Its meaning, as text.
    pub words: String,
}

impl Heading {
    /// Heading of the first column.
    pub(super) fn time() -> Self {
        Self {
            name: "time".to_owned(),
            unit: "s".to_owned(),
            words: "time".to_owned(),
        }
    }

    pub(super) fn of(column: &Column) -> Self {
        Self {
            name: column.name.clone(),
            unit: column.unit.clone(),
            words: column.words.clone(),
        }
    }

    /// The unit for people.
    pub(super) fn shown_unit(&self) -> &str {
        match self.unit.as_str() {
            "1" => "-",
            unit => unit,
        }
    }
}

/// A table that grows by rows.
pub(super) trait RowWriter: std::fmt::Debug {
    /// Path of the table.
    fn path(&self) -> &Path;

    /// Adds a row: time and the columns.
    fn write(&mut self, row: &[f64]) -> Result<(), RunFileProblem>;
}

pub(super) fn cannot_write(path: &Path, error: &std::io::Error) -> RunFileProblem {
    RunFileProblem::Output(OutputProblem::File {
        file: path.display().to_string(),
        reason: error.to_string(),
    })
}

pub(super) fn cannot_read(path: &Path, error: &std::io::Error) -> RunFileProblem {
    RunFileProblem::Unreadable {
        file: path.display().to_string(),
        reason: match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        },
        remedy: "name a file that transient wrote",
    }
}
