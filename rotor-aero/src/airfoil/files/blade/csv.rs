//! Columns with a header: `span [m]` from the root or `radius [m]` from the axis of rotation,
//! `chord [m]`, `twist [deg]` nose up or `feather [deg]` towards feather, and perhaps `airfoil`,
//! `thickness`, `axis`, `sweep [m]`, `prebend [m]`.
//!
//! A unit is in brackets or after an underscore, `chord_mm`; without it lengths are in m and
//! angles in deg. Lines that begin with `#` are comments. `axis` is the distance of the point to
//! which sweep and prebend refer from the leading edge, over chord, 0.25 if absent.

use shared_geom::exchange::text::Line;

use super::super::csv::header::{cells, content, separator};
use super::super::notes::Notes;
use super::BladeOptions;
use super::station::{AeroStation, BladeAero, BladeFormat, SpanOrigin, StationAirfoil};

/// Content of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Span,
    Radius,
    Chord,
    Twist,
    Feather,
    Airfoil,
    Thickness,
    Axis,
    Sweep,
    Prebend,
}

/// Names of the columns, in small letters.
const NAMES: [(Kind, &[&str]); 10] = [
    (Kind::Span, &["span", "s", "at"]),
    (Kind::Radius, &["radius", "r"]),
    (Kind::Chord, &["chord", "c"]),
    (Kind::Twist, &["twist"]),
    (Kind::Feather, &["feather", "twist to feather"]),
    (Kind::Airfoil, &["airfoil", "profile"]),
    (Kind::Thickness, &["thickness", "t/c"]),
    (Kind::Axis, &["axis"]),
    (Kind::Sweep, &["sweep"]),
    (Kind::Prebend, &["prebend"]),
];

/// Units, and their factors to m, rad and one.
const UNITS: [(&str, f64); 7] = [
    ("m", 1.0),
    ("mm", 1e-3),
    ("in", 0.0254),
    ("deg", std::f64::consts::PI / 180.0),
    ("rad", 1.0),
    ("-", 1.0),
    ("%", 1e-2),
];

/// A column that is used.
struct Column {
    kind: Kind,
    name: String,
    factor: f64,
}

/// Whether the first line of content names a position and the chord.
pub(super) fn recognize(text: &str) -> bool {
    let lines = content(text);
    let Some(first) = lines
        .first()
        .filter(|line| line.text.contains([',', ';', '\t']))
    else {
        return false;
    };
    let kinds: Vec<_> = names(first.text)
        .iter()
        .filter_map(|(name, _)| kind_of(name))
        .collect();
    kinds.contains(&Kind::Chord) && (kinds.contains(&Kind::Span) || kinds.contains(&Kind::Radius))
}

fn kind_of(name: &str) -> Option<Kind> {
    let found = NAMES.iter().find(|(_, names)| names.contains(&name));
    found.map(|(kind, _)| *kind)
}

/// Names and units of the columns, in small letters.
fn names(header: &str) -> Vec<(String, String)> {
    let split = |cell: String| {
        let cell = cell.to_lowercase();
        if let Some((name, unit)) = cell.split_once(['[', '(']) {
            let unit = unit.trim_end_matches([']', ')']).trim();
            return (name.trim().to_owned(), unit.to_owned());
        }
        match cell.rsplit_once('_') {
            Some((name, unit)) if UNITS.iter().any(|known| known.0 == unit) => {
                (name.replace('_', " "), unit.to_owned())
            }
            _ => (cell.replace('_', " "), String::new()),
        }
    };
    let cells = cells(header, separator(header)).into_iter();
    cells.map(split).collect()
}

/// Reads the blade of a file.
pub(super) fn read(text: &str, _: &BladeOptions, notes: &mut Notes) -> Option<BladeAero> {
    let lines = content(text);
    let (first, rest) = lines.split_first()?;
    let columns = columns(first, notes);
    let has = |kind: Kind| columns.iter().flatten().any(|column| column.kind == kind);
    for (kinds, expected) in [
        (
            [Kind::Span, Kind::Radius],
            "one of the columns \"span\" and \"radius\"",
        ),
        (
            [Kind::Twist, Kind::Feather],
            "one of the columns \"twist\" and \"feather\"",
        ),
    ] {
        let found = match kinds.map(has) {
            [false, false] => "none",
            [true, true] => "both",
            _ => continue,
        };
        let help =
            "twist is nose up, feather nose down; span begins at the root, radius at the axis";
        notes.wrong(first.number, ["the header", found, expected, help]);
    }
    let origin = if has(Kind::Radius) {
        SpanOrigin::RotationAxis
    } else {
        SpanOrigin::Root
    };
    let separator = separator(first.text);
    let stations = rest
        .iter()
        .filter_map(|line| station(line, separator, &columns, notes));
    let stations = stations.collect();
    Some(BladeAero::of(BladeFormat::Csv, origin, stations))
}

/// The columns of the header; notes unknown units, and remarks on unknown names.
fn columns(line: &Line<'_>, notes: &mut Notes) -> Vec<Option<Column>> {
    let mut columns: Vec<Option<Column>> = Vec::new();
    for (name, unit) in names(line.text) {
        let Some(kind) = kind_of(&name) else {
            notes.remark(line.number, &format!("column \"{name}\" is not used"));
            columns.push(None);
            continue;
        };
        let usual = match kind {
            Kind::Twist | Kind::Feather => "deg",
            Kind::Thickness | Kind::Axis => "-",
            _ => "m",
        };
        let unit = if unit.is_empty() {
            usual
        } else {
            unit.as_str()
        };
        let fits = match kind {
            Kind::Twist | Kind::Feather => ["deg", "rad"].contains(&unit),
            Kind::Thickness | Kind::Axis => ["-", "%"].contains(&unit),
            _ => ["m", "mm", "in"].contains(&unit),
        };
        let factor = UNITS.iter().find(|known| known.0 == unit && fits);
        if factor.is_none() && kind != Kind::Airfoil {
            let what = format!("unit of column \"{name}\"");
            let help = "lengths are in m, mm or in, angles in deg or rad, ratios in - or %";
            notes.wrong(line.number, [&what, &format!("\"{unit}\""), usual, help]);
        }
        let factor = factor.map_or(1.0, |known| known.1);
        columns.push(Some(Column { kind, name, factor }));
    }
    columns
}

/// A station of a row.
fn station(
    line: &Line<'_>,
    separator: char,
    columns: &[Option<Column>],
    notes: &mut Notes,
) -> Option<AeroStation> {
    let cells = cells(line.text, separator);
    if cells.len() != columns.len() {
        let found = format!("{} cells", cells.len());
        let expected = format!("{}, as in the header", columns.len());
        let help = "the line may have been cut off";
        notes.wrong(line.number, ["row of the blade", &found, &expected, help]);
        return None;
    }
    let mut station = AeroStation::plain(f64::NAN, f64::NAN, 0.0);
    let mut sound = true;
    for (column, cell) in columns.iter().zip(&cells) {
        let Some(column) = column else { continue };
        if column.kind == Kind::Airfoil {
            if !cell.is_empty() {
                station.airfoil = StationAirfoil::Blend(vec![(cell.clone(), 1.0)]);
            }
            continue;
        }
        let Some(value) = notes.number(line.number, &column.name, cell) else {
            sound = false;
            continue;
        };
        set(&mut station, column.kind, value * column.factor);
    }
    (sound && station.span.is_finite() && station.chord.is_finite()).then_some(station)
}

fn set(station: &mut AeroStation, kind: Kind, value: f64) {
    match kind {
        Kind::Span | Kind::Radius => station.span = value,
        Kind::Chord => station.chord = value,
        Kind::Twist => station.twist = value,
        Kind::Feather => station.twist = -value,
        Kind::Thickness => station.thickness = Some(value),
        Kind::Axis => station.reference_point = value,
        Kind::Sweep => station.sweep = value,
        Kind::Prebend => station.prebend = value,
        Kind::Airfoil => {}
    }
}
