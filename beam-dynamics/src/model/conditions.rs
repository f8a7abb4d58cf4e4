//! What surrounds a model: the turning frame, gravity, and how far loads are applied.

use nalgebra::Vector3;

use super::TurningFrame;

/// Gravity, the factors of the loads, and the time for which drives are asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loading {
    /// Acceleration of gravity as it acts now, in the frame [m/s^2].
    pub gravity: Vector3<f64>,
    /// Factor of the loads that are constant during an analysis [-].
    pub constant: f64,
    /// Factor of the loads that grow in proportion [-].
    pub proportional: f64,
    /// Time; statics and modes are at the time zero [s].
    pub time: f64,
    /// Part of the driven rotations that is applied: one, but while places are made to
    /// fulfill the constraints \[-\].
    pub turns: f64,
    /// Part of the given voltages that is applied: one, but on the way to an equilibrium that
    /// is not found otherwise \[-\].
    pub voltages: f64,
}

impl Loading {
    /// No load, no gravity.
    pub fn none() -> Self {
        Self {
            gravity: Vector3::zeros(),
            constant: 0.0,
            proportional: 0.0,
            time: 0.0,
            turns: 1.0,
            voltages: 1.0,
        }
    }
}

/// All that acts on a model from outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// The frame in which the model is written.
    pub frame: TurningFrame,
    /// Gravity and loads.
    pub loading: Loading,
}

impl Conditions {
    /// A frame at rest, no loads.
    pub fn at_rest() -> Self {
        Self::turning(TurningFrame::at_rest())
    }

    /// A turning frame, no loads.
    pub fn turning(frame: TurningFrame) -> Self {
        Self {
            frame,
            loading: Loading::none(),
        }
    }
}
