//! Tension center, shear center, mass center.
//!
//! # References
//! - Giavotto et al. 1983, section 5: centers from the compliance.

use nalgebra::{Matrix2, Matrix6, Vector2};

/// The centers of a section: positions (y, z) from the reference point \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Centers {
    /// Point at which an axial force causes no bending \[m\].
    pub tension: [f64; 2],
    /// Point at which a shear force causes no twist \[m\].
    pub shear: [f64; 2],
    /// Center of mass; `None` for a section without mass \[m\].
    pub mass: Option<[f64; 2]>,
}

impl Centers {
    /// Centers from compliance and mass about the same point, in consistent units.
    ///
    /// An axial force at t has the moments `t x F = (0, z F1, -y F1)`, a shear
    /// force there the torque `y F3 - z F2`:
    ///
    /// ```text
    /// tension   [z; -y] = -Cbb^-1 Cb1       (S-26), Cbb, Cb1: bending by bending, by axial force
    /// shear     y = -C43 / C44     z = C42 / C44      (S-27)
    /// mass      y = M34 / m        z = -M24 / m       (S-30)
    /// ```
    ///
    /// Both matrices must be about a point near the section, so that the coordinates keep
    /// their digits.
    pub fn new(compliance: &Matrix6<f64>, mass: &Matrix6<f64>) -> Self {
        let c = compliance;
        let bending: Matrix2<f64> = c.fixed_view::<2, 2>(4, 4).into_owned();
        let axial = Vector2::new(c[(4, 0)], c[(5, 0)]);
        // the bending block of a positive definite compliance has an inverse
        let solved = bending.try_inverse().unwrap_or_default() * -axial;
        let m = mass[(0, 0)];
        Self {
            tension: [-solved.y, solved.x],
            shear: [-c[(3, 2)] / c[(3, 3)], c[(3, 1)] / c[(3, 3)]],
            mass: (m > 0.0).then(|| [mass[(2, 3)] / m, -mass[(1, 3)] / m]),
        }
    }

    /// The same centers from a reference point moved by minus `offset` \[m\].
    pub fn placed(&self, offset: [f64; 2]) -> Self {
        let position = |[y, z]: [f64; 2]| [y + offset[0], z + offset[1]];
        Self {
            tension: position(self.tension),
            shear: position(self.shear),
            mass: self.mass.map(position),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::{Vector3, Vector6};
    use shared_geom::wrench;

    /// A section that is uncoupled about its centers, moved away: axial forces act at the
    /// tension center, shears at another point; the centers are recovered.
    #[test]
    fn centers_are_found_from_a_moved_section() {
        let (tension, shear) = ([0.3, -0.2], [-0.1, 0.4]);
        // K = T' diag T, strains at the tension center and shears at the shear center
        let at = |[y, z]: [f64; 2]| wrench::shift_matrix(&Vector3::new(0.0, y, z)).transpose();
        let stiff = |d: [f64; 6]| Matrix6::from_diagonal(&Vector6::from(d));
        let to = |k: Matrix6<f64>, [y, z]: [f64; 2]| wrench::shift(&k, &Vector3::new(0.0, -y, -z));
        let k = to(stiff([9.0, 0.0, 0.0, 0.0, 2.0, 3.0]), tension)
            + to(stiff([0.0, 5.0, 4.0, 1.5, 0.0, 0.0]), shear);
        let mass = to(stiff([2.0, 2.0, 2.0, 0.7, 0.3, 0.4]), [0.05, 0.06]);

        let centers = Centers::new(&k.try_inverse().expect("definite"), &mass);
        for axis in 0..2 {
            assert_relative_eq!(centers.tension[axis], tension[axis], epsilon = 1e-14);
            assert_relative_eq!(centers.shear[axis], shear[axis], epsilon = 1e-14);
        }
        let center = centers.mass.expect("has mass");
        assert_relative_eq!(center[0], 0.05, epsilon = 1e-15);
        assert_relative_eq!(center[1], 0.06, epsilon = 1e-15);
        // the shift that the test itself relies on
        assert_relative_eq!(at([0.0, 0.0]), Matrix6::identity());
    }

    #[test]
    fn a_section_without_mass_has_no_mass_center() {
        let centers = Centers::new(&Matrix6::identity(), &Matrix6::zeros());
        assert_eq!(centers.mass, None);
    }
}
