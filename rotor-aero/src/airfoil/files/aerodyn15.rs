//! Polars of AeroDyn 15: lines "value name - text", comments that begin with `!`, and one table
//! per Reynolds number and control setting.
//!
//! Lines are found by the name, never by their number. The columns of a table are set in the
//! main file of AeroDyn (`InCol_Alfa` and others): see [`Columns`].

use shared_geom::exchange::text::{Line, lines, number};

use super::super::constants::{UnsteadyConstants, is_name};
use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Columns, Options, ReadAirfoil};

mod write;

pub(super) use write::write;

/// Columns of a table if the main file is not known.
const USUAL: Columns = Columns {
    alpha: 1,
    lift: 2,
    drag: 3,
    moment: Some(4),
};

/// Whether `text` has the names of a polar.
pub(super) fn recognize(text: &str) -> bool {
    let is_name = |word: &str| {
        ["NumTabs", "NumAlf"]
            .iter()
            .any(|name| word.eq_ignore_ascii_case(name))
    };
    let mut all = text.lines().filter(|line| !is_comment(line));
    all.any(|line| line.split_whitespace().nth(1).is_some_and(is_name))
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with(['!', '#'])
}

/// A table of the file.
#[derive(Default)]
struct Table {
    line: usize,
    reynolds: Option<f64>,
    control: Option<f64>,
    has_constants: Option<bool>,
    constants: Vec<(String, Option<f64>)>,
    rows: Option<Vec<Row>>,
}

/// The parts of a file, while it is read.
#[derive(Default)]
struct Parts {
    tables: Vec<Table>,
    expected: Option<usize>,
    coordinates: Option<String>,
    /// Lines of coordinates in the file itself that are still to come.
    points: usize,
    thickness: Option<f64>,
}

/// Reads the tables of a file.
pub(super) fn read(text: &str, options: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let lines: Vec<Line<'_>> = lines(text)
        .into_iter()
        .filter(|line| !is_comment(line.text))
        .collect();
    let columns = options.columns.unwrap_or(USUAL);
    let mut parts = Parts::default();
    let mut next = 0;
    while let Some(line) = lines.get(next) {
        next += 1;
        let (value, name) = field(line.text);
        if name.eq_ignore_ascii_case("NumAlf") {
            let following = lines.get(next..).unwrap_or_default();
            next += parts.rows(line, value, following, &columns, notes);
        } else {
            parts.take(line, value, name, notes);
        }
    }
    parts.check_count(notes);
    parts.airfoil(notes).map(|airfoil| vec![airfoil])
}

/// The value and the name of a line; a value in quotes may have blanks.
fn field(text: &str) -> (&str, &str) {
    let quoted = text.strip_prefix('@').unwrap_or(text).strip_prefix('"');
    if let Some((value, rest)) = quoted.and_then(|quoted| quoted.split_once('"')) {
        return (value, rest.split_whitespace().next().unwrap_or_default());
    }
    let mut words = text.split_whitespace();
    (
        words.next().unwrap_or_default(),
        words.next().unwrap_or_default(),
    )
}

impl Parts {
    /// Takes a line "value name"; notes a line that is not understood.
    fn take(&mut self, line: &Line<'_>, value: &str, name: &str, notes: &mut Notes) {
        let at = line.number;
        match name.to_ascii_lowercase().as_str() {
            "numtabs" => self.expected = notes.count(at, "NumTabs", value),
            "re" => self.open(at, value, notes),
            "ctrl" | "userprop" => {
                let value = notes.number(at, name, value);
                self.in_table(at, name, notes).control = value;
            }
            "incluadata" => {
                let value = flag(at, value, notes);
                self.in_table(at, name, notes).has_constants = value;
            }
            "numcoords" => match value.parse() {
                Ok(points) => self.points = points,
                Err(_) => self.coordinates = Some(value.to_owned()),
            },
            "relthickness" => self.thickness = default_or(at, name, value, notes),
            "interpord" | "nondimarea" | "bl_file" => {}
            _ if is_name(name) => {
                let value = default_or(at, name, value, notes);
                self.in_table(at, name, notes)
                    .constants
                    .push((name.to_owned(), value));
            }
            _ => self.other(line, value, name, notes),
        }
    }

    /// A line with a name that is not known.
    fn other(&mut self, line: &Line<'_>, value: &str, name: &str, notes: &mut Notes) {
        let is_point = line
            .text
            .split_whitespace()
            .take(2)
            .all(|word| number(word).is_some());
        if is_point && self.points > 0 {
            self.points -= 1;
            return;
        }
        let is_field = name.chars().next().is_some_and(char::is_alphabetic);
        if is_field && number(value).is_some_and(|_| self.tables.is_empty()) {
            notes.remark(
                line.number,
                &format!("\"{name}\" is not known and not used"),
            );
            return;
        }
        let found = format!("\"{}\"", shared_geom::error::shortened(line.text));
        let help = "a row of numbers may be beyond the count NumAlf; comments begin with !";
        notes.wrong(
            line.number,
            [
                "AeroDyn polar",
                &found,
                "a line \"value name\" of AeroDyn",
                help,
            ],
        );
    }

    /// Begins a table.
    fn open(&mut self, line: usize, value: &str, notes: &mut Notes) {
        let reynolds = notes.number(line, "Re", value);
        self.tables.push(Table {
            line,
            reynolds: reynolds.filter(|&re| re > 0.0).map(|re| re * 1e6),
            ..Table::default()
        });
    }

    /// The present table; notes a line before the first one.
    fn in_table(&mut self, line: usize, name: &str, notes: &mut Notes) -> &mut Table {
        if self.tables.is_empty() {
            let help = "every table begins with its Reynolds number, \"1.0 Re\"";
            notes.wrong(
                line,
                [
                    name,
                    "it before the first table",
                    "a line Re before it",
                    help,
                ],
            );
        }
        let last = self.tables.len().saturating_sub(1);
        if self.tables.is_empty() {
            self.tables.push(Table {
                line,
                ..Table::default()
            });
        }
        &mut self.tables[last]
    }

    /// Reads the rows of the present table from `following`; returns the number of lines.
    fn rows(
        &mut self,
        line: &Line<'_>,
        value: &str,
        following: &[Line<'_>],
        columns: &Columns,
        notes: &mut Notes,
    ) -> usize {
        let Some(expected) = notes.count(line.number, "NumAlf", value) else {
            return following.iter().take_while(|line| is_row(line)).count();
        };
        let rows: Vec<_> = following
            .iter()
            .take(expected)
            .take_while(|line| is_row(line))
            .collect();
        if rows.len() < expected {
            let last = rows.last().map_or(line.number, |row| row.number);
            notes.cut(
                last,
                "a table of coefficients",
                &format!("{expected} rows, found {}", rows.len()),
            );
        }
        let values = rows
            .iter()
            .filter_map(|line| row(line, columns, notes))
            .collect();
        let table = self.in_table(line.number, "NumAlf", notes);
        let is_second = table.rows.is_some();
        table.rows = Some(values);
        if is_second {
            let help = "every table begins with its Reynolds number, \"1.0 Re\"";
            notes.wrong(
                line.number,
                [
                    "NumAlf",
                    "a second table of one Reynolds number",
                    "a line Re before it",
                    help,
                ],
            );
        }
        rows.len()
    }

    fn check_count(&mut self, notes: &mut Notes) {
        let found = self.tables.len();
        match self.expected {
            Some(expected) if expected == found => {}
            Some(expected) => {
                let help = "the file may have been cut off, or NumTabs is wrong";
                notes.wrong(
                    0,
                    [
                        "NumTabs",
                        &format!("{found} tables"),
                        &format!("{expected}"),
                        help,
                    ],
                );
            }
            None => notes.missing(0, "NumTabs", "write the number of tables, \"1 NumTabs\""),
        }
        if self.points > 0 {
            notes.cut(
                0,
                "the coordinates",
                &format!("{} more points", self.points),
            );
        }
    }

    /// The airfoil of all tables.
    fn airfoil(self, notes: &mut Notes) -> Option<ReadAirfoil> {
        let controls: Vec<_> = self
            .tables
            .iter()
            .map(|table| table.control.unwrap_or(0.0))
            .collect();
        let has_control = controls.iter().any(|&control| control != 0.0);
        if has_control {
            notes.remark(
                0,
                "the control setting is used as the deflection of a flap in deg",
            );
        }
        let mut airfoil = ReadAirfoil {
            coordinates: self.coordinates,
            ..ReadAirfoil::default()
        };
        airfoil.data.thickness = self.thickness;
        for (i, table) in self.tables.into_iter().enumerate() {
            let flap = has_control.then(|| controls.get(i).copied().unwrap_or(0.0).to_radians());
            table.add(flap, &format!("table {}", i + 1), &mut airfoil, notes);
        }
        Some(airfoil)
    }
}

impl Table {
    /// Adds its curves and constants to the airfoil.
    fn add(self, flap: Option<f64>, what: &str, airfoil: &mut ReadAirfoil, notes: &mut Notes) {
        if let Some(true) = self.has_constants.filter(|_| self.constants.is_empty()) {
            notes.remark(
                self.line,
                &format!("{what}: InclUAdata is true, and no constants follow"),
            );
        }
        if !self.constants.is_empty() {
            airfoil.unsteady.push(UnsteadyConstants {
                reynolds: self.reynolds,
                control: self.control,
                values: self.constants,
            });
        }
        let Some(rows) = self.rows else {
            notes.missing(
                self.line,
                &format!("{what}: NumAlf and its rows"),
                "the file may have been cut off",
            );
            return;
        };
        let Some(grid) = Grid::of(&rows, Unit::Degrees, (what, self.line), notes) else {
            return;
        };
        let condition = [None, self.reynolds, flap];
        airfoil.data.lift.extend(grid.curve(0, condition));
        airfoil.data.drag.extend(grid.curve(1, condition));
        airfoil.data.moment.extend(grid.curve(2, condition));
    }
}

/// Whether a line begins with a number and has no name.
fn is_row(line: &Line<'_>) -> bool {
    let mut words = line.words();
    words
        .next()
        .is_some_and(|word| number(word).is_some() || word.eq_ignore_ascii_case("nan"))
        && words.next().is_none_or(|word| {
            !word.starts_with(char::is_alphabetic) || word.eq_ignore_ascii_case("nan")
        })
}

/// A row of numbers.
fn row(line: &Line<'_>, columns: &Columns, notes: &mut Notes) -> Option<Row> {
    let text = line.text.split('!').next().unwrap_or_default();
    let bare = Line { text, ..*line };
    let numbers = bare.list("row of coefficients", None, &mut notes.problems)?;
    let mut value = |column: usize| {
        let found = column.checked_sub(1).and_then(|i| numbers.get(i).copied());
        if found.is_none() {
            let (found, expected) = (
                format!("{} numbers", numbers.len()),
                format!("a number in column {column}"),
            );
            let help = "the line may have been cut off; the main file of AeroDyn sets the columns";
            notes.wrong(
                line.number,
                ["row of coefficients", &found, &expected, help],
            );
        }
        found
    };
    let alpha = value(columns.alpha)?;
    let mut values = vec![value(columns.lift)?, value(columns.drag)?];
    // A table of three columns has no moment.
    let moment = columns.moment.filter(|_| numbers.len() > 3);
    if let Some(column) = moment {
        values.push(value(column)?);
    }
    Some(Row {
        line: line.number,
        alpha,
        values,
    })
}

/// A number; absent for the word `Default`.
fn default_or(line: usize, name: &str, value: &str, notes: &mut Notes) -> Option<f64> {
    let word = value.trim_matches('"');
    if word.eq_ignore_ascii_case("default") {
        None
    } else {
        notes.number(line, name, word)
    }
}

fn flag(line: usize, value: &str, notes: &mut Notes) -> Option<bool> {
    match value.to_ascii_lowercase().as_str() {
        "true" | "t" | ".true." => Some(true),
        "false" | "f" | ".false." => Some(false),
        _ => {
            let found = format!("\"{value}\"");
            notes.wrong(
                line,
                [
                    "InclUAdata",
                    &found,
                    "True or False",
                    "write True if constants follow",
                ],
            );
            None
        }
    }
}
