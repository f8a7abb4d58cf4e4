//! Relative motions of nodes that an element resists with springs, or leaves free.

use nalgebra::Vector3;

/// A relative motion of the nodes of an element at the undeformed state, as a linear
/// form of their displacements u and rotations theta: `sum_i d_i . u_i + r_i . theta_i`.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// `d_i` [-] and `r_i` [m] of each node of the element.
    pub form: Vec<[Vector3<f64>; 2]>,
    /// Whether a spring resists it; else it is free by design, as in a hinge.
    pub is_resisted: bool,
}
