//! Finite rotations: matrices, the skew operator, and two parametrizations;
//! [`parameters`] has the derivatives of the maps of both in one set of formulas.
//!
//! [`gibbs`] has the Gibbs-Rodrigues parameters with which the multibody nodes are
//! integrated (rational formulas, singular at half a turn); [`vector`] has the rotation
//! vector of the exponential map, for input, output and reference. A rotation matrix `R`
//! has the axes of the rotated frame as columns: it transforms components in that frame
//! into components in the parent frame. All angular velocities and virtual rotations are
//! spatial, in parent components: `dR/dt = [omega]x R`, `dR = [theta]x R`.
//!
//! # Example
//!
//! ```
//! use nalgebra::Vector3;
//! use shared_geom::rotation::vector;
//!
//! // a quarter turn about z takes x to y
//! let turn = vector::to_rotation(&Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
//! assert!((turn * Vector3::x() - Vector3::y()).norm() < 1e-15);
//! assert!((vector::from_rotation(&turn).z - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
//! ```
//!
//! # References
//! - P. Masarati, PhD thesis, Politecnico di Milano, chapter 3.
//! - O. A. Bauchau, L. Trainelli, "The vectorial parameterization of rotation",
//!   Nonlinear Dynamics 32, 2003.
//! - S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control
//!   1, 1978.

pub mod gibbs;
pub mod parameters;
pub mod vector;

use nalgebra::{Matrix3, Vector3};

/// The antisymmetric matrix `[a]x` for which `[a]x b = a x b`.
#[inline]
pub fn skew(a: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::new(0.0, -a.z, a.y, a.z, 0.0, -a.x, -a.y, a.x, 0.0)
}

/// `[a]x M`: the cross product of `a` with each column.
#[inline]
pub fn skew_times(a: &Vector3<f64>, m: &Matrix3<f64>) -> Matrix3<f64> {
    let column = |j: usize| {
        let (x, y, z) = (m[(0, j)], m[(1, j)], m[(2, j)]);
        Vector3::new(a.y * z - a.z * y, a.z * x - a.x * z, a.x * y - a.y * x)
    };
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

/// `M [a]x`: the cross product of each row with `a`.
#[inline]
pub fn times_skew(m: &Matrix3<f64>, a: &Vector3<f64>) -> Matrix3<f64> {
    let [x, y, z] = &m.data.0;
    let cross = |p: &[f64; 3], by_p: f64, q: &[f64; 3], by_q: f64| {
        let entry = |i: usize| p[i] * by_p - q[i] * by_q;
        [entry(0), entry(1), entry(2)]
    };
    Matrix3::from([
        cross(y, a.z, z, a.y),
        cross(z, a.x, x, a.z),
        cross(x, a.y, y, a.x),
    ])
}

/// `A B`, with the sums of nalgebra's product to the last bit.
///
/// The kernels of elements use it: the product of matrices of any shape takes five times as many
/// instructions where the code is built with little optimization, as the tests are.
#[inline]
pub fn product(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Matrix3<f64> {
    let [x, y, z] = &a.data.0;
    let column = |by: &[f64; 3]| {
        let entry = |i: usize| x[i] * by[0] + y[i] * by[1] + z[i] * by[2];
        [entry(0), entry(1), entry(2)]
    };
    let [first, second, third] = &b.data.0;
    Matrix3::from([column(first), column(second), column(third)])
}

/// `[a]x [b]x = b a^T - (a.b) I`.
#[inline]
pub fn skew_skew(a: &Vector3<f64>, b: &Vector3<f64>) -> Matrix3<f64> {
    let mut m = b * a.transpose();
    let dot = a.dot(b);
    for i in 0..3 {
        m[(i, i)] -= dot;
    }
    m
}

/// The vector `a` of the antisymmetric part: `[a]x = (m - m^T)/2`.
///
/// Inverse of [`skew`]; the symmetric part of `m` has no influence.
pub fn axial(m: &Matrix3<f64>) -> Vector3<f64> {
    0.5 * Vector3::new(
        m[(2, 1)] - m[(1, 2)],
        m[(0, 2)] - m[(2, 0)],
        m[(1, 0)] - m[(0, 1)],
    )
}

/// Whether `r` is a proper rotation: every entry of `R^T R - I` at most
/// `tolerance` [-] in magnitude, and a positive determinant.
///
/// A matrix with an entry that is not finite is not a rotation.
pub fn is_rotation(r: &Matrix3<f64>, tolerance: f64) -> bool {
    let defect = r.transpose() * r - Matrix3::identity();
    defect.iter().all(|entry| entry.abs() <= tolerance) && r.determinant() > 0.0
}

/// Unit quaternion of a rotation: `scalar = cos(phi/2) >= 0`, `vector = sin(phi/2) n`.
struct Quaternion {
    scalar: f64,
    vector: Vector3<f64>,
}

impl Quaternion {
    /// From a rotation matrix, accurate for every angle (Shepperd 1978).
    ///
    /// ```text
    /// 4 q0 q0 = 1 + tr R       4 q0 qi = R_kj - R_jk
    /// 4 qi qi = 1 - tr R + 2 R_ii     4 qi qj = R_ij + R_ji     (i, j, k cyclic)
    /// ```
    ///
    /// All four components follow from one row of these products, divided by the
    /// largest component, which is at least 1/2: no digits are lost.
    fn from_rotation(r: &Matrix3<f64>) -> Self {
        let trace = r.trace();
        let twice = 2.0 * axial(r);
        let (mut i, mut square) = (0, trace);
        for row in 0..3 {
            if r[(row, row)] > square {
                (i, square) = (row + 1, r[(row, row)]);
            }
        }

        let (scalar, vector) = if i == 0 {
            (1.0 + trace, twice)
        } else {
            let i = i - 1;
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let mut vector = Vector3::zeros();
            vector[i] = 1.0 - trace + 2.0 * r[(i, i)];
            vector[j] = r[(i, j)] + r[(j, i)];
            vector[k] = r[(i, k)] + r[(k, i)];
            (twice[i], vector)
        };

        // Dividing by the norm also removes a small defect of orthogonality.
        let norm = scalar.hypot(vector.norm()).copysign(scalar);
        Self {
            scalar: scalar / norm,
            vector: vector / norm,
        }
    }
}

/// Random rotations, the same in every run, for the tests of this crate.
#[cfg(test)]
pub(crate) mod samples {
    use super::{Matrix3, Vector3, vector};

    /// Linear congruential generator (Knuth's MMIX constants).
    pub(crate) struct Samples(u64);

    impl Samples {
        pub(crate) fn new(seed: u64) -> Self {
            Self(seed)
        }

        /// Uniform in [-1, 1).
        pub(crate) fn scalar(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }

        /// Uniform in the cube [-1, 1)^3.
        pub(crate) fn vector(&mut self) -> Vector3<f64> {
            Vector3::from_fn(|_, _| self.scalar())
        }

        /// Some direction, as a unit vector.
        pub(crate) fn direction(&mut self) -> Vector3<f64> {
            (self.vector() + Vector3::new(0.0, 0.0, 1e-3)).normalize()
        }

        /// Rotation vector with an angle in [0, `limit`) [rad].
        pub(crate) fn rotation_vector(&mut self, limit: f64) -> Vector3<f64> {
            self.direction() * (0.5 * limit * (1.0 + self.scalar()))
        }

        /// Rotation by an angle in [0, `limit`) [rad].
        pub(crate) fn rotation(&mut self, limit: f64) -> Matrix3<f64> {
            vector::to_rotation(&self.rotation_vector(limit))
        }

        /// Gibbs-Rodrigues parameters of an angle in [0, `limit`) [rad].
        pub(crate) fn parameters(&mut self, limit: f64) -> Vector3<f64> {
            let half_angle = 0.25 * limit * (1.0 + self.scalar());
            self.direction() * (2.0 * half_angle.tan())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::samples::Samples;
    use super::*;
    use std::f64::consts::PI;

    // Products of numbers below one: one rounding each.
    #[test]
    fn skew_is_the_cross_product_and_axial_its_inverse() {
        let mut samples = Samples::new(1);
        for _ in 0..100 {
            let (a, b) = (samples.vector(), samples.vector());
            assert!((skew(&a) * b - a.cross(&b)).amax() < 1e-15);
            let m = Matrix3::from_columns(&[a, b, samples.vector()]);
            // Sums of two products of numbers of size one.
            assert!((skew_times(&a, &m) - skew(&a) * m).amax() < 1e-14);
            assert!((times_skew(&m, &b) - m * skew(&b)).amax() < 1e-14);
            assert!((skew_skew(&a, &b) - skew(&a) * skew(&b)).amax() < 1e-14);
            assert_eq!(product(&m, &skew_skew(&a, &b)), m * skew_skew(&a, &b));
            let symmetric = a * b.transpose() + b * a.transpose();
            assert_eq!(axial(&skew(&a)), a);
            assert!((axial(&(skew(&a) + symmetric)) - a).amax() < 1e-15);
        }
    }

    #[test]
    fn a_rotation_is_distinguished_from_reflection_strain_and_nan() {
        let mut samples = Samples::new(2);
        for _ in 0..100 {
            let r = samples.rotation(PI);
            assert!(is_rotation(&r, 2e-15));
            assert!(!is_rotation(&-r, 0.5), "reflections have determinant -1");
            let mut strained = r;
            strained.column_mut(1).scale_mut(1.0 + 1e-6);
            assert!(!is_rotation(&strained, 1e-6));
            assert!(is_rotation(&strained, 3e-6));
            let mut broken = r;
            broken[(2, 0)] = f64::NAN;
            assert!(!is_rotation(&broken, 1e6));
        }
        assert!(!is_rotation(&Matrix3::zeros(), 0.1));
    }

    // The quaternion recovers the rotation: R = (q0^2 - q.q) I + 2 q q^T + 2 q0 [q]x, at
    // all angles; errors are a few roundings of numbers below one.
    #[test]
    fn quaternion_gives_the_rotation_back_at_all_angles() {
        let mut samples = Samples::new(3);
        for case in 0..200 {
            let angle = [1e-9, 1.0, PI - 1e-9, PI][case % 4];
            let r = vector::to_rotation(&(samples.direction() * angle));
            let Quaternion { scalar, vector } = Quaternion::from_rotation(&r);
            assert!(scalar >= 0.0);
            let back = Matrix3::identity() * (scalar * scalar - vector.norm_squared())
                + 2.0 * vector * vector.transpose()
                + 2.0 * scalar * skew(&vector);
            assert!((back - r).amax() < 3e-15);
        }
    }
}
