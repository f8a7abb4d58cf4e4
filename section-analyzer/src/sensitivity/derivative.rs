//! Derivatives of the properties of a section, in SI about the origin of the mesh.

use super::Solved;
use crate::assembly::{mass_of_moments, mass_per_length};
use crate::properties::invert_symmetric;
use nalgebra::{Matrix2, Matrix6, Vector2, Vector3};
use shared_geom::wrench;

/// Derivatives of the properties of a section with respect to a parameter in its SI unit:
/// Pa, kg/m^3, rad, m.
#[derive(Debug, Clone, PartialEq)]
pub struct Derivative {
    /// dK: of the stiffness \[N, N m, N m^2 per unit of the parameter\].
    pub stiffness: Matrix6<f64>,
    /// dF: of the compliance \[1/N, 1/(N m), 1/(N m^2) per unit of the parameter\].
    pub compliance: Matrix6<f64>,
    /// dM: of the mass per length \[kg/m, kg, kg m per unit of the parameter\].
    pub mass: Matrix6<f64>,
    /// Of the tension center \[m per unit of the parameter\].
    pub tension: [f64; 2],
    /// Of the shear center \[m per unit of the parameter\].
    pub shear: [f64; 2],
    /// Of the mass center; `None` for a section without mass \[m per unit of the
    /// parameter\].
    pub mass_center: Option<[f64; 2]>,
}

/// Converts derivatives from the units of the domain to SI, and from its origin to the
/// origin of the mesh.
pub(super) struct Conversion<'a> {
    solved: Solved<'a>,
    /// K in the units of the domain; zero for a compliance without inverse, which no valid
    /// section has.
    stiffness: Matrix6<f64>,
    /// F in SI about the origin of the domain.
    compliance: Matrix6<f64>,
    /// M about the origin of the domain.
    mass: Matrix6<f64>,
    /// Position of the domain's origin.
    origin: Vector3<f64>,
    compliance_unit: Matrix6<f64>,
    stiffness_unit: Matrix6<f64>,
}

impl<'a> Conversion<'a> {
    pub fn new(solved: Solved<'a>) -> Self {
        let scaling = &solved.domain.scaling;
        let (p, f) = (scaling.strain(), scaling.force());
        let compliance_unit = p * f.map(|unit| 1.0 / unit).transpose();
        let [y, z] = scaling.origin;
        let origin = Vector3::new(0.0, y, z);
        Self {
            stiffness: invert_symmetric(solved.compliance).unwrap_or_default(),
            compliance: solved.compliance.component_mul(&compliance_unit),
            mass: wrench::shift(&mass_per_length(solved.domain), &origin),
            compliance_unit,
            stiffness_unit: f * p.map(|unit| 1.0 / unit).transpose(),
            origin,
            solved,
        }
    }

    /// From dF in the units of the domain about its origin, and the sums of
    /// `d(rho (1, y, z, y y, y z, z z) dA)` in its units of length.
    ///
    /// ```text
    /// dK = -K dF K                                                              (S-113)
    /// ```
    pub fn derivative(&self, df: &Matrix6<f64>, moments: &[f64; 6]) -> Derivative {
        let dk = -(self.stiffness * df * self.stiffness);
        let dk = dk.component_mul(&self.stiffness_unit);
        let df = df.component_mul(&self.compliance_unit);
        let mass = mass_of_moments(self.solved.domain, moments);
        let v = wrench::shift_matrix(&self.origin);
        let (tension, shear) = self.centers(&df);
        Derivative {
            stiffness: symmetric(&wrench::shift(&dk, &-self.origin)),
            compliance: symmetric(&(v.transpose() * df * v)),
            tension,
            shear,
            mass_center: self.mass_center(&wrench::shift(&mass, &self.origin)),
            mass: symmetric(&mass),
        }
    }

    /// Derivatives of the tension and the shear center.
    ///
    /// ```text
    /// s = [z_t; -y_t]:   ds = -Fbb^-1 (dFb1 + dFbb s)
    /// dy_s = -(dF43 + y_s dF44)/F44      dz_s = (dF42 - z_s dF44)/F44            (S-122)
    /// ```
    fn centers(&self, df: &Matrix6<f64>) -> ([f64; 2], [f64; 2]) {
        let f = &self.compliance;
        let bending = |f: &Matrix6<f64>| -> Matrix2<f64> { f.fixed_view::<2, 2>(4, 4).into() };
        let axial = |f: &Matrix6<f64>| Vector2::new(f[(4, 0)], f[(5, 0)]);
        // the bending block of a positive definite compliance has an inverse
        let inverse = bending(f).try_inverse().unwrap_or_default();
        let s = -(inverse * axial(f));
        let ds = -(inverse * (axial(df) + bending(df) * s));
        let twist = f[(3, 3)];
        let (y, z) = (-f[(3, 2)] / twist, f[(3, 1)] / twist);
        let shear = [
            -(df[(3, 2)] + y * df[(3, 3)]) / twist,
            (df[(3, 1)] - z * df[(3, 3)]) / twist,
        ];
        ([-ds.y, ds.x], shear)
    }

    /// Derivative of the mass center.
    ///
    /// ```text
    /// dy_m = (dM34 - y_m dm)/m      dz_m = -(dM24 + z_m dm)/m                    (S-123)
    /// ```
    fn mass_center(&self, dm: &Matrix6<f64>) -> Option<[f64; 2]> {
        let m = self.mass[(0, 0)];
        let (y, z) = (self.mass[(2, 3)] / m, -self.mass[(1, 3)] / m);
        let (dy, dz) = (dm[(2, 3)] - y * dm[(0, 0)], dm[(1, 3)] + z * dm[(0, 0)]);
        (m > 0.0).then(|| [dy / m, -dz / m])
    }
}

fn symmetric(matrix: &Matrix6<f64>) -> Matrix6<f64> {
    0.5 * (matrix + matrix.transpose())
}
