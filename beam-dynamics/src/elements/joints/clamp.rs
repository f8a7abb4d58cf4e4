//! Clamp: a node held in position and attitude in the model's frame, in all directions or in some.
//!
//! With the held position `x_0` and axes `e_b` (columns of `E`) of the frame, and `e_a` the axes
//! that coincide with them in the undeformed state and turn with the node:
//!
//! ```text
//! e_bi . (x - x_0) = 0                                          multipliers: force
//! e_a2 . e_b3 = 0,   e_a3 . e_b1 = 0,   e_a1 . e_b2 = 0         multipliers: moment
//! ```
//!
//! If the rotation about one axis, say 1, is free, the rows of the other two are `e_a1 . e_b2 = 0`,
//! `e_a1 . e_b3 = 0`, which stay independent at every angle.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::Matrix3;

use super::joint::{ConstraintJoint, JointEnds};
use super::kinds;
use crate::model::Node;

/// Holds node `index` in its undeformed position and attitude.
pub fn clamped(label: impl Into<String>, index: usize, node: &Node) -> ConstraintJoint {
    partly_clamped(label, index, node, &node.rotation, [true; 6])
}

/// Holds node `index` in the directions `held`: three displacements along `axes` (columns, in the
/// model's frame), three rotations about them.
pub fn partly_clamped(
    label: impl Into<String>,
    index: usize,
    node: &Node,
    axes: &Matrix3<f64>,
    held: [bool; 6],
) -> ConstraintJoint {
    let ends = JointEnds {
        a: None,
        b: (index, node),
    };
    let at = kinds::Placing::at(&node.position, axes);
    let freedoms = held.map(|held| {
        if held {
            kinds::Freedom::Locked
        } else {
            kinds::Freedom::Free
        }
    });
    ConstraintJoint::total(label, &ends, &at, freedoms)
}
