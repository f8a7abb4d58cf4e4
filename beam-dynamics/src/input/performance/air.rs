//! The air of a rotor: `[air]`.

use rotor_aero::wind::{Atmosphere, AtmosphereInput};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Quantity};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// The air in which the rotor works.
    pub(super) CARD = "[air]";
    /// Altitude, from which the standard atmosphere gives all properties that are not given.
    ALTITUDE: f64 = "altitude", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "1500";
    /// Difference to the temperature of the standard atmosphere.
    OFFSET: f64 = "temperature_offset", [Quantity(Dimension::TEMPERATURE)], or "0" = 0.0, "20";
    /// Density.
    DENSITY: Option<f64> = "density", [Positive(Dimension::DENSITY)], or "by `altitude`", "1.225";
    /// Speed of sound.
    SPEED_OF_SOUND: Option<f64> = "speed_of_sound", [Positive(Dimension::VELOCITY)],
        or "by `altitude`", "340";
    /// Dynamic viscosity.
    VISCOSITY: Option<f64> = "viscosity", [Positive(Dimension::VISCOSITY)], or "by `altitude`",
        "1.81e-5";
}

/// Reads `[air]`: `None` if it is wrong, standard air at sea level if absent.
pub(super) fn read(root: &Table<'_>) -> Option<Atmosphere> {
    let Some(table) = root.has("air").then(|| root.table("air")) else {
        return Some(Atmosphere::default());
    };
    let table = table?;
    let [altitude, offset] = [&ALTITUDE, &OFFSET].map(|key| table.get(key));
    let given = [&DENSITY, &SPEED_OF_SOUND, &VISCOSITY].map(|key| table.get(key));
    table.finish();
    let [density, sound_speed, viscosity] = given;
    let input = AtmosphereInput {
        altitude: altitude?,
        temperature_offset: offset?,
        density: density?,
        temperature: None,
        sound_speed: sound_speed?,
        viscosity: viscosity?,
    };
    match input.atmosphere() {
        Ok(air) => Some(air),
        Err(problems) => {
            for problem in &problems {
                table.note("altitude", problem);
            }
            None
        }
    }
}
