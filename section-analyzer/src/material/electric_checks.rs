//! Admissible electric laws: positive energy of the field at constant strain.
//!
//! # References
//! - [Ieee1987]: the two forms and the two permittivities.

use nalgebra::{Matrix3, Matrix3x6, Matrix6};
use shared_geom::error::Explain;

use super::electric::ElectricLaw;

/// Largest difference between mirrored entries of a permittivity, relative to its largest
/// entry.
const SYMMETRY_TOLERANCE: f64 = 1e-6;

/// Smallest eigenvalue of a permittivity relative to its largest one.
const DEFINITENESS_TOLERANCE: f64 = 1e-9;

/// Largest permittivity \[F/m\], a hundred times the value of the best dielectrics, and
/// smallest one, a thousandth of the vacuum permittivity.
const PERMITTIVITIES: [f64; 2] = [1e-15, 1e-4];

/// Largest stress per field \[C/m^2\], thirty times the value of ceramics.
const LARGEST_COUPLING: f64 = 1e3;

/// State of the material at which a permittivity was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasuredAt {
    /// Free of stress: epsT.
    Stress,
    /// Clamped: epsS.
    Strain,
}

/// Reasons for which an electric law cannot exist.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElectricProblem {
    /// Mirrored entries of a permittivity differ.
    #[error(
        "permittivity entries ({row}, {column}) = {upper:e} F/m and ({column}, {row}) = \
         {lower:e} F/m differ, expected a symmetric matrix"
    )]
    NotSymmetric {
        /// Row, counted from one.
        row: usize,
        /// Column, counted from one.
        column: usize,
        /// Entry (row, column) \[F/m\].
        upper: f64,
        /// Entry (column, row) \[F/m\].
        lower: f64,
    },
    /// A given permittivity has zero or negative energy for some field.
    #[error(
        "the permittivity has the eigenvalue {smallest:e} F/m, expected all of them more than 0"
    )]
    NotPositive {
        /// Smallest eigenvalue \[F/m\].
        smallest: f64,
    },
    /// The permittivity at constant strain that follows from the constants is not positive.
    #[error(
        "the coupled law is indefinite: the permittivity at constant strain, epsT - {coupling}, \
         has the eigenvalue {smallest:.4e} F/m (at constant stress {least:.4e} to {largest:.4e} \
         F/m), expected all of them more than 0"
    )]
    Indefinite {
        /// `d c d'` or `e s e'`.
        coupling: &'static str,
        /// Smallest eigenvalue at constant strain \[F/m\].
        smallest: f64,
        /// Smallest one of the permittivity at constant stress \[F/m\].
        least: f64,
        /// Largest one of it \[F/m\].
        largest: f64,
    },
    /// A permittivity beyond all dielectrics.
    #[error(
        "the permittivity has the eigenvalue {value:e} F/m, expected {:e} to {:e} F/m",
        PERMITTIVITIES[0], PERMITTIVITIES[1]
    )]
    PermittivityOutOfRange {
        /// Value found \[F/m\].
        value: f64,
    },
    /// A coupling beyond all materials.
    #[error("e{row}{column} is {value:e} C/m^2, expected at most {LARGEST_COUPLING:e} C/m^2")]
    LargeCoupling {
        /// Component of the field, from one.
        row: usize,
        /// Component of the stress, from one.
        column: usize,
        /// Value found \[C/m^2\].
        value: f64,
    },
}

impl Explain for ElectricProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::NotSymmetric { .. } => return None,
            Self::NotPositive { .. } => {
                "the energy of a field must be positive in all directions: rows and columns are \
                 in the order of axes 1 2 3"
            }
            Self::Indefinite {
                coupling: "d c d'", ..
            } => {
                "d, the stiffness and the permittivity are inconsistent: the stiffness is at \
                 constant field, and with d the permittivity is at constant stress unless at = \
                 \"strain\"; check the unit of d too"
            }
            Self::Indefinite { .. } => {
                "e, the stiffness and the permittivity are inconsistent: the stiffness is at \
                 constant field; with e the permittivity is at constant strain unless at = \
                 \"stress\""
            }
            Self::PermittivityOutOfRange { .. } => {
                "the vacuum permittivity is 8.854e-12 F/m; \"relative_permittivity\" is in units \
                 of it"
            }
            Self::LargeCoupling { .. } => {
                "plain numbers are in units of the declared force, length and voltage: give the \
                 unit with the number, as in \"17 C/m^2\" or \"741 pC/N\""
            }
        };
        Some(text.to_owned())
    }
}

/// Coupling as given in a material's data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Coupling {
    /// Strain per field, 3x6 \[m/V\].
    Strains(Matrix3x6<f64>),
    /// Stress per field, 3x6 \[C/m^2\].
    Stresses(Matrix3x6<f64>),
}

impl ElectricLaw {
    /// The law of a coupling and a permittivity \[F/m\] measured `at` a state, with the
    /// stiffness `c` at constant field \[Pa\] (S-161).
    ///
    /// # Errors
    /// [`ElectricProblem`], all of them: the data do not give an admissible law.
    pub fn checked(
        coupling: Option<&Coupling>,
        (permittivity, at): (&Matrix3<f64>, MeasuredAt),
        c: &Matrix6<f64>,
    ) -> Result<Self, Vec<ElectricProblem>> {
        let mut problems = check_permittivity(permittivity);
        let symmetric = 0.5 * (permittivity + permittivity.transpose());
        let (e, part) = match coupling {
            None => (Matrix3x6::zeros(), Matrix3::zeros()),
            Some(Coupling::Strains(d)) => (d * c, d * c * d.transpose()),
            Some(Coupling::Stresses(e)) => {
                // admissible laws have an inverse
                let s = c.try_inverse().unwrap_or_else(Matrix6::zeros);
                (*e, e * s * e.transpose())
            }
        };
        problems.extend(check_coupling(&e));
        let law = Self {
            coupling: e,
            permittivity: match at {
                MeasuredAt::Strain => symmetric,
                MeasuredAt::Stress => symmetric - 0.5 * (part + part.transpose()),
            },
        };
        let smallest = law.permittivity.symmetric_eigenvalues().min();
        let given = symmetric.symmetric_eigenvalues();
        if problems.is_empty() && smallest <= DEFINITENESS_TOLERANCE * given.max() {
            problems.push(ElectricProblem::Indefinite {
                coupling: match coupling {
                    Some(Coupling::Stresses(_)) => "e s e'",
                    _ => "d c d'",
                },
                smallest,
                least: given.min(),
                largest: given.max(),
            });
        }
        if problems.is_empty() {
            Ok(law)
        } else {
            Err(problems)
        }
    }
}

fn check_permittivity(permittivity: &Matrix3<f64>) -> Vec<ElectricProblem> {
    let mut problems = Vec::new();
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let (upper, lower) = (permittivity[(i, j)], permittivity[(j, i)]);
        if (upper - lower).abs() > SYMMETRY_TOLERANCE * permittivity.amax() {
            problems.push(ElectricProblem::NotSymmetric {
                row: i + 1,
                column: j + 1,
                upper,
                lower,
            });
        }
    }
    if !problems.is_empty() {
        return problems;
    }
    let eigenvalues = (0.5 * (permittivity + permittivity.transpose())).symmetric_eigenvalues();
    let [smallest, largest] = [eigenvalues.min(), eigenvalues.max()];
    let within = PERMITTIVITIES[0]..=PERMITTIVITIES[1];
    if smallest <= DEFINITENESS_TOLERANCE * largest {
        problems.push(ElectricProblem::NotPositive { smallest });
    } else if let Some(value) = [smallest, largest]
        .into_iter()
        .find(|v| !within.contains(v))
    {
        problems.push(ElectricProblem::PermittivityOutOfRange { value });
    }
    problems
}

fn check_coupling(e: &Matrix3x6<f64>) -> Option<ElectricProblem> {
    let is_large = |&(row, column): &(usize, usize)| {
        let value: f64 = e[(row, column)];
        value.is_nan() || value.abs() > LARGEST_COUPLING
    };
    let entries = (0..3).flat_map(|row| (0..6).map(move |column| (row, column)));
    let (row, column) = entries.into_iter().find(is_large)?;
    Some(ElectricProblem::LargeCoupling {
        row: row + 1,
        column: column + 1,
        value: e[(row, column)],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::samples::{Ceramic, ceramic};
    use approx::assert_relative_eq;

    fn law(
        coupling: Coupling,
        permittivity: &Matrix3<f64>,
        at: MeasuredAt,
    ) -> Result<ElectricLaw, Vec<ElectricProblem>> {
        let c = ceramic().s.try_inverse().unwrap();
        ElectricLaw::checked(Some(&coupling), (permittivity, at), &c)
    }

    /// The reference has e and epsS of the same ceramic in eight digits: half a unit of
    /// the last digit is at most 5e-8 of any value. Both forms, measured at either state,
    /// give the same law.
    #[test]
    fn all_forms_of_the_data_are_one_law() {
        let Ceramic {
            d,
            at_stress,
            e,
            at_strain,
            ..
        } = ceramic();
        let by_d = law(Coupling::Strains(d), &at_stress, MeasuredAt::Stress).unwrap();
        assert_relative_eq!(by_d.coupling, e, max_relative = 5e-8);
        assert_relative_eq!(
            by_d.permittivity,
            at_strain,
            max_relative = 5e-8,
            epsilon = 1e-16
        );
        let e = by_d.coupling;
        for other in [
            law(Coupling::Strains(d), &by_d.permittivity, MeasuredAt::Strain),
            law(Coupling::Stresses(e), &at_stress, MeasuredAt::Stress),
            law(
                Coupling::Stresses(e),
                &by_d.permittivity,
                MeasuredAt::Strain,
            ),
        ] {
            let other = other.unwrap();
            assert_relative_eq!(other.coupling, e, max_relative = 1e-13, epsilon = 1e-13);
            // of differences of numbers twice as large
            let epsilon = 1e-13 * at_stress.amax();
            assert_relative_eq!(other.permittivity, by_d.permittivity, epsilon = epsilon);
        }
    }

    /// k33 of the ceramic is 0.75: with a d33 larger by more than 1/0.75 the energy of
    /// the field is not positive; likewise for d15.
    #[test]
    fn too_much_coupling_is_reported_with_the_part_that_is_negative() {
        let Ceramic {
            mut d, at_stress, ..
        } = ceramic();
        d[(2, 2)] *= 1.5;
        let problems = law(Coupling::Strains(d), &at_stress, MeasuredAt::Stress).unwrap_err();
        let [
            ElectricProblem::Indefinite {
                coupling, smallest, ..
            },
        ] = problems[..]
        else {
            panic!("{problems:?}");
        };
        assert!(coupling == "d c d'" && smallest < 0.0);
        // at constant strain nothing is subtracted
        assert!(law(Coupling::Strains(d), &at_stress, MeasuredAt::Strain).is_ok());
        let e = ceramic().e * 2.0;
        let problems = law(Coupling::Stresses(e), &at_stress, MeasuredAt::Stress).unwrap_err();
        assert!(matches!(
            problems[..],
            [ElectricProblem::Indefinite {
                coupling: "e s e'",
                ..
            }]
        ));
    }

    #[test]
    fn permittivities_are_symmetric_and_positive() {
        let of = |permittivity: Matrix3<f64>| {
            let at = MeasuredAt::Strain;
            ElectricLaw::checked(None, (&permittivity, at), &Matrix6::zeros())
        };
        let mut sound = Matrix3::identity() * 3e-11;
        assert_eq!(of(sound), Ok(ElectricLaw::dielectric(sound)));
        sound[(0, 1)] = 4e-11;
        let problems = of(sound).unwrap_err();
        assert!(matches!(
            problems[..],
            [ElectricProblem::NotSymmetric {
                row: 1,
                column: 2,
                ..
            }]
        ));
        sound[(1, 0)] = 4e-11;
        let problems = of(sound).unwrap_err();
        assert!(matches!(
            problems[..],
            [ElectricProblem::NotPositive { smallest }] if (smallest + 1e-11).abs() < 1e-20
        ));
        assert!(matches!(
            of(Matrix3::identity() * 3.0).unwrap_err()[..],
            [ElectricProblem::PermittivityOutOfRange { value: 3.0 }]
        ));
        assert!(matches!(
            law(
                Coupling::Stresses(Matrix3x6::repeat(1e30)),
                &ceramic().at_stress,
                MeasuredAt::Strain
            )
            .unwrap_err()[..],
            [ElectricProblem::LargeCoupling {
                row: 1,
                column: 1,
                ..
            }]
        ));
    }
}
