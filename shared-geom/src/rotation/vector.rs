//! Rotation vector: direction is the axis, length the angle [rad].
//!
//! The map to a rotation is the matrix exponential of the skew matrix. It has no
//! singularity; its inverse is unique for angles below half a turn, and its
//! tangent has an inverse for angles below a full turn.
//!
//! # Symbols
//! | symbol | meaning | shape |
//! |---|---|---|
//! | `phi` | rotation vector [rad] | 3 |
//! | `x` | its length, the angle [rad] | scalar |
//! | `R` | rotation `exp [phi]x` | 3x3 |
//! | `T` | tangent, `omega = T dphi/dt` (spatial) | 3x3 |
//! | `a b c` | `sin x / x`, `(1 - cos x)/x^2`, `(x - sin x)/x^3` | scalars |
//!
//! # References
//! - O. A. Bauchau, L. Trainelli, "The vectorial parameterization of rotation",
//!   Nonlinear Dynamics 32, 2003.

use super::{Quaternion, axial, skew};
use nalgebra::{Matrix3, Vector3};

/// Square of the sine of an angle below which the series of the arcsine suffices: the next term is
/// 0.012 1e-16.
const SMALL_SINE: f64 = 0.01;
/// `arcsin(s)/s` in powers of s^2.
const ARCSINE: [f64; 8] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    5.0 / 112.0,
    35.0 / 1152.0,
    63.0 / 2816.0,
    231.0 / 13312.0,
    143.0 / 10240.0,
];

/// Rotation of the rotation vector `phi` [rad]: `R = I + a [phi]x + b [phi]x [phi]x`.
///
/// Defined for every angle.
pub fn to_rotation(phi: &Vector3<f64>) -> Matrix3<f64> {
    let angle = phi.norm();
    let s = skew(phi);
    Matrix3::identity() + s * sine_ratio(angle) + s * s * cosine_ratio(angle)
}

/// Rotation vector [rad] of the rotation `r`, of length at most pi.
///
/// Accurate at all angles, through the quaternion: `phi = 2 atan2(|q|, q0) q/|q|`, and at small ones
/// through the axial part `s = sin(x) n` of R: `phi = (arcsin|s|/|s|) s`.
/// At half a turn both signs of the axis are right, and either may be returned.
/// A small defect of orthogonality is removed, or at small angles changes the vector by a part of the
/// same size; for a matrix that is far from a
/// rotation (see [`super::is_rotation`]) the result has no meaning.
pub fn from_rotation(r: &Matrix3<f64>) -> Vector3<f64> {
    let sine = axial(r);
    let square = sine.norm_squared();
    if square < SMALL_SINE && r.trace() > 1.0 {
        let terms = ARCSINE.iter().rev();
        return sine * terms.fold(0.0, |sum, term| sum * square + term);
    }
    let q = Quaternion::from_rotation(r);
    let sine = q.vector.norm();
    if sine > 0.0 {
        q.vector * (2.0 * sine.atan2(q.scalar) / sine)
    } else {
        2.0 * q.vector
    }
}

/// Tangent `T` of the exponential map: `omega = T dphi/dt`, spatial.
///
/// `T = I + b [phi]x + c [phi]x [phi]x`; the material angular velocity is
/// `R^T omega = T^T dphi/dt`. Singular at a full turn.
pub fn tangent(phi: &Vector3<f64>) -> Matrix3<f64> {
    let angle = phi.norm();
    let s = skew(phi);
    Matrix3::identity() + s * cosine_ratio(angle) + s * s * cubic_ratio(angle)
}

/// Inverse tangent: `dphi/dt = T^-1 omega`.
///
/// `T^-1 = I - 1/2 [phi]x + e [phi]x [phi]x`, `e = (1 - x/2 cot(x/2))/x^2`.
/// For angles below a full turn, where it is singular (entries without bound).
pub fn tangent_inverse(phi: &Vector3<f64>) -> Matrix3<f64> {
    // With y = x/2: e = (sin y - y cos y)/(4 y^2 sin y) = (b(y) - c(y))/(4 a(y)),
    // where b - c falls from 1/3 at zero without cancellation.
    let half = 0.5 * phi.norm();
    let e = (cosine_ratio(half) - cubic_ratio(half)) / (4.0 * sine_ratio(half));
    let s = skew(phi);
    Matrix3::identity() - s * 0.5 + s * s * e
}

/// Derivative of `T^-1 v` with respect to `phi`, `v` constant:
/// `1/2 [v]x - e ([phi x v]x + [phi]x [v]x) + e'/x (phi x (phi x v)) phi^T`.
///
/// The derivative of `T^-T v` is the same at `-phi`, with the other sign.
pub fn tangent_inverse_derivative(phi: &Vector3<f64>, v: &Vector3<f64>) -> Matrix3<f64> {
    let half = 0.5 * phi.norm();
    let e = (cosine_ratio(half) - cubic_ratio(half)) / (4.0 * sine_ratio(half));
    let once = phi.cross(v);
    0.5 * skew(v) - (skew(&once) + skew(phi) * skew(v)) * e
        + phi.cross(&once) * phi.transpose() * inverse_ratio_slope(phi.norm())
}

/// `e'/x = ((y/sin y)^2 + y cot y - 2)/x^4`, `y = x/2`, of [`tangent_inverse`].
///
/// The closed form loses `eps/x^4` by cancellation. Below half a radian the Taylor
/// series `sum 2 (m + 1) |B_(2m+4)|/(2m+4)! x^2m` with the Bernoulli numbers is used;
/// its seven terms leave 3e-15 of the value.
fn inverse_ratio_slope(x: f64) -> f64 {
    const COEFFICIENTS: [f64; 7] = [
        1.0 / 360.0,
        1.0 / 7560.0,
        1.0 / 201_600.0,
        1.0 / 5_987_520.0,
        691.0 / 130_767_436_800.0,
        1.0 / 6_227_020_800.0,
        3617.0 / 762_187_345_920_000.0,
    ];
    if x > 0.5 {
        let y = 0.5 * x;
        return ((y / y.sin()).powi(2) + y / y.tan() - 2.0) / x.powi(4);
    }
    let add = |sum: f64, coefficient: &f64| sum * x * x + coefficient;
    COEFFICIENTS.iter().rev().fold(0.0, add)
}

/// `a = sin x / x`. The quotient is accurate to rounding for every `x` except zero.
fn sine_ratio(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// `b = (1 - cos x)/x^2 = 1/2 (sin(x/2)/(x/2))^2`, free of cancellation.
fn cosine_ratio(x: f64) -> f64 {
    0.5 * sine_ratio(0.5 * x).powi(2)
}

/// `c = (x - sin x)/x^3`.
///
/// The closed form loses a relative `6 eps/x^2` by cancellation, 1e-15 at one
/// radian and without bound near zero. Below one radian the Taylor series
/// `sum (-1)^k x^2k/(2k+3)!` is used; its eight terms leave `x^16/19! < 1e-17`,
/// half a unit in the last place of 1/6.
fn cubic_ratio(x: f64) -> f64 {
    if x > SERIES_LIMIT {
        return (x - x.sin()) / (x * x * x);
    }

    // Nested: 1/6 (1 - x^2/(4.5) (1 - x^2/(6.7) (1 - ...))).
    let square = x * x;
    (1..SERIES_TERMS).rev().fold(1.0, |inner, k| {
        let n = 2.0 * f64::from(k);
        1.0 - square / ((n + 2.0) * (n + 3.0)) * inner
    }) / 6.0
}

/// Angle [rad] below which [`cubic_ratio`] uses its series; a larger value
/// needs more terms, a smaller one loses digits in the closed form.
const SERIES_LIMIT: f64 = 1.0;

/// Number of terms of that series.
const SERIES_TERMS: u8 = 8;

#[cfg(test)]
mod tests {
    use super::super::samples::Samples;
    use super::super::{axial, is_rotation};
    use super::*;
    use std::f64::consts::PI;

    // Oracle: the matrix exponential of nalgebra (scaling and squaring), which is
    // good to some 1e-14 for a norm of 6.
    #[test]
    fn rotation_is_the_matrix_exponential() {
        let mut samples = Samples::new(10);
        for _ in 0..200 {
            let phi = samples.rotation_vector(2.0 * PI);
            let r = to_rotation(&phi);
            assert!((r - skew(&phi).exp()).amax() < 2e-14);
            assert!(is_rotation(&r, 3e-15));
        }
    }

    // Angles up to and including pi; the inverse map amplifies roundings of R by
    // no more than a few units, times pi for the length.
    #[test]
    fn rotation_vector_comes_back_at_all_angles() {
        let mut samples = Samples::new(11);
        for angle in [
            0.0,
            1e-300,
            1e-12,
            1e-8,
            1e-4,
            0.1,
            0.3,
            1.0,
            2.0,
            3.0,
            PI - 1e-3,
            PI - 1e-9,
        ] {
            for _ in 0..20 {
                let phi = samples.direction() * angle;
                assert!((from_rotation(&to_rotation(&phi)) - phi).amax() < 5e-15);
            }
        }
    }

    // At half a turn the sign of the axis is free; R itself must be recovered.
    // sin(PI) = 1.2e-16 in double precision, hence the exact matrix 2 n n^T - I too.
    #[test]
    fn half_a_turn_gives_one_of_the_two_axes() {
        let mut samples = Samples::new(12);
        let mut axes = vec![Vector3::x(), Vector3::y(), Vector3::z(), -Vector3::x()];
        axes.extend((0..100).map(|_| samples.direction()));
        for n in axes {
            let exact = 2.0 * n * n.transpose() - Matrix3::identity();
            for r in [exact, to_rotation(&(n * PI)), to_rotation(&(n * -PI))] {
                let phi = from_rotation(&r);
                assert!((phi.norm() - PI).abs() < 3e-15);
                assert!((phi - n * PI).amax().min((phi + n * PI).amax()) < 1e-14);
                assert!((to_rotation(&phi) - r).amax() < 3e-15);
            }
        }
    }

    // Relative accuracy for small angles: an angle of 1e-9 keeps its digits, since
    // off-diagonal entries of R are proportional to it.
    #[test]
    fn small_angles_keep_their_digits() {
        let mut samples = Samples::new(13);
        for angle in [1e-3, 1e-6, 1e-9, 1e-100] {
            let phi = samples.direction() * angle;
            assert!((from_rotation(&to_rotation(&phi)) - phi).amax() < 1e-12 * angle);
        }
    }

    // Central differences of R with h = 1e-6: rounding 1e-16/h = 1e-10, times the
    // terms of R, which reach 10 before they cancel; truncation h^2/6 below 1e-12.
    #[test]
    fn tangent_agrees_with_finite_differences() {
        let (mut samples, h) = (Samples::new(14), 1e-6);
        for _ in 0..200 {
            let (phi, rate) = (samples.rotation_vector(6.0), samples.vector());
            let ahead = to_rotation(&(phi + rate * h));
            let behind = to_rotation(&(phi - rate * h));
            let r = to_rotation(&phi);
            let omega = axial(&((ahead - behind) / (2.0 * h) * r.transpose()));
            assert!((tangent(&phi) * rate - omega).amax() < 2e-9);
            // Material angular velocity: R^T T = T^T, products of numbers of order 1.
            assert!((r.transpose() * tangent(&phi) - tangent(&phi).transpose()).amax() < 5e-15);
        }
    }

    // det T = 2 (1 - cos x)/x^2 = 0.08 at 5 rad, so that T^-1 has entries of up to 10.
    #[test]
    fn tangent_inverse_inverts() {
        let mut samples = Samples::new(15);
        for limit in [5.0, 1e-3, 1e-7] {
            for _ in 0..100 {
                let phi = samples.rotation_vector(limit);
                let product = tangent(&phi) * tangent_inverse(&phi);
                assert!((product - Matrix3::identity()).amax() < 2e-14);
            }
        }
        assert_eq!(tangent_inverse(&Vector3::zeros()), Matrix3::identity());
    }

    // Both branches of c against (x - sin x)/x^3 evaluated with 50 digits, on both
    // sides of the switch-over; 6 eps/x^2 allowed to the closed form.
    #[test]
    fn cubic_ratio_is_accurate_on_both_sides_of_its_switch() {
        for (x, exact) in [
            (0.0, 1.0 / 6.0),
            (1e-3, 0.166_666_658_333_333_52),
            (0.01, 0.166_665_833_335_317_45),
            (0.1, 0.166_583_353_171_847_7),
            (0.5, 0.164_595_691_166_375_98),
            (1.0, 0.158_529_015_192_103_5),
            (1.25, 0.154_119_874_889_939_86),
            (2.0, 0.136_337_821_646_789_8),
        ] {
            assert!((cubic_ratio(x) / exact - 1.0).abs() < 1.4e-15, "x = {x}");
        }
        let jump = cubic_ratio(1.0) - cubic_ratio(1.0 + f64::EPSILON);
        assert!(jump.abs() < 3e-16);
    }

    // Central differences with h = 1e-6: rounding 1e-16/h = 1e-10 of terms below ten;
    // angles on both sides of the switch of series, up to where T^-1 becomes singular.
    #[test]
    fn derivative_of_the_inverse_tangent() {
        let mut samples = Samples::new(15);
        for angle in [0.0, 1e-3, 0.4, 0.49, 0.51, 1.0, 2.0, 4.0] {
            for _ in 0..20 {
                let phi = samples.direction() * angle;
                let v = samples.vector();
                let difference = Matrix3::from_columns(&std::array::from_fn::<_, 3, _>(|i| {
                    let mut by = Vector3::zeros();
                    by[i] = 1e-6;
                    (tangent_inverse(&(phi + by)) - tangent_inverse(&(phi - by))) * v / 2e-6
                }));
                let exact = tangent_inverse_derivative(&phi, &v);
                assert!((exact - difference).amax() < 1e-8, "{angle}");
                // T^-T at phi is T^-1 at -phi.
                let transposed = tangent_inverse(&phi).transpose() - tangent_inverse(&-phi);
                assert!(transposed.amax() < 1e-14);
            }
        }
    }

    // Both forms at one angle: eps/x^4 = 4e-15 of the closed one, against 1/360.
    #[test]
    fn the_series_of_the_slope_meets_the_closed_form() {
        let jump = inverse_ratio_slope(0.5) - inverse_ratio_slope(0.5 + 1e-12);
        assert!(jump.abs() < 2e-14, "{jump:e}");
    }
}
