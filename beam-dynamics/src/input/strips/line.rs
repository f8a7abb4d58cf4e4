//! The line of a blade on which its stations are.

use nalgebra::Vector3;

/// The line of a beam, in the axes of the blade.
pub(in crate::input) struct BladeLine<'a> {
    /// Its length \[m\].
    pub length: f64,
    /// Position at an arc length \[m\].
    pub position: &'a dyn Fn(f64) -> Vector3<f64>,
    /// Precone of its blades, if they could be read \[rad\].
    pub precone: Option<f64>,
}
