//! Propellers of QPROP.
//!
//! A line with the name, then six lines of two to four numbers: number of blades and perhaps
//! radius; cl at zero angle and its slope; limits of cl; cd and its quadratic coefficients;
//! Reynolds number and exponent; factors and addends of the stations; then rows of radius, chord
//! and angle, which become `value * factor + addend`. Text after `!` and lines that begin with
//! `#` or `!` are comments.

use shared_geom::exchange::text::{Line, lines};

use super::super::notes::Notes;
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, QpropPolar, SpanOrigin};

/// Whether `text` has the two lines of factors that only this format has.
pub(super) fn recognize(text: &str) -> bool {
    text.contains("Rfac") && text.contains("Radd")
}

/// Meaning and number of values of the lines after the name.
const HEAD: [(&str, usize, usize); 7] = [
    ("number of blades, radius", 1, 2),
    ("CL0, CL_a", 2, 2),
    ("CLmin, CLmax", 2, 2),
    ("CD0, CD2u, CD2l, CLCD0", 4, 4),
    ("REref, REexp", 2, 2),
    ("Rfac, Cfac, Bfac", 3, 3),
    ("Radd, Cadd, Badd", 3, 3),
];

/// Reads the propeller of a file.
pub(super) fn read(text: &str, _: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let mut content = lines(text).into_iter().filter_map(without_comment);
    let name = content.next();
    let mut head = Vec::new();
    for (what, least, most) in HEAD {
        let Some(line) = content.next() else {
            notes.cut(text.lines().count(), "the head", what);
            return None;
        };
        head.push(values(&line, what, (least, most), notes));
    }
    let rows: Vec<_> = content.collect();
    let head: Option<Vec<_>> = head.into_iter().collect();
    let rows = rows
        .iter()
        .map(|line| values(line, "radius, chord, angle", (3, 3), notes));
    // All rows are read, so that all problems are reported.
    let rows: Vec<_> = rows.collect();
    let (head, rows) = (head?, rows.into_iter().collect::<Option<Vec<_>>>()?);
    let mut blade = BladeAero::of(
        BladeFormat::Qprop,
        SpanOrigin::RotationAxis,
        stations(&head, &rows)?,
    );
    blade.name = name.map(|line| line.text.to_owned()).unwrap_or_default();
    blade.blades = blades(*head.first()?.first()?, notes);
    blade.tip_radius = blade.stations.last().map(|station| station.span);
    remark_radius(&head, blade.tip_radius, notes);
    blade.polar = polar(&head);
    Some(blade)
}

/// Remarks on a radius of the head that is not the one of the last station: QPROP 1.22 uses the
/// station (its output for `cam6x3.def` has `adv = V / (Omega R)` with the R of the station).
fn remark_radius(head: &[Vec<f64>], tip: Option<f64>, notes: &mut Notes) {
    let value = |line: usize, i: usize| head.get(line)?.get(i).copied();
    let Some((radius, tip)) = value(0, 1).filter(|&radius| radius > 0.0).zip(tip) else {
        return;
    };
    let scaled = radius * value(5, 0).unwrap_or(1.0) + value(6, 0).unwrap_or(0.0);
    if (scaled - tip).abs() > 1e-9 * tip.abs() {
        let text = format!(
            "the radius {scaled} m of the head is not used: the last station is at {tip} m"
        );
        notes.remark(0, &text);
    }
}

/// A line without its comment; absent if nothing remains.
fn without_comment(line: Line<'_>) -> Option<Line<'_>> {
    let text = line.text.split('!').next().unwrap_or_default().trim();
    (!text.is_empty() && !text.starts_with('#')).then_some(Line { text, ..line })
}

/// The numbers of a line; notes another number of them.
fn values(
    line: &Line<'_>,
    what: &str,
    (least, most): (usize, usize),
    notes: &mut Notes,
) -> Option<Vec<f64>> {
    let numbers = line.list(what, None, &mut notes.problems)?;
    if !(least..=most).contains(&numbers.len()) {
        let found = format!("{} numbers", numbers.len());
        let expected = if least == most {
            least.to_string()
        } else {
            format!("{least} to {most}")
        };
        notes.wrong(
            line.number,
            [
                what,
                &found,
                &expected,
                "a line may be missing; comments begin with !",
            ],
        );
        return None;
    }
    Some(numbers)
}

fn blades(count: f64, notes: &mut Notes) -> Option<usize> {
    if (1.0..=100.0).contains(&count) && count.fract() == 0.0 {
        return Some(count as usize);
    }
    notes.wrong(
        0,
        [
            "number of blades",
            &count.to_string(),
            "a whole number from 1 to 100",
            "correct the first number",
        ],
    );
    None
}

fn stations(head: &[Vec<f64>], rows: &[Vec<f64>]) -> Option<Vec<AeroStation>> {
    let (factors, addends) = (head.get(5)?, head.get(6)?);
    let scaled = |row: &Vec<f64>, i: usize| Some(row.get(i)? * factors.get(i)? + addends.get(i)?);
    let station = |row: &Vec<f64>| {
        let angle = scaled(row, 2)?.to_radians();
        Some(AeroStation::plain(scaled(row, 0)?, scaled(row, 1)?, angle))
    };
    rows.iter().map(station).collect()
}

fn polar(head: &[Vec<f64>]) -> Option<QpropPolar> {
    let value = |line: usize, i: usize| head.get(line)?.get(i).copied();
    Some(QpropPolar {
        lift_zero: value(1, 0)?,
        lift_slope: value(1, 1)?,
        lift_limits: [value(2, 0)?, value(2, 1)?],
        drag_zero: value(3, 0)?,
        drag_quadratic: [value(3, 1)?, value(3, 2)?],
        lift_drag_zero: value(3, 3)?,
        reynolds: value(4, 0)?,
        exponent: value(4, 1)?,
    })
}
