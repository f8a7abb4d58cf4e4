//! Aerodynamic layout of HAWC2.
//!
//! The first line has the number of sets; a set has a line "index rows", then rows of curved
//! length along the half chord [m], chord [m], thickness over chord [per cent] and set of
//! profiles. Twist is not in this file: HAWC2 has it in its `c2_def` lines, so it is zero here.

use shared_geom::exchange::text::{Line, lines, number};

use super::super::notes::Notes;
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin, StationAirfoil};

/// Whether `text` begins like a layout: two counts, then rows of four numbers.
pub(super) fn recognize(text: &str) -> bool {
    let lines: Vec<_> = lines(text).into_iter().take(3).collect();
    let [first, second, row] = &lines[..] else {
        return false;
    };
    let is_count = |line: &Line<'_>, count: usize| {
        line.words()
            .take(count)
            .filter(|word| word.parse::<usize>().is_ok())
            .count()
            == count
    };
    let numbers = row.words().take(4).map_while(number).count();
    is_count(first, 1) && is_count(second, 2) && numbers == 4
}

/// Reads a set of the layout.
pub(super) fn read(text: &str, options: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let lines = lines(text);
    let wanted = options.set.unwrap_or(1);
    let first = lines.first()?;
    let sets = notes.count(first.number, "number of sets", first.first())?;
    let mut rest = lines.get(1..).unwrap_or_default();
    let mut found = None;
    for set in 1..=sets {
        let Some((head, after)) = rest.split_first() else {
            notes.cut(
                lines.len(),
                &format!("set {set} of {sets}"),
                "a line \"index rows\"",
            );
            return None;
        };
        let words: Vec<_> = head.words().take(2).collect();
        let [_, count] = words[..] else {
            notes.wrong(
                head.number,
                [
                    "first line of a set",
                    head.text,
                    "\"index rows\"",
                    "the count of rows before may be wrong",
                ],
            );
            return None;
        };
        let count = notes.count(head.number, "number of rows", count)?;
        let rows = after.get(..count.min(after.len())).unwrap_or_default();
        if rows.len() < count {
            notes.cut(
                rows.last().map_or(head.number, |row| row.number),
                &format!("set {set}"),
                &format!("{count} rows, found {}", rows.len()),
            );
        }
        let stations: Vec<_> = rows
            .iter()
            .filter_map(|line| station(line, notes))
            .collect();
        if set == wanted {
            found = Some(stations);
        }
        rest = after.get(rows.len()..).unwrap_or_default();
    }
    check_rest(rest, notes);
    if sets > 1 && options.set.is_none() {
        notes.remark(0, &format!("the file has {sets} sets; the first is read"));
    }
    if found.is_none() {
        let help = format!("the file has {sets} sets");
        notes.missing(0, &format!("set {wanted}"), &help);
    }
    if !options.has_twist {
        notes.remark(0, "the twist is not in this file: it is zero");
    }
    found.map(|stations| BladeAero::of(BladeFormat::Hawc2Ae, SpanOrigin::RootAlongCurve, stations))
}

/// Notes numbers after the last set.
fn check_rest(rest: &[Line<'_>], notes: &mut Notes) {
    if let Some(line) = rest.first().filter(|line| number(line.first()).is_some()) {
        let help = "the number of rows or sets may be wrong";
        let expected = "the end of the file";
        notes.wrong(line.number, ["HAWC2 ae file", line.text, expected, help]);
    }
}

/// A station of a row.
fn station(line: &Line<'_>, notes: &mut Notes) -> Option<AeroStation> {
    let words: Vec<_> = line.words().take(4).collect();
    let [span, chord, percent, set] = words[..] else {
        let found = format!("{} numbers", words.len());
        notes.wrong(
            line.number,
            [
                "row of the layout",
                &found,
                "4: length, chord, thickness in per cent, set",
                "the line may have been cut off",
            ],
        );
        return None;
    };
    let [span, chord, percent] = [("length", span), ("chord", chord), ("thickness", percent)]
        .map(|(what, word)| notes.number(line.number, what, word));
    let set = notes.count(line.number, "set of profiles", set);
    Some(AeroStation {
        thickness: Some(percent? / 100.0),
        reference_point: 0.5,
        airfoil: StationAirfoil::ByThickness(set?),
        ..AeroStation::plain(span?, chord?, 0.0)
    })
}
