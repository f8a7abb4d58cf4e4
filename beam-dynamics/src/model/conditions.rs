//! Conditions of a model: the turning frame, gravity, and the factors of loads.

use nalgebra::Vector3;

use super::TurningFrame;

/// Gravity, the factors of the loads, and the time at which drives are evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loading {
    /// Present acceleration of gravity, in the frame [m/s^2].
    pub gravity: Vector3<f64>,
    /// Factor of the loads that are constant during an analysis [-].
    pub constant: f64,
    /// Factor of the loads that grow in proportion [-].
    pub proportional: f64,
    /// Factor of the loads of the start alone: one in its equilibrium, else zero [-].
    pub released: f64,
    /// Part of the rest of states of controls: one in the equilibrium of a start and on the whole way to it,
    /// else zero [-].
    pub resting: f64,
    /// Time; statics and modes are at time zero [s].
    pub time: f64,
    /// Part of the prescribed rotations that is applied: one, except while positions are
    /// adjusted to fulfill the constraints \[-\].
    pub turns: f64,
    /// Part of the given voltages that is applied: one, except on the way to an equilibrium
    /// that is not found otherwise \[-\].
    pub voltages: f64,
    /// Part of the forces of the air that acts: one, except on the way to an equilibrium \[-\].
    pub air: f64,
}

impl Loading {
    /// In the equilibrium of a start: its loads act, and states of controls rest.
    pub fn start(&mut self) {
        (self.released, self.resting) = (1.0, 1.0);
    }

    /// No load, no gravity, no air.
    pub fn none() -> Self {
        Self {
            gravity: Vector3::zeros(),
            constant: 0.0,
            proportional: 0.0,
            released: 0.0,
            resting: 0.0,
            time: 0.0,
            turns: 1.0,
            voltages: 1.0,
            air: 0.0,
        }
    }
}

/// All external actions on a model.
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
