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

/// An upper bound of the inverse of the reserve factor for all stresses from `low` to `high`, each
/// component by itself: with the largest value of each term of the modes that are possible.
pub(super) fn bound(limits: &DirectionalLimits, low: &Vector6<f64>, high: &Vector6<f64>) -> f64 {
    let square = |low: f64, high: f64| (low * low).max(high * high);
    let most = |i: usize, strength: f64| square(low[i], high[i]) / (strength * strength);
    let [s23, s13, s12] = limits.shear;
    let q = most(5, s12) + most(4, s13);
    let fiber = if high[0] >= 0.0 {
        ((high[0] / limits.tension[0]).powi(2) + q).sqrt()
    } else {
        0.0
    };
    let fiber = fiber.max(-low[0] / limits.compression[0]);
    let shear = most(3, s23) + q;
    let sums = [low[1] + low[2], high[1] + high[2]];
    let [yt, yc] = [limits.tension[1], limits.compression[1]];
    let mut matrix = 0.0_f64;
    if sums[1] >= 0.0 {
        let pairs = [(low, low), (low, high), (high, low), (high, high)];
        let products = pairs.map(|(a, b)| -a[1] * b[2]);
        let product = products.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let index = (sums[1] / yt).powi(2) + product / (s23 * s23) + shear;
        matrix = index.max(0.0).sqrt();
    }
    if sums[0] < 0.0 {
        let factor = ((yc / (2.0 * s23)).powi(2) - 1.0) / yc;
        let sum = if factor > 0.0 {
            sums[1].min(0.0)
        } else {
            sums[0]
        };
        let linear = factor * sum;
        let quadratic = square(low[1] - high[2], high[1] - low[2]) / (2.0 * s23).powi(2) + shear;
        let root = (linear * linear + 4.0 * quadratic).sqrt();
        matrix = matrix.max(0.5 * (linear + root));
    }
    fiber.max(matrix)
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
