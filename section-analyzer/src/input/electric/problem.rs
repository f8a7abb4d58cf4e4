//! Problems of the electric data of a material.

use shared_geom::error::Explain;

use crate::material::{AxesProblem, ElectricProblem};

/// A problem of `[material.NAME.electric]`, or of data that contradict it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElectricDataProblem {
    /// A law that cannot exist.
    #[error("material \"{material}\": {problem}")]
    Law {
        /// Name of the material.
        material: String,
        /// The reason.
        problem: ElectricProblem,
    },
    /// Directions that are not axes.
    #[error("material \"{material}\": {problem}")]
    Axes {
        /// Name of the material.
        material: String,
        /// The reason.
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
    /// A coupling that is zero.
    #[error("[material.{material}.electric]: \"{key}\" is zero, expected a nonzero constant")]
    ZeroCoupling {
        /// Name of the material.
        material: String,
        /// `d` or `e`.
        key: &'static str,
    },
    /// A state that has no effect.
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
    /// Strengths along axes from which the constants are rotated.
    #[error(
        "[material.{material}.{key}] is along the material axes, and \"poling\" rotates the other \
         constants, expected no poling but 3 with strengths"
    )]
    LimitsTurned {
        /// Name of the material.
        material: String,
        /// `strength` or `strain_limit`.
        key: &'static str,
    },
}

/// The key of a wrong law: the permittivity's or the coupling's.
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
            Self::ZeroCoupling { .. } => "remove it for a dielectric that is not piezoelectric",
            Self::NothingToCouple { .. } => {
                "the coupling needs a stiffness: give one, or remove the coupling"
            }
            Self::NothingToStrain { .. } => "remove it: it has no effect",
            Self::NothingAtAll { .. } => {
                "remove its cells from the mesh, or give a filler a small modulus"
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
