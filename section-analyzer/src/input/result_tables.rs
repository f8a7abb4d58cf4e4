//! Tables of results that the report of a blade shows: reserve factors, and modes.
//!
//! A table has a line of column names, then a row per line, with commas between the cells and
//! quotes where a cell has a comma.

use std::path::Path;

use serde::Serialize;
use shared_geom::document::read_text;
use shared_geom::error::{Diagnostics, Explain, SourceLocation, nearest_name, quoted};

/// A problem of a table of results.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ResultTableProblem {
    /// A column that is missing.
    #[error("the table has no column \"{column}\"")]
    NoColumn {
        /// The column.
        column: String,
        /// The columns of the table.
        known: Vec<String>,
        /// The table to name instead.
        expected: &'static str,
    },
    /// A cell without a number.
    #[error("column \"{column}\": found \"{found}\", expected a number")]
    NoNumber {
        /// The column.
        column: String,
        /// The cell.
        found: String,
    },
    /// A row that is too short or too long.
    #[error("the row has {found} cells, expected {expected}, one for each column")]
    Cells {
        /// Number of its cells.
        found: usize,
        /// Number of columns.
        expected: usize,
    },
    /// A table without rows.
    #[error("the table has no rows")]
    Empty,
    /// Text that is not a table.
    #[error("the table cannot be read: {reason}")]
    Unreadable {
        /// The reason.
        reason: String,
    },
}

impl Explain for ResultTableProblem {
    fn help(&self) -> Option<String> {
        let Self::NoColumn {
            column,
            known,
            expected,
        } = self
        else {
            return None;
        };
        let near = nearest_name(column, known.iter().map(String::as_str));
        Some(match near {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("it has {}; name {expected}", quoted(known)),
        })
    }
}

/// The smallest reserve factor of a ply of a section over many loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ListedReserve {
    /// The section.
    pub section: String,
    /// The ply: a physical surface of the section.
    pub ply: String,
    /// The smallest reserve factor [-].
    pub reserve_factor: f64,
    /// The failure index there [-].
    pub failure_index: f64,
    /// The criterion.
    pub criterion: String,
    /// The mode of failure.
    pub mode: String,
    /// The instant.
    pub instant: String,
    /// Position (y, z) in the section \[m\].
    pub position: [f64; 2],
    /// Internal force at the instant, in the order of [`shared_geom::wrench::COMPONENTS`]
    /// \[N, N m\].
    pub force: [f64; 6],
}

/// Columns with numbers of [`ListedReserve`].
const RESERVE_NUMBERS: [&str; 10] = [
    "reserve_factor [-]",
    "failure_index [-]",
    "y [m]",
    "z [m]",
    "axial [N]",
    "shear_y [N]",
    "shear_z [N]",
    "torsion [N m]",
    "bending_y [N m]",
    "bending_z [N m]",
];

/// The modes of a blade, as `beam-dynamics modes` lists them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeTable {
    /// The name of the file.
    pub file: String,
    /// The columns, with their units.
    pub columns: Vec<String>,
    /// The rows as written, a cell for each column.
    pub rows: Vec<Vec<String>>,
    /// The name of the mode of each row.
    pub names: Vec<String>,
    /// The rotor speed of each row \[rpm\].
    pub speeds: Vec<f64>,
    /// The frequency of each row, `None` where the mode does not exist \[Hz\].
    pub frequencies: Vec<Option<f64>>,
}

/// Reads the table `NAME.strength.csv` of `section-analyzer strength`.
///
/// # Errors
/// A file that cannot be read, a column that is missing, a row that does not fit, a cell without
/// a number.
pub fn read_reserves(path: &Path) -> Result<Vec<ListedReserve>, Diagnostics> {
    let table = Table::read(
        path,
        "the table NAME.strength.csv of \"section-analyzer strength\"",
    )?;
    let texts = ["section", "ply", "criterion", "mode", "instant"];
    let texts = table.require(texts)?;
    let numbers = table.require(RESERVE_NUMBERS)?;
    let row = |row: &Row| {
        let [section, ply, criterion, mode, instant] =
            texts.map(|column| row.cells[column].clone());
        let mut values = [0.0; 10];
        for (value, column) in values.iter_mut().zip(numbers) {
            *value = table.number(row, column)?;
        }
        let [reserve_factor, failure_index, y, z, force @ ..] = values;
        Ok(ListedReserve {
            section,
            ply,
            reserve_factor,
            failure_index,
            criterion,
            mode,
            instant,
            position: [y, z],
            force,
        })
    };
    table.rows.iter().map(row).collect()
}

/// Reads the table `NAME.modes.csv` or `NAME.frequencies.csv` of `beam-dynamics modes`.
///
/// # Errors
/// As [`read_reserves`].
pub fn read_modes(path: &Path) -> Result<ModeTable, Diagnostics> {
    let table = Table::read(path, "the table NAME.modes.csv of \"beam-dynamics modes\"")?;
    let [speed, name, frequency] =
        table.require(["rotor speed [rpm]", "name", "frequency [Hz]"])?;
    let mut modes = ModeTable {
        file: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        columns: table.columns.clone(),
        rows: Vec::new(),
        names: Vec::new(),
        speeds: Vec::new(),
        frequencies: Vec::new(),
    };
    for row in &table.rows {
        modes.speeds.push(table.number(row, speed)?);
        modes
            .frequencies
            .push(match row.cells[frequency].is_empty() {
                true => None,
                false => Some(table.number(row, frequency)?),
            });
        modes.names.push(row.cells[name].clone());
        modes.rows.push(row.cells.clone());
    }
    Ok(modes)
}

#[derive(Debug)]
struct Row {
    line: usize,
    cells: Vec<String>,
}

/// A table with at least one row, and a cell for each column in each row.
#[derive(Debug)]
struct Table {
    file: String,
    columns: Vec<String>,
    rows: Vec<Row>,
    expected: &'static str,
}

impl Table {
    fn read(path: &Path, expected: &'static str) -> Result<Self, Diagnostics> {
        let text = read_text(path)?;
        let file = path.display().to_string();
        let problem = |line: usize, problem: ResultTableProblem| {
            Diagnostics::one(SourceLocation::line(&file, line), &problem)
        };
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .has_headers(false)
            .trim(csv::Trim::All)
            .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| {
                let reason = error.to_string();
                problem(1, ResultTableProblem::Unreadable { reason })
            })?;
            rows.push(Row {
                line: record.position().map_or(1, |at| at.line() as usize),
                cells: record.iter().map(str::to_owned).collect(),
            });
        }
        if rows.len() < 2 {
            return Err(problem(1, ResultTableProblem::Empty));
        }
        let columns = rows.remove(0).cells;
        if let Some(row) = rows.iter().find(|row| row.cells.len() != columns.len()) {
            let (found, expected) = (row.cells.len(), columns.len());
            return Err(problem(
                row.line,
                ResultTableProblem::Cells { found, expected },
            ));
        }
        Ok(Self {
            file,
            columns,
            rows,
            expected,
        })
    }

    fn problem(&self, line: usize, problem: &ResultTableProblem) -> Diagnostics {
        Diagnostics::one(SourceLocation::line(&self.file, line), problem)
    }

    /// The indices of columns.
    fn require<const N: usize>(&self, names: [&str; N]) -> Result<[usize; N], Diagnostics> {
        let mut found = [0; N];
        for (found, name) in found.iter_mut().zip(names) {
            let index = self.columns.iter().position(|known| known == name);
            *found = index.ok_or_else(|| {
                let problem = ResultTableProblem::NoColumn {
                    column: name.to_owned(),
                    known: self.columns.clone(),
                    expected: self.expected,
                };
                self.problem(1, &problem)
            })?;
        }
        Ok(found)
    }

    /// A number of a row; it may be infinite.
    fn number(&self, row: &Row, column: usize) -> Result<f64, Diagnostics> {
        let found = &row.cells[column];
        let number = found.parse::<f64>().ok().filter(|number| !number.is_nan());
        number.ok_or_else(|| {
            let problem = ResultTableProblem::NoNumber {
                column: self.columns[column].clone(),
                found: found.clone(),
            };
            self.problem(row.line, &problem)
        })
    }
}
