//! The geometry of a blade, `.bld`: chord, twist and shape of the axis at sections, linear
//! between them. Airfoils are not used.
//!
//! The axis is the thread axis, about which sections are turned and on which the structural beam
//! is. `OFFSET_X` is in the plane of rotation, to the trailing edge, and `OFFSET_Y` out of it,
//! downwind; in the file of the NREL 5 MW in QBlade's documentation they move the half chord
//! from the pitch axis to the trailing edge, in axes turned by the twist.

use std::path::Path;

use nalgebra::Vector3;

use crate::error::Diagnostics;
use crate::exchange::frame::Convention;
use crate::exchange::plain::turns;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines, not_a_number, number};
use crate::line::{Course, LinePoint, ReferenceLine};

/// Names of the columns that are read.
const COLUMNS: [&str; 5] = ["POS", "CHORD", "TWIST", "OFFSET_X", "OFFSET_Y"];
/// First column of a blade of a vertical-axis rotor.
const HEIGHT: &str = "HEIGHT";

/// Line and chord of a blade.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Geometry {
    /// The thread axis, from the root.
    pub line: ReferenceLine,
    /// Chord at its points [m].
    pub chord: Vec<f64>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}

/// Whether `text` has the table of a blade.
pub(super) fn is_table(text: &str) -> bool {
    lines(text).iter().any(is_head)
}

fn is_head(line: &Line<'_>) -> bool {
    let names = names(line);
    let begins = |name: &str| names.first().is_some_and(|first| first == name);
    (begins(COLUMNS[0]) || begins(HEIGHT)) && names.iter().any(|name| name == COLUMNS[1])
}

/// The names of the columns, upper case, without their units.
fn names(line: &Line<'_>) -> Vec<String> {
    let name = |word: &str| {
        let name = word.split('[').next().unwrap_or_default();
        name.trim_end_matches('_').to_uppercase()
    };
    line.words()
        .map(name)
        .filter(|name| !name.is_empty())
        .collect()
}

/// Reads the geometry of `file`.
///
/// # Errors
/// All errors of the table.
pub(super) fn read(text: &str, file: &Path) -> Result<Geometry, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let rows = rows(&lines(text), &mut problems);
    let rows = problems.finish(rows)?;
    let axes = Convention::BeamDyn.axes();
    let root = rows[0][0];
    let point = |row: &[f64; 5]| LinePoint {
        position: axes * Vector3::new(row[4], row[3], row[0] - root),
        twist: 0.0,
    };
    let points = rows.iter().map(point).collect();
    let mut line = ReferenceLine::through(points, Course::Polyline);
    let turns = turns(&line);
    for ((point, turn), row) in line.points.iter_mut().zip(turns).zip(&rows) {
        point.twist = turn - row[2].to_radians();
    }
    let remark = format!(
        "line, twist and chord are from {}; its first section is at {root} m: if this is the \
         distance from the axis of rotation, give it as hub radius",
        file.display()
    );
    Ok(Geometry {
        line,
        chord: rows.iter().map(|row| row[1]).collect(),
        remarks: vec![remark],
    })
}

/// The columns of at least two rows.
fn rows(all: &[Line<'_>], problems: &mut Problems) -> Option<Vec<[f64; 5]>> {
    let head = all.iter().position(is_head)?;
    let names = names(&all[head]);
    let positions = positions(&all[head], &names, problems)?;
    let body = all[head + 1..].iter();
    let body = body.take_while(|line| number(line.first()).is_some());
    let mut rows: Vec<[f64; 5]> = Vec::new();
    for (count, line) in body.enumerate() {
        let what = format!("section {}", count + 1);
        let Some(row) = row(&what, line, positions, problems) else {
            continue;
        };
        check(&what, line, &row, rows.last(), problems);
        rows.push(row);
    }
    if rows.len() < 2 && problems.is_empty() {
        problems.push(
            all[head].number,
            &ExchangeProblem::CutShort {
                what: "the table of the blade".to_owned(),
                expected: "at least two sections".to_owned(),
            },
        );
    }
    (rows.len() > 1).then_some(rows)
}

/// Indices of the columns; notes missing ones, and a vertical-axis rotor.
fn positions(line: &Line<'_>, names: &[String], problems: &mut Problems) -> Option<[usize; 5]> {
    if names.first().is_some_and(|name| name == HEIGHT) {
        let problem = ExchangeProblem::Other {
            what: "the table of the blade".to_owned(),
            found: "a blade of a vertical-axis rotor (HEIGHT)".to_owned(),
            expected: "a blade of a horizontal-axis rotor (POS)".to_owned(),
            help: "write its line into a NAME.blade.toml".to_owned(),
        };
        problems.push(line.number, &problem);
        return None;
    }
    let found = COLUMNS.map(|name| names.iter().position(|found| found == name));
    for (name, _) in COLUMNS.iter().zip(found).filter(|(_, at)| at.is_none()) {
        let problem = ExchangeProblem::Missing {
            what: format!("the column \"{name}\""),
            help: format!("the names of the columns are {}", names.join(", ")),
        };
        problems.push(line.number, &problem);
    }
    let [pos, chord, twist, x, y] = found;
    Some([pos?, chord?, twist?, x?, y?])
}

/// The numbers of a row; its last words name an airfoil.
fn row(
    what: &str,
    line: &Line<'_>,
    positions: [usize; 5],
    problems: &mut Problems,
) -> Option<[f64; 5]> {
    let words: Vec<_> = line.words().collect();
    let mut numbers = [0.0; 5];
    let mut is_sound = true;
    for ((value, at), name) in numbers.iter_mut().zip(positions).zip(COLUMNS) {
        let word = words.get(at).copied().unwrap_or_default();
        match number(word) {
            Some(found) => *value = found,
            None => {
                problems.push(
                    line.number,
                    &not_a_number(&format!("{name} of {what}"), word),
                );
                is_sound = false;
            }
        }
    }
    is_sound.then_some(numbers)
}

/// Notes a chord that is not positive, and a position that is not after the previous one.
fn check(
    what: &str,
    line: &Line<'_>,
    row: &[f64; 5],
    before: Option<&[f64; 5]>,
    problems: &mut Problems,
) {
    let mut note = |name: &str, found: f64, expected: String| {
        let problem = ExchangeProblem::Other {
            what: format!("{name} of {what}"),
            found: found.to_string(),
            expected,
            help: "correct the number, or the order of the rows".to_owned(),
        };
        problems.push(line.number, &problem);
    };
    if row[1] <= 0.0 {
        note(COLUMNS[1], row[1], "more than zero".to_owned());
    }
    if let Some(before) = before.filter(|before| before[0] >= row[0]) {
        let expected = format!(
            "more than the position of the previous section, {}",
            before[0]
        );
        note(COLUMNS[0], row[0], expected);
    }
}
