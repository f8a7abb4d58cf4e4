//! Six-component vectors and 6x6 matrices: change of point and of axes.
//!
//! The order of the components is the same everywhere: three along the axes, then three
//! about them (see [`COMPONENTS`]). It applies to internal forces (axial force, shears,
//! torque, bendings) and to their conjugates (axial strain, shears, twist and bending
//! rates), and to momenta and velocities with a mass matrix.
//!
//! # Symbols
//! | symbol | meaning | shape |
//! |---|---|---|
//! | `t` | force-like: internal force, momentum | 6 |
//! | `p` | strain-like: generalized strain, velocity; `t = K p` | 6 |
//! | `K` | stiffness or mass, symmetric | 6x6 |
//! | `d` | from the old to the new point, in the section axes [m] | 3 |
//! | `U` | shift of the point | 6x6 |
//! | `Q` | columns are the new axes in the old ones | 3x3 |
//!
//! | change | force-like | strain-like | matrix |
//! |---|---|---|---|
//! | point to `O + d` | `t' = U t` | `p = U^T p'` | `K' = U K U^T` |
//! | axes, `v' = Q^T v` | `t' = S^T t` | `p' = S^T p` | `K' = S^T K S`, `S = diag(Q, Q)` |
//!
//! The change of point is (S-31), the change of axes (S-32). Both preserve the energy
//! `1/2 p^T K p` and the power `t^T p`.
//!
//! # Example
//!
//! ```
//! use nalgebra::{Matrix6, Vector3, Vector6};
//! use shared_geom::wrench::shift;
//!
//! // EA = 4 GN, EIy = EIz = 1 MN m^2, about a point 0.1 m from the elastic axis
//! let k = Matrix6::from_diagonal(&Vector6::new(4e9, 1e9, 1e9, 1e6, 1e6, 1e6));
//! let moved = shift(&k, &Vector3::new(0.0, 0.1, 0.0));
//! // an axial strain now needs a moment about z, and EIz has the term EA d^2
//! assert!((moved[(5, 5)] - (1e6 + 4e9 * 0.01)).abs() < 1.0);
//! assert!((moved[(0, 5)].abs() - 4e8).abs() < 1.0);
//! ```
//!
//! # References
//! - V. Giavotto et al., "Anisotropic beam theory and applications", Computers and
//!   Structures 16, 1983.

use crate::rotation::skew;
use nalgebra::{Matrix3, Matrix6, Vector3};

/// Names of the six components, in their order, of forces and of strains.
pub const COMPONENTS: [&str; 6] = [
    "axial",
    "shear y",
    "shear z",
    "torsion",
    "bending y",
    "bending z",
];

/// The matrix `U = [I 0; -[d]x I]` that moves forces to the point `O + d`.
///
/// `d` has 3 components in the axes of the six-vectors [m]. The force stays; the
/// moment about the new point is `M - d x F`. A 6xn coupling matrix, whose
/// columns are force-like, becomes `U C`.
pub fn shift_matrix(d: &Vector3<f64>) -> Matrix6<f64> {
    let mut u = Matrix6::identity();
    u.fixed_view_mut::<3, 3>(3, 0).copy_from(&-skew(d));
    u
}

/// The matrix `S = diag(Q, Q)`: six components in the new axes to the old ones.
///
/// The columns of `q` are the new axes in the old ones; `v' = S^T v`.
pub fn rotation_matrix(q: &Matrix3<f64>) -> Matrix6<f64> {
    let mut s = Matrix6::zeros();
    s.fixed_view_mut::<3, 3>(0, 0).copy_from(q);
    s.fixed_view_mut::<3, 3>(3, 3).copy_from(q);
    s
}

/// Stiffness or mass `k` about the point `O + d` instead of `O`: `U K U^T`.
///
/// `d` as in [`shift_matrix`] [m]; components stay in the same axes.
pub fn shift(k: &Matrix6<f64>, d: &Vector3<f64>) -> Matrix6<f64> {
    let u = shift_matrix(d);
    u * k * u.transpose()
}

/// Stiffness or mass `k` in new axes at the same point: `S^T K S`.
///
/// The columns of `q` are the new axes in the old ones.
pub fn rotate(k: &Matrix6<f64>, q: &Matrix3<f64>) -> Matrix6<f64> {
    let s = rotation_matrix(q);
    s.transpose() * k * s
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::samples::Samples;
    use nalgebra::Vector6;
    use std::f64::consts::PI;

    // K = A A^T with entries of A and d below one: entries of K up to 6, of U K U^T
    // up to some 50; a few roundings of these, with margin.
    const TOLERANCE: f64 = 1e-13;

    fn stiffness(samples: &mut Samples) -> Matrix6<f64> {
        let a = Matrix6::from_fn(|_, _| samples.scalar());
        a * a.transpose()
    }

    fn six(samples: &mut Samples) -> Vector6<f64> {
        Vector6::from_fn(|_, _| samples.scalar())
    }

    #[test]
    fn shifts_add_up_and_undo_each_other() {
        let mut samples = Samples::new(50);
        for _ in 0..100 {
            let k = stiffness(&mut samples);
            let (a, b) = (samples.vector(), samples.vector());
            assert!((shift(&shift(&k, &a), &-a) - k).amax() < TOLERANCE);
            assert!((shift(&shift(&k, &a), &b) - shift(&k, &(a + b))).amax() < TOLERANCE);
        }
    }

    #[test]
    fn rotations_compose_and_undo_each_other() {
        let mut samples = Samples::new(51);
        for _ in 0..100 {
            let k = stiffness(&mut samples);
            let (p, q) = (samples.rotation(PI), samples.rotation(PI));
            assert!((rotate(&rotate(&k, &q), &q.transpose()) - k).amax() < TOLERANCE);
            assert!((rotate(&rotate(&k, &p), &q) - rotate(&k, &(p * q))).amax() < TOLERANCE);
        }
    }

    // Shifting, then turning the axes: the shift vector turns with them.
    #[test]
    fn shift_and_rotation_commute_with_the_shift_in_its_own_axes() {
        let mut samples = Samples::new(52);
        for _ in 0..100 {
            let (k, d) = (stiffness(&mut samples), samples.vector());
            let q = samples.rotation(PI);
            let turned = shift(&rotate(&k, &q), &(q.transpose() * d));
            assert!((rotate(&shift(&k, &d), &q) - turned).amax() < TOLERANCE);
        }
    }

    // The same physical strain has the components p = U^T p' and p' = S^T p: energy and
    // power are invariant, and t' = K' p' is the transformed t.
    #[test]
    fn energy_and_power_are_invariant() {
        let mut samples = Samples::new(53);
        for _ in 0..100 {
            let (k, d) = (stiffness(&mut samples), samples.vector());
            let (q, strain) = (samples.rotation(PI), six(&mut samples));
            let energy = strain.dot(&(k * strain));

            let shifted = shift_matrix(&-d).transpose() * strain;
            let force = shift(&k, &d) * shifted;
            assert!((shift_matrix(&d).transpose() * shifted - strain).amax() < 1e-15);
            assert!((force - shift_matrix(&d) * k * strain).amax() < TOLERANCE);
            assert!((shifted.dot(&force) - energy).abs() < TOLERANCE);

            let turned = rotation_matrix(&q).transpose() * strain;
            let force = rotate(&k, &q) * turned;
            assert!((force - rotation_matrix(&q).transpose() * k * strain).amax() < TOLERANCE);
            assert!((turned.dot(&force) - energy).abs() < TOLERANCE);
        }
    }

    // A force F at the point P has the moment (P - A) x F about A, for A = O and O + d.
    #[test]
    fn moment_of_a_force_moves_with_the_point() {
        let mut samples = Samples::new(54);
        for _ in 0..100 {
            let (f, p, d) = (samples.vector(), samples.vector(), samples.vector());
            let about = |a: Vector3<f64>| {
                let m = (p - a).cross(&f);
                Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z)
            };
            let moved = shift_matrix(&d) * about(Vector3::zeros());
            assert!((moved - about(d)).amax() < 1e-15);
        }
    }

    // Point mass m at c. About O its momentum is m v, its moment c x m v, with
    // v = v_O + w x c:  M = m [I, -[c]x; [c]x, (c.c) I - c c^T], closed form.
    #[test]
    fn mass_matrix_of_a_point_mass() {
        let mut samples = Samples::new(55);
        for _ in 0..100 {
            let (m, c) = (1.5 + samples.scalar(), samples.vector());
            let mut own = Matrix6::zeros();
            own.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);

            let mut exact = own;
            let inertia = Matrix3::identity() * c.norm_squared() - c * c.transpose();
            exact
                .fixed_view_mut::<3, 3>(0, 3)
                .copy_from(&(-m * skew(&c)));
            exact
                .fixed_view_mut::<3, 3>(3, 0)
                .copy_from(&(m * skew(&c)));
            exact.fixed_view_mut::<3, 3>(3, 3).copy_from(&(m * inertia));

            // From the mass to O is a shift by -c, relative to the mass.
            assert!((shift(&own, &-c) - exact).amax() < TOLERANCE);
            assert!((shift(&exact, &c) - own).amax() < TOLERANCE);
        }
    }

    // Steiner: EA = 2 at (y, z) = (0.3, 0.1) adds EA z^2 to bending y and EA y^2 to
    // bending z; an axial force there bends by M_y = z F, M_z = -y F.
    #[test]
    fn axial_stiffness_off_the_reference_bends_with_the_known_signs() {
        let mut k = Matrix6::zeros();
        k[(0, 0)] = 2.0;
        let moved = shift(&k, &Vector3::new(0.0, -0.3, -0.1));
        let expected = [
            (0, 0, 2.0),
            (0, 4, 0.2),
            (0, 5, -0.6),
            (4, 4, 0.02),
            (4, 5, -0.06),
        ];
        for (row, column, value) in expected {
            assert!((moved[(row, column)] - value).abs() < 1e-16);
        }
        assert!((moved[(5, 5)] - 0.18).abs() < 1e-16);
    }
}
