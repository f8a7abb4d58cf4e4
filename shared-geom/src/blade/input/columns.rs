//! Tables of numbers in files: comma-separated, with a line of column names.

use std::cell::RefCell;

use super::Sources;
use super::keys::{COLUMN_NAME, COLUMN_UNIT, COLUMN_VALUE, COLUMNS, FACTOR, FILE};
use super::problem::InputProblem;
use crate::document::Table;
use crate::error::{Diagnostics, SourceLocation};
use crate::units::{self, Dimension};

/// Number of wrong cells that are reported one by one.
const CELLS_SHOWN: usize = 5;

/// Quantity of a column, and SI units in one of its plain numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measure {
    pub dimension: Dimension,
    pub factor: f64,
}

/// A row of a table.
#[derive(Debug, Clone)]
struct Row {
    line: usize,
    cells: Vec<String>,
}

/// A table of a file, and the names of its columns.
#[derive(Debug)]
pub(super) struct Columns<'a> {
    file: String,
    names: Vec<String>,
    names_line: usize,
    rows: Vec<Row>,
    /// The table that names the file.
    owner: &'a Table<'a>,
    /// Its table `columns`.
    map: Option<Table<'a>>,
    used: RefCell<Vec<usize>>,
}

impl<'a> Columns<'a> {
    /// Reads the file that `owner` names under `file`, with its names for `keys` in
    /// `columns`.
    pub fn read(owner: &'a Table<'a>, keys: &[String], sources: &Sources) -> Option<Self> {
        let map = owner.table(&COLUMNS);
        if let Some(map) = &map {
            // All of them are known keys, even if others are wrong.
            for key in keys {
                map.has(key);
            }
        }
        let document = owner.document();
        let written = owner.get(&FILE)?;
        let path = owner.existing(&FILE, &written)?;
        let text = document.keep(sources.read(&path))?;
        let file = path.display().to_string();
        let (names_line, names, rows) = document.keep(rows(&text, &file))?;
        Some(Self {
            file,
            names,
            names_line,
            rows,
            owner,
            map,
            used: RefCell::default(),
        })
    }

    /// Location of each row.
    pub fn locations(&self) -> Vec<SourceLocation> {
        let location = |row: &Row| SourceLocation::line(&self.file, row.line);
        self.rows.iter().map(location).collect()
    }

    /// Whether there is a column for `key`.
    pub fn has(&self, key: &str) -> bool {
        self.map.as_ref().is_some_and(|map| map.has(key)) || self.index(key).is_some()
    }

    /// The numbers for `key` in SI units.
    pub fn numbers(&self, key: &str, measure: Measure) -> Option<Vec<f64>> {
        let mapped = self.map.as_ref().filter(|map| map.has(key));
        match mapped {
            Some(map) if map.is_table(key) => self.described(key, &map.table(key)?, measure),
            Some(map) => self.column(&map.text(key)?, key, measure.factor),
            None => self.column(key, key, measure.factor),
        }
    }

    /// A value for all rows, or a column with a unit and a factor, as the table
    /// specifies.
    fn described(&self, key: &str, table: &Table<'_>, measure: Measure) -> Option<Vec<f64>> {
        if table.has(&COLUMN_VALUE) {
            let value = table.quantity(COLUMN_VALUE.name(), measure.dimension);
            table.finish();
            return Some(vec![value?; self.rows.len()]);
        }
        let name = table.get(&COLUMN_NAME);
        let unit = match table.get(&COLUMN_UNIT) {
            Some(Some(text)) => unit(table, &text, measure.dimension),
            Some(None) => Some(measure.factor),
            None => None,
        };
        let factor = table.get(&FACTOR);
        table.finish();
        self.column(&name?, key, unit? * factor?)
    }

    /// The numbers of the column `name`, times `factor`.
    fn column(&self, name: &str, key: &str, factor: f64) -> Option<Vec<f64>> {
        let Some(index) = self.index(name) else {
            let purpose = if name == key {
                ", and \"columns\" names no other".to_owned()
            } else {
                format!(" (for \"{key}\")")
            };
            let problem = InputProblem::NoColumn {
                file: self.file.clone(),
                column: name.to_owned(),
                purpose,
                known: self.names.clone(),
            };
            match self.map.as_ref().filter(|map| map.has(key)) {
                Some(map) => map.note(key, &problem),
                None => self.owner.note(&FILE, &problem),
            }
            return None;
        };
        self.used.borrow_mut().push(index);
        let numbers = self.parsed(index);
        let numbers = self.owner.document().keep(numbers)?;
        Some(numbers.into_iter().map(|number| number * factor).collect())
    }

    fn parsed(&self, index: usize) -> Result<Vec<f64>, Diagnostics> {
        let mut problems = Diagnostics::new();
        let column = &self.names[index];
        let mut bad = 0;
        let mut number = |row: &Row| {
            let found = &row.cells[index];
            let number = found.parse().ok().filter(|number: &f64| number.is_finite());
            if number.is_none() {
                bad += 1;
                if bad <= CELLS_SHOWN {
                    let (column, found) = (column.clone(), found.clone());
                    let location = SourceLocation::line(&self.file, row.line);
                    problems.push(location, &InputProblem::Cell { column, found });
                }
            }
            number.unwrap_or_default()
        };
        let numbers = self.rows.iter().map(&mut number).collect();
        if bad > CELLS_SHOWN {
            let (column, count) = (column.clone(), bad - CELLS_SHOWN);
            let location = SourceLocation::line(&self.file, self.names_line);
            problems.push(location, &InputProblem::MoreCells { column, count });
        }
        problems.into_result(numbers)
    }

    fn index(&self, name: &str) -> Option<usize> {
        let exact = self.names.iter().position(|known| known == name);
        let alike = |known: &String| known.eq_ignore_ascii_case(name);
        exact.or_else(|| self.names.iter().position(alike))
    }

    /// Notes unknown keys of `columns`; remarks the unused columns.
    pub fn finish(&self, sources: &Sources) {
        if let Some(map) = &self.map {
            map.finish();
        }
        let used = self.used.borrow();
        let columns = self.names.iter().enumerate();
        let unused: Vec<_> = columns
            .filter(|(index, _)| !used.contains(index))
            .map(|(_, name)| name.as_str())
            .collect();
        if !unused.is_empty() {
            let columns = unused.join(", ");
            sources.remark(format!("{}: unused columns: {columns}", self.file));
        }
    }
}

/// SI units in one unit, the `text` in a table.
fn unit(table: &Table<'_>, text: &str, dimension: Dimension) -> Option<f64> {
    match units::parse_as(text, dimension) {
        Ok(unit) => Some(unit.factor),
        Err(problem) => {
            if is_weight(text, dimension) {
                let unit = text.to_owned();
                table.note(&COLUMN_UNIT, &InputProblem::Weight { unit });
            } else {
                let key = COLUMN_UNIT.name().to_owned();
                table.note(
                    &COLUMN_UNIT,
                    &crate::document::DocumentProblem::Unit { key, problem },
                );
            }
            None
        }
    }
}

/// Whether a unit measures the weight of the mass that is expected.
fn is_weight(text: &str, mass: Dimension) -> bool {
    let weight = Dimension {
        length: mass.length.saturating_add(1),
        time: mass.time.saturating_sub(2),
        ..mass
    };
    units::parse(text).is_ok_and(|unit| mass.mass == 1 && unit.dimension == weight)
}

/// Line of the names, names, and rows of the text of a table.
fn rows(text: &str, file: &str) -> Result<(usize, Vec<String>, Vec<Row>), Diagnostics> {
    let mut problems = Diagnostics::new();
    let mut rows = Vec::new();
    let lines = text.lines().enumerate();
    let written = |line: &str| !(line.is_empty() || line.starts_with('#'));
    for (i, text) in lines.filter(|(_, line)| written(line.trim_start())) {
        match cells(text) {
            Ok(cells) => rows.push(Row { line: i + 1, cells }),
            Err(reason) => {
                problems.push(
                    SourceLocation::line(file, i + 1),
                    &InputProblem::Row { reason },
                );
            }
        }
    }
    let found = match rows.first() {
        None => Some("no line"),
        Some(first) if first.cells.iter().any(|cell| cell.parse::<f64>().is_ok()) => {
            Some("numbers in its first line")
        }
        Some(_) if rows.len() == 1 => Some("no row of numbers"),
        Some(_) => None,
    };
    if let Some(found) = found {
        let line = rows.first().map_or(1, |row| row.line);
        problems.push(
            SourceLocation::line(file, line),
            &InputProblem::NoRows { found },
        );
        return Err(problems);
    }
    let names = rows.remove(0);
    let expected = names.cells.len();
    for row in rows.iter().filter(|row| row.cells.len() != expected) {
        let found = row.cells.len();
        let problem = InputProblem::Columns { found, expected };
        problems.push(SourceLocation::line(file, row.line), &problem);
    }
    problems.into_result((names.line, names.cells, rows))
}

/// The cells of one line: read alone, so that its number is known.
fn cells(line: &str) -> Result<Vec<String>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    let record = reader.records().next();
    match record {
        Some(Ok(record)) => Ok(record.iter().map(str::to_owned).collect()),
        Some(Err(error)) => Err(error.to_string()),
        None => Ok(Vec::new()),
    }
}
