//! Linear elastic laws and their stiffness in material axes.
//!
//! Material axes: 1 along the fiber, 2 transverse in the plane of the ply,
//! 3 through the thickness.
//!
//! # References
//! - Jones, *Mechanics of Composite Materials*, 2nd ed. 1999, chapter 2: the
//!   orthotropic stiffness in terms of the engineering constants.

use super::electric::ElectricLaw;
use nalgebra::Matrix6;

/// A material: its name, elastic law, density and expansion.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Name, used by regions.
    pub name: String,
    /// Elastic law.
    pub law: ElasticLaw,
    /// Density \[kg/m^3\].
    pub density: f64,
    /// Coefficients of thermal expansion along the material axes 1, 2, 3; `None` for a
    /// material that does not expand \[1/K\].
    pub expansion: Option<[f64; 3]>,
    /// Electric law; `None` for a material that is not part of the electric problem.
    pub electric: Option<ElectricLaw>,
}

/// A linear elastic law.
#[derive(Debug, Clone, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a section has a handful of materials, and cells refer to them by index"
)]
pub enum ElasticLaw {
    /// Isotropic.
    Isotropic {
        /// Young's modulus \[Pa\].
        young: f64,
        /// Poisson's ratio \[-\].
        poisson: f64,
    },
    /// Three planes of symmetry, the material planes.
    Orthotropic(EngineeringConstants),
    /// Stiffness in material axes, order 11 22 33 23 13 12 with engineering
    /// shear strains \[Pa\].
    Full(Matrix6<f64>),
    /// No stiffness: a material with an electric field and weight only.
    Absent,
}

/// Engineering constants of an orthotropic material.
///
/// `nu_ij = -strain_j / strain_i` under a stress along i alone, so that
/// `nu_ji = nu_ij E_j / E_i`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EngineeringConstants {
    /// Young's modulus along the fiber \[Pa\].
    pub e1: f64,
    /// Young's modulus transverse to the fiber, in the ply \[Pa\].
    pub e2: f64,
    /// Young's modulus through the thickness \[Pa\].
    pub e3: f64,
    /// Shear modulus in the plane of the ply \[Pa\].
    pub g12: f64,
    /// Shear modulus between fiber and thickness \[Pa\].
    pub g13: f64,
    /// Shear modulus between transverse direction and thickness \[Pa\].
    pub g23: f64,
    /// Poisson's ratio: contraction along 2 under stress along 1 \[-\].
    pub nu12: f64,
    /// Poisson's ratio: contraction along 3 under stress along 1 \[-\].
    pub nu13: f64,
    /// Poisson's ratio: contraction along 3 under stress along 2 \[-\].
    pub nu23: f64,
}

impl EngineeringConstants {
    /// `1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu12 nu23 nu31` \[-\]: the
    /// determinant of the normal compliance times `E1 E2 E3`, positive for an
    /// admissible material.
    pub(super) fn determinant(&self) -> f64 {
        let [nu21, nu31, nu32] = self.minor_ratios();
        1.0 - self.nu12 * nu21
            - self.nu23 * nu32
            - self.nu13 * nu31
            - 2.0 * self.nu12 * self.nu23 * nu31
    }

    /// nu21, nu31, nu32 from the symmetry of the compliance.
    fn minor_ratios(&self) -> [f64; 3] {
        [
            self.nu12 * self.e2 / self.e1,
            self.nu13 * self.e3 / self.e1,
            self.nu23 * self.e3 / self.e2,
        ]
    }

    /// Stiffness in material axes, order 11 22 33 23 13 12 \[Pa\]: the inverse of the
    /// compliance (S-7), written out.
    ///
    /// ```text
    /// C11 = E1 (1 - nu23 nu32) / D      C12 = E1 (nu21 + nu31 nu23) / D
    /// C22 = E2 (1 - nu13 nu31) / D      C13 = E1 (nu31 + nu21 nu32) / D
    /// C33 = E3 (1 - nu12 nu21) / D      C23 = E2 (nu32 + nu12 nu31) / D
    /// C44 = G23   C55 = G13   C66 = G12
    /// ```
    fn stiffness(&self) -> Matrix6<f64> {
        let [nu21, nu31, nu32] = self.minor_ratios();
        let d = self.determinant();

        let mut c = Matrix6::zeros();
        c[(0, 0)] = self.e1 * (1.0 - self.nu23 * nu32) / d;
        c[(1, 1)] = self.e2 * (1.0 - self.nu13 * nu31) / d;
        c[(2, 2)] = self.e3 * (1.0 - self.nu12 * nu21) / d;
        c[(0, 1)] = self.e1 * (nu21 + nu31 * self.nu23) / d;
        c[(0, 2)] = self.e1 * (nu31 + nu21 * nu32) / d;
        c[(1, 2)] = self.e2 * (nu32 + self.nu12 * nu31) / d;
        c[(1, 0)] = c[(0, 1)];
        c[(2, 0)] = c[(0, 2)];
        c[(2, 1)] = c[(1, 2)];
        c[(3, 3)] = self.g23;
        c[(4, 4)] = self.g13;
        c[(5, 5)] = self.g12;
        c
    }
}

impl ElasticLaw {
    /// Whether the material has a stiffness.
    pub fn has_stiffness(&self) -> bool {
        !matches!(self, Self::Absent)
    }

    /// Stiffness in material axes, order 11 22 33 23 13 12 with engineering
    /// shear strains \[Pa\].
    ///
    /// Meaningful for an admissible law only: see [`ElasticLaw::check`].
    pub fn stiffness(&self) -> Matrix6<f64> {
        match self {
            Self::Isotropic { young, poisson } => isotropic_stiffness(*young, *poisson),
            Self::Orthotropic(constants) => constants.stiffness(),
            Self::Full(stiffness) => *stiffness,
            Self::Absent => Matrix6::zeros(),
        }
    }
}

/// Lame's form: `C_ij = lambda + 2 mu delta_ij` on the normal part, `mu` on the
/// shears, with `lambda = E nu / ((1 + nu)(1 - 2 nu))` and `mu = E / (2 (1 + nu))`.
fn isotropic_stiffness(young: f64, poisson: f64) -> Matrix6<f64> {
    let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    let mu = young / (2.0 * (1.0 + poisson));
    let mut c = Matrix6::zeros();
    for i in 0..3 {
        for j in 0..3 {
            c[(i, j)] = lambda;
        }
        c[(i, i)] += 2.0 * mu;
        c[(3 + i, 3 + i)] = mu;
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::CARBON;
    use approx::assert_relative_eq;

    /// The compliance of an orthotropic material by definition of its constants
    /// (Jones 1999, chapter 2) times the stiffness must be one, to round-off.
    #[test]
    fn orthotropic_stiffness_inverts_the_compliance() {
        let k = CARBON;
        let mut s = Matrix6::zeros();
        s[(0, 0)] = 1.0 / k.e1;
        s[(1, 1)] = 1.0 / k.e2;
        s[(2, 2)] = 1.0 / k.e3;
        s[(0, 1)] = -k.nu12 / k.e1;
        s[(0, 2)] = -k.nu13 / k.e1;
        s[(1, 2)] = -k.nu23 / k.e2;
        s.fill_lower_triangle_with_upper_triangle();
        s[(3, 3)] = 1.0 / k.g23;
        s[(4, 4)] = 1.0 / k.g13;
        s[(5, 5)] = 1.0 / k.g12;

        let product = s * ElasticLaw::Orthotropic(k).stiffness();
        assert_relative_eq!(product, Matrix6::identity(), epsilon = 1e-13);
    }

    /// An orthotropic law with isotropic constants is the isotropic law.
    #[test]
    fn isotropic_is_a_special_orthotropic_law() {
        let (e, nu) = (210e9, 0.3);
        let g = e / (2.0 * (1.0 + nu));
        let law = ElasticLaw::Orthotropic(EngineeringConstants {
            e1: e,
            e2: e,
            e3: e,
            g12: g,
            g13: g,
            g23: g,
            nu12: nu,
            nu13: nu,
            nu23: nu,
        });
        let isotropic = ElasticLaw::Isotropic {
            young: e,
            poisson: nu,
        };
        assert_relative_eq!(law.stiffness(), isotropic.stiffness(), max_relative = 1e-14);
    }
}
