//! Stiffness and mass from engineering properties: stiffnesses and inertias about
//! their centers, in their principal axes.
//!
//! ```text
//! K = U(-t) R_a diag(EA, 0, 0, 0, EIy, EIz) R_a^T U(-t)^T
//!   + U(-s) R_a diag(0, GAy, GAz, GJ, 0, 0) R_a^T U(-s)^T
//! M = U(-c) R_b diag(m, m, m, Iy + Iz, Iy, Iz) R_b^T U(-c)^T
//! ```
//!
//! with t, s, c the tension, shear and mass centers relative to the reference point, U(d)
//! the change to the point O + d, and R the turn about x by the angle of the principal
//! axes: the sums are about the centers, and the reference point is at -t, -s, -c from
//! them.

use nalgebra::{Matrix6, Vector2, Vector3, Vector6};

use super::{Centers, PrincipalAxes, Provenance, SectionProperties, half_turn};
use crate::line::about_x;
use crate::wrench;

/// Engineering properties of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Engineering {
    /// EA, GAy, GAz [N], GJ, EIy, EIz [N m^2].
    pub stiffness: [f64; 6],
    /// m [kg/m], Iy, Iz [kg m].
    pub mass: [f64; 3],
    /// Tension, shear and mass centers.
    pub centers: Centers,
    /// From +y to the axis y of the stiffnesses, positive about +x [rad].
    pub stiffness_angle: f64,
    /// From +y to the axis y of the inertias, positive about +x [rad].
    pub inertia_angle: f64,
}

impl Engineering {
    /// The stiffness at the reference point, 6x6 [N, N m, N m^2].
    pub fn stiffness_matrix(&self) -> Matrix6<f64> {
        let [ea, gay, gaz, gj, eiy, eiz] = self.stiffness;
        let angle = self.stiffness_angle;
        let bending = [ea, 0.0, 0.0, 0.0, eiy, eiz];
        let shearing = [0.0, gay, gaz, gj, 0.0, 0.0];
        from_center(&self.centers.tension, angle, bending)
            + from_center(&self.centers.shear, angle, shearing)
    }

    /// The mass per length at the reference point, 6x6 [kg/m, kg, kg m].
    pub fn mass_matrix(&self) -> Matrix6<f64> {
        let [m, iy, iz] = self.mass;
        let diagonal = [m, m, m, iy + iz, iy, iz];
        from_center(&self.centers.mass, self.inertia_angle, diagonal)
    }

    /// The section with these properties.
    pub fn section(&self, name: &str, provenance: Provenance) -> SectionProperties {
        let [.., eiy, eiz] = self.stiffness;
        let [_, iy, iz] = self.mass;
        SectionProperties {
            name: name.to_owned(),
            reference_point: Vector2::zeros(),
            stiffness: self.stiffness_matrix(),
            mass: self.mass_matrix(),
            centers: self.centers,
            principal_axes: PrincipalAxes {
                bending_angle: half_turn(self.stiffness_angle),
                bending_stiffness: [eiy, eiz],
                inertia_angle: half_turn(self.inertia_angle),
                inertia: [iy, iz],
            },
            initial_curvature: None,
            piezo: None,
            thermal_force: None,
            imposed: Vec::new(),
            damping: None,
            prestress: None,
            provenance,
        }
    }
}

/// A diagonal in axes turned by `angle` at `center`, about the reference point.
fn from_center(center: &Vector2<f64>, angle: f64, diagonal: [f64; 6]) -> Matrix6<f64> {
    let own = Matrix6::from_diagonal(&Vector6::from(diagonal));
    let turned = match angle {
        0.0 => own,
        // The section axes, relative to the principal axes, are turned back.
        _ => wrench::rotate(&own, &about_x(-angle)),
    };
    wrench::shift(&turned, &-Vector3::new(0.0, center.x, center.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

    fn sample(stiffness_angle: f64, inertia_angle: f64) -> Engineering {
        Engineering {
            stiffness: [7e6, 2e6, 1e6, 30.0, 40.0, 900.0],
            mass: [2.0, 0.01, 0.04],
            centers: Centers {
                tension: Vector2::new(0.3, -0.1),
                shear: Vector2::new(-0.2, 0.05),
                mass: Vector2::new(0.1, 0.02),
            },
            stiffness_angle,
            inertia_angle,
        }
    }

    // A quarter turn exchanges y and z of the principal axes; the rest stays.
    #[test]
    fn a_quarter_turn_exchanges_the_axes() {
        let turned = sample(FRAC_PI_2, FRAC_PI_2);
        let mut exchanged = sample(0.0, 0.0);
        exchanged.stiffness = [7e6, 1e6, 2e6, 30.0, 900.0, 40.0];
        exchanged.mass = [2.0, 0.04, 0.01];
        let difference = turned.stiffness_matrix() - exchanged.stiffness_matrix();
        // Entries up to 7e6: round-off of the turn by pi/2, 6e-17 of 2e6.
        assert!(difference.amax() < 1e-9, "{difference}");
        let difference = turned.mass_matrix() - exchanged.mass_matrix();
        assert!(difference.amax() < 1e-16, "{difference}");
    }

    // Tension center at the origin, axes turned by 30 degrees: Mohr's circle,
    // K55 = EIy cos^2 + EIz sin^2, and a bending about the first principal axis (cos,
    // sin) keeps its direction.
    #[test]
    fn principal_axes_are_those_of_the_angle() {
        let mut turned = sample(FRAC_PI_6, FRAC_PI_6);
        turned.centers.tension = Vector2::zeros();
        turned.centers.shear = Vector2::zeros();
        let k = turned.stiffness_matrix();
        assert!((k[(4, 4)] - (40.0 * 0.75 + 900.0 * 0.25)).abs() < 1e-12);
        let (s, c) = FRAC_PI_6.sin_cos();
        let moment = k * Vector6::new(0.0, 0.0, 0.0, 0.0, c, s);
        let expected = Vector6::new(0.0, 0.0, 0.0, 0.0, 40.0 * c, 40.0 * s);
        assert!((moment - expected).amax() < 1e-12, "{moment}");
    }
}
