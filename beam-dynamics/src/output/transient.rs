//! Output of a run in time, during the run and at its end.

use std::path::Path;

use shared_geom::files::OutputProblem;

mod csv_rows;
mod effort;
mod files;
mod grids;
mod netcdf_rows;
mod netcdf_table;
mod plot;
mod problem;
mod restart;
mod table;

#[cfg(test)]
mod plot_tests;
#[cfg(test)]
mod tests;

pub use effort::effort_text;
pub use files::{RunFiles, not_drawn_text};
pub use plot::TimePlot;
pub use problem::RunFileProblem;
pub use restart::{parse_snapshot, read_snapshot, write_snapshot};
pub use table::TimeTable;

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
    fn time() -> Self {
        Self {
            name: "time".to_owned(),
            unit: "s".to_owned(),
            words: "time".to_owned(),
        }
    }

    fn of(column: &Column) -> Self {
        Self {
            name: column.name.clone(),
            unit: column.unit.clone(),
            words: column.words.clone(),
        }
    }

    /// The unit for people.
    fn shown_unit(&self) -> &str {
        match self.unit.as_str() {
            "1" => "-",
            unit => unit,
        }
    }
}

/// A table that grows by rows.
trait RowWriter: std::fmt::Debug {
    /// Path of the table.
    fn path(&self) -> &Path;

    /// Adds a row: time and the columns.
    fn write(&mut self, row: &[f64]) -> Result<(), RunFileProblem>;
}

fn cannot_write(path: &Path, error: &std::io::Error) -> RunFileProblem {
    RunFileProblem::Output(OutputProblem::File {
        file: path.display().to_string(),
        reason: error.to_string(),
    })
}

fn cannot_read(path: &Path, error: &std::io::Error) -> RunFileProblem {
    RunFileProblem::Unreadable {
        file: path.display().to_string(),
        reason: match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        },
        remedy: "name a file that transient wrote",
    }
}
