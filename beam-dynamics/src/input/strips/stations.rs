//! Stations of a blade in the air: chord, twist and airfoil along the line.

use rotor_aero::airfoil::{Blend, BlendProblem, Section};
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Quantity, Tables, Text};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::input::aerodynamics::{Airfoils, MachLimit, StripProblem, mach_limits};

keys! {
    /// Stations from the root to the tip, unless there is a `file`; linear between them.
    pub(super) STATIONS: ByHand = "stations", [Tables(&CARD)], optional, "";
}

keys! {
    /// A station of a blade in the air.
    pub(super) CARD = "stations = [{ ... }, ...]";
    /// Arc length from the root along the line.
    AT: f64 = "at", [NotNegative(Dimension::LENGTH)], required, "12.5";
    /// Chord.
    CHORD: f64 = "chord", [Positive(Dimension::LENGTH)], required, "4.2";
    /// Angle of the chord, nose up from the plane of rotation of the blade without pitch.
    TWIST: f64 = "twist", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-11.5";
    /// The airfoil: a name of `[airfoils]`, or a built-in one; blended linearly to the next station.
    AIRFOIL: String = "airfoil", [Text], required, "\"DU21\"";
    /// Distance of the line of the blade from the leading edge, in chords.
    AXIS: f64 = "axis", [Quantity(Dimension::NUMBER)], or "0.25" = 0.25, "0.3";
}

/// A station.
#[derive(Debug, Clone)]
pub(super) struct Station {
    /// Arc length from the root \[m\].
    pub at: f64,
    /// Chord \[m\].
    pub chord: f64,
    /// Twist, nose up \[rad\].
    pub twist: f64,
    /// Distance of the line from the leading edge, in chords \[-\].
    pub axis: f64,
    /// Airfoil.
    pub airfoil: Section,
}

/// The blade between two stations.
#[derive(Debug, Clone)]
pub(super) struct Between {
    /// Chord \[m\].
    pub chord: f64,
    /// Twist, nose up \[rad\].
    pub twist: f64,
    /// Distance of the line from the leading edge, in chords \[-\].
    pub axis: f64,
    /// Airfoil.
    pub airfoil: Section,
}

/// Stations in ascending order.
#[derive(Debug, Clone)]
pub(super) struct Stations {
    stations: Vec<Station>,
    airfoils: Blend,
}

impl Stations {
    /// Stations in ascending order, and airfoils at positions between them.
    ///
    /// # Errors
    /// Positions that do not ascend, and no station.
    pub fn new(stations: Vec<Station>, between: Vec<(f64, Section)>) -> Result<Self, BlendProblem> {
        let own = stations.iter();
        let own = own.map(|station| (station.at, station.airfoil.clone()));
        let mut sections: Vec<_> = own.chain(between).collect();
        sections.sort_by(|a, b| a.0.total_cmp(&b.0));
        let airfoils = Blend::along_span(sections)?;
        Ok(Self { stations, airfoils })
    }

    /// Positions of the stations \[m\]: between them the blade is smooth.
    pub fn positions(&self) -> impl Iterator<Item = f64> + '_ {
        self.stations.iter().map(|station| station.at)
    }

    /// Their sections.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        self.stations.iter().map(|station| &station.airfoil)
    }

    /// Largest Mach numbers of the tables; `radius` is the distance from the shaft at a position
    /// \[m\].
    pub fn mach_limits(&self, radius: impl Fn(f64) -> f64) -> Vec<MachLimit> {
        let stations = self.stations.iter();
        mach_limits(stations.map(|station| (radius(station.at), &station.airfoil)))
    }

    /// The blade at a position between the first and the last station \[m\].
    pub fn at(&self, position: f64) -> Option<Between> {
        let stations = &self.stations;
        let after = stations.partition_point(|station| station.at <= position);
        let after = after.clamp(1, stations.len().checked_sub(1)?.max(1));
        let (a, b) = (stations.get(after - 1)?, stations.get(after)?);
        let part = ((position - a.at) / (b.at - a.at)).clamp(0.0, 1.0);
        let mix = |a: f64, b: f64| a + part * (b - a);
        Some(Between {
            chord: mix(a.chord, b.chord),
            twist: mix(a.twist, b.twist),
            axis: mix(a.axis, b.axis),
            airfoil: self.airfoils.section(position).ok()?,
        })
    }
}

/// Reads the stations of a card for a line of the given length \[m\].
pub(super) fn read(
    table: &Table<'_>,
    airfoils: &Airfoils,
    (user, length): (&str, f64),
) -> Option<Stations> {
    let tables = table.tables(&STATIONS);
    let read: Vec<_> = tables
        .iter()
        .map(|table| {
            let station = station(table, airfoils, user);
            table.finish();
            station
        })
        .collect();
    if tables.len() < 2 {
        let found = tables.len();
        table.note(&STATIONS, &StripProblem::FewStations { found });
        return None;
    }
    let stations: Vec<Station> = read.into_iter().collect::<Option<_>>()?;
    let mut sound = true;
    for (index, pair) in stations.windows(2).enumerate() {
        if pair[1].at <= pair[0].at {
            let (found, before) = (pair[1].at, pair[0].at);
            let index = index + 1;
            let problem = StripProblem::Order {
                index,
                found,
                before,
            };
            tables[index].note(&AT, &problem);
            sound = false;
        }
    }
    for (index, station) in stations.iter().enumerate() {
        if station.at > length * (1.0 + ROUNDING) {
            let found = station.at;
            let problem = StripProblem::OffLine {
                index,
                found,
                length,
            };
            tables[index].note(&AT, &problem);
            sound = false;
        }
    }
    if !sound {
        return None;
    }
    match Stations::new(stations, Vec::new()) {
        Ok(stations) => Some(stations),
        Err(problem) => {
            table.note(&STATIONS, &problem);
            None
        }
    }
}

/// Part of the length by which a station may lie beyond the end: digits lost in the input.
const ROUNDING: f64 = 1e-6;

fn station(table: &Table<'_>, airfoils: &Airfoils, user: &str) -> Option<Station> {
    let (at, chord) = (table.get(&AT), table.get(&CHORD));
    let (twist, axis) = (table.get(&TWIST), table.get(&AXIS));
    let airfoil = table.get(&AIRFOIL);
    let airfoil = airfoils.find(&airfoil?, (table, AIRFOIL.name()), user);
    Some(Station {
        at: at?,
        chord: chord?,
        twist: twist?,
        axis: axis?,
        airfoil: airfoil?,
    })
}
