//! How a three-node beam is attached to its nodes, and by which formulation it acts on them.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::parameters::Parametrization;

/// xi of the evaluation points: the Gauss points, which make the beam of constant
/// properties exact at its ends.
pub(super) const EVALUATION_POINTS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// How the forces of a beam on its nodes follow from those in its sections.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Formulation {
    /// Gradient of the energy, with rotation vectors.
    #[default]
    Variational,
    /// Balance of finite volumes, with the given parameters of rotation.
    FiniteVolume(Parametrization),
}

impl Formulation {
    /// How it interpolates rotations.
    pub fn parametrization(self) -> Parametrization {
        match self {
            Self::Variational => Parametrization::RotationVector,
            Self::FiniteVolume(parametrization) => parametrization,
        }
    }
}

/// How the beam is attached to one of its nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamNode {
    /// Offset of the reference line from the node, in node axes [m].
    pub offset: Vector3<f64>,
    /// Section axes (columns) in node axes [-].
    pub orientation: Matrix3<f64>,
}

impl BeamNode {
    /// On the node, with section axes along those of the node.
    pub fn aligned() -> Self {
        Self {
            offset: Vector3::zeros(),
            orientation: Matrix3::identity(),
        }
    }
}

/// Attachment of a three-node beam, and how its field is interpolated and tested.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamGeometry {
    /// Attachment to nodes 1, 2, 3.
    pub nodes: [BeamNode; 3],
    /// Forces, inertia and loads of the beam all follow it.
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
