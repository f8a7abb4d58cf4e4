//! What can be wrong with imposed states.

use shared_geom::error::Explain;

use super::super::problem::nearest_or_all;

/// A problem of a temperature, of an initial strain, or of what refers to one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImposedProblem {
    /// A name of an imposed state that is no name.
    #[error("{kind} \"{name}\": expected a name of letters, digits, \"-\" and \"_\"")]
    Name {
        /// `temperature` or `initial_strain`.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// Two imposed states of one name.
    #[error(
        "[initial_strain.{name}] has the name of [temperature.{name}] on line {line}, expected a \
         name of its own"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of the temperature.
        line: usize,
    },
    /// A temperature that is given in no way, or in two.
    #[error(
        "temperature \"{name}\" has {found}, expected \"rise\", \"gradient\" with or without \
         \"rise\", or \"table\""
    )]
    Form {
        /// Name of the temperature.
        name: String,
        /// What it has, in words.
        found: &'static str,
    },
    /// An imposed state that changes nothing.
    #[error("{kind} \"{name}\" is zero everywhere, expected a number that is not")]
    Zero {
        /// `temperature` or `initial_strain`.
        kind: &'static str,
        /// Its name.
        name: String,
    },
    /// A strain beyond all that is linear.
    #[error("strain {component} is {value}, expected at most {limit}")]
    Large {
        /// The component, in material axes.
        component: &'static str,
        /// The strain \[-\].
        value: f64,
        /// The largest \[-\].
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
    /// A temperature where nothing expands.
    #[error(
        "temperature \"{name}\" has no effect: no region has a material with an \
         \"expansion\" that is not zero"
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
        /// Those of the file.
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
            } => Some(match known.is_empty() {
                true => format!("add [{kind}.{name}] to the section file"),
                false => nearest_or_all(name, known, "those of the file"),
            }),
            Self::NothingExpands { .. } => Some(
                "add \"expansion\" to [material.NAME] of what is heated: strain per declared unit \
                 of temperature, or a text with its own unit, \"12e-6 1/K\""
                    .to_owned(),
            ),
            Self::Name { .. } => Some("the name stands in property files".to_owned()),
            _ => None,
        }
    }
}
