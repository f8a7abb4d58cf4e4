//! Tables of results with named columns: a line of names, then a row per line.
//!
//! Commas separate the cells, and quotes enclose a cell with a comma. A name may have a unit in
//! brackets, as `torsion [N m]`. Names are compared in lower case, with underscores for spaces.
//! Empty lines and lines that begin with `#` are left out.

use std::path::Path;

use shared_geom::document::read_text;
use shared_geom::error::{Diagnostics, Explain, SourceLocation, nearest_name, quoted};
use shared_geom::file_kind::FileKind;
use shared_geom::units::{Dimension, parse_any, parse_as};

/// A problem of a table with named columns.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ColumnProblem {
    /// A column that is missing.
    #[error("the table has no column \"{column}\"")]
    NoColumn {
        /// The column.
        column: String,
        /// The columns of the table.
        known: Vec<String>,
        /// The remedy if no name is near.
        remedy: &'static str,
    },
    /// A cell without a number.
    #[error("column \"{column}\": found \"{found}\", expected a number")]
    NoNumber {
        /// The column.
        column: String,
        /// The cell.
        found: String,
    },
    /// A unit that does not fit.
    #[error("column \"{column}\": {reason}")]
    Unit {
        /// The column.
        column: String,
        /// The problem.
        reason: String,
    },
    /// A row that is too short or too long.
    #[error("the row has {found} cells, expected {expected}, one for each column")]
    Cells {
        /// Number of its cells.
        found: usize,
        /// Number of columns.
        expected: usize,
    },
    /// Several columns of one name.
    #[error("{count} columns are called \"{column}\", expected one")]
    Doubled {
        /// The name.
        column: String,
        /// Number of columns.
        count: usize,
    },
    /// A unit in round brackets.
    #[error("column \"{column}\" has its unit in round brackets, expected square brackets")]
    Round {
        /// The column.
        column: String,
        /// Its name.
        name: String,
        /// Its unit.
        unit: String,
    },
    /// Cells that other characters separate.
    #[error("{separator} separate the cells of \"{heading}\", expected commas")]
    Separator {
        /// The characters between them.
        separator: &'static str,
        /// The line of names.
        heading: String,
    },
    /// A table without rows.
    #[error("the table has no rows")]
    Empty,
    /// A file of another kind.
    #[error("this is {found}, expected a table with named columns")]
    Kind {
        /// The kind, with its article.
        found: &'static str,
        /// The remedy.
        remedy: &'static str,
    },
}

impl Explain for ColumnProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoColumn {
                column,
                known,
                remedy,
            } => {
                let near = nearest_name(column, known.iter().map(String::as_str));
                Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("it has {}; {remedy}", quoted(known)),
                })
            }
            Self::Doubled { .. } => Some("remove or rename one of them".to_owned()),
            Self::Cells { .. } => Some(
                "commas separate cells: write decimals with a point, and enclose a cell with a \
                 comma in quotes"
                    .to_owned(),
            ),
            Self::Round { name, unit, .. } => Some(format!("write \"{name} [{unit}]\"")),
            Self::Separator { .. } => {
                Some("write commas between cells, and decimals with a point".to_owned())
            }
            Self::NoNumber { column, found } => {
                let (number, unit) = found.split_once(' ')?;
                let is_unit = parse_any(&format!("1 {}", unit.trim().replace(' ', "*"))).is_ok();
                let name = column.split('[').next().unwrap_or_default().trim();
                (is_unit && number.parse::<f64>().is_ok()).then(|| {
                    format!(
                        "write the unit in the heading, as \"{name} [{}]\", and {number} here",
                        unit.trim()
                    )
                })
            }
            Self::Kind { remedy, .. } => Some((*remedy).to_owned()),
            _ => None,
        }
    }
}

/// A row, with a cell for each column.
#[derive(Debug)]
pub(super) struct Row {
    /// Its line.
    pub line: usize,
    /// Its cells.
    pub cells: Vec<String>,
}

/// The heading of a column.
#[derive(Debug)]
struct Column {
    written: String,
    /// The name as it is compared.
    name: String,
    unit: Option<String>,
}

impl Column {
    fn new(written: &str) -> Self {
        let (name, unit) = match written.split_once('[') {
            Some((name, unit)) => (name, Some(unit.trim_end_matches(']').trim().to_owned())),
            None => (written, None),
        };
        Self {
            written: written.to_owned(),
            name: plain(name),
            unit,
        }
    }

    /// The problem of a unit in round brackets.
    fn round(&self) -> Option<ColumnProblem> {
        let (name, unit) = self.written.strip_suffix(')')?.split_once('(')?;
        let (name, unit) = (name.trim().to_owned(), unit.trim().to_owned());
        let is_unit = unit == "-" || parse_any(&format!("1 {}", unit.replace(' ', "*"))).is_ok();
        is_unit.then(|| ColumnProblem::Round {
            column: self.written.clone(),
            name,
            unit,
        })
    }
}

/// A table with at least one row, and a cell for each column in each row.
#[derive(Debug)]
pub(super) struct ColumnTable {
    file: String,
    columns: Vec<Column>,
    /// The rows.
    pub rows: Vec<Row>,
    remedy: &'static str,
}

impl ColumnTable {
    /// Reads the table at `path`; `remedy` is for columns that are missing.
    ///
    /// # Errors
    /// A file that cannot be read, is of another kind or has no rows, two columns of one name and unit, a row that does
    /// not fit.
    pub fn read(path: &Path, remedy: &'static str) -> Result<Self, Diagnostics> {
        let text = read_text(path)?;
        if let Some(kind) = FileKind::of(path, &text) {
            let found = kind.words();
            let location = SourceLocation::file(path.display().to_string());
            let problem = ColumnProblem::Kind { found, remedy };
            return Err(Diagnostics::one(location, &problem));
        }
        let lines = text.trim_start_matches('\u{feff}').lines().zip(1..);
        let is_row = |(line, _): &(&str, usize)| !line.trim().is_empty() && !line.starts_with('#');
        let mut rows = lines.filter(is_row).map(|(line, number)| Row {
            line: number,
            cells: cells(line),
        });
        let head = rows.next().map_or_else(Vec::new, |head| head.cells);
        let table = Self {
            file: path.display().to_string(),
            columns: head.iter().map(|written| Column::new(written)).collect(),
            rows: rows.collect(),
            remedy,
        };
        if table.rows.is_empty() {
            return Err(table.problem(1, &ColumnProblem::Empty));
        }
        table.check_headings()?;
        for column in &table.columns {
            let same = |other: &&Column| (&other.name, &other.unit) == (&column.name, &column.unit);
            let count = table.columns.iter().filter(same).count();
            if count > 1 {
                let column = column.name.clone();
                return Err(table.problem(1, &ColumnProblem::Doubled { column, count }));
            }
        }
        let expected = table.columns.len();
        match table.rows.iter().find(|row| row.cells.len() != expected) {
            None => Ok(table),
            Some(row) => {
                let found = row.cells.len();
                Err(table.problem(row.line, &ColumnProblem::Cells { found, expected }))
            }
        }
    }

    /// Checks that commas separate the headings, and that no unit is in round brackets.
    fn check_headings(&self) -> Result<(), Diagnostics> {
        if let [only] = &self.columns[..] {
            let separators = [(';', "semicolons"), ('\t', "tabulators")];
            let found = separators.iter().find(|one| only.written.contains(one.0));
            if let Some((_, separator)) = found {
                let heading = only.written.clone();
                return Err(self.problem(1, &ColumnProblem::Separator { separator, heading }));
            }
        }
        match self.columns.iter().find_map(Column::round) {
            Some(problem) => Err(self.problem(1, &problem)),
            None => Ok(()),
        }
    }

    /// A problem of a line.
    pub fn problem<P: Explain>(&self, line: usize, problem: &P) -> Diagnostics {
        Diagnostics::one(SourceLocation::line(&self.file, line), problem)
    }

    /// Names of the columns, as they are compared, and their units.
    pub fn columns(&self) -> impl Iterator<Item = (&str, Option<String>)> {
        self.columns.iter().map(|column| {
            let unit = column.unit.as_ref();
            (
                column.name.as_str(),
                unit.map(|unit| unit.replace(' ', "*")),
            )
        })
    }

    /// The heading of a column, as written.
    pub fn heading(&self, column: usize) -> &str {
        &self.columns[column].written
    }

    /// The headings, as written.
    pub fn headings(&self) -> Vec<String> {
        let written = self.columns.iter().map(|column| column.written.clone());
        written.collect()
    }

    /// The column of a name; with a unit after the name, the column has this unit.
    pub fn index(&self, heading: &str) -> Option<usize> {
        let wanted = Column::new(heading);
        let is_it = |column: &Column| {
            column.name == wanted.name && (wanted.unit.is_none() || column.unit == wanted.unit)
        };
        self.columns.iter().position(is_it)
    }

    /// Number of columns of a name, of any unit.
    pub fn count(&self, name: &str) -> usize {
        let wanted = plain(name);
        let columns = self.columns.iter();
        columns.filter(|column| column.name == wanted).count()
    }

    /// The column of a name, if it is there.
    ///
    /// # Errors
    /// Several columns of this name, with different units, of which the heading selects none.
    pub fn find(&self, heading: &str) -> Result<Option<usize>, Diagnostics> {
        let count = self.count(heading);
        if count > 1 && !heading.contains('[') {
            let column = heading.to_owned();
            return Err(self.problem(1, &ColumnProblem::Doubled { column, count }));
        }
        Ok(self.index(heading))
    }

    /// The columns of names, all of which are needed.
    ///
    /// # Errors
    /// The first column that is missing, or there in several units.
    pub fn require<const N: usize>(&self, headings: [&str; N]) -> Result<[usize; N], Diagnostics> {
        let mut found = [0; N];
        for (found, heading) in found.iter_mut().zip(headings) {
            *found = self.find(heading)?.ok_or_else(|| {
                let has_unit = heading.contains('[');
                let known = self.columns.iter().map(|column| {
                    if has_unit {
                        column.written.clone()
                    } else {
                        column.name.clone()
                    }
                });
                let problem = ColumnProblem::NoColumn {
                    column: heading.to_owned(),
                    known: known.collect(),
                    remedy: self.remedy,
                };
                self.problem(1, &problem)
            })?;
        }
        Ok(found)
    }

    /// SI units in a number of a column; plain numbers are in SI units.
    ///
    /// # Errors
    /// A unit of another dimension.
    pub fn factor(&self, column: usize, dimension: Dimension) -> Result<f64, Diagnostics> {
        // as in "N m"
        let unit = self.columns[column].unit.as_ref();
        let unit = unit.map_or_else(String::new, |unit| unit.replace(' ', "*"));
        if unit.is_empty() || unit == "-" && dimension == Dimension::NUMBER {
            return Ok(1.0);
        }
        if unit == "%" && dimension == Dimension::NUMBER {
            return Ok(0.01);
        }
        let parsed = parse_as(&unit, dimension).map(|unit| unit.factor);
        parsed.map_err(|problem| {
            let problem = ColumnProblem::Unit {
                column: self.columns[column].written.clone(),
                reason: problem.to_string(),
            };
            self.problem(1, &problem)
        })
    }

    /// A finite number of a row.
    ///
    /// # Errors
    /// A cell without one.
    pub fn number(&self, row: &Row, column: usize) -> Result<f64, Diagnostics> {
        self.accepted(row, column, f64::is_finite)
    }

    /// A number of a row that may be infinite.
    ///
    /// # Errors
    /// A cell without one.
    pub fn number_or_infinity(&self, row: &Row, column: usize) -> Result<f64, Diagnostics> {
        self.accepted(row, column, |number| !number.is_nan())
    }

    fn accepted(
        &self,
        row: &Row,
        column: usize,
        is_accepted: impl Fn(f64) -> bool,
    ) -> Result<f64, Diagnostics> {
        let found = &row.cells[column];
        let number = found.parse().ok().filter(|number| is_accepted(*number));
        number.ok_or_else(|| {
            let problem = ColumnProblem::NoNumber {
                column: self.columns[column].written.clone(),
                found: found.clone(),
            };
            self.problem(row.line, &problem)
        })
    }
}

/// A name of a column as it is compared.
pub(super) fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace(' ', "_")
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .buffer_capacity(line.len().max(1))
        .from_reader(line.as_bytes());
    // a line of text is always a record
    let record = reader.records().next().and_then(Result::ok);
    record.map_or_else(Vec::new, |record| {
        record.iter().map(str::to_owned).collect()
    })
}
