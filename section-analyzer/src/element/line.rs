//! The reference line of a beam of constant initial curvature, and its metric at a point of
//! the section.
//!
//! The section frame turns along the beam by `k`, and the line has the direction `l` in
//! this frame, both constant. A material line through the point t = (0, y, z) has the
//! tangent
//!
//! ```text
//! g1 = l + k x t = (J, a, b)
//! J = l1 + k2 z - k3 y      a = l2 - k1 z      b = l3 + k1 y                      (S-71)
//! ```
//!
//! so that a volume is `J dy dz dx`, and the derivative along x at a fixed point of space
//! is the derivative along the material line minus `(a d/dy + b d/dz)`.
//!
//! # References
//! - [Borri1992]: beams of constant initial curvature, the section frame that turns
//!   along the line.

use nalgebra::{Matrix3, Matrix6, Vector3};
use shared_geom::rotation::skew;
use shared_geom::section::InitialCurvature;

/// Curvature of the section frame and slope of the reference line at the origin of
/// the coordinates, in section axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// k: twist about x, curvature about y and z \[1/m\].
    pub curvature: Vector3<f64>,
    /// l: derivative of the line along the beam \[-\].
    pub slope: Vector3<f64>,
}

/// The metric of a line at a point of the section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metric {
    /// J: volume per area and length of the line \[-\].
    pub volume: f64,
    /// a, b: slope of the material line along y and z \[-\].
    pub tilt: [f64; 2],
}

impl Line {
    /// The line of a straight beam, normal to the section.
    pub const STRAIGHT: Self = Self {
        curvature: Vector3::new(0.0, 0.0, 0.0),
        slope: Vector3::new(1.0, 0.0, 0.0),
    };

    /// The line that `initial` describes, through the point (y, z) = `origin` from the
    /// reference point \[m\], in units of `length` \[m\] (S-70).
    pub fn through(initial: &InitialCurvature, [y, z]: [f64; 2], length: f64) -> Self {
        Self {
            curvature: length * initial.curvature,
            slope: initial.tangent_at(y, z),
        }
    }

    /// Whether the beam is straight and its line normal to the section: J is one, a and b
    /// are zero.
    pub fn is_straight(&self) -> bool {
        *self == Self::STRAIGHT
    }

    /// J, a, b at (y, z) (S-71).
    #[inline(always)]
    pub fn metric(&self, y: f64, z: f64) -> Metric {
        let (k, l) = (&self.curvature, &self.slope);
        Metric {
            volume: l.x + k.y * z - k.z * y,
            tilt: [l.y - k.x * z, l.z + k.x * y],
        }
    }

    /// T' of `theta' = T' theta`: change of the internal forces along an unloaded beam in
    /// the section frame (S-72).
    ///
    /// ```text
    /// F' = -k x F      M' = -l x F - k x M
    /// ```
    ///
    /// For a straight beam `M2' = F3` and `M3' = -F2`, all else is constant.
    pub fn equilibrium(&self) -> Matrix6<f64> {
        let (turn, arm) = (-skew(&self.curvature), -skew(&self.slope));
        let mut t: Matrix6<f64> = Matrix6::zeros();
        let mut position = |row: usize, column: usize, part: &Matrix3<f64>| {
            t.fixed_view_mut::<3, 3>(row, column).copy_from(part);
        };
        position(0, 0, &turn);
        position(3, 0, &arm);
        position(3, 3, &turn);
        t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::Vector6;

    /// `M2' = F3`, `M3' = -F2`: the moment of a shear force increases with the arm.
    #[test]
    fn equilibrium_of_a_straight_beam() {
        let rate = Line::STRAIGHT.equilibrium() * Vector6::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
        assert_eq!(rate, Vector6::new(0.0, 0.0, 0.0, 0.0, 3.0, -2.0));
    }

    /// A force and a moment that are constant in space, along a helix: their rate in the
    /// turning frame is (S-72), by central differences of the frame.
    #[test]
    fn forces_at_rest_turn_in_the_frame() {
        let line = Line {
            curvature: Vector3::new(0.4, -0.3, 0.7),
            slope: Vector3::new(0.9, 0.2, -0.1),
        };
        let (force, moment) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.3, 0.8, -1.1));
        // frame exp(s k x) and position s l to first order: exact for the rate at s = 0
        let at = |s: f64| {
            let frame = nalgebra::Rotation3::new(s * line.curvature);
            let position = s * line.slope;
            let about = moment - position.cross(&force);
            let (f, m) = (frame.inverse() * force, frame.inverse() * about);
            Vector6::new(f.x, f.y, f.z, m.x, m.y, m.z)
        };
        let h = 1e-5;
        let rate = (at(h) - at(-h)) / (2.0 * h);
        // differences of second order: h^2 and round-off over h, both 1e-10
        assert_relative_eq!(rate, line.equilibrium() * at(0.0), epsilon = 1e-9);
    }

    /// The tangent of a material line by the definition, `l + k x t`.
    #[test]
    fn metric_is_the_tangent_of_a_material_line() {
        let initial = InitialCurvature {
            curvature: Vector3::new(0.4, -0.3, 0.7),
            slope: Vector3::new(0.9, 0.2, -0.1),
        };
        let line = Line::through(&initial, [0.3, -0.2], 2.0);
        let t = Vector3::new(0.0, 0.3 + 2.0 * 0.1, -0.2 + 2.0 * 0.4);
        let tangent = initial.slope + initial.curvature.cross(&t);
        let Metric { volume, tilt } = line.metric(0.1, 0.4);
        let found = Vector3::new(volume, tilt[0], tilt[1]);
        assert_relative_eq!(found, tangent, epsilon = 1e-15);
    }
}
