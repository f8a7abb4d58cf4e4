//! Polars of AeroDyn 12 and 13: title lines, lines "numbers text" without names, then rows of
//! angle and coefficients, and at the end nothing or `EOT`.
//!
//! A file has one or more tables side by side: a line of the head has a number per table, a row
//! has the angle, then lift, drag and perhaps moment of each table.

use shared_geom::error::shortened;
use shared_geom::exchange::text::{Line, lines, number};

use super::super::constants::UnsteadyConstants;
use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil};

/// Words of the line that begins the head.
const BEGIN: &str = "number of airfoil tables";

/// Whether `text` has the first line of a head.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(begins)
}

fn begins(line: &str) -> bool {
    line.to_ascii_lowercase().contains(BEGIN)
}

/// Phrases of the head, in the order in which they are tried, and the constant's name; without a
/// name for lines that are not used.
const PHRASES: [(&[&str], Option<&str>); 10] = [
    (&["no longer used"], None),
    (&["slope"], Some("C_nalpha")),
    (&["positive"], Some("Cn1")),
    (&["negative"], Some("Cn2")),
    (&["minimum cd", "angle"], None),
    (&["minimum cd"], Some("Cd0")),
    (&["zero"], Some("alpha0")),
    (&["stall angle"], Some("alpha1")),
    (&["reynolds"], Some("Re")),
    (&["control setting"], Some("Ctrl")),
];

/// Reads the tables of a file.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let lines = lines(text);
    let start = lines.iter().position(|line| begins(line.text))?;
    let first = lines.get(start)?;
    let tables = notes.count(first.number, "number of airfoil tables", first.first())?;
    if tables == 0 || tables > 100 {
        let help = "write the number of tables of the file";
        notes.wrong(first.number, [BEGIN, &tables.to_string(), "1 to 100", help]);
        return None;
    }
    let mut constants = vec![UnsteadyConstants::default(); tables];
    let mut rows = Vec::new();
    let mut has_ended = false;
    for line in lines.iter().skip(start + 1) {
        if has_ended {
            after_end(line, notes);
        } else if line.first().eq_ignore_ascii_case("EOT") {
            has_ended = true;
        } else if line.words().all(|word| number(word).is_some()) {
            rows.extend(row(line, tables, notes));
        } else if rows.is_empty() {
            head(line, &mut constants, notes);
        } else {
            let found = format!("\"{}\"", shortened(line.text));
            let help = "correct the row, or end the table with EOT";
            notes.wrong(
                line.number,
                ["row of coefficients", &found, "numbers alone, or EOT", help],
            );
        }
    }
    airfoil(&rows, constants, first.number, notes).map(|airfoil| vec![airfoil])
}

fn after_end(line: &Line<'_>, notes: &mut Notes) {
    let found = format!("\"{}\"", shortened(line.text));
    notes.wrong(
        line.number,
        [
            "AeroDyn polar",
            &found,
            "the end of the file after EOT",
            "delete the line",
        ],
    );
}

/// Takes a line of the head: a number per table, then text.
fn head(line: &Line<'_>, constants: &mut [UnsteadyConstants], notes: &mut Notes) {
    let numbers: Vec<f64> = line.words().map_while(number).collect();
    let text = line
        .words()
        .skip(numbers.len())
        .collect::<Vec<_>>()
        .join(" ")
        .to_ascii_lowercase();
    if numbers.len() < constants.len() {
        let (found, expected) = (
            format!("\"{}\"", shortened(line.text)),
            format!("{}, one per table", constants.len()),
        );
        let help = "write the numbers before the text";
        notes.wrong(
            line.number,
            ["numbers of the head", &found, &expected, help],
        );
        return;
    }
    let fits = |words: &&(&[&str], Option<&str>)| words.0.iter().all(|word| text.contains(word));
    let Some((_, name)) = PHRASES.iter().find(fits) else {
        notes.remark(
            line.number,
            &format!("\"{text}\" is not known and not used"),
        );
        return;
    };
    for (constants, value) in constants.iter_mut().zip(numbers) {
        match name {
            Some("Re") => {
                constants.reynolds = Some(value).filter(|&re| re > 0.0).map(|re| re * 1e6)
            }
            Some("Ctrl") => constants.control = Some(value),
            Some(name) => constants.values.push(((*name).to_owned(), Some(value))),
            None => {}
        }
    }
}

/// A row: the angle, then two or three coefficients of each table.
fn row(line: &Line<'_>, tables: usize, notes: &mut Notes) -> Option<Row> {
    let numbers = line.list("row of coefficients", None, &mut notes.problems)?;
    let (alpha, values) = numbers.split_first()?;
    if values.len() != 2 * tables && values.len() != 3 * tables {
        let found = format!("{} numbers", numbers.len());
        let expected = format!("{} or {}", 1 + 2 * tables, 1 + 3 * tables);
        let help = "the line may have been cut off";
        notes.wrong(
            line.number,
            ["row of coefficients", &found, &expected, help],
        );
        return None;
    }
    Some(Row {
        line: line.number,
        alpha: *alpha,
        values: values.to_vec(),
    })
}

fn airfoil(
    rows: &[Row],
    constants: Vec<UnsteadyConstants>,
    line: usize,
    notes: &mut Notes,
) -> Option<ReadAirfoil> {
    let grid = Grid::of(rows, Unit::Degrees, ("the table", line), notes)?;
    let has_control = constants
        .iter()
        .any(|table| table.control.is_some_and(|control| control != 0.0));
    if has_control {
        notes.remark(
            0,
            "the control setting is used as the deflection of a flap in deg",
        );
    }
    let mut airfoil = ReadAirfoil::default();
    let width = grid.columns.len() / constants.len().max(1);
    for (i, table) in constants.iter().enumerate() {
        let flap = has_control.then(|| table.control.unwrap_or(0.0).to_radians());
        let condition = [None, table.reynolds, flap];
        airfoil.data.lift.extend(grid.curve(width * i, condition));
        airfoil
            .data
            .drag
            .extend(grid.curve(width * i + 1, condition));
        if width > 2 {
            airfoil
                .data
                .moment
                .extend(grid.curve(width * i + 2, condition));
        }
    }
    airfoil.unsteady = constants;
    Some(airfoil)
}
