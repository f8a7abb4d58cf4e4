//! What can be wrong with the electric data of a material.

use shared_geom::error::Explain;

use crate::material::{AxesProblem, ElectricProblem};

/// A problem of `[material.NAME.electric]`, or of what does not go with it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElectricDataProblem {
    /// A law that cannot exist.
    #[error("material \"{material}\": {problem}")]
    Law {
        /// Name of the material.
        material: String,
        /// Why.
        problem: ElectricProblem,
    },
    /// Directions that are no axes.
    #[error("material \"{material}\": {problem}")]
    Axes {
        /// Name of the material.
        material: String,
        /// Why.
        problem: AxesProblem,
    },
    /// No permittivity.
    #[error(
        "[material.{material}.electric] has no permittivity, expected \"permittivity\" or \
         \"relative_permittivity\""
    )]
    NoPermittivity {
        /// Name of the material.
        material: String,
    },
    /// Two permittivities.
    #[error(
        "[material.{material}.electric] has \"permittivity\" and \"relative_permittivity\", \
         expected one of them"
    )]
    TwoPermittivities {
        /// Name of the material.
        material: String,
    },
    /// Two forms of the coupling.
    #[error("[material.{material}.electric] has \"d\" and \"e\", expected one of them")]
    TwoCouplings {
        /// Name of the material.
        material: String,
    },
    /// A coupling that couples nothing.
    #[error("[material.{material}.electric]: \"{key}\" is zero, expected a constant that is not")]
    ZeroCoupling {
        /// Name of the material.
        material: String,
        /// `d` or `e`.
        key: &'static str,
    },
    /// A state that makes no difference.
    #[error("[material.{material}.electric] has \"at\", but no \"d\" or \"e\"")]
    AtAlone {
        /// Name of the material.
        material: String,
    },
    /// A coupling of a material without stiffness.
    #[error(
        "material \"{material}\" has no stiffness, and \"{key}\" of [material.{material}.electric]"
    )]
    NothingToCouple {
        /// Name of the material.
        material: String,
        /// `d` or `e`.
        key: &'static str,
    },
    /// Strains or stresses of a material without stiffness.
    #[error("material \"{material}\" has no stiffness, and \"{key}\"")]
    NothingToStrain {
        /// Name of the material.
        material: String,
        /// The key.
        key: &'static str,
    },
    /// A material without stiffness and without electric law.
    #[error(
        "material \"{material}\" has neither stiffness nor electric law, expected \
         [material.{material}.electric]"
    )]
    NothingAtAll {
        /// Name of the material.
        material: String,
    },
    /// Strengths along axes from which the constants are turned.
    #[error(
        "[material.{material}.{key}] is along the material axes, and \"poling\" turns the other \
         constants, expected no poling but 3 beside strengths"
    )]
    LimitsTurned {
        /// Name of the material.
        material: String,
        /// `strength` or `strain_limit`.
        key: &'static str,
    },
}

/// The key under which what is wrong with a law stands: that of the permittivity, or that of
/// the coupling.
pub(super) fn key_of(
    problem: &ElectricProblem,
    permittivity: &'static str,
    coupling: Option<&'static str>,
) -> &'static str {
    match problem {
        ElectricProblem::Indefinite { .. } | ElectricProblem::LargeCoupling { .. } => {
            coupling.unwrap_or(permittivity)
        }
        _ => permittivity,
    }
}

impl Explain for ElectricDataProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Law { problem, .. } => return problem.help(),
            Self::Axes { problem, .. } => return problem.help(),
            Self::AtAlone { .. } => {
                "without coupling the permittivity is the same at constant stress and strain"
            }
            Self::TwoCouplings { .. } => "one follows from the other by the stiffness: e = d c",
            Self::ZeroCoupling { .. } => "leave it out for a dielectric that is not piezoelectric",
            Self::NothingToCouple { .. } => {
                "a field strains what has a stiffness: give one, or leave the coupling out"
            }
            Self::NothingToStrain { .. } => "leave it out: it would do nothing",
            Self::NothingAtAll { .. } => {
                "leave its cells out of the mesh, or give a filler a small modulus"
            }
            Self::LimitsTurned { .. } => {
                "give all constants along the material axes, with \"d\" or \"e\" as 3 rows of 6, \
                 and no \"poling\""
            }
            Self::NoPermittivity { .. } | Self::TwoPermittivities { .. } => return None,
        };
        Some(text.to_owned())
    }
}
