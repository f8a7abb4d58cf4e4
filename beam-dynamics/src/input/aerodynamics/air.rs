//! The air: `[air]`.

use nalgebra::Vector3;
use rotor_aero::wind::{Atmosphere, AtmosphereInput, MeanWind, Wind, WindProblem};
use shared_geom::document::schema::ValueKind::{
    Positive, Quantity, Table as OneTable, Tables, Vector, Word,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::elements::strips::Air;
use crate::input::drives;
use crate::input::number::short_number;

mod checks;
mod condition;
mod event;
mod gusts;
mod mean;
mod problem;
mod towers;
mod turbulence;

#[cfg(test)]
mod tests;

pub(in crate::input) use checks::{check_boxes, check_ground, check_mach, check_steady};
pub use problem::AirProblem;

use mean::MeanCard;

keys! {
    /// The air in which blades and bodies with strips move.
    pub(in crate::input) CARD = "[air]";
    /// Altitude of the ground, from which the standard atmosphere gives all properties that are not
    /// given.
    ALTITUDE: f64 = "altitude", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "1500";
    /// Difference to the temperature of the standard atmosphere at this altitude.
    TEMPERATURE_OFFSET: f64 = "temperature_offset", [Quantity(Dimension::TEMPERATURE)],
        or "0" = 0.0, "15";
    /// Density.
    DENSITY: Option<f64> = "density", [Positive(Dimension::DENSITY)], or "by `altitude`", "1.225";
    /// Speed of sound.
    SPEED_OF_SOUND: Option<f64> = "speed_of_sound", [Positive(Dimension::VELOCITY)],
        or "by `altitude`", "340";
    /// Dynamic viscosity.
    VISCOSITY: Option<f64> = "viscosity", [Positive(Dimension::VISCOSITY)], or "by `altitude`",
        "1.81e-5";
    /// Mach numbers of strips beyond the tables of their airfoils: an error, or the values of the
    /// last table.
    OUTSIDE_MACH: usize = "outside_mach", [Word(&["refuse", "hold"])],
        or "\"refuse\"" = 0, "\"hold\"";
    /// Velocity of the wind, or a table.
    WIND: ByHand = "wind", [Vector(3, Dimension::VELOCITY), OneTable(&mean::CARD)],
        or "[0, 0, 0]", "[8, 0, 0]";
    /// Gusts that travel.
    GUSTS: ByHand = "gust", [Tables(&gusts::CARD)], optional, "";
    /// A wind condition of IEC 61400-1.
    EVENT: ByHand = "event", [OneTable(&event::CARD)], optional, "";
    /// A turbulence box.
    TURBULENCE: ByHand = "turbulence", [OneTable(&turbulence::CARD)], optional, "";
    /// Towers that change the wind.
    TOWERS: ByHand = "tower", [Tables(&towers::CARD)], optional, "";
}

/// Reads `[air]`: `None` if it is wrong, standard air at sea level if absent. The default of the
/// vertical is opposite to `gravity` \[m/s^2\].
pub(super) fn read(
    root: &Table<'_>,
    gravity: &Vector3<f64>,
    drives: &drives::Catalog,
) -> Option<Air> {
    let Some(table) = root.has("air").then(|| root.table("air")) else {
        return Some(Air::default().refusing_mach());
    };
    let table = table?;
    let up = if gravity.norm() > 0.0 {
        -gravity.normalize()
    } else {
        Vector3::z()
    };
    let (atmosphere, wind) = (atmosphere(&table), wind(&table, &up, drives));
    let outside_mach = table.get(&OUTSIDE_MACH);
    table.finish();
    let air = Air::new(atmosphere?, wind?);
    Some(match outside_mach? {
        0 => air.refusing_mach(),
        _ => air,
    })
}

fn atmosphere(table: &Table<'_>) -> Option<Atmosphere> {
    let (altitude, temperature_offset) = (table.get(&ALTITUDE), table.get(&TEMPERATURE_OFFSET));
    let [density, sound_speed, viscosity] =
        [&DENSITY, &SPEED_OF_SOUND, &VISCOSITY].map(|key| table.get(key));
    let input = AtmosphereInput {
        altitude: altitude?,
        temperature_offset: temperature_offset?,
        density: density?,
        temperature: None,
        sound_speed: sound_speed?,
        viscosity: viscosity?,
    };
    match input.atmosphere() {
        Ok(atmosphere) => Some(atmosphere),
        Err(problems) => {
            for problem in &problems {
                let is_of_altitude =
                    matches!(problem, WindProblem::Value { what, .. } if what == ALTITUDE.name());
                if is_of_altitude {
                    table.note(&ALTITUDE, problem)
                } else {
                    table.note(&TEMPERATURE_OFFSET, problem)
                }
            }
            None
        }
    }
}

/// The wind of all tables. Every table is read, so that all problems are noted.
fn wind(table: &Table<'_>, up: &Vector3<f64>, drives: &drives::Catalog) -> Option<Wind> {
    let mean = mean_wind(table, up, drives);
    let known = mean.as_ref();
    let gusts = gusts::read(&table.tables(&GUSTS), known);
    let towers = towers::read(&table.tables(&TOWERS), known.map(|mean| &mean.frame));
    let has_box = table.has(&TURBULENCE);
    let condition = optional(table, EVENT.name(), |table| {
        event::read(table, known, has_box)
    });
    let turbulence = optional(table, TURBULENCE.name(), |table| {
        turbulence::read(table, known)
    });
    let (condition, boxes) = (condition?, turbulence?.into_iter());
    let (gusts, towers) = (gusts?, towers?);
    let MeanCard { frame, mean } = mean?;
    let mut wind = Wind {
        frame,
        mean,
        events: Vec::new(),
        gusts,
        boxes: boxes.collect(),
        towers,
    };
    if let Some(condition) = condition {
        condition::add(condition, &mut wind, table)?;
    }
    along_the_boxes(table, &wind)?;
    Some(wind)
}

/// Notes a constant turn of the mean wind beside turbulence, which is carried along the direction of the
/// wind and would no longer be along and across the mean wind.
fn along_the_boxes(table: &Table<'_>, wind: &Wind) -> Option<()> {
    if wind.boxes.is_empty() {
        return Some(());
    }
    let at = [0.0, 1.7, 23.0].map(|time| wind.mean.at(time));
    let mut is_sound = true;
    for (key, of) in [
        ("turn", (|mean| mean.direction) as fn(&MeanWind) -> f64),
        ("upflow", |mean| mean.upflow),
    ] {
        let [angle, later, last] = at.each_ref().map(of);
        if angle == 0.0 || angle != later || angle != last {
            continue;
        }
        is_sound = false;
        let problem = AirProblem::Value {
            key,
            found: format!("{} degrees", short_number(angle.to_degrees(), 6)),
            expected: "zero, since turbulence is carried along \"direction\"".to_owned(),
            help: if key == "turn" {
                "turn \"direction\" of [air.wind]: it turns the turbulence, too"
            } else {
                "incline \"up\" of [air.wind] against the vertical: it inclines the turbulence, too"
            },
        };
        table.note(&WIND, &problem);
    }
    is_sound.then_some(())
}

/// The content of a table in `table`: `Some(None)` if it is absent, `None` if it is wrong.
fn optional<T>(
    table: &Table<'_>,
    key: &str,
    read: impl FnOnce(&Table<'_>) -> Option<T>,
) -> Option<Option<T>> {
    if table.has(key) {
        read(&table.table(key)?).map(Some)
    } else {
        Some(None)
    }
}

fn mean_wind(table: &Table<'_>, up: &Vector3<f64>, drives: &drives::Catalog) -> Option<MeanCard> {
    if table.is_table(&WIND) {
        return mean::read(&table.table(&WIND)?, up, drives);
    }
    let velocity = if table.has(&WIND) {
        table.vector(WIND.name(), Dimension::VELOCITY)?
    } else {
        Vector3::zeros()
    };
    match MeanCard::of_velocity(&velocity, up) {
        Ok(mean) => Some(mean),
        Err(problem) => {
            table.note(&WIND, &problem);
            None
        }
    }
}
