//! Imposed displacement and rotation of a node: a clamp that moves, in any of its six
//! components.
//!
//! In axes D with the held components i of displacement u and rotation phi, times s, the
//! factor of the loads and a drive, and with the node's triad `a_i = R R_0^T d_i` and the driven
//! one `b = D R(s phi)`:
//!
//! ```text
//! d_i . (x - x_0) - s u_i = 0                     multiplier: force
//! a_j . b_k = 0                                   multiplier: moment
//! ```
//!
//! Pairs (j, k) for held rotations: three as in a clamp; two, about all axes but k, keep `a_k`
//! orthogonal to both other driven axes, so that the node turns freely about `b_k` by any angle;
//! one keeps the two axes normal to its own orthogonal. The reactions are as in a clamp: force
//! `-lambda d_i`, couple `-lambda (a_j x b_k)`. By the factor,
//!
//! ```text
//! d b_k / ds = D G(s phi) phi x b_k,   and  G(s phi) phi = phi
//! ```
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::Matrix3;

use super::factor::LoadFactor;
use crate::elements::joints::{ConstraintJoint, Freedom, JointEnds, Placing};
use crate::model::{Drive, Node};

/// The motion imposed on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImposedMotion {
    /// Displacement along each axis; `None` if free [m].
    pub displacement: [Option<f64>; 3],
    /// Components of the rotation vector; `None` if free [rad].
    pub rotation: [Option<f64>; 3],
    /// The axes (columns), in the model's axes [-].
    pub axes: Matrix3<f64>,
    /// Factor with which it grows.
    pub factor: LoadFactor,
}

/// Imposes `motion` on node `index`.
pub fn imposed(
    label: impl Into<String>,
    index: usize,
    node: &Node,
    motion: ImposedMotion,
) -> ConstraintJoint {
    let ends = JointEnds {
        a: None,
        b: (index, node),
    };
    let at = Placing::at(&node.position, &motion.axes);
    let [x, y, z] = motion.displacement;
    let [about_x, about_y, about_z] = motion.rotation;
    let freedoms = [x, y, z, about_x, about_y, about_z].map(|component| match component {
        None => Freedom::Free,
        Some(value) => Freedom::Driven(Drive::Constant(value).into()),
    });
    ConstraintJoint::total(label, &ends, &at, freedoms).growing_with(motion.factor)
}
