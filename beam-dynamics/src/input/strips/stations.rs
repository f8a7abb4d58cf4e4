//! Stations of a blade in the air: chord, twist and airfoil along the line.

use rotor_aero::airfoil::{Blend, BlendProblem, Section};
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Quantity, Tables};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::input::aerodynamics::family::{self, AIRFOIL, Family, THICKNESS};
use crate::input::aerodynamics::{Airfoils, MachLimit, StripProblem, mach_limits};
use crate::input::number::short_number;

keys! {
    /// Stations from the root to the tip; linear between them, and without air inboard of the first and outboard
    /// of the last one. A blade may have a `file` in their place.
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
    /// Distance of the line of the blade from the leading edge, in chords.
    AXIS: f64 = "axis", [Quantity(Dimension::NUMBER)], or "0.25" = 0.25, "0.3";
    with AIRFOIL.schema, THICKNESS.schema;
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

/// Part of a blade up to which a root without stations is usual.
const MOST_ROOT: f64 = 0.35;
/// Part of a blade at which the last station should be.
const LEAST_TIP: f64 = 0.97;

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

    /// A remark on a chord that is longer than the blade of `length` \[m\].
    pub fn remark_on_chord(&self, user: &str, length: f64) -> Option<String> {
        let chords = self.stations.iter().map(|station| station.chord);
        let chord = chords.fold(0.0, f64::max);
        let [shown, of_blade] = [chord, length].map(|x| short_number(x, 6));
        (chord > length).then(|| {
            format!(
                "{user}: the chord is {shown} m, more than the length of the blade, {of_blade} m: \
                 check the unit"
            )
        })
    }

    /// A remark on stations that leave much of the root, or some of the tip, of a blade of `length` \[m\]
    /// without forces of the air.
    pub fn remark_on_span(&self, user: &str, length: f64) -> Option<String> {
        let [from, to] = [self.stations.first()?.at, self.stations.last()?.at];
        let is_short = from > MOST_ROOT * length || to < LEAST_TIP * length;
        is_short.then(|| {
            let [from, to, length] = [from, to, length].map(|x| short_number(x, 6));
            format!(
                "{user}: the stations are from {from} to {to} m of its {length} m, and the rest has no \
                 forces of the air: check the unit and the origin of the positions"
            )
        })
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
    let family = Family::read(table, airfoils, user);
    let read: Vec<_> = tables
        .iter()
        .map(|table| {
            let station = station(table, (airfoils, family.as_ref()), user);
            table.finish();
            station
        })
        .collect();
    let by_thickness = tables.iter().any(|table| table.has(&THICKNESS));
    family::note_unused(table, family.as_ref(), by_thickness);
    if tables.len() < 2 {
        let found = tables.len();
        table.note(&STATIONS, &StripProblem::FewStations { found });
        return None;
    }
    let read: Vec<(Station, Option<f64>)> = read.into_iter().collect::<Option<_>>()?;
    let family = family?;
    let more = family
        .iter()
        .flat_map(|family| between(family, &read))
        .collect();
    let stations: Vec<Station> = read.into_iter().map(|station| station.0).collect();
    are_placed(&tables, &stations, length)?;
    match Stations::new(stations, more) {
        Ok(stations) => Some(stations),
        Err(problem) => {
            table.note(&STATIONS, &problem);
            None
        }
    }
}

/// Notes stations that do not ascend, or lie beyond a line of a length \[m\].
fn are_placed(tables: &[Table<'_>], stations: &[Station], length: f64) -> Option<()> {
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
    sound.then_some(())
}

/// Part of the length by which a station may lie beyond the end: digits lost in the input.
const ROUNDING: f64 = 1e-6;

/// Sections between stations whose thicknesses enclose the one of a profile of the family.
fn between(family: &Family, stations: &[(Station, Option<f64>)]) -> Vec<(f64, Section)> {
    let pairs = stations.windows(2);
    let pairs = pairs.filter_map(|pair| {
        let end = |(station, thickness): &(Station, Option<f64>)| Some([station.at, (*thickness)?]);
        Some([end(&pair[0])?, end(&pair[1])?])
    });
    pairs.flat_map(|ends| family.between(ends)).collect()
}

/// A station, and its thickness over chord if it has one in place of an airfoil \[-\].
fn station(
    table: &Table<'_>,
    airfoils: (&Airfoils, Option<&Option<Family>>),
    user: &str,
) -> Option<(Station, Option<f64>)> {
    let (at, chord) = (table.get(&AT), table.get(&CHORD));
    let (twist, axis) = (table.get(&TWIST), table.get(&AXIS));
    let (airfoil, thickness) = family::of_station(table, airfoils, user).unzip();
    let station = Station {
        at: at?,
        chord: chord?,
        twist: twist?,
        axis: axis?,
        airfoil: airfoil?,
    };
    Some((station, thickness?))
}
