//! Problems of blade files, in addition to the problems of any input file and of the
//! meshing.

use shared_geom::error::Explain;

/// A problem of a blade file, or of the airfoil file that it names.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BladeFileProblem {
    /// A layup.
    #[error("the file is a layup, expected a section of plies that are given for parts of a blade")]
    Layup,
    /// No airfoil.
    #[error("[airfoil] has neither \"naca\" nor \"file\", expected one of them")]
    NoAirfoil,
    /// Two airfoils.
    #[error("[airfoil] has \"naca\" and \"file\", expected one of them")]
    TwoAirfoils,
    /// A shape of the trailing edge for an airfoil given by points.
    #[error(
        "\"trailing_edge\" is for NACA airfoils: the points of a file include the trailing edge"
    )]
    EdgeOfFile,
    /// One name with two meanings.
    #[error(
        "\"{name}\" has another material, angle or position on line {line}, expected one of \
         each"
    )]
    NameTwice {
        /// The name.
        name: String,
        /// Line of its first use.
        line: usize,
    },
    /// A core without its own space.
    #[error("[core.{core}] needs {needed}")]
    NoCavity {
        /// The core.
        core: &'static str,
        /// The missing part.
        needed: &'static str,
    },
    /// Neither a skin nor a core along a part of the contour.
    #[error(
        "the file has no \"skin\", and no [core.{core}] that fills the section up to its contour"
    )]
    NoSkin {
        /// The core.
        core: &'static str,
    },
    /// A ply in a front web that does not exist.
    #[error("\"on\" has \"front_web\", but the spar has no front web")]
    NoFrontWeb,
    /// A row of an airfoil file.
    #[error("\"{found}\" is not a point, expected x/c and z/c")]
    Row {
        /// The row.
        found: String,
    },
    /// The heading of an airfoil file.
    #[error("the columns are \"{found}\", expected one called \"x\" and one called \"z\" or \"y\"")]
    Heading {
        /// The row.
        found: String,
    },
    /// An airfoil file without points.
    #[error("the file has no points, expected rows of x/c and z/c")]
    NoPoints,
    /// Surfaces whose numbers of points differ from the announced ones.
    #[error("the file announces {upper} and {lower} points, and has {found}")]
    Announced {
        /// Points of the upper surface as announced.
        upper: usize,
        /// Points of the lower surface as announced.
        lower: usize,
        /// Points found.
        found: usize,
    },
}

impl Explain for BladeFileProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Layup => Some("use \"section-analyzer mesh layup\"".into()),
            Self::NoAirfoil => Some("naca = \"0012\", or file = \"airfoil.dat\"".into()),
            Self::NameTwice { .. } => Some("give it a name of its own".into()),
            Self::NoSkin { core } => Some(format!(
                "[skin] plies = [{{ name = \"skin\", thickness = ... }}], or [core.{core}] name = \"foam\""
            )),
            Self::NoFrontWeb => {
                Some("front_web = 0.12 in [spar], or \"web\" for its only web".into())
            }
            Self::EdgeOfFile => {
                Some("remove it; [airfoil] end = 0.98 cuts off the thin end".into())
            }
            _ => None,
        }
    }
}
