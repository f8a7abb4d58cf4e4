//! Problems of layup files, in addition to the problems of any input file and of the meshing.

use shared_geom::error::{Explain, nearest_name, quoted};

use crate::mesh::generate::layup::LayupProblem;

/// A problem of a layup file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LayupFileProblem {
    /// No airfoil, or several.
    #[error("[shape] has {found} of \"naca\", \"file\" and \"airfoils\", expected one of them")]
    Airfoil {
        /// Number of them.
        found: usize,
    },
    /// Airfoils that are not in the order of the span.
    #[error("the airfoils are not at ascending positions from 0 to 1 along the span")]
    AirfoilOrder,
    /// Digits or points that are not an airfoil.
    #[error("{0}")]
    Points(String),
    /// A name that the file does not have.
    #[error("{kind} \"{found}\" is not in the file")]
    Unknown {
        /// Kind of the thing.
        kind: &'static str,
        /// The name.
        found: String,
        /// The names of the file.
        known: Vec<String>,
    },
    /// One name twice.
    #[error(
        "\"{name}\" is the name of another layer or web on line {line}, expected a name of its own"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of the other one.
        line: usize,
    },
    /// Places that refer to each other.
    #[error("places go in a circle: {}", .places.join(" -> "))]
    Circle {
        /// The places.
        places: Vec<String>,
    },
    /// A place that is not on the contour.
    #[error("\"{place}\" is not on the contour at eta {eta}")]
    OffContour {
        /// The place.
        place: String,
        /// The position along the span [-].
        eta: f64,
    },
    /// A range along the span that is not one.
    #[error("\"eta\" of web \"{web}\" is not two ascending positions from 0 to 1")]
    Range {
        /// The web.
        web: String,
    },
    /// A section that cannot be meshed.
    #[error("eta {eta}: {problem}")]
    Section {
        /// The position along the span [-].
        eta: f64,
        /// The problem.
        problem: LayupProblem,
    },
}

impl Explain for LayupFileProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Airfoil { .. } => {
                Some("naca = \"4415\", file = \"airfoil.dat\", or [[shape.airfoils]]".into())
            }
            Self::Unknown { found, known, .. } => {
                match nearest_name(found, known.iter().map(String::as_str)) {
                    Some(near) => Some(format!("did you mean \"{near}\"?")),
                    None => Some(format!("the file has {}", quoted(known))),
                }
            }
            Self::Section { problem, .. } => problem.help(),
            _ => None,
        }
    }
}
