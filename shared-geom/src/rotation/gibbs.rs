//! Gibbs-Rodrigues parameters `g = 2 tan(phi/2) n`: all maps are rational.
//!
//! The parameters are singular at half a turn, where they grow without bound.
//! The integrator therefore uses them for increments only (*updated-updated*
//! scheme): a step measures the history from the last rotation with
//! [`relative`], predicts, and lets Newton's method correct the prediction by
//! further parameters that start from zero, with [`corrected`] and [`linearized`].
//!
//! # Symbols
//! | symbol | meaning | shape |
//! |---|---|---|
//! | `g` | Gibbs-Rodrigues parameters [-] | 3 |
//! | `d` | `4/(4 + g.g)`, the square of `cos(phi/2)` | scalar |
//! | `R` | rotation | 3x3 |
//! | `G` | tangent, `omega = G dg/dt` (spatial) | 3x3 |
//! | `H` | `d(G v)/dg` for a constant vector `v` | 3x3 |
//! | `R0 w0` | rotation and angular velocity that are corrected | 3x3, 3 |
//! | `theta` | virtual rotation, `dR = [theta]x R` | 3 |
//!
//! # References
//! - P. Masarati, PhD thesis, Politecnico di Milano, chapter 3; the
//!   updated-updated scheme is in section 3.4.
//! - O. A. Bauchau, L. Trainelli, "The vectorial parameterization of rotation",
//!   Nonlinear Dynamics 32, 2003.

use super::{Quaternion, skew, skew_skew};
use nalgebra::{Matrix3, Vector3};

/// Rotation of the parameters `g`: `R = I + d ([g]x + 1/2 [g]x [g]x)`.
#[inline]
pub fn to_rotation(g: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() + (skew(g) + 0.5 * skew_skew(g, g)) * scale(g)
}

/// Parameters of the rotation `r`: `g = 2/(1 + tr R) (R32-R23, R13-R31, R21-R12)`.
///
/// Evaluated through the quaternion, `g = 2 q/q0`, which keeps its digits close
/// to half a turn. At half a turn exactly the parameters do not exist, and the
/// result is very large or has components that are not finite.
pub fn from_rotation(r: &Matrix3<f64>) -> Vector3<f64> {
    let q = Quaternion::from_rotation(r);
    q.vector * (2.0 / q.scalar)
}

/// Tangent `G = d (I + 1/2 [g]x)`: spatial angular velocity `omega = G dg/dt`.
///
/// The material one is `R^T omega = G^T dg/dt`. The determinant is `d^2`.
#[inline]
pub fn tangent(g: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() + 0.5 * skew(g)) * scale(g)
}

/// Inverse tangent `G^-1 = I - 1/2 [g]x + 1/4 g g^T`: `dg/dt = G^-1 omega`.
#[inline]
pub fn tangent_inverse(g: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() - 0.5 * skew(g) + 0.25 * g * g.transpose()
}

/// Parameters `c` of the product `R(c) = R(a) R(b)`:
/// `c = 4/(4 - a.b) (a + b + 1/2 a x b)`.
///
/// Not finite, or very large, if the product is half a turn (`a.b = 4`).
pub fn compose(a: &Vector3<f64>, b: &Vector3<f64>) -> Vector3<f64> {
    (a + b + 0.5 * a.cross(b)) * (4.0 / (4.0 - a.dot(b)))
}

/// Derivative of `G v` with respect to `g`, `v` constant:
/// `H = -1/2 d [v]x - 1/2 d^2 (v + 1/2 g x v) g^T`.
#[inline]
pub fn tangent_derivative(g: &Vector3<f64>, v: &Vector3<f64>) -> Matrix3<f64> {
    let d = scale(g);
    -0.5 * d * skew(v) - 0.5 * d * d * (v + 0.5 * g.cross(v)) * g.transpose()
}

/// Derivative of `G^T v` with respect to `g`, `v` constant:
/// `+1/2 d [v]x - 1/2 d^2 (v - 1/2 g x v) g^T`.
#[inline]
pub fn tangent_transpose_derivative(g: &Vector3<f64>, v: &Vector3<f64>) -> Matrix3<f64> {
    let d = scale(g);
    0.5 * d * skew(v) - 0.5 * d * d * (v - 0.5 * g.cross(v)) * g.transpose()
}

/// `d = 4/(4 + g.g)`.
#[inline]
fn scale(g: &Vector3<f64>) -> f64 {
    4.0 / (4.0 + g.norm_squared())
}

/// Rotation and angular velocity of a frame, in the parent frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    /// Rotation matrix, 3x3; columns are the axes of the frame [-].
    pub rotation: Matrix3<f64>,
    /// Spatial angular velocity, 3 components [rad/s].
    pub angular_velocity: Vector3<f64>,
}

/// Rotation increment in Gibbs-Rodrigues parameters, with its rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Increment {
    /// Parameters `g`, 3 components [-].
    pub parameters: Vector3<f64>,
    /// Their time derivative, 3 components [1/s].
    pub rate: Vector3<f64>,
}

/// Expresses `attitude` by parameters counted from the constant rotation `origin`.
///
/// `g = g(R Rorigin^T)`, `dg/dt = G(g)^-1 omega`. The history of a step is relative to
/// the last rotation in this way: the last attitude itself becomes `g = 0`,
/// `dg/dt = omega`. Singular, as [`from_rotation`], if the two rotations are half a turn
/// apart: keep the rotation of a step well below.
pub fn relative(attitude: &Attitude, origin: &Matrix3<f64>) -> Increment {
    let parameters = from_rotation(&(attitude.rotation * origin.transpose()));
    Increment {
        parameters,
        rate: tangent_inverse(&parameters) * attitude.angular_velocity,
    }
}

/// Applies `increment` to `base`, which may itself rotate.
///
/// `R = R(g) R0`, `omega = G(g) dg/dt + R(g) w0`. If `base` is the predicted attitude,
/// this is the corrected one. If `base` is the last rotation, at rest (`w0 = 0`), it is
/// the prediction, and the inverse of [`relative`].
pub fn corrected(increment: &Increment, base: &Attitude) -> Attitude {
    let g = &increment.parameters;
    let turn = to_rotation(g);
    Attitude {
        rotation: turn * base.rotation,
        angular_velocity: tangent(g) * increment.rate + turn * base.angular_velocity,
    }
}

/// Derivatives of a [`corrected`] attitude with respect to its increment.
///
/// With `dg` and `d gdot` the variations of parameters and rate:
/// `theta = rotation dg`, `d omega = velocity dg + velocity_by_rate d gdot`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearization {
    /// Virtual rotation by parameters, 3x3 [-].
    pub rotation: Matrix3<f64>,
    /// Angular velocity by parameters, 3x3 [rad/s].
    pub velocity: Matrix3<f64>,
    /// Angular velocity by rate, 3x3 [-].
    pub velocity_by_rate: Matrix3<f64>,
}

/// Exact linearization of [`corrected`].
///
/// `theta = G dg`, `d omega = G d gdot + H(g, gdot) dg + theta x (R(g) w0)`.
/// At `g = 0`, `gdot = 0` it is the simplified one, `theta = dg`,
/// `d omega = d gdot - omega x dg`, which Masarati (3.10-3.11) keeps throughout
/// the iteration; the exact one converges quadratically from poor predictions too.
pub fn linearized(increment: &Increment, base: &Attitude) -> Linearization {
    let g = &increment.parameters;
    let tangent = tangent(g);
    let carried = to_rotation(g) * base.angular_velocity;
    Linearization {
        rotation: tangent,
        velocity: tangent_derivative(g, &increment.rate) - skew(&carried) * tangent,
        velocity_by_rate: tangent,
    }
}

#[cfg(test)]
#[path = "gibbs_tests.rs"]
mod tests;
