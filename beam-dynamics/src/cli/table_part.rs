//! The part of tables of runs that a command takes: columns and times.

use std::path::PathBuf;

use shared_geom::error::Explain;

use super::terminal::Terminal;
use crate::output::{RunFileProblem, TimeTable};

/// Selected columns and times.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct TablePart {
    /// Columns to take, joined by commas, with * at the end all that begin with the text; all
    /// columns if not given
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    columns: Vec<String>,
    /// Time from which on rows are taken; from the first if not given
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    from: Option<f64>,
    /// Time up to which rows are taken; to the last if not given
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    to: Option<f64>,
}

/// A time.
fn seconds(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.trim().trim_end_matches('s').trim_end().parse().ok();
    let value = value.filter(|value| value.is_finite());
    value.ok_or_else(|| "expected a number of seconds".to_owned())
}

/// A span of time that ends before it begins.
#[derive(Debug, thiserror::Error)]
#[error("--from {from} is later than --to {to}: there is no time between them")]
struct Backward {
    from: f64,
    to: f64,
}

impl Explain for Backward {
    fn help(&self) -> Option<String> {
        Some("give --from the earlier of the two".to_owned())
    }
}

impl TablePart {
    /// The names of the columns; none for all of them.
    pub fn columns(&self) -> Vec<String> {
        let names = self.columns.iter();
        names.map(|name| name.trim().to_owned()).collect()
    }

    /// Reads the rows of all tables; reports all problems.
    pub fn read(&self, results: &[PathBuf], terminal: &mut Terminal<'_>) -> Option<Vec<TimeTable>> {
        if let (Some(from), Some(to)) = (self.from, self.to)
            && from > to
        {
            terminal.report(&Backward { from, to });
            return None;
        }
        let tables = results.iter().map(|path| {
            let table: Result<TimeTable, RunFileProblem> = TimeTable::read(path);
            table.map_err(|problem| terminal.report(&problem)).ok()
        });
        let tables: Vec<_> = tables.collect();
        let mut tables: Vec<TimeTable> = tables.into_iter().collect::<Option<_>>()?;
        if self.from.is_some() || self.to.is_some() {
            let from = self.from.unwrap_or(f64::NEG_INFINITY);
            let to = self.to.unwrap_or(f64::INFINITY);
            for table in &mut tables {
                table.between(from, to);
            }
        }
        Some(tables)
    }
}
