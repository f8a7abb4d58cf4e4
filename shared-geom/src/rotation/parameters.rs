//! Vectorial parameters of a rotation: one set of formulas, two sets of coefficients.
//!
//! ```text
//! T v    = a v + b psi x v + c (psi . v) psi          omega = T d psi/dt, spatial
//! T^-1 v = i v - 1/2 psi x v + e (psi . v) psi        T^T(psi) = T(-psi)
//! ```
//!
//! with `x = psi . psi`; the index 1 is `2 d/dx`, 2 is that twice:
//!
//! ```text
//! rotation vector  a = sin(f)/f, b = (1 - cos f)/f^2, c = (1 - a)/f^2, f = |psi|
//!                  e = (1 - (f/2) cot(f/2))/f^2, i = 1 - e x
//! Gibbs            a = 1/(1 + x/4), b = a/2, c = 0, e = 1/4, i = 1
//!
//! D(T.; v)    = (a1 v + b1 psi x v + c1 (psi . v) psi) psi^T - b [v]x + c (psi v^T + (psi . v) I)
//! D(T^-1.; v) = (i1 v + e1 (psi . v) psi) psi^T + 1/2 [v]x + e (psi v^T + (psi . v) I)
//! ```
//!
//! and for `k = T^T psi'`, the rotation per length of a change psi' of the parameters:
//!
//! ```text
//! S     = d k/d psi
//! S^T m = k_1 psi + b t + c u
//! H     = d^2 (k . m)/d psi^2
//!       = k_1 I + k_2 psi psi^T + psi (b1 t + c1 u)^T + (b1 t + c1 u) psi^T
//!         + c (m psi'^T + psi' m^T)
//! P = psi . m, Q = psi . psi', t = m x psi', u = Q m + P psi', k_n = a_n psi'.m + b_n psi.t + c_n P Q
//! ```
//!
//! # References
//! - O. A. Bauchau, L. Trainelli, "The vectorial parameterization of rotation",
//!   Nonlinear Dynamics 32, 2003.

use nalgebra::{Matrix3, Vector3};

use super::{gibbs, skew, vector};

/// A vectorial parametrization of rotations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parametrization {
    /// Axis times angle: unique below half a turn, regular below a full one.
    RotationVector,
    /// Axis times twice the tangent of half the angle: without bound at half a turn.
    Gibbs,
}

impl Parametrization {
    /// Parameters of the rotation `r` [rad].
    pub fn of_rotation(self, r: &Matrix3<f64>) -> Vector3<f64> {
        match self {
            Self::RotationVector => vector::from_rotation(r),
            Self::Gibbs => gibbs::from_rotation(r),
        }
    }

    /// The maps at the parameters `psi`.
    #[inline]
    pub fn at(self, psi: &Vector3<f64>) -> RotationMap {
        RotationMap {
            psi: *psi,
            scale: match self {
                Self::RotationVector => Scale::of_vector(psi.norm_squared()),
                Self::Gibbs => Scale::of_gibbs(psi.norm_squared()),
            },
        }
    }
}

/// The maps of a parametrization at a rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationMap {
    /// The parameters, 3 components [rad].
    pub psi: Vector3<f64>,
    scale: Scale,
}

/// Coefficients of the maps.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale {
    /// a, b, c with their derivatives 1 and 2.
    a: [f64; 3],
    b: [f64; 3],
    c: [f64; 3],
    /// e and i with their derivative 1.
    e: [f64; 2],
    i: [f64; 2],
}

/// `1/(2k + 2)!`, `1/(2k + 3)!` with alternating signs, and `|B_2k+2|/(2k + 2)!`: terms of the
/// series of b, c and e. At x = 1 the last ones are below 1e-20 of the first.
const SERIES: [[f64; 3]; 14] = series();
/// Below these x as many terms suffice: the next one of e, the slowest, which falls by 39,
/// is (x/39)^5 or (x/39)^7, below 1e-22.
const SMALL: [(f64, usize); 2] = [(1e-3, 5), (0.02, 7)];

const fn series() -> [[f64; 3]; 14] {
    const E: [f64; 14] = [
        8.333_333_333_333_333e-2,
        1.388_888_888_888_889e-3,
        3.306_878_306_878_307e-5,
        8.267_195_767_195_767e-7,
        2.087_675_698_786_81e-8,
        5.284_190_138_687_493e-10,
        1.338_253_653_068_467_9e-11,
        3.389_680_296_322_583e-13,
        8.586_062_056_277_845e-15,
        2.174_868_698_558_062e-16,
        5.509_002_828_360_23e-18,
        1.395_446_468_581_252_3e-19,
        3.534_707_039_629_467e-21,
        8.953_517_427_037_547e-23,
    ];
    let mut terms = [[0.0; 3]; 14];
    let (mut k, mut b) = (0, 0.5);
    while k < terms.len() {
        let n = 2.0 * k as f64;
        terms[k] = [b, b / (n + 3.0), E[k]];
        b /= -(n + 3.0) * (n + 4.0);
        k += 1;
    }
    terms
}

impl Scale {
    fn of_gibbs(x: f64) -> Self {
        let a = 1.0 / (1.0 + 0.25 * x);
        let all = [a, -0.5 * a * a, 0.5 * a * a * a];
        Self {
            a: all,
            b: all.map(|value| 0.5 * value),
            c: [0.0; 3],
            e: [0.25, 0.0],
            i: [1.0, 0.0],
        }
    }

    fn of_vector(x: f64) -> Self {
        if x < 1.0 {
            Self::by_series(x)
        } else {
            Self::in_closed_form(x)
        }
    }

    /// The closed forms divide differences by x once per differentiation.
    fn by_series(x: f64) -> Self {
        let count = SMALL.iter().find(|(limit, _)| x < *limit);
        let terms = &SERIES[..count.map_or(SERIES.len(), |(_, count)| *count)];
        // value, first and half the second derivative by x of b, c, e
        let mut sums = [[0.0; 3]; 3];
        for terms in terms.iter().rev() {
            for (sum, term) in sums.iter_mut().zip(terms) {
                sum[2] = sum[2] * x + sum[1];
                sum[1] = sum[1] * x + sum[0];
                sum[0] = sum[0] * x + term;
            }
        }
        let [b, c, e] = sums.map(|[value, first, half]| [value, 2.0 * first, 8.0 * half]);
        Self::new(1.0 - c[0] * x, b, c, [e[0], e[1]], x)
    }

    fn in_closed_form(x: f64) -> Self {
        let f = x.sqrt();
        let (sine, cosine) = (0.5 * f).sin_cos();
        let a = 2.0 * sine * cosine / f;
        let b = 2.0 * sine * sine / x;
        let c = (1.0 - a) / x;
        let a1 = c - b;
        let (b1, c1) = ((a - 2.0 * b) / x, (b - 3.0 * c) / x);
        let (b2, c2) = ((a1 - 4.0 * b1) / x, (b1 - 5.0 * c1) / x);
        let cotangent = cosine / sine;
        let e = (1.0 - 0.5 * f * cotangent) / x;
        let slope = (-0.5 * cotangent + 0.25 * f / (sine * sine)) / f;
        Self::new(a, [b, b1, b2], [c, c1, c2], [e, (slope - 2.0 * e) / x], x)
    }

    fn new(a: f64, b: [f64; 3], c: [f64; 3], e: [f64; 2], x: f64) -> Self {
        Self {
            a: [a, c[0] - b[0], c[1] - b[1]],
            b,
            c,
            e,
            i: [1.0 - e[0] * x, -(e[1] * x + 2.0 * e[0])],
        }
    }
}

impl RotationMap {
    /// Rotation matrix `R = I + T [psi]x`, 3x3.
    #[inline]
    pub fn rotation(&self) -> Matrix3<f64> {
        Matrix3::identity() + self.tangent() * skew(&self.psi)
    }

    /// T, 3x3.
    #[inline]
    pub fn tangent(&self) -> Matrix3<f64> {
        let Self { psi, scale } = self;
        let axis = scale.b[0] * skew(psi) + scale.c[0] * psi * psi.transpose();
        axis + Matrix3::from_diagonal_element(scale.a[0])
    }

    /// T^-1, 3x3.
    #[inline]
    pub fn tangent_inverse(&self) -> Matrix3<f64> {
        let Self { psi, scale } = self;
        let axis = -0.5 * skew(psi) + scale.e[0] * psi * psi.transpose();
        axis + Matrix3::from_diagonal_element(scale.i[0])
    }

    /// Derivative of `T v` by psi, 3x3.
    #[inline]
    pub fn tangent_derivative(&self, v: &Vector3<f64>) -> Matrix3<f64> {
        self.tangent_derivative_at(1.0, v)
    }

    /// Derivative of `T^T v` by psi, 3x3: S for `v = psi'`.
    #[inline]
    pub fn tangent_transpose_derivative(&self, v: &Vector3<f64>) -> Matrix3<f64> {
        -self.tangent_derivative_at(-1.0, v)
    }

    /// `D(T.; v)` at `sign psi`.
    #[inline]
    fn tangent_derivative_at(&self, sign: f64, v: &Vector3<f64>) -> Matrix3<f64> {
        let Scale { a, b, c, .. } = &self.scale;
        let psi = sign * self.psi;
        let along = psi.dot(v);
        let slope = a[1] * v + b[1] * psi.cross(v) + c[1] * along * psi;
        slope * psi.transpose() - b[0] * skew(v)
            + c[0] * psi * v.transpose()
            + Matrix3::from_diagonal_element(c[0] * along)
    }

    /// Derivative of `T^-1 v` by psi, 3x3.
    #[inline]
    pub fn tangent_inverse_derivative(&self, v: &Vector3<f64>) -> Matrix3<f64> {
        self.inverse_derivative_at(1.0, v)
    }

    /// Derivative of `T^-T v` by psi, 3x3.
    #[inline]
    pub fn tangent_inverse_transpose_derivative(&self, v: &Vector3<f64>) -> Matrix3<f64> {
        -self.inverse_derivative_at(-1.0, v)
    }

    #[inline]
    fn inverse_derivative_at(&self, sign: f64, v: &Vector3<f64>) -> Matrix3<f64> {
        let Scale { e, i, .. } = &self.scale;
        let psi = sign * self.psi;
        let along = psi.dot(v);
        (i[1] * v + e[1] * along * psi) * psi.transpose()
            + 0.5 * skew(v)
            + e[0] * psi * v.transpose()
            + Matrix3::from_diagonal_element(e[0] * along)
    }

    /// H, the second derivative of `psi' . T m` by psi, 3x3 symmetric.
    #[inline]
    pub fn second_derivative(&self, slope: &Vector3<f64>, m: &Vector3<f64>) -> Matrix3<f64> {
        let Self { psi, scale } = self;
        let Scale { a, b, c, .. } = scale;
        let (p, q, t) = (psi.dot(m), psi.dot(slope), m.cross(slope));
        let u = q * m + p * slope;
        let k = |n: usize| a[n] * slope.dot(m) + b[n] * psi.dot(&t) + c[n] * p * q;
        let half = 0.5 * k(2) * psi + b[1] * t + c[1] * u;
        let product = psi * half.transpose() + c[0] * m * slope.transpose();
        product + product.transpose() + Matrix3::from_diagonal_element(k(1))
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::Samples;
    use super::*;

    /// Central differences of a vector function of psi.
    fn differences(
        psi: &Vector3<f64>,
        of: impl Fn(&RotationMap) -> Vector3<f64>,
        kind: Parametrization,
    ) -> Matrix3<f64> {
        let h = 1e-5;
        Matrix3::from_columns(&std::array::from_fn::<_, 3, _>(|i| {
            let mut by = Vector3::zeros();
            by[i] = h;
            (of(&kind.at(&(psi + by))) - of(&kind.at(&(psi - by)))) / (2.0 * h)
        }))
    }

    const KINDS: [Parametrization; 2] = [Parametrization::RotationVector, Parametrization::Gibbs];

    // The maps of the two other modules, which are tested by the exponential. Products of
    // numbers below ten.
    #[test]
    fn the_maps_are_those_of_each_parametrization() {
        let mut samples = Samples::new(41);
        for case in 0..400 {
            let psi = samples.direction() * [1e-9, 1e-3, 0.5, 0.999, 1.001, 2.0, 2.9][case % 7];
            let of_vector = Parametrization::RotationVector.at(&psi);
            let of_gibbs = Parametrization::Gibbs.at(&psi);
            let pairs = [
                (of_vector.rotation(), vector::to_rotation(&psi)),
                (of_vector.tangent(), vector::tangent(&psi)),
                (of_vector.tangent_inverse(), vector::tangent_inverse(&psi)),
                (of_gibbs.rotation(), gibbs::to_rotation(&psi)),
                (of_gibbs.tangent(), gibbs::tangent(&psi)),
                (of_gibbs.tangent_inverse(), gibbs::tangent_inverse(&psi)),
            ];
            for (position, (found, expected)) in pairs.into_iter().enumerate() {
                let difference = (found - expected).amax();
                assert!(difference < 1e-14, "{position} at {psi}: {difference:e}");
            }
        }
    }

    // Step 1e-5: rounding 1e-16/1e-5 times terms of ten, truncation 1e-10 times third
    // derivatives of order one.
    #[test]
    fn every_derivative_agrees_with_differences() {
        let mut samples = Samples::new(42);
        for case in 0..400 {
            let psi = samples.direction() * [1e-3, 0.01, 0.5, 0.99, 1.01, 1.5, 2.9][case % 7];
            let (v, m) = (samples.vector(), samples.vector());
            for kind in KINDS {
                let at = kind.at(&psi);
                let pairs = [
                    (
                        at.tangent_derivative(&v),
                        differences(&psi, |at| at.tangent() * v, kind),
                    ),
                    (
                        at.tangent_transpose_derivative(&v),
                        differences(&psi, |at| at.tangent().transpose() * v, kind),
                    ),
                    (
                        at.tangent_inverse_derivative(&v),
                        differences(&psi, |at| at.tangent_inverse() * v, kind),
                    ),
                    (
                        at.tangent_inverse_transpose_derivative(&v),
                        differences(&psi, |at| at.tangent_inverse().transpose() * v, kind),
                    ),
                    (
                        at.second_derivative(&v, &m),
                        differences(
                            &psi,
                            |at| at.tangent_transpose_derivative(&v).transpose() * m,
                            kind,
                        ),
                    ),
                ];
                for (position, (exact, difference)) in pairs.into_iter().enumerate() {
                    let error = (exact - difference).amax();
                    assert!(error < 2e-9, "{kind:?} {position} at {psi}: {error:e}");
                }
            }
        }
    }

    // Both forms at x = 1, at which the closed ones lose a few times eps/x^2 at most.
    #[test]
    fn series_and_closed_forms_meet() {
        let (series, closed) = (Scale::by_series(1.0), Scale::in_closed_form(1.0));
        let list = |scale: &Scale| [&scale.a[..], &scale.b, &scale.c, &scale.e, &scale.i].concat();
        for (one, other) in list(&series).into_iter().zip(list(&closed)) {
            assert!((one - other).abs() < 2e-15, "{one} {other}");
        }
    }
}
