//! Parts of constraints: points and axes on two ends, and the forms that constrain them.
//!
//! End a and end b carry a point and axes, `p = x + f`, `f = R f~`, `E = R E~`. An end is a node,
//! or the frame of the model, which acts as a fixed node. Each constraint is a [`Form`] of the two
//! ends; with its gradient g by the displacements and spatial rotations q = (x_a, theta_a, x_b,
//! theta_b), the virtual work of the reactions is `-lambda d Phi`, so that
//!
//! ```text
//! forces and moments on the ends   -lambda g
//! their derivatives                -lambda H,      H = dg/dq
//! Phi'  = g . q' + Phi_t
//! Phi'' = g . q'' + q' . H q' + 2 g_t . q' + Phi_tt
//! ```
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, Vector3};

use crate::model::{Node, NodeMotion};

mod form;
mod row;
mod turn;
mod words;

pub(super) use form::{Carrier, Form};
pub(super) use row::{Held, Row, Seen};
pub(super) use turn::Turned;

/// A point and axes fixed to a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attachment {
    /// Offset of the point from the node, in node axes [m].
    pub offset: Vector3<f64>,
    /// The axes (columns) in node axes [-].
    pub axes: Matrix3<f64>,
}

impl Attachment {
    /// The point and the axes of the undeformed model that move with `node`: `position`
    /// and `axes` (columns) are given in the model's frame.
    pub fn to(node: &Node, position: &Vector3<f64>, axes: &Matrix3<f64>) -> Self {
        let back = node.rotation.transpose();
        Self {
            offset: back * (position - node.position),
            axes: back * axes,
        }
    }

    /// A point and axes of the frame of the model.
    pub fn to_frame(position: &Vector3<f64>, axes: &Matrix3<f64>) -> Self {
        Self {
            offset: *position,
            axes: *axes,
        }
    }
}

/// Displacement or rotation of an end: a variable of a form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// Displacement of the node of a.
    PositionA,
    /// Rotation of the node of a.
    TurnA,
    /// Displacement of the node of b.
    PositionB,
    /// Rotation of the node of b.
    TurnB,
}

impl Part {
    pub const ALL: [Self; 4] = [Self::PositionA, Self::TurnA, Self::PositionB, Self::TurnB];

    /// 0 for a, 1 for b.
    pub fn end(self) -> usize {
        self as usize / 2
    }

    pub fn is_turn(self) -> bool {
        self as usize % 2 == 1
    }
}

/// A vector for each [`Part`].
pub(super) type Parts = [Vector3<f64>; 4];

/// One end at a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    /// Local number of the node; `None` for the frame.
    pub node: Option<usize>,
    /// Position of the point [m].
    pub position: Vector3<f64>,
    /// Offset of the point from the node, model axes; zero for the frame [m].
    pub arm: Vector3<f64>,
    /// The axes (columns), model axes [-].
    pub axes: Matrix3<f64>,
    /// Velocity of the node relative to the frame [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity relative to the frame [rad/s].
    pub omega: Vector3<f64>,
}

impl End {
    /// An attachment to local node `node`, or to the frame.
    pub fn at(attachment: &Attachment, node: Option<usize>, nodes: &[NodeMotion]) -> Self {
        let Some(motion) = node.map(|node| &nodes[node]) else {
            return Self {
                node: None,
                position: attachment.offset,
                arm: Vector3::zeros(),
                axes: attachment.axes,
                velocity: Vector3::zeros(),
                omega: Vector3::zeros(),
            };
        };
        let arm = motion.rotation * attachment.offset;
        Self {
            node,
            position: motion.position + arm,
            arm,
            axes: motion.rotation * attachment.axes,
            velocity: motion.velocity,
            omega: motion.angular_velocity,
        }
    }

    /// Velocity of the point relative to the frame [m/s].
    pub fn point_velocity(&self) -> Vector3<f64> {
        self.velocity + self.omega.cross(&self.arm)
    }
}

/// Both ends of a joint at a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    pub a: End,
    pub b: End,
}

impl Ends {
    /// From the point of a to the point of b [m].
    pub fn between(&self) -> Vector3<f64> {
        self.b.position - self.a.position
    }

    /// Velocities of the nodes, by part.
    pub fn rates(&self) -> Parts {
        let Self { a, b } = self;
        [a.velocity, a.omega, b.velocity, b.omega]
    }

    /// Local node of an end.
    pub fn node(&self, end: usize) -> Option<usize> {
        [self.a.node, self.b.node][end]
    }
}
