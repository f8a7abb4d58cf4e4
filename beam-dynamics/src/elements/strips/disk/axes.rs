//! Axes of a disk that do not turn with its rotor.
//!
//! With the shaft n, which the hub carries, and a direction E that is fixed in the frame:
//!
//! ```text
//! e_1 = (E - n (n . E)) / s        s = |E - n (n . E)|        e_2 = n x e_1
//! d n = - [n]x theta               d e_1 = (1/s) (I - e_1 e_1^T) (n E^T + n . E) [n]x theta
//! d e_2 = [e_1]x [n]x theta + [n]x d e_1
//! ```

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

/// Axes of a disk at a state.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements::strips) struct DiskAxes {
    /// n \[-\].
    pub shaft: Vector3<f64>,
    /// `e_1` and `e_2` \[-\].
    pub across: [Vector3<f64>; 2],
    /// E \[-\].
    reference: Vector3<f64>,
    /// s \[-\].
    length: f64,
}

impl DiskAxes {
    /// The axes for the direction `reference`, which is not along the shaft.
    pub fn new(shaft: Vector3<f64>, reference: &Vector3<f64>) -> Self {
        let across = reference - shaft * shaft.dot(reference);
        let length = across.norm();
        let first = across / length;
        Self {
            shaft,
            across: [first, shaft.cross(&first)],
            reference: *reference,
            length,
        }
    }

    /// Derivatives of both axes by the rotation of the hub \[-\].
    pub fn by_turn(&self) -> [Matrix3<f64>; 2] {
        let (shaft, [first, _]) = (&self.shaft, &self.across);
        let turn = skew(shaft);
        let normal = Matrix3::identity() - first * first.transpose();
        let along = shaft.dot(&self.reference);
        let inner = shaft * self.reference.transpose() + Matrix3::identity() * along;
        let by_first = normal * inner * turn / self.length;
        [by_first, skew(first) * turn + turn * by_first]
    }

    /// The components of a vector across the shaft.
    pub fn components(&self, of: &Vector3<f64>) -> [f64; 2] {
        self.across.map(|axis| axis.dot(of))
    }
}
