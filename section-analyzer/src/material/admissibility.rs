//! Admissible materials: positive moduli, bounds on Poisson's ratios, positive strain
//! energy.
//!
//! # References
//! - Lempriere, *Poisson's ratio in orthotropic materials*, AIAA J. 6 (1968)
//!   2226-2227: the bounds for orthotropic constants.

use super::elastic::{ElasticLaw, EngineeringConstants, Material};
use nalgebra::Matrix6;
use shared_geom::error::Explain;
use shared_geom::units::rounded;

/// Largest difference between mirrored entries of a full stiffness, relative to its
/// largest entry. Files contain six digits or more; a larger difference is a mistake.
const SYMMETRY_TOLERANCE: f64 = 1e-6;

/// Smallest eigenvalue of a full stiffness relative to its largest entry; below it, the
/// strain energy is zero within the accuracy of a factorization.
const DEFINITENESS_TOLERANCE: f64 = 1e-12;
/// Bound of a ratio below which the moduli differ by more than in any material, ten thousand times [-].
const FAR: f64 = 1e-2;

/// Reasons for which a material cannot exist.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MaterialProblem {
    /// A constant is not a number or infinite.
    #[error("{constant} is {value}, expected a finite number")]
    NotFinite {
        /// Name of the constant.
        constant: &'static str,
        /// Value found.
        value: f64,
    },
    /// A Young's or shear modulus is zero or negative.
    #[error("{constant} is {} Pa, expected more than 0", rounded(*.value))]
    ModulusNotPositive {
        /// Name of the modulus.
        constant: &'static str,
        /// Value found \[Pa\].
        value: f64,
    },
    /// The density is negative.
    #[error("density is {} kg/m^3, expected 0 or more", rounded(*.value))]
    DensityNegative {
        /// Value found \[kg/m^3\].
        value: f64,
    },
    /// Poisson's ratio of an isotropic law is out of its range.
    #[error("poisson is {value}, expected more than -1 and less than 0.5")]
    PoissonOutOfRange {
        /// Value found \[-\].
        value: f64,
    },
    /// A Poisson's ratio of an orthotropic law is too large for its moduli.
    #[error("|{constant}| is {value:.6}, expected less than sqrt({along}/{across}) = {bound:.6}")]
    PoissonTooLarge {
        /// Name of the ratio.
        constant: &'static str,
        /// Its absolute value \[-\].
        value: f64,
        /// Modulus along the stress.
        along: &'static str,
        /// Modulus along the contraction.
        across: &'static str,
        /// Upper bound \[-\].
        bound: f64,
    },
    /// The three Poisson's ratios together give a negative strain energy.
    #[error(
        "1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu12 nu23 nu31 is {value:.6}, \
         expected more than 0"
    )]
    PoissonTogetherTooLarge {
        /// Value found \[-\].
        value: f64,
    },
    /// Mirrored entries of a full stiffness differ.
    #[error(
        "stiffness entries ({row}, {column}) = {upper} Pa and ({column}, {row}) = {lower} Pa differ, expected a symmetric matrix"
    )]
    NotSymmetric {
        /// Row, counted from one.
        row: usize,
        /// Column, counted from one.
        column: usize,
        /// Entry (row, column) \[Pa\].
        upper: f64,
        /// Entry (column, row) \[Pa\].
        lower: f64,
    },
    /// A full stiffness has zero or negative energy for some strain.
    #[error(
        "smallest eigenvalue of the stiffness is {smallest:e} Pa, the largest {largest:e} Pa, expected more than 0"
    )]
    NotPositiveDefinite {
        /// Smallest eigenvalue \[Pa\].
        smallest: f64,
        /// Largest eigenvalue \[Pa\].
        largest: f64,
    },
}

impl Explain for MaterialProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::PoissonTooLarge {
                along,
                across,
                bound,
                ..
            } if *bound < FAR => {
                return Some(format!(
                    "{along} is {:.1e} of {across}: one of them may be in another unit",
                    bound * bound
                ));
            }
            Self::PoissonTooLarge { .. } => {
                "nu_ij is -strain_j / strain_i under a stress along i alone; nu_ji = nu_ij E_j / \
                 E_i may have been given instead"
            }
            Self::PoissonTogetherTooLarge { .. } => {
                "each ratio is within its own bound, but some strain would release energy: lower \
                 nu23 or the least certain ratio"
            }
            Self::PoissonOutOfRange { .. } => {
                "nearly incompressible materials such as rubber have 0.49 to 0.4999"
            }
            Self::ModulusNotPositive { .. } => {
                "give soft fillers a small modulus, such as 1e-6 of the modulus of the skin"
            }
            Self::NotPositiveDefinite { .. } | Self::NotSymmetric { .. } => {
                "rows and columns are ordered 11 22 33 23 13 12, with engineering shear strains"
            }
            Self::DensityNegative { .. } => "a material without mass has the density 0",
            Self::NotFinite { .. } => return None,
        };
        Some(text.to_owned())
    }
}

impl Material {
    /// All violations of this material's bounds; empty if admissible.
    pub fn check(&self) -> Vec<MaterialProblem> {
        let mut problems = self.law.check();
        if !self.density.is_finite() {
            problems.push(MaterialProblem::NotFinite {
                constant: "density",
                value: self.density,
            });
        } else if self.density < 0.0 {
            problems.push(MaterialProblem::DensityNegative {
                value: self.density,
            });
        }
        problems
    }
}

impl ElasticLaw {
    /// All violations of this law's bounds; empty if admissible.
    ///
    /// Bounds that depend on a modulus are checked only if the modulus is sound.
    pub fn check(&self) -> Vec<MaterialProblem> {
        match self {
            Self::Isotropic { young, poisson } => check_isotropic(*young, *poisson),
            Self::Orthotropic(constants) => check_orthotropic(constants),
            Self::Full(stiffness) => check_full(stiffness),
            Self::Absent => Vec::new(),
        }
    }
}

fn not_finite(constants: &[(&'static str, f64)]) -> Vec<MaterialProblem> {
    constants
        .iter()
        .filter(|(_, value)| !value.is_finite())
        .map(|&(constant, value)| MaterialProblem::NotFinite { constant, value })
        .collect()
}

fn not_positive(moduli: &[(&'static str, f64)]) -> Vec<MaterialProblem> {
    moduli
        .iter()
        .filter(|(_, value)| *value <= 0.0)
        .map(|&(constant, value)| MaterialProblem::ModulusNotPositive { constant, value })
        .collect()
}

fn check_isotropic(young: f64, poisson: f64) -> Vec<MaterialProblem> {
    let mut problems = not_finite(&[("E", young), ("nu", poisson)]);
    problems.append(&mut not_positive(&[("E", young)]));
    if poisson.is_finite() && !(poisson > -1.0 && poisson < 0.5) {
        problems.push(MaterialProblem::PoissonOutOfRange { value: poisson });
    }
    problems
}

fn check_orthotropic(k: &EngineeringConstants) -> Vec<MaterialProblem> {
    let moduli = [
        ("E1", k.e1),
        ("E2", k.e2),
        ("E3", k.e3),
        ("G12", k.g12),
        ("G13", k.g13),
        ("G23", k.g23),
    ];
    let ratios = [("nu12", k.nu12), ("nu13", k.nu13), ("nu23", k.nu23)];

    let mut problems = not_finite(&moduli);
    problems.append(&mut not_finite(&ratios));
    problems.append(&mut not_positive(&moduli));
    if problems.is_empty() {
        problems = check_ratios(k);
    }
    problems
}

/// `|nu_ij| < sqrt(E_i / E_j)` for each pair, then the combined bound.
fn check_ratios(k: &EngineeringConstants) -> Vec<MaterialProblem> {
    let pairs = [
        ("nu12", k.nu12, ("E1", k.e1), ("E2", k.e2)),
        ("nu13", k.nu13, ("E1", k.e1), ("E3", k.e3)),
        ("nu23", k.nu23, ("E2", k.e2), ("E3", k.e3)),
    ];
    let mut problems = Vec::new();
    for (constant, value, along, across) in pairs {
        let bound = (along.1 / across.1).sqrt();
        if value.abs() >= bound {
            problems.push(MaterialProblem::PoissonTooLarge {
                constant,
                value: value.abs(),
                along: along.0,
                across: across.0,
                bound,
            });
        }
    }
    if problems.is_empty() && k.determinant() <= 0.0 {
        problems.push(MaterialProblem::PoissonTogetherTooLarge {
            value: k.determinant(),
        });
    }
    problems
}

fn check_full(c: &Matrix6<f64>) -> Vec<MaterialProblem> {
    if let Some(&value) = c.iter().find(|value| !value.is_finite()) {
        return vec![MaterialProblem::NotFinite {
            constant: "stiffness entry",
            value,
        }];
    }

    let mut problems = Vec::new();
    let largest_entry = c.amax();
    for row in 0..6 {
        for column in row + 1..6 {
            let (upper, lower) = (c[(row, column)], c[(column, row)]);
            if (upper - lower).abs() > SYMMETRY_TOLERANCE * largest_entry {
                problems.push(MaterialProblem::NotSymmetric {
                    row: row + 1,
                    column: column + 1,
                    upper,
                    lower,
                });
            }
        }
    }

    let eigenvalues = (0.5 * (c + c.transpose())).symmetric_eigenvalues();
    if problems.is_empty() && eigenvalues.min() <= DEFINITENESS_TOLERANCE * largest_entry {
        problems.push(MaterialProblem::NotPositiveDefinite {
            smallest: eigenvalues.min(),
            largest: eigenvalues.max(),
        });
    }
    problems
}

#[cfg(test)]
mod tests {
    use super::*;

    const GLASS: EngineeringConstants = EngineeringConstants {
        e1: 37e9,
        e2: 9e9,
        e3: 9e9,
        g12: 4e9,
        g13: 4e9,
        g23: 3.4e9,
        nu12: 0.28,
        nu13: 0.28,
        nu23: 0.32,
    };

    #[test]
    fn sound_materials_have_no_problem() {
        for law in [
            ElasticLaw::Isotropic {
                young: 210e9,
                poisson: 0.3,
            },
            ElasticLaw::Orthotropic(GLASS),
            ElasticLaw::Full(ElasticLaw::Orthotropic(GLASS).stiffness()),
        ] {
            assert_eq!(law.check(), vec![]);
        }
    }

    #[test]
    fn isotropic_bounds_are_open() {
        let check = |young, poisson| ElasticLaw::Isotropic { young, poisson }.check();
        assert_eq!(check(1.0, -0.999), vec![]);
        assert!(matches!(
            check(1.0, 0.5)[..],
            [MaterialProblem::PoissonOutOfRange { .. }]
        ));
        assert!(matches!(
            check(1.0, -1.0)[..],
            [MaterialProblem::PoissonOutOfRange { .. }]
        ));
        assert_eq!(check(-1.0, 0.7).len(), 2, "both problems at once");
        assert!(matches!(
            check(f64::NAN, 0.3)[..],
            [MaterialProblem::NotFinite { constant: "E", .. }]
        ));
    }

    /// nu21 instead of nu12: 0.28 * 9/37 would be sound, 0.28 * 37/9 = 1.15 is sound too
    /// (bound 2.03), but nu12 = 2.5 is not.
    #[test]
    fn poisson_ratio_above_its_own_bound_names_the_bound() {
        let law = ElasticLaw::Orthotropic(EngineeringConstants { nu12: 2.5, ..GLASS });
        let problems = law.check();
        assert_eq!(
            problems[0].to_string(),
            "|nu12| is 2.500000, expected less than sqrt(E1/E2) = 2.027588"
        );
        assert!(problems[0].help().is_some());
    }

    /// Three ratios of 0.6 with equal moduli: 1 - 3 * 0.36 - 2 * 0.216 = -0.512.
    #[test]
    fn poisson_ratios_can_be_too_large_together() {
        let law = ElasticLaw::Orthotropic(EngineeringConstants {
            e1: 1.0,
            e2: 1.0,
            e3: 1.0,
            g12: 1.0,
            g13: 1.0,
            g23: 1.0,
            nu12: 0.6,
            nu13: 0.6,
            nu23: 0.6,
        });
        let problems = law.check();
        assert!(matches!(
            problems[..],
            [MaterialProblem::PoissonTogetherTooLarge { value }] if (value + 0.512).abs() < 1e-12
        ));
    }

    #[test]
    fn full_stiffness_must_be_symmetric_and_positive() {
        let mut c = Matrix6::identity();
        c[(0, 5)] = 0.5;
        assert_eq!(
            ElasticLaw::Full(c).check(),
            vec![MaterialProblem::NotSymmetric {
                row: 1,
                column: 6,
                upper: 0.5,
                lower: 0.0
            }]
        );
        c[(5, 0)] = 0.5;
        assert_eq!(ElasticLaw::Full(c).check(), vec![]);
        c[(0, 5)] = 1.5;
        c[(5, 0)] = 1.5;
        assert!(matches!(
            ElasticLaw::Full(c).check()[..],
            [MaterialProblem::NotPositiveDefinite { smallest, .. }] if (smallest + 0.5).abs() < 1e-12
        ));
    }

    #[test]
    fn density_must_not_be_negative() {
        let mut material = Material {
            name: "glass".into(),
            law: ElasticLaw::Orthotropic(GLASS),
            density: 0.0,
            expansion: None,
            electric: None,
        };
        assert_eq!(material.check(), vec![]);
        material.density = -1.0;
        assert_eq!(
            material.check(),
            vec![MaterialProblem::DensityNegative { value: -1.0 }]
        );
    }
}
