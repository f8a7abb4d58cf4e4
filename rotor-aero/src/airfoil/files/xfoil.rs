//! Polar files of XFOIL and XFLR5: one Reynolds number per file.
//!
//! A head with "Calculated polar for: NAME" and "Mach = x Re = y e 6 Ncrit = z", a line of titles,
//! dashes, then rows of the converged angles: no step between angles is assumed. XFLR5 writes
//! more numbers than titles.

use shared_geom::error::shortened;
use shared_geom::exchange::text::{Line, lines, number};

use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil};

/// Words before the name of the airfoil.
const NAME: &str = "Calculated polar for:";

/// Whether `text` has the head of a polar.
pub(super) fn recognize(text: &str) -> bool {
    text.lines()
        .any(|line| line.contains(NAME) || (line.contains("Ncrit") && line.contains("Mach")))
}

/// The columns of the titles, from zero.
struct Titles {
    alpha: usize,
    lift: usize,
    drag: usize,
    moment: usize,
}

/// Reads the polar of a file.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let lines = lines(text);
    let mut airfoil = ReadAirfoil::default();
    let Some(dashes) = lines.iter().position(|line| is_rule(line.text)) else {
        let help = "the file may have been cut off";
        notes.missing(0, "the line of dashes under the titles", help);
        return None;
    };
    let (head, rows) = lines.split_at(dashes);
    let name = head.iter().find_map(|line| line.text.split_once(NAME));
    airfoil.data.name = name
        .map(|(_, name)| name.trim().to_owned())
        .unwrap_or_default();
    check_kind(head, notes);
    let mach = value(head, "Mach=", notes);
    let reynolds = value(head, "Re=", notes);
    let titles = titles(head, notes)?;
    let mut rows: Vec<Row> = rows
        .iter()
        .skip(1)
        .filter_map(|line| row(line, &titles, notes))
        .collect();
    if rows.windows(2).any(|two| two[1].alpha < two[0].alpha) {
        notes.remark(0, "the rows are sorted by the angle");
        rows.sort_by(|a, b| a.alpha.total_cmp(&b.alpha));
    }
    let line = lines.get(dashes).map_or(0, |line| line.number);
    let grid = Grid::of(&rows, Unit::Degrees, ("the polar", line), notes)?;
    // At Mach zero the table is incompressible, and does not depend on it.
    let condition = [
        mach.filter(|&mach| mach > 0.0),
        reynolds.filter(|&re| re > 0.0),
        None,
    ];
    airfoil.data.lift.extend(grid.curve(0, condition));
    airfoil.data.drag.extend(grid.curve(1, condition));
    airfoil.data.moment.extend(grid.curve(2, condition));
    Some(vec![airfoil])
}

/// Whether a line has only dashes.
fn is_rule(text: &str) -> bool {
    text.contains("---") && text.chars().all(|c| c == '-' || c.is_whitespace())
}

/// Notes a polar whose Reynolds number depends on lift.
fn check_kind(head: &[Line<'_>], notes: &mut Notes) {
    let kind = head
        .iter()
        .find(|line| line.text.contains("Reynolds number"));
    if let Some(line) = kind.filter(|line| line.text.contains('~') || line.text.contains("sqrt")) {
        let found = format!("\"{}\"", shortened(line.text));
        let help = "calculate the polar at a fixed Reynolds number (type 1)";
        notes.wrong(
            line.number,
            ["kind of the polar", &found, "a fixed Reynolds number", help],
        );
    }
}

/// The number after `key` in the head, in which blanks have no meaning: "0.100 e 6".
fn value(head: &[Line<'_>], key: &str, notes: &mut Notes) -> Option<f64> {
    for line in head {
        let packed: String = line.text.split_whitespace().collect();
        let Some(at) = packed.find(key) else {
            continue;
        };
        let rest = &packed[at + key.len()..];
        let is_of = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e' | 'E');
        let end = rest.find(|c| !is_of(c)).unwrap_or(rest.len());
        // "0.000Re" ends in the letter of the next name.
        let word = &rest[..end];
        return notes.number(line.number, key.trim_end_matches('='), word);
    }
    let name = key.trim_end_matches('=');
    notes.missing(
        0,
        &format!("{name} of the head"),
        "write \"Mach = 0.0  Re = 0.1 e 6  Ncrit = 9\"",
    );
    None
}

/// The columns of the coefficients by their titles.
fn titles(head: &[Line<'_>], notes: &mut Notes) -> Option<Titles> {
    let line = head
        .iter()
        .rev()
        .find(|line| line.first().eq_ignore_ascii_case("alpha"));
    let Some(line) = line else {
        notes.missing(
            0,
            "the line of titles, \"alpha CL CD CDp CM\"",
            "the file may have been cut off",
        );
        return None;
    };
    let mut column = |name: &str| {
        let found = line
            .words()
            .position(|word| word.eq_ignore_ascii_case(name));
        if found.is_none() {
            notes.missing(
                line.number,
                &format!("column {name}"),
                "titles are alpha CL CD CDp CM",
            );
        }
        found
    };
    let (alpha, lift, drag, moment) = (column("alpha"), column("CL"), column("CD"), column("CM"));
    Some(Titles {
        alpha: alpha?,
        lift: lift?,
        drag: drag?,
        moment: moment?,
    })
}

/// A row of numbers.
fn row(line: &Line<'_>, titles: &Titles, notes: &mut Notes) -> Option<Row> {
    let numbers = line.list("row of the polar", None, &mut notes.problems)?;
    let columns = [titles.alpha, titles.lift, titles.drag, titles.moment];
    let found: Vec<f64> = columns
        .iter()
        .filter_map(|&column| numbers.get(column).copied())
        .collect();
    let [alpha, values @ ..] = &found[..] else {
        return None;
    };
    if values.len() < 3 || number(line.first()).is_none() {
        let found = format!("{} numbers", numbers.len());
        let help = "the line may have been cut off";
        notes.wrong(
            line.number,
            [
                "row of the polar",
                &found,
                "at least alpha, CL, CD, CDp and CM",
                help,
            ],
        );
        return None;
    }
    Some(Row {
        line: line.number,
        alpha: *alpha,
        values: values.to_vec(),
    })
}
