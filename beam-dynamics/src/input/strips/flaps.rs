//! Flaps and trim tabs of strips: `flaps` of `[blade.aerodynamics]` and `[[strip]]`.

use rotor_aero::airfoil::PlainFlap;
use rotor_aero::strip::Flap as FlapLaw;
use shared_geom::document::schema::ValueKind::{Drive, NotNegative, Positive, Tables};
use shared_geom::document::{ByHand, Table};
use shared_geom::error::Explain;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::stations::Stations;
use crate::elements::Signal;
use crate::input::drives::{Catalog, read_signal};
use crate::input::short_number;

keys! {
    /// Flaps, each on a part of the span.
    pub(super) FLAPS: ByHand = "flaps", [Tables(&CARD)], optional, "";
}

keys! {
    /// A flap or a trim tab at the trailing edge.
    pub(super) CARD = "flaps = [{ ... }, ...]";
    /// Its beginning along the line, as `at` of the stations.
    FROM: f64 = "from", [NotNegative(Dimension::LENGTH)], required, "8";
    /// Its end along the line.
    TO: f64 = "to", [Positive(Dimension::LENGTH)], required, "10";
    /// Deflection, trailing edge down positive.
    DEFLECTION: ByHand = "deflection", [Drive(Dimension::ANGLE)], required, "\"= 2*cos(4*t)\"";
    /// Part of the chord behind the hinge of a plain flap, by thin-airfoil theory; without it the
    /// tables of the airfoils have deflections.
    CHORD: Option<f64> = "chord", [Positive(Dimension::NUMBER)], optional, "0.2";
}

/// A flap.
#[derive(Debug, Clone)]
pub(super) struct Flap {
    /// Arc lengths at its ends \[m\].
    pub range: [f64; 2],
    /// Its effect on the section.
    pub law: FlapLaw,
    /// Deflection, trailing edge down \[rad\].
    pub deflection: Signal,
}

impl Flap {
    /// Whether it is at a position \[m\].
    pub fn is_at(&self, position: f64) -> bool {
        self.range[0] < position && position < self.range[1]
    }
}

/// Digits of positions in messages.
const DIGITS: usize = 6;
/// Part of the span by which a flap may end beyond the stations: digits lost in the input.
const ROUNDING: f64 = 1e-6;
/// Number of positions at which the airfoils of a flap are checked.
const CHECKED: u32 = 200;

/// A problem of a flap.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
enum FlapProblem {
    #[error(
        "the flap is from {} m to {} m, expected an end after the beginning",
        short_number(range[0], DIGITS),
        short_number(range[1], DIGITS)
    )]
    Backward { range: [f64; 2] },
    #[error(
        "the flap is from {} m to {} m, expected a part of the stations, {} m to {} m",
        short_number(range[0], DIGITS),
        short_number(range[1], DIGITS),
        short_number(stations[0], DIGITS),
        short_number(stations[1], DIGITS)
    )]
    Outside { range: [f64; 2], stations: [f64; 2] },
    #[error(
        "the flap begins at {} m, expected at least {} m, the end of the flap before it",
        short_number(*found, DIGITS),
        short_number(*end, DIGITS)
    )]
    Overlap { found: f64, end: f64 },
    #[error(
        "the flap is {} of the chord, expected more than 0 and at most 1",
        short_number(*found, DIGITS)
    )]
    Part { found: f64 },
    #[error("airfoil \"{airfoil}\" has no deflections of a flap in its table")]
    NoTable { airfoil: String },
    #[error(
        "the deflection is {} deg, expected {} to {} deg, the deflections of airfoil \"{airfoil}\"",
        short_number(found.to_degrees(), DIGITS),
        short_number(range[0].to_degrees(), DIGITS),
        short_number(range[1].to_degrees(), DIGITS)
    )]
    Beyond {
        found: f64,
        range: [f64; 2],
        airfoil: String,
    },
}

impl Explain for FlapProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Backward { .. } => "\"from\" is nearer to the root than \"to\"",
            Self::Outside { .. } => "positions are arc lengths from the root, as \"at\"",
            Self::Overlap { .. } => "order the flaps from the root to the tip, and do not overlap",
            Self::Part { .. } => "usual are 0.1 to 0.3",
            Self::NoTable { .. } => {
                "add chord = PART for a plain flap, or use a table with a column of deflections"
            }
            Self::Beyond { .. } => "add deflections to the table, or deflect the flap less",
        };
        Some(text.to_owned())
    }
}

/// Reads the flaps of a card on its stations, if they are known.
pub(super) fn read(
    table: &Table<'_>,
    stations: Option<&Stations>,
    catalog: &Catalog,
) -> Option<Vec<Flap>> {
    let tables = table.tables(&FLAPS);
    let flaps = tables.iter().map(|table| {
        let flap = flap(table, stations, catalog);
        table.finish();
        flap
    });
    let flaps: Vec<_> = flaps.collect();
    let flaps: Vec<Flap> = flaps.into_iter().collect::<Option<_>>()?;
    for (pair, table) in flaps.windows(2).zip(tables.iter().skip(1)) {
        let (found, end) = (pair[1].range[0], pair[0].range[1]);
        if found < end {
            table.note(&FROM, &FlapProblem::Overlap { found, end });
            return None;
        }
    }
    Some(flaps)
}

fn flap(table: &Table<'_>, stations: Option<&Stations>, catalog: &Catalog) -> Option<Flap> {
    let range = [table.get(&FROM), table.get(&TO)];
    let deflection = table
        .require_item(&DEFLECTION, &Dimension::ANGLE.to_string())
        .and_then(|_| read_signal(table, &DEFLECTION.schema, catalog));
    let law = match table.get(&CHORD)? {
        None => Some(FlapLaw::OfTables),
        Some(found) => {
            let plain = PlainFlap::new(found);
            if plain.is_none() {
                table.note(&CHORD, &FlapProblem::Part { found });
            }
            plain.map(FlapLaw::Plain)
        }
    };
    let range = [range[0]?, range[1]?];
    if range[1] <= range[0] {
        table.note(&TO, &FlapProblem::Backward { range });
        return None;
    }
    let flap = Flap {
        range,
        law: law?,
        deflection: deflection?,
    };
    match stations.map_or(Ok(()), |stations| check(&flap, stations)) {
        Ok(()) => Some(flap),
        Err(problem) => {
            let key = match problem {
                FlapProblem::Beyond { .. } => DEFLECTION.name(),
                FlapProblem::Outside { .. } => TO.name(),
                _ => "",
            };
            table.note(key, &problem);
            None
        }
    }
}

/// Checks a flap with the stations and their airfoils.
fn check(flap: &Flap, stations: &Stations) -> Result<(), FlapProblem> {
    let [from, to] = flap.range;
    let first = stations.positions().next().unwrap_or_default();
    let last = stations.positions().last().unwrap_or_default();
    let slack = ROUNDING * (last - first);
    if from < first - slack || to > last + slack {
        return Err(FlapProblem::Outside {
            range: flap.range,
            stations: [first, last],
        });
    }
    if flap.law != FlapLaw::OfTables {
        return Ok(());
    }
    let positions = (0..CHECKED).map(|k| {
        let part = (f64::from(k) + 0.5) / f64::from(CHECKED);
        from + part * (to - from)
    });
    for between in positions.filter_map(|position| stations.at(position)) {
        for (_, airfoil) in between.airfoil.parts() {
            let name = || airfoil.name().to_owned();
            let Some(range) = airfoil.flap_range() else {
                return Err(FlapProblem::NoTable { airfoil: name() });
            };
            let constant = flap.deflection.constant();
            if let Some(found) = constant.filter(|angle| *angle < range[0] || *angle > range[1]) {
                let airfoil = name();
                return Err(FlapProblem::Beyond {
                    found,
                    range,
                    airfoil,
                });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
#[path = "flaps_tests.rs"]
mod tests;
