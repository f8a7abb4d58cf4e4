//! Blade files of AeroDyn 15.
//!
//! The line NumBlNds has the number of stations, the line of titles begins with BlSpn, then one
//! line of units and the rows. Columns are found by their titles. Stations are aerodynamic
//! centers: BlSpn along the pitch axis from the root, BlCrvAC positive downwind, BlSwpAC positive
//! against the rotation, BlTwist positive towards feather, BlAFID from one.

use shared_geom::exchange::text::{Line, lines, number};

use super::super::notes::Notes;
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin, StationAirfoil};

/// Titles of the columns that are used.
const TITLES: [&str; 6] = [
    "BlSpn", "BlCrvAC", "BlSwpAC", "BlTwist", "BlChord", "BlAFID",
];

/// Whether `text` has the title of the first column.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(is_titles) || text.lines().any(is_count)
}

fn is_titles(line: &str) -> bool {
    line.split_whitespace()
        .next()
        .is_some_and(|word| word.eq_ignore_ascii_case(TITLES[0]))
}

fn is_count(line: &str) -> bool {
    line.split_whitespace()
        .nth(1)
        .is_some_and(|word| word.eq_ignore_ascii_case("NumBlNds"))
}

/// Reads the blade of a file.
pub(super) fn read(text: &str, _: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let lines = lines(text);
    let counted = lines.iter().find(|line| is_count(line.text));
    if counted.is_none() {
        notes.missing(
            0,
            "NumBlNds",
            "write the number of stations, \"50 NumBlNds\"",
        );
    }
    let count = counted.and_then(|line| notes.count(line.number, "NumBlNds", line.first()));
    let Some(titles) = lines.iter().position(|line| is_titles(line.text)) else {
        notes.missing(
            0,
            "the line of titles, \"BlSpn BlCrvAC ...\"",
            "the file may have been cut off",
        );
        return None;
    };
    let columns = columns(lines.get(titles)?, notes)?;
    let rest = lines.get(titles + 1..).unwrap_or_default();
    // The line of units.
    let rest = match rest.split_first() {
        Some((first, rest)) if number(first.first()).is_none() => rest,
        _ => rest,
    };
    let stations: Vec<_> = rest
        .iter()
        .filter_map(|line| station(line, &columns, notes))
        .collect();
    if let Some(count) = count.filter(|&count| count != rest.len()) {
        let found = format!("{} rows", rest.len());
        let help = "the file may have been cut off, or NumBlNds is wrong";
        notes.wrong(
            counted.map_or(0, |line| line.number),
            ["NumBlNds", &found, &count.to_string(), help],
        );
    }
    let mut blade = BladeAero::of(BladeFormat::AeroDyn15, SpanOrigin::Root, stations);
    blade.name = lines
        .get(1)
        .map(|line| line.text.to_owned())
        .unwrap_or_default();
    Some(blade)
}

/// The columns of [`TITLES`]; notes missing ones.
fn columns(line: &Line<'_>, notes: &mut Notes) -> Option<[usize; 6]> {
    let column = |title: &str| {
        line.words()
            .position(|word| word.eq_ignore_ascii_case(title))
    };
    let found = TITLES.map(column);
    for (title, _) in TITLES
        .iter()
        .zip(&found)
        .filter(|(_, column)| column.is_none())
    {
        notes.missing(
            line.number,
            &format!("column {title}"),
            "blades of AeroDyn 14 have other columns",
        );
    }
    let found: Option<Vec<usize>> = found.into_iter().collect();
    found?.try_into().ok()
}

/// A station of a row.
fn station(line: &Line<'_>, columns: &[usize; 6], notes: &mut Notes) -> Option<AeroStation> {
    let numbers = line.list("row of the blade", None, &mut notes.problems)?;
    let found: Vec<f64> = columns
        .iter()
        .filter_map(|&column| numbers.get(column).copied())
        .collect();
    let [span, prebend, against, feather, chord, index] = found[..] else {
        let found = format!("{} numbers", numbers.len());
        let help = "the line may have been cut off";
        notes.wrong(
            line.number,
            ["row of the blade", &found, "a number in every column", help],
        );
        return None;
    };
    if index < 1.0 || index.fract() != 0.0 || index > 1e6 {
        let help = "BlAFID is the index, from one, in the list AFNames of the main file";
        notes.wrong(
            line.number,
            ["BlAFID", &index.to_string(), "a whole number from 1", help],
        );
        return None;
    }
    Some(AeroStation {
        sweep: -against,
        prebend,
        aerodynamic_center: None,
        airfoil: StationAirfoil::Index(index as usize - 1),
        ..AeroStation::plain(span, chord, -feather.to_radians())
    })
}
