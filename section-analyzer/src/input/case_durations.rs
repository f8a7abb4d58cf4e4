//! Table of the time that each load case lasts in the life of a blade.

use std::path::Path;

use shared_geom::error::{Diagnostics, Explain, nearest_name, quoted};
use shared_geom::units::Dimension;

use super::column_table::ColumnTable;

/// A problem of the cases.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DurationProblem {
    /// A duration that is negative.
    #[error("column \"{column}\" of case \"{case}\": found {found}, expected 0 or more")]
    Negative {
        /// The column, with its unit.
        column: String,
        /// The case.
        case: String,
        /// The duration as written.
        found: String,
    },
    /// A case in two rows.
    #[error("case \"{case}\" is there twice, expected once")]
    Twice {
        /// The case.
        case: String,
    },
    /// A case without history.
    #[error("case \"{case}\" is not in the table of loads, which has {}", quoted(.known))]
    Unknown {
        /// The case.
        case: String,
        /// The cases of the loads.
        known: Vec<String>,
    },
    /// Cases of the loads without duration.
    #[error("the table has no duration of {}, expected one of each case of the loads", quoted(.cases))]
    Missing {
        /// The cases.
        cases: Vec<String>,
    },
}

impl Explain for DurationProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Negative { .. } => {
                "write the time that the case lasts in the whole life".to_owned()
            }
            Self::Twice { .. } => return None,
            Self::Unknown { case, known } => {
                let near = nearest_name(case, known.iter().map(String::as_str))?;
                format!("did you mean \"{near}\"?")
            }
            Self::Missing { .. } => "a case that does not occur lasts 0".to_owned(),
        };
        Some(text)
    }
}

/// Reads the table at `path`, columns `case` and `duration` (s without unit): the duration of each
/// of `cases`, in their order \[s\].
///
/// # Errors
/// All problems of its cases; a file that cannot be read, a column that is missing, the first cell
/// without a number.
pub fn read_durations(path: &Path, cases: &[String]) -> Result<Vec<f64>, Diagnostics> {
    const REMEDY: &str = "it needs the columns case and duration [h]";
    let table = ColumnTable::read(path, REMEDY)?;
    let [case, duration] = table.require(["case", "duration"])?;
    let factor = table.factor(duration, Dimension::TIME)?;
    let mut found: Vec<Option<f64>> = vec![None; cases.len()];
    let mut problems = Diagnostics::new();
    for row in &table.rows {
        let name = &row.cells[case];
        let seconds = factor * table.number(row, duration)?;
        let at = cases.iter().position(|known| known == name);
        let case = name.clone();
        let problem = match at {
            _ if seconds < 0.0 => DurationProblem::Negative {
                column: table.heading(duration).to_owned(),
                case,
                found: row.cells[duration].clone(),
            },
            None => DurationProblem::Unknown {
                case,
                known: cases.to_vec(),
            },
            Some(at) if found[at].is_some() => DurationProblem::Twice { case },
            Some(at) => {
                found[at] = Some(seconds);
                continue;
            }
        };
        problems.append(table.problem(row.line, &problem));
    }
    let has_row = |name: &String| table.rows.iter().any(|row| row.cells[case] == *name);
    let missing = cases.iter().filter(|name| !has_row(name));
    let missing: Vec<String> = missing.cloned().collect();
    if !missing.is_empty() {
        let problem = DurationProblem::Missing { cases: missing };
        problems.append(table.problem(1, &problem));
    }
    problems.into_result(found.into_iter().flatten().collect())
}
