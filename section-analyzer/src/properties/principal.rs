//! Principal axes of bending and of rotary inertia.

use nalgebra::{Matrix2, Matrix6, Vector3};
use shared_geom::wrench;

/// Relative difference of the two principal values below which every direction
/// is principal: the round-off of a symmetric section.
const EQUAL: f64 = 1e-9;

/// Axes in the section along which a symmetric 2x2 quantity is uncoupled.
///
/// The first axis is the one nearest to +y, so that turning the section axes by
/// `angle` turns (bending y, bending z) into (first, second).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    /// Angle from +y to the first axis, positive towards +z, within -pi/4 and
    /// pi/4 \[rad\]; zero when all directions are equal.
    pub angle: f64,
    /// Value about the first axis: stiffness \[N m^2\] or inertia \[kg m\].
    pub first: f64,
    /// Value about the second axis: stiffness \[N m^2\] or inertia \[kg m\].
    pub second: f64,
}

impl PrincipalAxes {
    /// Principal axes of a symmetric tensor over (y, z).
    ///
    /// ```text
    /// angle = 1/2 atan(2 t_yz / (t_yy - t_zz))
    /// first, second = (t_yy + t_zz)/2 +- sign(t_yy - t_zz) sqrt(((t_yy - t_zz)/2)^2 + t_yz^2)
    /// ```
    pub fn of_tensor(t: &Matrix2<f64>) -> Self {
        let mean = 0.5 * (t[(0, 0)] + t[(1, 1)]);
        let half = 0.5 * (t[(0, 0)] - t[(1, 1)]);
        let mixed = 0.5 * (t[(0, 1)] + t[(1, 0)]);
        let radius = half.hypot(mixed);
        if radius <= EQUAL * mean.abs() {
            return Self {
                angle: 0.0,
                first: t[(0, 0)],
                second: t[(1, 1)],
            };
        }
        let sign = if half < 0.0 { -1.0 } else { 1.0 };
        Self {
            angle: 0.5 * (sign * mixed).atan2(sign * half),
            first: mean + sign * radius,
            second: mean - sign * radius,
        }
    }

    /// Principal bending axes \[N m^2\]: bending stiffness about the tension
    /// center with all other internal forces zero.
    ///
    /// `compliance` at the reference point. Moments are the same about every point when the
    /// force is zero, so the bending block of the compliance is also valid at the tension
    /// center; its inverse is the stiffness.
    pub fn of_bending(compliance: &Matrix6<f64>) -> Self {
        let block: Matrix2<f64> = compliance.fixed_view::<2, 2>(4, 4).into_owned();
        Self::of_tensor(&block.try_inverse().unwrap_or_default())
    }

    /// Principal axes of rotary inertia about the mass center \[kg m\], given the
    /// mass about the reference point and the mass center from there; `None`
    /// without mass.
    pub fn of_mass(mass: &Matrix6<f64>, center: Option<[f64; 2]>) -> Option<Self> {
        let [y, z] = center?;
        let mass = wrench::shift(mass, &Vector3::new(0.0, y, z));
        Some(Self::of_tensor(&mass.fixed_view::<2, 2>(4, 4).into_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{FRAC_PI_3, FRAC_PI_4, FRAC_PI_6};

    /// diag(a, b) in axes turned by phi: t = Q diag Q', Q columns (cos, sin), (-sin, cos).
    fn turned(a: f64, b: f64, phi: f64) -> Matrix2<f64> {
        let (s, c) = phi.sin_cos();
        let q = Matrix2::new(c, -s, s, c);
        q * Matrix2::new(a, 0.0, 0.0, b) * q.transpose()
    }

    #[test]
    fn turned_axes_are_found_within_an_eighth_of_a_turn() {
        for (a, b) in [(3.0, 1.0), (1.0, 3.0)] {
            for phi in [0.0, FRAC_PI_6, -0.7, 0.1] {
                let axes = PrincipalAxes::of_tensor(&turned(a, b, phi));
                assert_relative_eq!(axes.angle, phi, epsilon = 1e-15);
                assert_relative_eq!(axes.first, a, epsilon = 1e-14);
                assert_relative_eq!(axes.second, b, epsilon = 1e-14);
            }
        }
        // beyond an eighth of a turn the other axis is nearer to y
        let axes = PrincipalAxes::of_tensor(&turned(3.0, 1.0, FRAC_PI_3));
        assert_relative_eq!(axes.angle, -FRAC_PI_6, epsilon = 1e-15);
        assert_relative_eq!(axes.first, 1.0, epsilon = 1e-14);
    }

    #[test]
    fn equal_values_keep_the_section_axes() {
        let axes = PrincipalAxes::of_tensor(&turned(2.0, 2.0 + 1e-12, FRAC_PI_4));
        assert_eq!(axes.angle, 0.0);
    }
}
