//! Maximum stress and maximum strain of an isotropic material.
//!
//! ```text
//! index = max( s_max / T ,  -s_min / C ,  (s_max - s_min) / 2 / S )              (S-54)
//! ```
//!
//! for principal stresses; for principal strains with the engineering shear `e_max - e_min`
//! in the last term. Linear in the load.

use super::{Mode, Verdict, worst_linear};
use crate::material::UniformLimits;
use crate::recovery::axes::tensor;
use nalgebra::{Matrix3, Vector6};

/// Index of a stress, order 11 22 33 23 13 12.
pub(super) fn of_stress(limits: &UniformLimits, stress: &Vector6<f64>) -> Verdict {
    index(limits, &tensor(stress, 1.0), 0.5)
}

/// Index of a strain with engineering shears, order 11 22 33 23 13 12.
pub(super) fn of_strain(limits: &UniformLimits, strain: &Vector6<f64>) -> Verdict {
    index(limits, &tensor(strain, 0.5), 1.0)
}

/// `shear` is the measure of shear per difference of principal values.
fn index(limits: &UniformLimits, tensor: &Matrix3<f64>, shear: f64) -> Verdict {
    let principal = tensor.symmetric_eigenvalues();
    let (low, high) = (principal.min(), principal.max());
    worst_linear([
        (high / limits.tension, Mode::PrincipalTension),
        (-low / limits.compression, Mode::PrincipalCompression),
        (shear * (high - low) / limits.shear, Mode::LargestShear),
    ])
}
