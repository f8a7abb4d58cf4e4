//! Observations: quantities that elements report of a state.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3, Vector6};

use super::air_state::AirState;

/// A beam section at an evaluation point.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionState {
    /// Name of the beam.
    pub beam: Arc<str>,
    /// Position along the undeformed beam, -1 to 1 [-].
    pub xi: f64,
    /// Position of the reference line in the model's frame [m].
    pub position: Vector3<f64>,
    /// Section axes (columns) in the model's frame [-].
    pub axes: Matrix3<f64>,
    /// Generalized strain, section axes [-, 1/m].
    pub strain: Vector6<f64>,
    /// Internal force, section axes [N, N m].
    pub internal_force: Vector6<f64>,
    /// Least and largest change of the stiffness by prestress, relative to the stiffness without
    /// prestress; `None` if no table of prestress is used [-].
    pub change_of_stiffness: Option<[f64; 2]>,
    /// The larger rotation of the two outer sections of the element relative to its middle one
    /// [rad].
    pub turn: f64,
}

/// Reaction of a joint on a node.
#[derive(Debug, Clone, PartialEq)]
pub struct Reaction {
    /// Name of the joint.
    pub joint: String,
    /// Index of the node on which it acts.
    pub node: usize,
    /// Force on the node, model's axes [N].
    pub force: Vector3<f64>,
    /// Moment on the node about the node, model's axes [N m].
    pub moment: Vector3<f64>,
}

/// A joint at a state: its reaction and the motion of its second end relative to its first.
///
/// The first end, a, is the first of two nodes, or the frame of the model; b is the other. Each
/// carries a point and axes, which coincide in the undeformed model unless the joint specifies
/// otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct JointState {
    /// Name of the joint.
    pub joint: String,
    /// Indices of the nodes of a and b; `None` for the frame.
    pub nodes: [Option<usize>; 2],
    /// The axes (columns) that turn with a and with b, model's axes [-].
    pub axes: [Matrix3<f64>; 2],
    /// Force on b, model's axes [N].
    pub force: Vector3<f64>,
    /// Moment on b about its point, model's axes [N m].
    pub moment: Vector3<f64>,
    /// From the point of a to the point of b, axes of a [m].
    pub displacement: Vector3<f64>,
    /// Rotation vector of the axes of b relative to the axes of a, axes of a; at most half a turn
    /// [rad].
    pub rotation: Vector3<f64>,
    /// Angle about the axis of a joint that has one, between minus and plus half a turn
    /// (see [`JointState::unwrapped`]) [rad].
    pub angle: Option<f64>,
    /// Rate of `displacement`: the velocity of b's point relative to a [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity of b relative to a, axes of a [rad/s].
    pub angular_velocity: Vector3<f64>,
}

/// Axes of the components of a reaction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReactionAxes {
    /// The axes of the model.
    Model,
    /// The axes of the joint that turn with a.
    First,
    /// The axes of the joint that turn with b.
    Second,
}

impl JointState {
    /// Force [N] and moment [N m] on b at its point.
    pub fn reaction(&self, axes: ReactionAxes) -> [Vector3<f64>; 2] {
        let back = match axes {
            ReactionAxes::Model => Matrix3::identity(),
            ReactionAxes::First => self.axes[0].transpose(),
            ReactionAxes::Second => self.axes[1].transpose(),
        };
        [back * self.force, back * self.moment]
    }

    /// The angle plus full turns, closest to `before`, the angle a moment ago [rad].
    pub fn unwrapped(&self, before: f64) -> Option<f64> {
        use std::f64::consts::TAU;
        let angle = self.angle?;
        Some(angle + TAU * ((before - angle) / TAU).round())
    }
}

/// A rod, or a spring between two nodes or between the frame and a node.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringState {
    /// Name of the rod or spring.
    pub spring: String,
    /// Axes (columns) of the vectors below, in the model's frame: the axes of the first node, or
    /// for a rod its line and two directions across it [-].
    pub axes: Matrix3<f64>,
    /// Displacement of the second end relative to the first since the undeformed state; for a rod
    /// its elongation and zeros [m].
    pub displacement: Vector3<f64>,
    /// Rotation vector of the second end relative to the first; zero for a rod [rad].
    pub rotation: Vector3<f64>,
    /// Force of the spring against the displacement: for a rod its tension and zeros [N].
    pub force: Vector3<f64>,
    /// Moment of the spring against the rotation, on its first end and about the position of the
    /// second [N m].
    pub moment: Vector3<f64>,
}

/// All observations of the elements, in their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Observations {
    /// Sections of beams.
    pub sections: Vec<SectionState>,
    /// Reactions of joints.
    pub reactions: Vec<Reaction>,
    /// Joints.
    pub joints: Vec<JointState>,
    /// Rods and springs between two ends.
    pub springs: Vec<SpringState>,
    /// Strips in the air.
    pub air: Vec<AirState>,
}
