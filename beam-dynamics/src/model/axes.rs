//! Directions used to name the motion of a node: span, lag, flap, torsion.

use nalgebra::Matrix3;

/// Axes of a node for naming modes, in the undeformed configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamingAxes {
    /// Axes of the blade root (columns): x along the span, y in the direction of lag
    /// (toward the leading edge), z in the direction of flap [-].
    pub blade: Matrix3<f64>,
    /// Axes of the section at the node (columns): x along the beam, the axis of
    /// torsion [-].
    pub section: Matrix3<f64>,
    /// Whether the node belongs to no blade and is on the axis of rotation, which is then x of
    /// both axes: its motion across the axis is lateral, in any direction.
    pub is_central: bool,
    /// Of a node that belongs to no blade, in a model with a tower: the directions (columns) up the
    /// tower, from side to side, and along the wind, fore-aft [-].
    pub tower: Option<Matrix3<f64>>,
}

impl Default for NamingAxes {
    /// The axes of the model's frame: span along x, lag along y, flap along z.
    fn default() -> Self {
        Self {
            blade: Matrix3::identity(),
            section: Matrix3::identity(),
            is_central: false,
            tower: None,
        }
    }
}
