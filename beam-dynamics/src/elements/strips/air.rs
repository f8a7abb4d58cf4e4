//! The air of a model: its properties and its motion.

use nalgebra::{Matrix3, Vector3};
use rotor_aero::strip::AirProperties;

/// The air in which a model moves.
#[derive(Debug, Clone, PartialEq)]
pub struct Air {
    /// Density, speed of sound, viscosity.
    pub properties: AirProperties,
    /// Velocity of the wind, model axes [m/s].
    pub wind: Vector3<f64>,
}

impl Air {
    /// Velocity of the air at a point and a time [m/s], and its derivatives by the point [1/s].
    pub(super) fn motion(&self, _point: &Vector3<f64>, _time: f64) -> (Vector3<f64>, Matrix3<f64>) {
        (self.wind, Matrix3::zeros())
    }
}

impl Air {
    /// Standard air at an altitude [m], at rest.
    pub fn standard(_altitude: f64) -> Self {
        Self {
            properties: AirProperties {
                density: 1.225,
                speed_of_sound: 340.294,
                viscosity: 1.789e-5,
                acting: 1.0,
            },
            wind: Vector3::zeros(),
        }
    }
}
