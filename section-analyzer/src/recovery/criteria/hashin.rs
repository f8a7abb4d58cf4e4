//! The four modes of Hashin, in three dimensions.
//!
//! ```text
//! fiber, s11 >= 0:         (s11/Xt)^2 + q                                        (S-56)
//! fiber, s11 < 0:          (s11/Xc)^2
//! matrix, s22 + s33 >= 0:  (s22 + s33)^2/Yt^2 + (s23^2 - s22 s33)/S23^2 + q      (S-57)
//! matrix, s22 + s33 < 0:   [(Yc/(2 S23))^2 - 1] (s22 + s33)/Yc
//!                            + (s22 + s33)^2/(4 S23^2) + (s23^2 - s22 s33)/S23^2 + q
//! q = (s12/S12)^2 + (s13/S13)^2
//! ```
//!
//! The material is assumed transversely isotropic: the strengths of direction 2 apply to 2
//! and 3. The index of the fiber in compression is squared, as in the other modes. The
//! applicable modes do not change with the size of the load, so that each has its own
//! reserve factor, and the smallest governs.
//!
//! # References
//! - \[Hashin1980\]

use super::{Mode, Verdict, quadratic_reserve};
use crate::material::DirectionalLimits;
use nalgebra::Vector6;

/// Index of a stress in material axes, order 11 22 33 23 13 12.
pub(super) fn index(limits: &DirectionalLimits, s: &Vector6<f64>) -> Verdict {
    let (fiber, matrix) = (of_fiber(limits, s), of_matrix(limits, s));
    if matrix.1 < fiber.1 { matrix } else { fiber }
}

/// Shear along the fiber: q.
fn axial_shear(limits: &DirectionalLimits, s: &Vector6<f64>) -> f64 {
    (s[5] / limits.shear[2]).powi(2) + (s[4] / limits.shear[1]).powi(2)
}

fn of_fiber(limits: &DirectionalLimits, s: &Vector6<f64>) -> Verdict {
    let (index, mode) = if s[0] >= 0.0 {
        let tension = (s[0] / limits.tension[0]).powi(2);
        (tension + axial_shear(limits, s), Mode::FiberTension)
    } else {
        let compression = (s[0] / limits.compression[0]).powi(2);
        (compression, Mode::FiberCompression)
    };
    (index, quadratic_reserve(index, 0.0), mode)
}

fn of_matrix(limits: &DirectionalLimits, s: &Vector6<f64>) -> Verdict {
    let sum = s[1] + s[2];
    let transverse_shear = limits.shear[0];
    let shear = axial_shear(limits, s) + (s[3] / transverse_shear).powi(2);
    if sum >= 0.0 {
        // negative only if 2 S23 < Yt, for tension along 2 and 3 together: the mode then
        // has no factor at which it fails
        let tension = (sum / limits.tension[1]).powi(2);
        let index = tension - s[1] * s[2] / transverse_shear.powi(2) + shear;
        let reserve = quadratic_reserve(index.max(0.0), 0.0);
        return (index, reserve, Mode::MatrixTension);
    }
    let strength = limits.compression[1];
    let linear = ((strength / (2.0 * transverse_shear)).powi(2) - 1.0) * sum / strength;
    // (s22 + s33)^2/4 - s22 s33 as one square
    let quadratic = ((s[1] - s[2]) / (2.0 * transverse_shear)).powi(2) + shear;
    let reserve = quadratic_reserve(quadratic, linear);
    (linear + quadratic, reserve, Mode::MatrixCompression)
}
