//! Electric laws: dielectrics and piezoelectric materials.
//!
//! ```text
//! sigma = c eps - e' E        D = e eps + epsS E        E = -grad V               (S-160)
//! e = d c                     epsS = epsT - d e'                                  (S-161)
//! ```
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `c` | stiffness at constant electric field, order 11 22 33 23 13 12 | Pa | 6x6 |
//! | `e` | stress per electric field, rows 1 2 3 of the field | C/m^2 | 3x6 |
//! | `d` | strain per electric field at no stress | m/V | 3x6 |
//! | `epsS`, `epsT` | permittivity at constant strain, at constant stress | F/m | 3x3 |
//!
//! # References
//! - [Ieee1987]: the two forms and their symbols.

use nalgebra::{Matrix3, Matrix3x6, Matrix6};

/// Permittivity of vacuum \[F/m\] (CODATA 2018).
pub const VACUUM_PERMITTIVITY: f64 = 8.854_187_812_8e-12;

/// The electric law of a material in material axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElectricLaw {
    /// e: rows are the components 1 2 3 of the field, columns the stresses 11 22 33 23 13 12;
    /// zero for a material that is not piezoelectric \[C/m^2\].
    pub coupling: Matrix3x6<f64>,
    /// epsS: permittivity at constant strain, symmetric positive definite \[F/m\].
    pub permittivity: Matrix3<f64>,
}

impl ElectricLaw {
    /// A dielectric that is not piezoelectric, of this permittivity \[F/m\].
    pub fn dielectric(permittivity: Matrix3<f64>) -> Self {
        Self {
            coupling: Matrix3x6::zeros(),
            permittivity,
        }
    }

    /// The law of strains `d` per electric field (3x6) \[m/V\] and of the permittivity at
    /// constant stress \[F/m\], with the stiffness `c` at constant field \[Pa\] (S-161).
    pub fn of_strains(d: &Matrix3x6<f64>, at_stress: &Matrix3<f64>, c: &Matrix6<f64>) -> Self {
        let coupling = d * c;
        Self {
            coupling,
            permittivity: at_stress - d * coupling.transpose(),
        }
    }

    /// Whether electric field and stress are coupled.
    pub fn is_piezoelectric(&self) -> bool {
        self.coupling.iter().any(|&entry| entry != 0.0)
    }
}
