//! The air: `[air]`.

use nalgebra::Vector3;
use rotor_aero::strip::AirProperties;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Quantity, Vector};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::elements::strips::Air;

keys! {
    /// The air in which blades and bodies with `[[strip]]` move.
    pub(in crate::input) CARD = "[air]";
    /// Altitude, from which the standard atmosphere gives all properties that are not given.
    ALTITUDE: f64 = "altitude", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "1500";
    /// Density.
    DENSITY: Option<f64> = "density", [Positive(Dimension::DENSITY)], or "by `altitude`", "1.225";
    /// Speed of sound.
    SPEED_OF_SOUND: Option<f64> = "speed_of_sound", [Positive(Dimension::VELOCITY)],
        or "by `altitude`", "340";
    /// Dynamic viscosity.
    VISCOSITY: Option<f64> = "viscosity", [Positive(Dimension::VISCOSITY)], or "by `altitude`",
        "1.81e-5";
    /// Velocity of the wind.
    WIND: Vector3<f64> = "wind", [Vector(3, Dimension::VELOCITY)],
        or "[0, 0, 0]" = Vector3::zeros(), "[8, 0, 0]";
}

/// Reads `[air]`: `None` if it is wrong, standard air at sea level if absent.
pub(super) fn read(root: &Table<'_>) -> Option<Air> {
    let Some(table) = root.has("air").then(|| root.table("air")) else {
        return Some(Air::standard(0.0));
    };
    let table = table?;
    let altitude = table.get(&ALTITUDE);
    let [density, sound, viscosity] =
        [&DENSITY, &SPEED_OF_SOUND, &VISCOSITY].map(|key| table.get(key));
    let wind = table.get(&WIND);
    table.finish();
    let standard = Air::standard(altitude?);
    Some(Air {
        properties: AirProperties {
            density: density?.unwrap_or(standard.properties.density),
            speed_of_sound: sound?.unwrap_or(standard.properties.speed_of_sound),
            viscosity: viscosity?.unwrap_or(standard.properties.viscosity),
            acting: 1.0,
        },
        wind: wind?,
    })
}
