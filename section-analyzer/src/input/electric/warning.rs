//! Warnings about electric laws and electrodes.

use std::fmt;

use shared_geom::figure::tick_label;

/// A warning about an electric law or an electrode.
#[derive(Debug, Clone, PartialEq)]
pub enum ElectricWarning {
    /// A constant of an electric law whose partner is not given, and therefore zero.
    AloneConstant {
        /// Name of the material.
        material: String,
        /// The constant, and its partner.
        constants: [String; 2],
    },
    /// A permittivity below the vacuum permittivity.
    BelowVacuum {
        /// Name of the material.
        material: String,
        /// Smallest relative permittivity \[-\].
        relative: f64,
    },
    /// A piezoelectric material in a section without electrodes.
    NoElectrodes {
        /// Its name.
        material: String,
    },
    /// An electrode only part of which is on a dielectric.
    LooseElectrode {
        /// Its name.
        electrode: String,
        /// Number of its nodes that are not on dielectrics.
        loose: usize,
        /// Number of its nodes.
        nodes: usize,
        /// Tag of one of these.
        first: u64,
    },
}

impl fmt::Display for ElectricWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AloneConstant {
                material,
                constants: [given, other],
            } => write!(
                f,
                "material \"{material}\" has {given} and no {other}, which is then 0: in poled \
                 ceramics they are equal"
            ),
            Self::BelowVacuum { material, relative } => write!(
                f,
                "material \"{material}\" has a relative permittivity of {} at constant strain, \
                 less than 1, the value of vacuum: check the unit",
                tick_label(*relative, 0.0)
            ),
            Self::NoElectrodes { material } => write!(
                f,
                "material \"{material}\" is piezoelectric, and the section has no electrodes: it \
                 is solved with its stiffness at constant field, without potentials"
            ),
            Self::LooseElectrode {
                electrode,
                loose,
                nodes,
                first,
            } => write!(
                f,
                "{loose} of the {nodes} nodes of electrode \"{electrode}\" (node {first} for \
                 example) are on no dielectric: they have no effect"
            ),
        }
    }
}
