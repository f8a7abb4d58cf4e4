//! Rigid connection: two nodes that move as one body, at any distance.
//!
//! Node b is attached to node a as in the undeformed state:
//!
//! ```text
//! x_b - (x_a + f_a) = 0                                         multipliers: force
//! e_a2 . e_b3 = 0,   e_a3 . e_b1 = 0,   e_a1 . e_b2 = 0         multipliers: moment
//! ```
//!
//! with `f_a` the offset of b from a and `e_a` the axes of b as they turn with a.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use super::joint::{ConstraintJoint, JointEnds};
use super::kinds::Placing;
use crate::model::Node;

/// Holds the second of the nodes `nodes`, undeformed at `undeformed`, to the first.
pub fn rigid_connection(
    label: impl Into<String>,
    nodes: [usize; 2],
    undeformed: [&Node; 2],
) -> ConstraintJoint {
    let [a, b] = [0, 1].map(|i| (nodes[i], undeformed[i]));
    let ends = JointEnds { a: Some(a), b };
    let at = Placing::at(&b.1.position, &b.1.rotation);
    ConstraintJoint::clamp(label, &ends, &at)
}
