//! What elements tell of a state.

use nalgebra::{Matrix3, Vector3, Vector6};

/// A beam section at an evaluation point.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionState {
    /// Name of the beam.
    pub beam: String,
    /// Place along the undeformed beam, -1 to 1 [-].
    pub xi: f64,
    /// Place of the reference line in the model's frame [m].
    pub position: Vector3<f64>,
    /// Section axes (columns) in the model's frame [-].
    pub axes: Matrix3<f64>,
    /// Generalized strain, section axes [-, 1/m].
    pub strain: Vector6<f64>,
    /// Internal force, section axes [N, N m].
    pub internal_force: Vector6<f64>,
}

/// What a joint exerts on a node.
#[derive(Debug, Clone, PartialEq)]
pub struct Reaction {
    /// Name of the joint.
    pub joint: String,
    /// Number of the node on which it acts.
    pub node: usize,
    /// Force on the node, model's axes [N].
    pub force: Vector3<f64>,
    /// Moment on the node about the node, model's axes [N m].
    pub moment: Vector3<f64>,
}

/// A rod, or a spring between two nodes or between the frame and a node.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringState {
    /// Name of the rod or spring.
    pub spring: String,
    /// Axes in which the vectors below are (columns), in the model's frame: those of the
    /// first node, or of a rod its line and two directions across it [-].
    pub axes: Matrix3<f64>,
    /// Displacement of the second end against the first since the undeformed state; of a
    /// rod its elongation and zeros [m].
    pub displacement: Vector3<f64>,
    /// Rotation vector of the second end against the first; of a rod zero [rad].
    pub rotation: Vector3<f64>,
    /// Force with which the spring resists the displacement: of a rod its tension and
    /// zeros [N].
    pub force: Vector3<f64>,
    /// Moment with which the spring resists the rotation, on its first end and about the
    /// place of the second [N m].
    pub moment: Vector3<f64>,
}

/// All that the elements tell, in their order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Observations {
    /// Sections of beams.
    pub sections: Vec<SectionState>,
    /// Reactions of joints.
    pub reactions: Vec<Reaction>,
    /// Rods and springs between two ends.
    pub springs: Vec<SpringState>,
}
