//! Problems of imposed states.

use shared_geom::error::Explain;

use super::super::problem::nearest_or_all;

/// A problem of a temperature, of an initial strain, or of a reference to one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImposedProblem {
    /// An invalid name of an imposed state.
    #[error("{kind} \"{name}\": expected a name of letters, digits, \"-\" and \"_\"")]
    Name {
        /// `temperature` or `initial_strain`.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// Two imposed states with the same name.
    #[error(
        "[initial_strain.{name}] has the name of [temperature.{name}] on line {line}, expected \
         different names"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of the temperature.
        line: usize,
    },
    /// A temperature that is not given, or given in two ways.
    #[error(
        "temperature \"{name}\" has {found}, expected \"rise\", \"gradient\" with or without \
         \"rise\", or \"table\""
    )]
    Form {
        /// Name of the temperature.
        name: String,
        /// The keys found, as text.
        found: &'static str,
    },
    /// An imposed state that is zero.
    #[error("{kind} \"{name}\" is zero everywhere, expected a nonzero number")]
    Zero {
        /// `temperature` or `initial_strain`.
        kind: &'static str,
        /// Its name.
        name: String,
    },
    /// A strain beyond linear theory.
    #[error("strain {component} is {value}, expected at most {limit}")]
    Large {
        /// The component, in material axes.
        component: &'static str,
        /// The strain \[-\].
        value: f64,
        /// The largest allowed \[-\].
        limit: f64,
    },
    /// An initial strain without any region.
    #[error("initial strain \"{name}\" has no region, expected [[initial_strain.{name}.region]]")]
    NoRegion {
        /// Its name.
        name: String,
    },
    /// A region of an initial strain that the file does not have.
    #[error("unknown region \"{group}\" in initial strain \"{name}\"")]
    UnknownRegion {
        /// Name of the initial strain.
        name: String,
        /// Group of the region.
        group: String,
        /// Groups of the regions of the file.
        known: Vec<String>,
    },
    /// A region with two initial strains in one state.
    #[error("initial strain \"{name}\" has region \"{group}\" twice, expected it once")]
    RegionTwice {
        /// Name of the initial strain.
        name: String,
        /// Group of the region.
        group: String,
    },
    /// A temperature for which no material expands.
    #[error(
        "temperature \"{name}\" has no effect: no region has a material with a nonzero \
         \"expansion\""
    )]
    NothingExpands {
        /// Name of the temperature.
        name: String,
    },
    /// A load under an imposed state that the file does not have.
    #[error("unknown {kind} \"{name}\" in load \"{load}\"")]
    Unknown {
        /// `temperature` or `initial_strain`.
        kind: &'static str,
        /// The name found.
        name: String,
        /// Name of the load case.
        load: String,
        /// The states of the file.
        known: Vec<String>,
    },
}

impl Explain for ImposedProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::UnknownRegion { group, known, .. } => {
                Some(nearest_or_all(group, known, "regions of the file"))
            }
            Self::Unknown {
                kind, name, known, ..
            } => Some(if known.is_empty() {
                format!("add [{kind}.{name}] to the section file")
            } else {
                nearest_or_all(name, known, "states of the file")
            }),
            Self::NothingExpands { .. } => Some(
                "add \"expansion\" to [material.NAME] of the heated regions: strain per declared \
                 unit of temperature, or a text with its own unit, \"12e-6 1/K\""
                    .to_owned(),
            ),
            Self::Name { .. } => Some("the name appears in property files".to_owned()),
            _ => None,
        }
    }
}
