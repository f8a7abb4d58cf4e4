//! The frame in which the model is written: it may turn at a constant speed.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

/// A frame that turns with constant angular velocity about a fixed point.
///
/// All vectors of the model are components in this frame and all rates are
/// relative to it, so that a steadily rotating rotor is at rest. Bodies move
/// through space with `v = x' + Omega x (x - c)` and `omega = omega_rel + Omega`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningFrame {
    /// Angular velocity `Omega` of the frame, in the frame [rad/s].
    pub angular_velocity: Vector3<f64>,
    /// A point `c` of the axis of rotation [m].
    pub center: Vector3<f64>,
}

impl TurningFrame {
    /// The frame at rest.
    pub fn at_rest() -> Self {
        Self {
            angular_velocity: Vector3::zeros(),
            center: Vector3::zeros(),
        }
    }

    /// Velocity in space of a point at `position` that moves with `velocity`
    /// relative to the frame [m/s].
    pub fn velocity(&self, position: &Vector3<f64>, velocity: &Vector3<f64>) -> Vector3<f64> {
        velocity + self.angular_velocity.cross(&(position - self.center))
    }

    /// `[Omega]x`, the derivative of the velocity in space with respect to position [1/s].
    pub fn skew(&self) -> Matrix3<f64> {
        skew(&self.angular_velocity)
    }
}
