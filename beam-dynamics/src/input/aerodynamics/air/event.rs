//! Events of IEC 61400-1: `[air.event]`.

use rotor_aero::wind::{Event, EventShape, IecTurbine, TurbulenceCategory, WindClass};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Boolean, Positive, Quantity, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::mean::MeanCard;
use super::problem::AirProblem;

keys! {
    /// An extreme event of IEC 61400-1, for the class of a turbine and the speed of the mean wind at
    /// the hub.
    pub(super) CARD = "[air.event]";
    /// Operating gust (EOG), direction change (EDC), coherent gust with direction change (ECD),
    /// vertical or horizontal shear (EWS).
    KIND: usize = "kind", [Word(&["EOG", "EDC", "ECD", "EWS vertical", "EWS horizontal"])],
        required, "\"EOG\"";
    /// Class of the turbine; of class S, the reference speed is given.
    CLASS: usize = "class", [Word(&["I", "II", "III", "S"])], required, "\"I\"";
    /// Category of turbulence; of category S, the intensity is given.
    CATEGORY: usize = "category", [Word(&["A", "B", "C", "S"])], required, "\"A\"";
    /// Reference speed of class S, averaged over 10 minutes.
    REFERENCE_SPEED: Option<f64> = "reference_speed", [Positive(Dimension::VELOCITY)], optional,
        "45";
    /// Turbulence intensity of category S, at 15 m/s.
    INTENSITY: Option<f64> = "intensity", [Positive(Dimension::NUMBER)], optional, "0.18";
    /// Height of the hub above the ground.
    HUB_HEIGHT: f64 = "hub_height", [Positive(Dimension::LENGTH)], required, "90";
    /// Diameter of the rotor.
    DIAMETER: f64 = "diameter", [Positive(Dimension::LENGTH)], required, "126";
    /// Time at which it begins.
    START: f64 = "start", [Quantity(Dimension::TIME)], or "0" = 0.0, "10";
    /// Whether direction change and shear have the other sign.
    REVERSED: bool = "reversed", [Boolean], or "false" = false, "true";
}

/// Reads the table. Without a mean wind, only the keys are checked.
pub(super) fn read(table: &Table<'_>, mean: Option<&MeanCard>) -> Option<Event> {
    let (kind, turbine) = (table.get(&KIND), turbine(table));
    let (start, reversed) = (table.get(&START), table.get(&REVERSED));
    table.finish();
    let (kind, turbine, start) = (kind?, turbine?, start?);
    let sign = if reversed? { -1.0 } else { 1.0 };
    let speed = mean?.speed(turbine.hub_height, start);
    if speed.is_nan() || speed <= 0.0 {
        table.note(
            &KIND,
            &AirProblem::Value {
                key: "speed",
                found: format!("{speed} m/s at the hub"),
                expected: "a positive speed, by which the standard scales an event".to_owned(),
                help: "give \"speed\" in [air.wind]",
            },
        );
        return None;
    }
    let shape = shape(&turbine, kind, speed, sign);
    Some(Event { start, shape })
}

fn shape(turbine: &IecTurbine, kind: usize, speed: f64, sign: f64) -> EventShape {
    match kind {
        0 => turbine.operating_gust(speed),
        1 => turbine.direction_change(speed, sign),
        2 => turbine.coherent_gust(speed, sign),
        3 => turbine.vertical_shear(speed, sign),
        _ => turbine.horizontal_shear(speed, sign),
    }
}

fn turbine(table: &Table<'_>) -> Option<IecTurbine> {
    let (class, category) = (table.get(&CLASS), table.get(&CATEGORY));
    let (reference_speed, intensity) = (table.get(&REFERENCE_SPEED), table.get(&INTENSITY));
    let (hub_height, diameter) = (table.get(&HUB_HEIGHT), table.get(&DIAMETER));
    let (reference_speed, intensity) = (reference_speed?, intensity?);
    let class = match (class?, reference_speed) {
        (3, Some(reference_speed)) => Some(WindClass::Special { reference_speed }),
        (3, None) => missing(table, REFERENCE_SPEED.name(), "class S"),
        (_, Some(_)) => useless(table, REFERENCE_SPEED.name(), "the class has its own"),
        (0, None) => Some(WindClass::One),
        (1, None) => Some(WindClass::Two),
        (_, None) => Some(WindClass::Three),
    };
    let category = match (category?, intensity) {
        (3, Some(intensity)) => Some(TurbulenceCategory::Special { intensity }),
        (3, None) => missing(table, INTENSITY.name(), "category S"),
        (_, Some(_)) => useless(table, INTENSITY.name(), "the category has its own"),
        (0, None) => Some(TurbulenceCategory::A),
        (1, None) => Some(TurbulenceCategory::B),
        (_, None) => Some(TurbulenceCategory::C),
    };
    Some(IecTurbine {
        class: class?,
        category: category?,
        hub_height: hub_height?,
        diameter: diameter?,
    })
}

fn missing<T>(table: &Table<'_>, key: &'static str, user: &'static str) -> Option<T> {
    table.note(key, &AirProblem::Missing { key, user });
    None
}

fn useless<T>(table: &Table<'_>, key: &'static str, reason: &'static str) -> Option<T> {
    table.note(key, &AirProblem::Useless { key, reason });
    None
}
