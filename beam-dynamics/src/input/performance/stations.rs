//! Stations of the blades of a rotor, as the file lists them.

use rotor_aero::airfoil::Section;
use rotor_aero::rotor::Station;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{NotNegative, Positive, Quantity};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use crate::input::aerodynamics::Airfoils;
use crate::input::aerodynamics::family::{self, AIRFOIL, Family, THICKNESS};

keys! {
    /// A station of the blades.
    pub(super) CARD = "stations = [{ ... }, ...]";
    /// Distance from the shaft along the axis of the blade.
    R: f64 = "r", [NotNegative(Dimension::LENGTH)], required, "12.5";
    /// Chord.
    CHORD: f64 = "chord", [Positive(Dimension::LENGTH)], required, "4.2";
    /// Angle of the chord to the plane of rotation at zero pitch: of turbines towards feather,
    /// of other machines nose up.
    TWIST: f64 = "twist", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "11.5";
    /// Offset from the axis of the blade, downwind positive.
    PREBEND: f64 = "prebend", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "-0.4";
    with AIRFOIL.schema, THICKNESS.schema;
}

/// Reads the stations under a key.
pub(super) fn read(
    table: &Table<'_>,
    key: &'static str,
    airfoils: &Airfoils,
) -> Option<Vec<Station<Section>>> {
    let tables = table.tables(key);
    let family = Family::read(table, airfoils, "the rotor");
    let read = tables.iter().enumerate().map(|(index, table)| {
        let station = station(table, (airfoils, family.as_ref()), index + 1);
        table.finish();
        station
    });
    let read: Vec<_> = read.collect();
    let by_thickness = tables.iter().any(|table| table.has(&THICKNESS));
    family::note_unused(table, family.as_ref(), by_thickness);
    family.as_ref()?;
    if tables.len() < 2 {
        let found = tables.len();
        table.note(key, &PerformanceProblem::FewStations { found });
        return None;
    }
    let stations: Vec<_> = read.into_iter().collect::<Option<_>>()?;
    let mut sound = true;
    for (index, pair) in stations.windows(2).enumerate() {
        if pair[1].radius <= pair[0].radius {
            let problem = PerformanceProblem::Order {
                number: index + 2,
                found: pair[1].radius,
                before: pair[0].radius,
            };
            tables[index + 1].note(&R, &problem);
            sound = false;
        }
    }
    sound.then_some(stations)
}

fn station(
    table: &Table<'_>,
    airfoils: (&Airfoils, Option<&Option<Family>>),
    number: usize,
) -> Option<Station<Section>> {
    let (radius, chord) = (table.get(&R), table.get(&CHORD));
    let (twist, prebend) = (table.get(&TWIST), table.get(&PREBEND));
    let section = family::of_station(table, airfoils, &format!("station {number}"));
    Some(Station {
        radius: radius?,
        chord: chord?,
        twist: twist?,
        prebend: prebend?,
        section: section?.0,
    })
}
