//! Critical factors of loads, and the shapes of buckling.

use nalgebra::Vector3;

use super::StaticStep;
use crate::model::Node;

/// One critical load.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingMode {
    /// Factor of the proportional loads at which the model buckles; negative if the loads
    /// must be reversed [-].
    pub factor: f64,
    /// Displacement of each node, model's axes; the largest is one, or all are zero and
    /// the largest rotation is one [-].
    pub displacements: Vec<Vector3<f64>>,
    /// Rotation of each node, model's axes, in the scale of the displacements [rad/m].
    pub rotations: Vec<Vector3<f64>>,
    /// Error of factor and shape in the equations, relative [-].
    pub residual: f64,
}

impl BucklingMode {
    /// Whether nodes turn without being displaced, as in torsion.
    pub fn is_rotation(&self) -> bool {
        let is_zero = |vector: &Vector3<f64>| *vector == Vector3::zeros();
        self.displacements.iter().all(is_zero)
    }
}

/// Critical loads of a model about an equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingResult {
    /// Name of the model.
    pub name: String,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// The undeformed nodes.
    pub nodes: Vec<Node>,
    /// Nodes of each beam, for drawing.
    pub beams: Vec<[usize; 3]>,
    /// The equilibrium under rotation and constant loads, about which the model buckles;
    /// its factor is zero.
    pub base: Option<StaticStep>,
    /// Critical loads, ascending by the magnitude of the factor.
    pub modes: Vec<BucklingMode>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}
