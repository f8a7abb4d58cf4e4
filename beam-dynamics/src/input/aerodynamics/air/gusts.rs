//! Gusts that travel: `[[air.gust]]`.

use nalgebra::Vector3;
use rotor_aero::wind::{GustShape, TravelingGust};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Quantity, Vector, Word};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::mean::MeanCard;
use super::problem::AirProblem;

keys! {
    /// A gust that travels through the air. Its start is seen by the control of the steps, at the
    /// undeformed position of each strip.
    pub(super) CARD = "[[air.gust]]";
    /// Shape over the distance behind its front: half of one minus the cosine of 2 pi s/length; one
    /// after a ramp; or the sine of 2 pi s/length.
    SHAPE: usize = "shape", [Word(&["one minus cosine", "sharp edge", "harmonic"])], required,
        "\"one minus cosine\"";
    /// Velocity that is added where the shape is one, model axes.
    VELOCITY: Vector3<f64> = "velocity", [Vector(3, Dimension::VELOCITY)], required, "[0, 0, 9]";
    /// Length of the gust, wavelength, or length of the ramp of a sharp edge.
    LENGTH: Option<f64> = "length", [Positive(Dimension::LENGTH)],
        or "required; without ramp for a sharp edge", "50";
    /// Direction in which it travels, model axes, of any length.
    DIRECTION: Option<Vector3<f64>> = "direction", [Vector(3, Dimension::NUMBER)],
        or "the direction of the wind at time zero, at its reference height", "[1, 0, 0]";
    /// Speed at which it travels; zero for a gust at rest.
    SPEED: Option<f64> = "speed", [Quantity(Dimension::VELOCITY)],
        or "the speed of the wind at time zero, at its reference height", "60";
    /// Time at which its front passes the point `at`.
    START: f64 = "start", [Quantity(Dimension::TIME)], or "0" = 0.0, "2";
    /// A point that its front passes at `start`.
    AT: Vector3<f64> = "at", [Vector(3, Dimension::LENGTH)], or "[0, 0, 0]" = Vector3::zeros(),
        "[-10, 0, 0]";
}

/// Reads every `[[air.gust]]`; `None` if one is wrong. Without a mean wind, only the keys are
/// checked.
pub(super) fn read(tables: &[Table<'_>], mean: Option<&MeanCard>) -> Option<Vec<TravelingGust>> {
    let read = tables.iter().map(|table| gust(table, mean));
    let gusts: Vec<_> = read.collect();
    gusts.into_iter().collect()
}

fn gust(table: &Table<'_>, mean: Option<&MeanCard>) -> Option<TravelingGust> {
    let (shape, length) = (table.get(&SHAPE), table.get(&LENGTH));
    let (velocity, direction) = (table.get(&VELOCITY), table.get(&DIRECTION));
    let (speed, start, at) = (table.get(&SPEED), table.get(&START), table.get(&AT));
    table.finish();
    let shape = shaped(table, shape?, length?);
    let frame = &mean?.frame;
    let wind = Vector3::from(mean?.velocity());
    let direction = match direction? {
        // In still air the downwind axis.
        None => Some(wind.try_normalize(0.0).unwrap_or_else(Vector3::x)),
        Some(direction) => {
            let direction = direction.try_normalize(0.0);
            if direction.is_none() {
                table.wrong(&DIRECTION, "a vector that is not zero");
            }
            direction.map(|direction| frame.components(&direction).into())
        }
    };
    let convection = match speed? {
        None if wind.norm() == 0.0 => {
            let (key, user) = (
                SPEED.name(),
                "a gust where the mean wind is zero at time zero",
            );
            table.note(&SHAPE, &AirProblem::Missing { key, user });
            None
        }
        None => Some(wind.norm()),
        given => given,
    };
    let (direction, convection): ([f64; 3], f64) = (direction?.into(), convection?);
    let at = frame.point(&at?.into());
    let along: f64 = at.iter().zip(&direction).map(|(a, b)| a * b).sum();
    let gust = TravelingGust {
        shape: shape?,
        velocity: frame.components(&velocity?),
        direction,
        convection,
        front: along - convection * start?,
    };
    match gust.check() {
        Ok(()) => Some(gust),
        Err(problem) => {
            table.note(&SHAPE, &problem);
            None
        }
    }
}

fn shaped(table: &Table<'_>, shape: usize, length: Option<f64>) -> Option<GustShape> {
    match (shape, length) {
        (1, ramp) => Some(GustShape::SharpEdge {
            ramp: ramp.unwrap_or(0.0),
        }),
        (0, Some(length)) => Some(GustShape::OneMinusCosine { length }),
        (_, Some(length)) => Some(GustShape::Harmonic { length }),
        (_, None) => {
            let problem = AirProblem::Missing {
                key: LENGTH.name(),
                user: "a gust of this shape",
            };
            table.note(&SHAPE, &problem);
            None
        }
    }
}
