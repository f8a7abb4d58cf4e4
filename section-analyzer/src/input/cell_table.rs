//! Tables of angles or of rises of temperature, one row for each cell.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use shared_geom::error::{Diagnostics, SourceLocation};

use super::problem::InputProblem;

/// Problems of the rows of one table that are shown one by one.
const ROWS_SHOWN: usize = 10;

/// Content of the second column of a table.
#[derive(Debug, PartialEq)]
pub(super) struct Column {
    /// Its heading.
    pub heading: &'static str,
    /// Description of one value.
    pub value: &'static str,
    /// Largest value, in any unit.
    pub largest: f64,
}

/// Angles: for a much larger angle the remainder after whole revolutions has no accurate
/// digit.
pub(super) const ANGLE: Column = Column {
    heading: "angle",
    value: "an angle",
    largest: 360_000.0,
};

/// Temperature rises: far above all temperatures of solids.
pub(super) const RISE: Column = Column {
    heading: "rise",
    value: "a rise of temperature",
    largest: LARGEST_RISE,
};

/// Largest temperature rise, in any unit: far above all temperatures of solids.
pub(super) const LARGEST_RISE: f64 = 100_000.0;

/// A table of values by cell tag.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CellTable {
    /// Value of each cell, in the unit of the file \[SI unit per unit of the caller\].
    values: BTreeMap<u64, f64>,
}

/// Mismatch between the rows of a table and the cells that use it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Misfit {
    pub missing: Vec<u64>,
    pub unknown: Vec<u64>,
}

impl CellTable {
    /// Reads `text`, the content of the file at `path`: the heading `cell,` and the
    /// column's heading, then one row per cell. Empty lines and lines that begin with `#`
    /// are ignored; spaces and double quotes around a field are allowed.
    pub fn parse(text: &str, path: &Path, column: &'static Column) -> Result<Self, Diagnostics> {
        let mut problems = RowProblems::new(path.display().to_string(), column);
        let lines = text.trim_start_matches('\u{feff}').lines();
        let mut rows = lines
            .zip(1..)
            .filter(|(row, _)| !row.trim().is_empty() && !row.starts_with('#'));
        problems.heading(rows.next());

        let mut line_of = BTreeMap::new();
        let mut values = BTreeMap::new();
        for (row, line) in rows {
            match cell_and_value(row, column) {
                Err(problem) => problems.push(line, &problem),
                Ok((cell, value)) => {
                    let first = *line_of.entry(cell).or_insert(line);
                    if first != line {
                        let (value, line_of_first) = (column.value, first);
                        let problem = InputProblem::TableRepeats {
                            cell,
                            value,
                            line: line_of_first,
                        };
                        problems.push(line, &problem);
                    }
                    values.insert(cell, value);
                }
            }
        }
        problems.finish().into_result(Self { values })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// The value of a cell, in the unit of the file.
    pub fn value(&self, cell: u64) -> Option<f64> {
        self.values.get(&cell).copied()
    }

    /// Compares the rows with the cells that take their value from the table;
    /// `None` if each has exactly one row. Rows of `others` are allowed.
    pub fn misfit(&self, cells: &BTreeSet<u64>, others: &[u64]) -> Option<Misfit> {
        let has = |cell: &&u64| self.values.contains_key(*cell);
        let missing: Vec<_> = cells.iter().filter(|cell| !has(cell)).copied().collect();
        let unknown: Vec<_> = self
            .values
            .keys()
            .filter(|cell| !cells.contains(cell) && !others.contains(cell))
            .copied()
            .collect();
        let fits = missing.is_empty() && unknown.is_empty();
        (!fits).then_some(Misfit { missing, unknown })
    }
}

/// The problems of the rows, the first ones in full.
struct RowProblems {
    file: String,
    column: &'static Column,
    found: Diagnostics,
    count: usize,
}

impl RowProblems {
    fn new(file: String, column: &'static Column) -> Self {
        let found = Diagnostics::new();
        Self {
            file,
            column,
            found,
            count: 0,
        }
    }

    fn push(&mut self, line: usize, problem: &InputProblem) {
        self.count += 1;
        if self.count <= ROWS_SHOWN {
            self.found
                .push(SourceLocation::line(&self.file, line), problem);
        }
    }

    /// Checks the first row; a missing one is reported on line 1.
    fn heading(&mut self, row: Option<(&str, usize)>) {
        let (found, line) = match row {
            Some((row, _)) if fields(row) == ["cell", self.column.heading] => return,
            Some((row, line)) => (format!("\"{}\"", row.trim()), line),
            None => ("missing".to_owned(), 1),
        };
        let column = self.column.heading;
        self.push(line, &InputProblem::TableHeading { found, column });
    }

    fn finish(mut self) -> Diagnostics {
        if self.count > ROWS_SHOWN {
            let count = self.count - ROWS_SHOWN;
            self.found.push(
                SourceLocation::file(&self.file),
                &InputProblem::TableMore { count },
            );
        }
        self.found
    }
}

fn fields(row: &str) -> Vec<&str> {
    let fields = row.split(',').map(str::trim);
    fields.map(|field| field.trim_matches('"')).collect()
}

fn cell_and_value(row: &str, column: &Column) -> Result<(u64, f64), InputProblem> {
    let wrong = |expected: String| InputProblem::TableRow {
        found: row.trim().to_owned(),
        expected,
    };
    let Column { heading, value, .. } = column;
    let [cell, number] = fields(row)[..] else {
        let expected = format!("two columns, the number of a cell and its {heading}");
        return Err(wrong(expected));
    };
    let cell = cell
        .parse()
        .map_err(|_| wrong("the number of a cell in the first column".to_owned()))?;
    let number: f64 = number
        .parse()
        .map_err(|_| wrong(format!("{value} in the second column")))?;
    if number.abs() <= column.largest {
        Ok((cell, number))
    } else {
        let largest = column.largest;
        let expected = format!("{value} of at most {largest} in the second column");
        Err(wrong(expected))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<CellTable, Diagnostics> {
        CellTable::parse(text, Path::new("a.csv"), &ANGLE)
    }

    #[test]
    fn rows_comments_and_spaces_are_read() {
        let table = parse("# by hand\ncell, angle\n7, 30\n\n8,-1.5e1\n").unwrap();
        assert_eq!(
            (table.len(), table.value(7), table.value(8)),
            (2, Some(30.0), Some(-15.0))
        );
        assert_eq!(table.value(9), None);
    }

    #[test]
    fn every_wrong_row_is_reported_with_its_line() {
        let shown = parse("cell,angle\n1,2\n\nx,2\n3\n1,4\n4,nan\n5,2 deg\n").unwrap_err();
        assert_eq!(
            shown.to_string(),
            "error: a.csv:4: row \"x,2\" cannot be read, expected the number of a cell in the first column\n\
             error: a.csv:5: row \"3\" cannot be read, expected two columns, the number of a cell and its angle\n\
             error: a.csv:6: cell 1 has an angle on line 2 already, expected one row for each cell\n\
             error: a.csv:7: row \"4,nan\" cannot be read, expected an angle of at most 360000 in the second column\n\
             error: a.csv:8: row \"5,2 deg\" cannot be read, expected an angle in the second column"
        );
    }

    #[test]
    fn heading_is_required_and_long_lists_are_cut() {
        let shown = parse("1,2\n").unwrap_err().to_string();
        assert_eq!(
            shown,
            "error: a.csv:1: the columns are \"1,2\", expected \"cell,angle\""
        );
        let shown = parse("").unwrap_err().to_string();
        assert_eq!(
            shown,
            "error: a.csv:1: the columns are missing, expected \"cell,angle\""
        );
        let many = format!("cell,angle\n{}", "x,1\n".repeat(25));
        let shown = parse(&many).unwrap_err().to_string();
        assert_eq!(shown.lines().count(), 11);
        assert!(shown.ends_with("a.csv: 15 more rows with problems of this kind follow"));
    }

    #[test]
    fn misfit_names_missing_and_unknown_cells() {
        let table = parse("cell,angle\n1,2\n9,2\n").unwrap();
        let expected = Misfit {
            missing: vec![2, 3],
            unknown: vec![9],
        };
        assert_eq!(
            table.misfit(&BTreeSet::from([1, 2, 3]), &[]),
            Some(expected)
        );
        assert_eq!(table.misfit(&BTreeSet::from([1]), &[7, 9]), None);
    }
}
