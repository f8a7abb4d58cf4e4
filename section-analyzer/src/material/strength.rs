//! Strengths of materials: stresses and strains at which they fail.
//!
//! Values in material axes, 1 along the fiber, 2 transverse in the ply, 3 through the
//! thickness; all are positive numbers, in compression too.

use serde::Serialize;
use shared_geom::error::Explain;

use super::fatigue::{Fatigue, SLOPES, Slopes};

/// Slack of the combined bound of the three interactions: the default, -0.5 for all
/// three, lies on it.
const OPEN_SURFACE: f64 = -1e-12;

/// Smallest and largest limit \[unit of the limited quantity: Pa or -\]: far beyond all
/// materials; squares of stresses over strengths are still finite.
const RANGE: (f64, f64) = (1e-15, 1e100);

/// Default interaction of the tensor criterion \[-\]: with it the criterion equals the
/// von Mises criterion for a material of equal strengths.
pub const DEFAULT_INTERACTION: f64 = -0.5;

/// Limits of a stress or a strain along the material axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DirectionalLimits {
    /// Tension along 1, 2, 3 \[unit of the limited quantity: Pa or -\].
    pub tension: [f64; 3],
    /// Compression along 1, 2, 3, positive \[unit of the limited quantity: Pa or -\].
    pub compression: [f64; 3],
    /// Shear 23, 13, 12 \[unit of the limited quantity: Pa or -\].
    pub shear: [f64; 3],
}

/// Isotropic limits of a stress or a strain.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct UniformLimits {
    /// Of the largest principal value \[unit of the limited quantity: Pa or -\].
    pub tension: f64,
    /// Of the smallest principal value, positive \[unit of the limited quantity: Pa or -\].
    pub compression: f64,
    /// Of the largest shear, engineering shear for strains
    /// \[unit of the limited quantity: Pa or -\].
    pub shear: f64,
}

/// Limits of the stresses in a material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Strength {
    /// Along the material axes.
    Ply {
        /// Strengths \[Pa\].
        limits: DirectionalLimits,
        /// Interactions 23, 13, 12 of the tensor criterion: `F_ij / sqrt(F_ii F_jj)` \[-\].
        interaction: [f64; 3],
    },
    /// Isotropic, by principal stresses \[Pa\].
    Uniform(UniformLimits),
    /// Yield stress, for the von Mises stress \[Pa\].
    Yield(f64),
}

/// Limits of the strains in a material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum StrainLimit {
    /// Along the material axes \[-\].
    Ply(DirectionalLimits),
    /// Isotropic, by principal strains \[-\].
    Uniform(UniformLimits),
}

/// Known limits of a material.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MaterialLimits {
    /// Limits of stresses, if known.
    pub strength: Option<Strength>,
    /// Limits of strains, if known.
    pub strain: Option<StrainLimit>,
    /// Slopes of the S-N lines, if known.
    #[serde(skip)]
    pub fatigue: Fatigue,
}

/// Reasons for which a strength is not admissible.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StrengthProblem {
    /// A limit is zero, negative, or not a number.
    #[error("{key} is {value}, expected more than 0")]
    NotPositive {
        /// Key of the limit.
        key: &'static str,
        /// Value found, in SI units.
        value: f64,
    },
    /// A limit beyond all materials.
    #[error("{key} is {value:e}, expected {:e} to {:e}", RANGE.0, RANGE.1)]
    Extreme {
        /// Key of the limit.
        key: &'static str,
        /// Value found, in SI units.
        value: f64,
    },
    /// An interaction is out of its range.
    #[error("{key} is {value}, expected more than -1 and less than 1")]
    InteractionOutOfRange {
        /// Key of the interaction.
        key: &'static str,
        /// Value found \[-\].
        value: f64,
    },
    /// A slope of an S-N line is out of its range.
    #[error("{key} is {value}, expected {} to {}", SLOPES.0, SLOPES.1)]
    SlopeOutOfRange {
        /// Key of the slope.
        key: &'static str,
        /// Value found \[-\].
        value: f64,
    },
    /// The failure surface is open with the three interactions.
    #[error(
        "1 + 2 f12 f13 f23 - f12^2 - f13^2 - f23^2 is {value:.6}, expected 0 or more: \
         the failure surface is open, and some stress of any size would be safe"
    )]
    OpenSurface {
        /// Value found \[-\].
        value: f64,
    },
}

impl Explain for StrengthProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::NotPositive { .. } => {
                "strengths are positive numbers, also in compression; omit unknown ones"
            }
            Self::Extreme { .. } => {
                "this is the value in SI units; omit unknown ones, and give 1e30 for a direction \
                 that never fails"
            }
            Self::InteractionOutOfRange { .. } => {
                "it is F12 / sqrt(F11 F22), without a unit; -0.5 is the usual choice"
            }
            Self::SlopeOutOfRange { .. } => {
                "it is the exponent of N = (S / S_a)^m, as 10 of glass fibers in epoxy"
            }
            Self::OpenSurface { .. } => {
                "the default of f13 and f23 is f12; equal ones must be -0.5 or more"
            }
        };
        Some(text.to_owned())
    }
}

/// Keys of the limits along the material axes, in the order of [`DirectionalLimits`].
const DIRECTIONAL_KEYS: [&str; 9] = ["xt", "yt", "zt", "xc", "yc", "zc", "s23", "s13", "s12"];

/// Keys of the interactions 23, 13, 12.
const INTERACTION_KEYS: [&str; 3] = ["f23", "f13", "f12"];

impl DirectionalLimits {
    fn check(&self) -> Vec<StrengthProblem> {
        let values = self.tension.iter().chain(&self.compression);
        let values: Vec<f64> = values.chain(&self.shear).copied().collect();
        not_limits(&DIRECTIONAL_KEYS, &values)
    }
}

impl UniformLimits {
    fn check(&self) -> Vec<StrengthProblem> {
        let keys = ["tension", "compression", "shear"];
        not_limits(&keys, &[self.tension, self.compression, self.shear])
    }
}

impl Strength {
    /// All violations of this strength's bounds; empty if admissible.
    pub fn check(&self) -> Vec<StrengthProblem> {
        match self {
            Self::Ply {
                limits,
                interaction,
            } => {
                let mut problems = limits.check();
                problems.append(&mut check_interaction(interaction));
                problems
            }
            Self::Uniform(limits) => limits.check(),
            Self::Yield(stress) => not_limits(&["yield"], &[*stress]),
        }
    }
}

impl StrainLimit {
    /// All violations of this limit's bounds; empty if admissible.
    pub fn check(&self) -> Vec<StrengthProblem> {
        match self {
            Self::Ply(limits) => limits.check(),
            Self::Uniform(limits) => limits.check(),
        }
    }
}

impl Slopes {
    /// All slopes out of their range.
    pub fn check(&self) -> Vec<StrengthProblem> {
        let is_wrong = |value: f64| !(SLOPES.0..=SLOPES.1).contains(&value);
        let fiber = self.fiber.map(|value| ("m", value));
        let slopes = fiber.into_iter().chain([("m_matrix", self.matrix)]);
        let wrong = slopes.filter(|(_, value)| is_wrong(*value));
        wrong
            .map(|(key, value)| StrengthProblem::SlopeOutOfRange { key, value })
            .collect()
    }
}

fn not_limits(keys: &[&'static str], values: &[f64]) -> Vec<StrengthProblem> {
    let pairs = keys.iter().zip(values);
    pairs
        .filter_map(|(&key, &value)| {
            if value.is_nan() || value <= 0.0 {
                Some(StrengthProblem::NotPositive { key, value })
            } else if value < RANGE.0 || value > RANGE.1 {
                Some(StrengthProblem::Extreme { key, value })
            } else {
                None
            }
        })
        .collect()
}

/// Each is within (-1, 1), and the quadratic form of the three normal stresses is not
/// negative: its normalized matrix has ones and the interactions.
fn check_interaction(interaction: &[f64; 3]) -> Vec<StrengthProblem> {
    let pairs = INTERACTION_KEYS.iter().zip(interaction);
    let mut problems: Vec<_> = pairs
        .filter(|(_, value)| value.is_nan() || value.abs() >= 1.0)
        .map(|(&key, &value)| StrengthProblem::InteractionOutOfRange { key, value })
        .collect();
    let [f23, f13, f12] = interaction;
    let value = 1.0 + 2.0 * f12 * f13 * f23 - f12 * f12 - f13 * f13 - f23 * f23;
    if problems.is_empty() && value < OPEN_SURFACE {
        problems.push(StrengthProblem::OpenSurface { value });
    }
    problems
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: DirectionalLimits = DirectionalLimits {
        tension: [1500e6, 50e6, 50e6],
        compression: [1200e6, 200e6, 200e6],
        shear: [100e6, 70e6, 70e6],
    };

    fn ply(limits: DirectionalLimits, interaction: [f64; 3]) -> Vec<StrengthProblem> {
        let strength = Strength::Ply {
            limits,
            interaction,
        };
        strength.check()
    }

    #[test]
    fn sound_strengths_have_no_problem() {
        assert_eq!(ply(LIMITS, [DEFAULT_INTERACTION; 3]), []);
        assert_eq!(ply(LIMITS, [0.0; 3]), []);
        assert_eq!(Strength::Yield(250e6).check(), []);
        assert_eq!(StrainLimit::Ply(LIMITS).check(), []);
    }

    #[test]
    fn every_limit_must_be_positive() {
        let mut limits = LIMITS;
        limits.compression[1] = -200e6;
        limits.shear[2] = f64::NAN;
        let problems = ply(limits, [DEFAULT_INTERACTION; 3]);
        let shown: Vec<_> = problems.iter().map(ToString::to_string).collect();
        assert_eq!(
            shown,
            [
                "yc is -200000000, expected more than 0",
                "s12 is NaN, expected more than 0",
            ]
        );
        assert!(problems[0].help().unwrap().contains("positive numbers"));
        assert_eq!(Strength::Yield(0.0).check().len(), 1);
        let uniform = UniformLimits {
            tension: 1.0,
            compression: -1.0,
            shear: 1.0,
        };
        assert_eq!(StrainLimit::Uniform(uniform).check().len(), 1);
    }

    /// Squares of stresses over these strengths are not finite.
    #[test]
    fn limits_beyond_all_numbers_are_refused() {
        let mut limits = LIMITS;
        limits.tension[1] = 1e-150;
        limits.compression[0] = 1e200;
        let problems = ply(limits, [DEFAULT_INTERACTION; 3]);
        let shown: Vec<_> = problems.iter().map(ToString::to_string).collect();
        let expected = [
            "yt is 1e-150, expected 1e-15 to 1e100",
            "xc is 1e200, expected 1e-15 to 1e100",
        ];
        assert_eq!(shown, expected);
        assert_eq!(Strength::Yield(5e-324).check().len(), 1);
        assert_eq!(Strength::Yield(1e30).check(), []);
    }

    /// Three equal interactions f have the eigenvalues 1 - f, 1 - f, 1 + 2 f; the
    /// determinant at -0.7 is 1.7^2 (-0.4) = -1.156.
    #[test]
    fn interactions_must_leave_the_surface_closed() {
        assert!(matches!(
            ply(LIMITS, [-0.5, -0.5, 1.0])[..],
            [StrengthProblem::InteractionOutOfRange { key: "f12", .. }]
        ));
        assert!(matches!(
            ply(LIMITS, [-0.7; 3])[..],
            [StrengthProblem::OpenSurface { value }] if (value + 1.156).abs() < 1e-12
        ));
        // f12 = f13 = -0.7 is closed with f23 of at least 2 f12^2 - 1 = -0.02
        assert_eq!(ply(LIMITS, [0.0, -0.7, -0.7]), []);
    }
}
