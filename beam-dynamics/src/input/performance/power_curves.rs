//! Operating curves of turbines: `[[power_curve]]`.

use std::f64::consts::FRAC_PI_2;

use shared_geom::document::ByHand;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Quantities, Quantity, Table as OneTable};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use super::sweeps::{LOADS_AT, NAME};
use super::values::{self, RANGE, increasing};
use crate::case::{
    Abscissa, PerformancePart, PerformanceRequest, PowerCurve, RatedPower, RotorSpeedLaw,
};

keys! {
    /// The operating curve of a turbine with variable speed and pitch control: below rated power
    /// the speed of rotation follows a law at constant pitch; above it the pitch holds the power
    /// at the largest speed of rotation.
    pub(super) CARD = "[[power_curve]]";
    /// Speeds of the wind.
    SPEED: Option<Vec<f64>> = "speed", [Quantities(Dimension::VELOCITY), OneTable(&RANGE)],
        optional, "{ from = 3, to = 25, steps = 23 }";
    /// Power of the rotor that the pitch holds.
    RATED_POWER: Option<f64> = "rated_power", [Positive(Dimension::POWER)], or "no limit",
        "\"5.2966 MW\"";
    /// Least and largest speed of rotation.
    ROTOR_SPEEDS: ByHand = "rotor_speeds", [Quantities(Dimension::ROTATION_SPEED)], required,
        "[6.9, 12.1]";
    /// Pitch below rated power.
    PITCH: f64 = "pitch", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-1";
    /// Largest pitch of the search for rated power.
    LARGEST_PITCH: f64 = "largest_pitch", [Quantity(Dimension::ANGLE)], or "90" = FRAC_PI_2, "45";
    /// Law of the speed of rotation: a constant ratio of the speed of the tip to the wind.
    TIP_SPEED_RATIO: Option<f64> = "tip_speed_ratio", [Positive(Dimension::NUMBER)], optional,
        "7.55";
    /// Law of the speed of rotation: a torque of the load proportional to its square, in
    /// N m s^2/rad^2 on the shaft of the rotor.
    TORQUE_GAIN: Option<f64> = "torque_gain", [Positive(Dimension::NUMBER)], optional, "2.13e6";
    /// Law of the speed of rotation: a torque of the load by a table.
    TORQUE: ByHand = "torque", [OneTable(&TORQUE_TABLE)], optional, "";
    with NAME.schema, LOADS_AT.schema;
}

keys! {
    /// Torque of the load on the shaft of the rotor, linear between the values and constant
    /// outside.
    pub(super) TORQUE_TABLE = "torque = { ... }";
    /// Speeds of rotation, increasing.
    TABLE_SPEED: Vec<f64> = "rotor_speed", [Quantities(Dimension::ROTATION_SPEED)], required,
        "[6.9, 9, 11.7, 12.1]";
    /// Torques at these speeds.
    TABLE_TORQUE: Vec<f64> = "torque", [Quantities(Dimension::MOMENT)], required,
        "[0, 1.88e6, 3.2e6, 4.18e6]";
}

/// Reads a power curve; `usual` is its name if it has none.
pub(super) fn read(table: &Table<'_>, usual: String) -> Option<PerformancePart> {
    let (name, loads_at) = (table.get(&NAME), table.get(&LOADS_AT));
    let speeds = values::read(table, &SPEED);
    let limits = limits(table);
    let (rated, pitch) = (table.get(&RATED_POWER), table.get(&PITCH));
    let largest = table.get(&LARGEST_PITCH);
    let law = law(table);
    table.finish();
    let (pitch, largest) = (pitch?, largest?);
    let Some(speeds) = speeds? else {
        let (column, found) = (SPEED.name(), "no such key".to_owned());
        table.note(
            "",
            &PerformanceProblem::NoColumn {
                column,
                found,
                known: &[],
            },
        );
        return None;
    };
    let is_sound = increasing(table, SPEED.name(), &speeds);
    if largest <= pitch {
        table.wrong(&LARGEST_PITCH, "a pitch above \"pitch\"");
        return None;
    }
    let curve = PowerCurve {
        speeds,
        law: law?,
        rotor_speeds: limits?,
        pitch,
        rated: rated?.map(|power| RatedPower {
            power,
            largest_pitch: largest,
        }),
    };
    let part = PerformancePart {
        name: name?.unwrap_or(usual),
        request: PerformanceRequest::PowerCurve(curve),
        abscissa: Abscissa::Speed,
        curves: vec![String::new()],
        is_map: false,
        loads_at: loads_at?,
    };
    is_sound.then_some(part)
}

/// The least and the largest speed of rotation.
fn limits(table: &Table<'_>) -> Option<[f64; 2]> {
    let expected = "the least and the largest rotation speed, such as [6.9, 12.1]";
    table.require_item(&ROTOR_SPEEDS, expected)?;
    let key = ROTOR_SPEEDS.name();
    let found: [f64; 2] = table.array(key, Dimension::ROTATION_SPEED, expected)?;
    if found[0] < 0.0 || found[1] <= found[0] {
        table.wrong(key, expected);
        return None;
    }
    Some(found)
}

fn law(table: &Table<'_>) -> Option<RotorSpeedLaw> {
    let (ratio, gain) = (table.get(&TIP_SPEED_RATIO), table.get(&TORQUE_GAIN));
    let rows = table.has(&TORQUE).then(|| torque(table));
    let (ratio, gain) = (ratio?, gain?);
    match (ratio, gain, rows) {
        (Some(ratio), None, None) => Some(RotorSpeedLaw::TipSpeedRatio(ratio)),
        (None, Some(gain), None) => Some(RotorSpeedLaw::TorqueGain(gain)),
        (None, None, Some(rows)) => Some(RotorSpeedLaw::Torque(rows?)),
        (ratio, gain, rows) => {
            let given = [
                (ratio.is_some(), "\"tip_speed_ratio\""),
                (gain.is_some(), "\"torque_gain\""),
                (rows.is_some(), "\"torque\""),
            ];
            let given = given.iter().filter(|it| it.0).map(|it| it.1);
            let found = match given.collect::<Vec<_>>() {
                none if none.is_empty() => "none of them".to_owned(),
                several => several.join(" and "),
            };
            table.note("", &PerformanceProblem::Law { found });
            None
        }
    }
}

/// Rows of the table of the torque.
fn torque(table: &Table<'_>) -> Option<Vec<[f64; 2]>> {
    let table = table.table(&TORQUE)?;
    let (speeds, torques) = (table.get(&TABLE_SPEED), table.get(&TABLE_TORQUE));
    table.finish();
    let (speeds, torques) = (speeds?, torques?);
    if speeds.len() != torques.len() || speeds.is_empty() {
        let problem = PerformanceProblem::Lengths {
            key: TABLE_TORQUE.name(),
            found: torques.len(),
            expected: speeds.len(),
            longest: TABLE_SPEED.name(),
        };
        table.note(&TABLE_TORQUE, &problem);
        return None;
    }
    let sound = increasing(&table, TABLE_SPEED.name(), &speeds);
    let rows = speeds.into_iter().zip(torques);
    sound.then(|| rows.map(|row| [row.0, row.1]).collect())
}
