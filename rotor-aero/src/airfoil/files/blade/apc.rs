//! Propeller geometry of APC: files PE0 in inches and degrees.
//!
//! Rows of 13 numbers: station, chord, three pitches, sweep, thickness over chord, twist (nose
//! up), largest thickness, area, and three heights; then lines RADIUS, HUBTRA, BLADES, AIRFOIL1
//! and AIRFOIL2 with the radii of the transition between both airfoils, which is linear. Sweep is
//! the offset of the leading edge in the direction of rotation.

use shared_geom::exchange::text::{Line, lines, number};

use super::super::notes::Notes;
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin, StationAirfoil};

/// Meters of an inch.
pub(super) const INCH: f64 = 0.0254;

/// Numbers of a row.
const COLUMNS: usize = 13;

/// Whether `text` has the heading of a geometry.
pub(super) fn recognize(text: &str) -> bool {
    text.contains("AIRFOIL SUMMARY DATA")
        || text
            .lines()
            .any(|line| line.trim_start().starts_with("HUBTRA:"))
}

/// An airfoil, and the radius at which the transition begins or ends [m].
struct Transition {
    radius: f64,
    name: String,
}

/// Reads the propeller of a file.
pub(super) fn read(text: &str, _: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let lines = lines(text);
    let is_number = |line: &Line<'_>| line.words().all(|word| number(word).is_some());
    let units = lines.iter().position(|line| line.text.starts_with("(IN)"));
    if units.is_none() {
        notes.missing(
            0,
            "the line of units, \"(IN) (IN) (QUOTED) ...\"",
            "the file may have been cut off",
        );
    }
    let rest = lines
        .get(units.map_or(0, |at| at + 1)..)
        .unwrap_or_default();
    let end = rest
        .iter()
        .position(|line| line.text.contains(':'))
        .unwrap_or(rest.len());
    let (rows, tail) = rest.split_at(end);
    let mut stations: Vec<_> = rows
        .iter()
        .filter_map(|line| station(line, notes))
        .collect();
    if let Some(line) = tail.iter().find(|line| is_number(line)) {
        notes.wrong(
            line.number,
            [
                "APC geometry",
                line.text,
                "a heading or a value",
                "put all rows under the titles",
            ],
        );
    }
    let radius = value(tail, "RADIUS:", notes);
    let hub = value(tail, "HUBTRA:", notes);
    let blades = value(tail, "BLADES:", notes);
    let (first, second) = (
        transition(tail, "AIRFOIL1:", notes),
        transition(tail, "AIRFOIL2:", notes),
    );
    if let (Some(first), Some(second)) = (&first, &second) {
        for station in &mut stations {
            station.airfoil = blend(station.span, first, second);
        }
    }
    let mut blade = BladeAero::of(BladeFormat::Apc, SpanOrigin::RotationAxis, stations);
    blade.name = lines
        .first()
        .map(|line| line.first().to_owned())
        .unwrap_or_default();
    blade.blades = blades.and_then(|count| whole(count, notes));
    blade.tip_radius = radius.map(|radius| radius * INCH);
    blade.hub_radius = hub.map(|radius| radius * INCH);
    Some(blade)
}

/// A number of blades; notes another number.
fn whole(count: f64, notes: &mut Notes) -> Option<usize> {
    if (1.0..=100.0).contains(&count) && count.fract() == 0.0 {
        return Some(count as usize);
    }
    let expected = "a whole number from 1 to 100";
    notes.wrong(
        0,
        [
            "BLADES",
            &count.to_string(),
            expected,
            "correct the line BLADES",
        ],
    );
    None
}

/// A station of a row.
fn station(line: &Line<'_>, notes: &mut Notes) -> Option<AeroStation> {
    let n: [f64; COLUMNS] = line.numbers("row of the geometry", &mut notes.problems)?;
    Some(AeroStation {
        sweep: n[5] * INCH,
        reference_point: 0.0,
        thickness: Some(n[6]),
        ..AeroStation::plain(n[0] * INCH, n[1] * INCH, n[7].to_radians())
    })
}

/// The words after a name, with their line.
fn after<'t>(lines: &[Line<'t>], name: &str, notes: &mut Notes) -> Option<(usize, &'t str)> {
    let found = lines
        .iter()
        .find_map(|line| Some((line.number, line.text.strip_prefix(name)?.trim())));
    if found.is_none() {
        notes.missing(
            0,
            &format!("the line {name}"),
            "the file may have been cut off",
        );
    }
    found
}

fn value(lines: &[Line<'_>], name: &str, notes: &mut Notes) -> Option<f64> {
    let (line, rest) = after(lines, name, notes)?;
    let word = rest.split_whitespace().next().unwrap_or_default();
    notes.number(line, name.trim_end_matches(':'), word)
}

fn transition(lines: &[Line<'_>], name: &str, notes: &mut Notes) -> Option<Transition> {
    let (line, rest) = after(lines, name, notes)?;
    let Some((radius, airfoil)) = rest.split_once(',') else {
        notes.wrong(
            line,
            [name, rest, "\"radius, airfoil\"", "write \"4.90, E63\""],
        );
        return None;
    };
    let radius = notes.number(line, name.trim_end_matches(':'), radius.trim())? * INCH;
    let name = airfoil
        .split('(')
        .next()
        .unwrap_or_default()
        .trim()
        .to_owned();
    Some(Transition { radius, name })
}

/// The airfoils at a radius: linear over the transition.
fn blend(radius: f64, first: &Transition, second: &Transition) -> StationAirfoil {
    let width = second.radius - first.radius;
    let part = if width > 0.0 {
        ((radius - first.radius) / width).clamp(0.0, 1.0)
    } else {
        f64::from(radius >= second.radius)
    };
    let parts = [
        (first.name.clone(), 1.0 - part),
        (second.name.clone(), part),
    ];
    StationAirfoil::Blend(parts.into_iter().filter(|(_, part)| *part > 0.0).collect())
}
