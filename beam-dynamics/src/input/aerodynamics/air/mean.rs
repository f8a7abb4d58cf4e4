//! Axes of the wind and mean wind: `wind` of `[air]`, a velocity or a table.

use std::sync::Arc;

use nalgebra::Vector3;
use rotor_aero::wind::{
    Mean, MeanWind, Shear, Wind, WindFrame, WindOverTime, WindProblem, read_uniform_wind,
};
use shared_geom::document::schema::ValueKind::{
    Drive as OneDrive, Positive, Quantity, Text, Vector,
};
use shared_geom::document::{ByHand, Key, Table, read_text};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::AirProblem;
use crate::elements::strips::DrivenWind;
use crate::input::drives;
use crate::model::Drive;

keys! {
    /// Mean wind, which is constant or changes with the height, or a table over time. Downwind,
    /// lateral and up are the axes of turbulence boxes, too.
    pub(super) CARD = "[air.wind]";
    /// Speed at the reference height; a drive of time may be below zero, and the wind then blows
    /// back.
    SPEED: ByHand = "speed", [OneDrive(Dimension::VELOCITY)], or "0", "11.4";
    /// Direction into which it blows, level, of any length.
    DIRECTION: Vector3<f64> = "direction", [Vector(3, Dimension::NUMBER)],
        or "[1, 0, 0]" = Vector3::x(), "[0, 0, 1]";
    /// Turn of the direction, clockwise seen from above.
    TURN: ByHand = "turn", [OneDrive(Dimension::ANGLE)], or "0", "\"= 20*sin(t/10)\"";
    /// Upward direction, of any length.
    UP: Option<Vector3<f64>> = "up", [Vector(3, Dimension::NUMBER)],
        or "opposite to gravity, without it [0, 0, 1]", "[1, 0, 0]";
    /// A point of the ground, from which heights and lateral positions are measured.
    GROUND: Vector3<f64> = "ground", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, -90]";
    /// Height of the speed above the ground.
    REFERENCE_HEIGHT: Option<f64> = "reference_height", [Positive(Dimension::LENGTH)], optional,
        "90";
    /// Power law over the height: its exponent.
    EXPONENT: Option<f64> = "exponent", [Quantity(Dimension::NUMBER)], optional, "0.2";
    /// Logarithmic law over the height: roughness length of the ground.
    ROUGHNESS: Option<f64> = "roughness", [Positive(Dimension::LENGTH)], optional, "0.03";
    /// Change of the direction with the height, clockwise seen from above, per length.
    VEER: f64 = "veer", [Quantity(Dimension::CURVATURE)], or "0" = 0.0, "0.1";
    /// Angle of the wind above the level.
    UPFLOW: ByHand = "upflow", [OneDrive(Dimension::ANGLE)], or "0", "8";
    /// Vertical wind.
    VERTICAL: ByHand = "vertical", [OneDrive(Dimension::VELOCITY)], or "0", "0.5";
    /// Linear shear across: change over the reference length, as part of the speed.
    HORIZONTAL_SHEAR: f64 = "horizontal_shear", [Quantity(Dimension::NUMBER)], or "0" = 0.0, "0.1";
    /// Linear shear over the height: change over the reference length, as part of the speed.
    VERTICAL_SHEAR: f64 = "vertical_shear", [Quantity(Dimension::NUMBER)], or "0" = 0.0, "0.1";
    /// Length of the linear shears: the diameter of the rotor.
    REFERENCE_LENGTH: Option<f64> = "reference_length", [Positive(Dimension::LENGTH)], optional,
        "126";
    /// A uniform-wind file of InflowWind: time, speed, direction, vertical speed, horizontal shear,
    /// exponent, vertical shear, gust, and upflow.
    TABLE: Option<String> = "table", [Text], optional, "\"ramp.wnd\"";
}

/// Keys of which the table has its own values.
const IN_TABLE: [&str; 9] = [
    SPEED.name(),
    TURN.name(),
    EXPONENT.name(),
    ROUGHNESS.name(),
    VEER.name(),
    UPFLOW.name(),
    VERTICAL.name(),
    HORIZONTAL_SHEAR.name(),
    VERTICAL_SHEAR.name(),
];

/// Largest sine of the angle of the direction above the level: digits lost in the input.
const LEVEL: f64 = 1e-6;

/// Axes and mean wind.
#[derive(Debug)]
pub(super) struct MeanCard {
    /// Axes of all parts of the wind.
    pub frame: WindFrame,
    /// Mean wind.
    pub mean: Mean,
}

impl MeanCard {
    /// The wind of a `velocity` \[m/s\].
    pub fn of_velocity(velocity: &Vector3<f64>, up: &Vector3<f64>) -> Result<Self, WindProblem> {
        let Wind { frame, mean, .. } = Wind::uniform(velocity, *up)?;
        Ok(Self { frame, mean })
    }

    /// Velocity at the reference height at time zero, axes of the wind \[m/s\].
    pub fn velocity(&self) -> [f64; 3] {
        let mean = self.mean.at(0.0);
        mean.velocity(&[0.0, 0.0, mean.reference_height], 0.0)
    }

    /// Speed along the wind at a height and a time \[m/s\].
    pub fn speed(&self, height: f64, time: f64) -> f64 {
        let mean = MeanWind {
            direction: 0.0,
            veer: 0.0,
            upflow: 0.0,
            ..self.mean.at(time)
        };
        mean.velocity(&[0.0, 0.0, height], 0.0)[0]
    }
}

/// Reads the table; `up` is the default of the upward direction.
pub(super) fn read(
    table: &Table<'_>,
    up: &Vector3<f64>,
    catalog: &drives::Catalog,
) -> Option<MeanCard> {
    let frame = frame(table, up);
    let [height, length] = [&REFERENCE_HEIGHT, &REFERENCE_LENGTH].map(|key| table.get(key));
    let (mean, file) = (driven(table, catalog), table.get(&TABLE));
    table.finish();
    let (height, length) = (height?, length?);
    let mean = match file? {
        Some(file) => from_file(table, &file, [height, length]),
        None => {
            let mean = mean?;
            let constant = complete(table, mean.constant, [height, length])?;
            let mean = DrivenWind { constant, ..mean };
            Some(if mean.is_steady() {
                Mean::Steady(mean.at(0.0))
            } else {
                Mean::Function(Arc::new(mean))
            })
        }
    };
    Some(MeanCard {
        frame: frame?,
        mean: mean?,
    })
}

fn frame(table: &Table<'_>, default_up: &Vector3<f64>) -> Option<WindFrame> {
    let (direction, up) = (table.get(&DIRECTION), table.get(&UP));
    let ground = table.get(&GROUND);
    let (direction, up) = (direction?, up?.unwrap_or(*default_up));
    let frame = match WindFrame::new(ground?, direction, up) {
        Ok(frame) => frame,
        Err(problem) => {
            note_direction(table, &direction, &up, &problem);
            return None;
        }
    };
    let slope = frame.up().dot(&direction) / direction.norm();
    if slope.abs() > LEVEL {
        table.note(
            &DIRECTION,
            &AirProblem::Value {
                key: DIRECTION.name(),
                found: format!("{:.6} deg above the level", slope.asin().to_degrees()),
                expected: "a level direction".to_owned(),
                help: "give the inclination by \"upflow\", or the vertical by \"up\"",
            },
        );
        return None;
    }
    Some(frame)
}

/// Notes a direction or a vertical that gives no axes.
fn note_direction(
    table: &Table<'_>,
    direction: &Vector3<f64>,
    up: &Vector3<f64>,
    problem: &WindProblem,
) {
    if direction.norm() == 0.0 || up.norm() == 0.0 {
        let key = if up.norm() == 0.0 {
            &UP.schema
        } else {
            &DIRECTION.schema
        };
        table.wrong(key.name, "a direction, a vector that is not zero");
        return;
    }
    if direction.cross(up).norm() > LEVEL * direction.norm() * up.norm() {
        table.note(&DIRECTION, problem);
        return;
    }
    // Without the sign of a negative zero.
    let shown = |of: &Vector3<f64>| format!("[{}, {}, {}]", of.x + 0.0, of.y + 0.0, of.z + 0.0);
    let problem = AirProblem::Value {
        key: DIRECTION.name(),
        found: format!("{}, along the vertical {}", shown(direction), shown(up)),
        expected: "a level direction".to_owned(),
        help: "give the vertical of this model by \"up\", as up = [1, 0, 0], with a point of the ground \
               by \"ground\"; a vertical wind is \"vertical\"",
    };
    table.note(&DIRECTION, &problem);
}

/// The mean wind without reference height and length.
fn driven(table: &Table<'_>, catalog: &drives::Catalog) -> Option<DrivenWind> {
    let driven = [&SPEED, &TURN, &UPFLOW, &VERTICAL];
    let [speed, turn, upflow, vertical] = driven.map(|key| {
        if table.has(key) {
            drives::read(table, &key.schema, catalog)
        } else {
            Some(Drive::Constant(0.0))
        }
    });
    let constant = constant(table);
    let speed = speed?;
    if speed.constant().is_some_and(|speed| speed < 0.0) {
        table.wrong(&SPEED, "a speed of zero or more, or a drive");
        return None;
    }
    Some(DrivenWind {
        constant: constant?,
        speed,
        turn: turn?,
        upflow: upflow?,
        vertical: vertical?,
    })
}

/// The numbers of the mean wind that are constant.
fn constant(table: &Table<'_>) -> Option<MeanWind> {
    let (exponent, roughness) = (table.get(&EXPONENT), table.get(&ROUGHNESS));
    let numbers = [&VEER, &HORIZONTAL_SHEAR, &VERTICAL_SHEAR];
    let [veer, across, over_height] = numbers.map(|key| table.get(key));
    let shear = match (exponent?, roughness?) {
        (None, None) => Shear::Uniform,
        (Some(exponent), None) => Shear::Power { exponent },
        (None, Some(roughness)) => Shear::Log { roughness },
        (Some(_), Some(_)) => {
            let problem = AirProblem::Useless {
                key: ROUGHNESS.name(),
                reason: "\"exponent\" gives the law of the height already",
            };
            table.note(&ROUGHNESS, &problem);
            return None;
        }
    };
    Some(MeanWind {
        shear,
        veer: veer?,
        horizontal_shear: across?,
        vertical_shear: over_height?,
        ..MeanWind::default()
    })
}

/// The same with reference height and length, if it needs them.
fn complete(
    table: &Table<'_>,
    mut mean: MeanWind,
    [height, length]: [Option<f64>; 2],
) -> Option<MeanWind> {
    let mut missing = Missing { table, any: false };
    let needs_length = mean.horizontal_shear != 0.0 || mean.vertical_shear != 0.0;
    if mean.shear != Shear::Uniform {
        missing.check(height, &REFERENCE_HEIGHT, "the law of the height");
    } else if mean.veer != 0.0 || mean.vertical_shear != 0.0 {
        missing.check(height, &REFERENCE_HEIGHT, "a change with the height");
    }
    if needs_length {
        missing.check(length, &REFERENCE_LENGTH, "a linear shear");
    }
    if missing.any {
        return None;
    }
    mean.reference_height = height.unwrap_or(mean.reference_height);
    mean.reference_length = length.unwrap_or(mean.reference_length);
    if let Shear::Log { roughness } = mean.shear
        && roughness >= mean.reference_height
    {
        table.note(
            &ROUGHNESS,
            &AirProblem::Value {
                key: ROUGHNESS.name(),
                found: format!("{roughness} m"),
                expected: format!(
                    "less than the reference height, {} m",
                    mean.reference_height
                ),
                help: "the roughness length of grass is 0.01 m, of a forest 1 m",
            },
        );
        return None;
    }
    Some(mean)
}

/// Notes missing keys.
struct Missing<'a, 'b> {
    table: &'a Table<'b>,
    any: bool,
}

impl Missing<'_, '_> {
    fn check(&mut self, found: Option<f64>, key: &Key<Option<f64>>, user: &'static str) {
        if found.is_none() {
            let key = key.name();
            let problem = AirProblem::Missing { key, user };
            self.table.note(key, &problem);
            self.any = true;
        }
    }
}

fn from_file(table: &Table<'_>, file: &str, given: [Option<f64>; 2]) -> Option<Mean> {
    let mut is_wrong = false;
    for key in IN_TABLE.into_iter().filter(|key| table.has(key)) {
        let problem = AirProblem::Useless {
            key,
            reason: "the file of \"table\" has this number at each time",
        };
        table.note(key, &problem);
        is_wrong = true;
    }
    let user = "the file of \"table\"";
    let mut missing = Missing { table, any: false };
    missing.check(given[0], &REFERENCE_HEIGHT, user);
    missing.check(given[1], &REFERENCE_LENGTH, user);
    let path = table.existing(&TABLE, file)?;
    let [Some(height), Some(length)] = given else {
        return None;
    };
    let name = path.display().to_string();
    let read = read_text(&path).and_then(|text| read_uniform_wind(&text, &name, height, length));
    let rows = table.keep_file(TABLE.name(), read)?;
    (!is_wrong).then_some(Mean::Table(rows))
}
