//! Drives from tables: rows in the card, or columns of a CSV file.

use std::sync::Arc;

use shared_geom::document::{DocumentProblem, Key, Table, read_text};
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::units::Dimension;

use super::DriveProblem;
use super::keys::{COLUMNS, FILE, INTERPOLATION, OUTSIDE, ROWS};
use super::measure::Measure;
use crate::input::csv_rows;
use crate::model::{Drive, DriveTable, Extrapolation, Interpolation, TableProblem};

/// A row of a table, and its line.
pub(in crate::input) type Row = (usize, [f64; 2]);

/// Reads a table of times and values.
pub(super) fn read(table: &Table<'_>, measure: Measure) -> Option<Drive> {
    let (interpolation, extrapolation) = (table.get(&INTERPOLATION), table.get(&OUTSIDE));
    let second = table.document().factor(Dimension::TIME);
    let factor = measure.factor(table.document());
    let (file, rows) = match (table.has(&FILE), table.has(&ROWS)) {
        (true, false) => {
            let file = (FILE.name(), table.get(&FILE)??);
            let (file, rows) = from_file(table, file, &COLUMNS, ["times", "values"])?;
            (Some(file), rows)
        }
        (false, true) => {
            let expected = "rows of a time and a value, as in [[0, 1], [2, 3]]";
            (None, table.item(&ROWS)?.pairs(expected)?)
        }
        (both, _) => {
            let _ = table.has(&COLUMNS);
            let found = if both { "both" } else { "none" };
            let keys = [FILE.name(), ROWS.name()];
            let drive = table.title().to_owned();
            table.note("", &DriveProblem::OneOf { drive, keys, found });
            return None;
        }
    };
    let scaled = |row: &Row| [row.1[0] * second, row.1[1] * factor];
    let numbers: Vec<_> = rows.iter().map(scaled).collect();
    let interpolation = [Interpolation::Linear, Interpolation::Spline][interpolation?];
    let extrapolation = [Extrapolation::Error, Extrapolation::Hold][extrapolation?];
    let reported = |line: usize, problem: DriveProblem| match &file {
        Some(file) => drop(table.document().keep::<()>(Err(Diagnostics::one(
            SourceLocation::line(file, line),
            &problem,
        )))),
        None => table.document().note(line, &problem),
    };
    match DriveTable::new(&numbers, interpolation, extrapolation) {
        Ok(found) => return Some(Drive::Table(Arc::new(found))),
        Err(TableProblem::Few { found }) => {
            let line = rows.first().map_or(1, |row| row.0);
            reported(line, DriveProblem::FewRows { found });
        }
        Err(TableProblem::NotRising { row } | TableProblem::NotFinite { row }) => {
            let before = rows[row.saturating_sub(1)].1[0];
            let time = rows[row].1[0];
            reported(rows[row].0, DriveProblem::NotRising { time, before });
        }
    }
    None
}

/// The name of the file `written` under a key of the table, and the rows of two of its columns,
/// described by `of`: the columns under `columns`, or the first two.
pub(in crate::input) fn from_file(
    table: &Table<'_>,
    (key, written): (&str, String),
    columns: &Key<Option<Vec<String>>>,
    of: [&str; 2],
) -> Option<(String, Vec<Row>)> {
    let expected = format!(
        "two names: of the column of {} and of the column of {}",
        of[0], of[1]
    );
    let are_two = |names: &Option<Vec<String>>| names.as_ref().is_none_or(|names| names.len() == 2);
    let columns = table.get_if(columns, are_two, &expected)?;
    let path = table.existing(key, &written)?;
    let file = path.display().to_string();
    let text = table.document().keep(read_text(&path))?;
    let rows = rows(&text, &file, columns.as_deref(), of);
    Some((file, table.document().keep(rows)?))
}

/// Indices of the two columns in the heading, on line `first` of `file`.
fn column_indices(
    heading: &[String],
    columns: Option<&[String]>,
    (file, first): (&str, usize),
    of: [&str; 2],
) -> Result<[usize; 2], Diagnostics> {
    let mut problems = Diagnostics::new();
    let mut index = |i: usize| match columns {
        None => (i < heading.len()).then_some(i),
        Some(names) => {
            let found = heading.iter().position(|own| *own == names[i]);
            if found.is_none() {
                let (name, known) = (names[i].clone(), heading.to_vec());
                let problem = DriveProblem::NoColumn { name, known };
                problems.push(SourceLocation::line(file, first), &problem);
            }
            found
        }
    };
    let indices = [index(0), index(1)];
    let [Some(time), Some(value)] = indices else {
        if problems.is_empty() {
            let expected = format!(
                "a heading and two columns, of {} and {}, separated by commas",
                of[0], of[1]
            );
            let (key, found) = (
                "file".to_owned(),
                "a table of fewer than two columns".to_owned(),
            );
            let problem = DocumentProblem::WrongValue {
                key,
                found,
                expected,
            };
            problems.push(SourceLocation::line(file, first), &problem);
        }
        return Err(problems);
    };
    Ok([time, value])
}

/// The two columns of a CSV text with a heading; the first two unless they are named.
fn rows(
    text: &str,
    file: &str,
    columns: Option<&[String]>,
    of: [&str; 2],
) -> Result<Vec<Row>, Diagnostics> {
    let mut records = csv_rows::records(text);
    let (first, headers) = records.next().unwrap_or((1, csv::StringRecord::new()));
    let heading: Vec<_> = headers.iter().map(str::to_owned).collect();
    let [time, value] = column_indices(&heading, columns, (file, first), of)?;
    let mut rows = Vec::new();
    let mut wrong = Vec::new();
    for (line, record) in records {
        let number = |column: usize| {
            let found = record.get(column).unwrap_or("");
            let number = found.parse::<f64>().ok().filter(|n| n.is_finite());
            number.ok_or_else(|| DriveProblem::NoNumber {
                found: found.to_owned(),
                column: heading[column].clone(),
            })
        };
        match (number(time), number(value)) {
            (Ok(time), Ok(value)) => rows.push((line, [time, value])),
            (Err(problem), _) | (_, Err(problem)) => wrong.push((line, problem)),
        }
    }
    let more = |count| DriveProblem::MoreRows { count };
    csv_rows::problems(file, &wrong, more).into_result(rows)
}
