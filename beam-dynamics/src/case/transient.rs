//! The requested motion in time.

use nalgebra::Vector3;

use super::Model;
use crate::elements::Queries;
use crate::integrator::{Scheme, StepLimits, Stepping};
use crate::model::{Conditions, Loading, Pace, TurningFrame};

/// Initial motion of a node, as far as it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialMotion {
    /// Velocity in the model's frame [m/s].
    pub velocity: Option<Vector3<f64>>,
    /// Angular velocity, in the axes of the model [rad/s].
    pub angular_velocity: Option<Vector3<f64>>,
    /// Weight of a change of position and orientation: the larger, the less they change
    /// [-].
    pub weight: f64,
    /// Weight of a change of the velocities [-]; `None`: one for given velocities, almost
    /// zero for the others.
    pub velocity_weight: Option<f64>,
}

impl Default for InitialMotion {
    /// Nothing is given.
    fn default() -> Self {
        Self {
            velocity: None,
            angular_velocity: None,
            weight: 1.0,
            velocity_weight: None,
        }
    }
}

/// Initial state of a run in time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// From the given positions and velocities of the nodes, adjusted to fulfill the
    /// constraints.
    Given,
    /// From the equilibrium at rest under the loads at the first instant.
    Equilibrium,
    /// From the equilibrium of the whole model in steady rotation about the axis of the
    /// hub, with the periodic response to gravity across it.
    Rotating {
        /// Speed of rotation [rad/s].
        speed: f64,
    },
}

/// A mode whose shape is added to the equilibrium of the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StartShape {
    /// Number of the mode by ascending frequency, from one.
    pub mode: usize,
    /// The largest component of the displacement of a node [m].
    pub displacement: f64,
}

/// Method for the accelerations and the reactions of the first instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartAccelerations {
    /// From the second derivative of the constraints, if all elements provide it, else by
    /// dummy steps.
    Consistent,
    /// They are zero.
    Zero,
    /// From the same equations with everything at rest: without the terms that are
    /// quadratic in the velocities, as in the source of the two-step scheme.
    AtRest,
    /// By a few very short steps, of which only the accelerations and reactions are kept.
    Dummy,
}

/// Treatment of redundant constraints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Redundant {
    /// They are reported, and nothing is run.
    Error,
    /// They are removed.
    Remove,
}

/// The requested motion in time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientSettings {
    /// First instant [s].
    pub from: f64,
    /// Last instant [s].
    pub to: f64,
    /// Length of the steps.
    pub stepping: Stepping,
    /// Integration scheme.
    pub scheme: Scheme,
    /// Iteration of a step.
    pub newton: StepLimits,
    /// Whether rotations are linearized as at their prediction, instead of exactly.
    pub simplified_jacobian: bool,
    /// Initial state of the run.
    pub start: Start,
    /// Shape that is added to an equilibrium.
    pub shape: Option<StartShape>,
    /// Method for the first accelerations and reactions.
    pub start_accelerations: StartAccelerations,
    /// Treatment of redundant constraints.
    pub redundant: Redundant,
}

impl TransientSettings {
    /// From the given state, at time zero, to the time `to` in equal steps \[s\], with the
    /// defaults of an input file for everything else.
    pub fn new(to: f64, step: f64) -> Self {
        Self {
            from: 0.0,
            to,
            stepping: Stepping::Constant { step },
            scheme: Scheme::default(),
            newton: StepLimits::default(),
            simplified_jacobian: false,
            start: Start::Given,
            shape: None,
            start_accelerations: StartAccelerations::Consistent,
            redundant: Redundant::Error,
        }
    }

    /// Speed of a start in steady rotation [rad/s].
    pub fn rotating_speed(&self) -> Option<f64> {
        match self.start {
            Start::Rotating { speed } => Some(speed),
            Start::Given | Start::Equilibrium => None,
        }
    }
}

impl Model {
    /// All loads at a time \[s\] of a run, in axes that do not turn: constant and
    /// proportional loads act in full.
    pub fn conditions_at(&self, time: f64) -> Conditions {
        Conditions {
            frame: TurningFrame {
                angular_velocity: Vector3::zeros(),
                center: self.frame_rotation.center,
            },
            loading: Loading {
                gravity: self.gravity_at(time),
                constant: 1.0,
                proportional: 1.0,
                released: 0.0,
                resting: 0.0,
                time,
                turns: 1.0,
                voltages: 1.0,
                air: 1.0,
            },
        }
    }

    /// Whether a force may have a kink or a jump over the motion: by a law, or by a signal of sensed
    /// quantities.
    pub fn has_kinks(&self) -> bool {
        let mut elements = self.system.elements();
        elements.any(|element| element.has_kinks() || element.senses())
    }

    /// Limits of the step length from quantities given over time in a run \[s\].
    pub fn pace(&self, run: [f64; 2]) -> Pace {
        let drives = self.system.elements().flat_map(|element| element.drives());
        Pace::new(drives.chain([&self.gravity_drive]), run)
    }

    /// The first time after `time` at which a drive or load has a corner \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        let corners = self.system.elements().map(|one| one.next_corner(time));
        corners.fold(self.gravity_drive.next_corner(time), f64::min)
    }

    /// Acceleration of gravity at a time \[s\], in the model's frame \[m/s^2\].
    pub fn gravity_at(&self, time: f64) -> Vector3<f64> {
        self.gravity_drive.at(time).value * self.gravity
    }
}
