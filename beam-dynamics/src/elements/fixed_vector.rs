//! Unknowns that are components of vectors along fixed axes.

use nalgebra::{Matrix3, Vector3};

/// Successive unknowns of an element that are the components along fixed axes of a vector that turns
/// with a node; the equations of the same numbers are the components of another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FixedVector {
    /// Three multipliers and constraints; the vector turns with the last node of the element.
    Constraints {
        /// The first of them.
        first: usize,
        /// The axes (columns), in the model's axes \[-\].
        axes: Matrix3<f64>,
    },
    /// Two scalars across a shaft, with which the vector turns; the first node of the element carries
    /// the shaft.
    Scalars {
        /// The first of them.
        first: usize,
        /// The shaft, the first axis and the second one after it forming a right-handed system, in
        /// the axes of the node \[-\].
        shaft: Vector3<f64>,
    },
}
