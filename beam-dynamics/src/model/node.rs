//! Nodes: carriers of unknowns.

use nalgebra::{Matrix3, Vector3};

/// A structural node in the undeformed configuration.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Name, for messages and tables.
    pub label: String,
    /// Position in the model's frame [m].
    pub position: Vector3<f64>,
    /// Orientation: columns are the node's axes in the model's frame [-].
    pub rotation: Matrix3<f64>,
}
