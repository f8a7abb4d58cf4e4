//! Attachment of a three-node beam to its nodes, and the formulation of its nodal forces.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::parameters::Parametrization;

/// xi of the evaluation points: the Gauss points, at which the beam of constant properties is exact
/// at its ends.
pub const EVALUATION_POINTS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// Relation between the nodal forces of a beam and its section forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Formulation {
    /// Gradient of the energy, with rotation vectors.
    #[default]
    Variational,
    /// Balance of finite volumes, with the given parameters of rotation.
    FiniteVolume(Parametrization),
}

impl Formulation {
    /// Interpolation of rotations.
    pub fn parametrization(self) -> Parametrization {
        match self {
            Self::Variational => Parametrization::RotationVector,
            Self::FiniteVolume(parametrization) => parametrization,
        }
    }
}

/// Attachment of the beam to one of its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamNode {
    /// Offset of the reference line from the node, in node axes [m].
    pub offset: Vector3<f64>,
    /// Section axes (columns) in node axes [-].
    pub orientation: Matrix3<f64>,
}

impl BeamNode {
    /// On the node, with section axes along the axes of the node.
    pub fn aligned() -> Self {
        Self {
            offset: Vector3::zeros(),
            orientation: Matrix3::identity(),
        }
    }
}

/// Attachment of a three-node beam, and its interpolation and test functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamGeometry {
    /// Attachment to nodes 1, 2, 3.
    pub nodes: [BeamNode; 3],
    /// The formulation of forces, inertia and loads of the beam.
    pub formulation: Formulation,
}

impl BeamGeometry {
    /// A variational beam.
    pub fn new(nodes: [BeamNode; 3]) -> Self {
        Self {
            nodes,
            formulation: Formulation::Variational,
        }
    }

    /// The same with another formulation.
    #[must_use]
    pub fn formulated(self, formulation: Formulation) -> Self {
        Self {
            formulation,
            ..self
        }
    }
}
