//! What can be wrong with laws, rods and springs.

use shared_geom::error::Explain;

use crate::input::short_number;

/// A problem of a law, or of what carries it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LawProblem {
    /// No term.
    #[error("the list of laws is empty, expected at least one")]
    Empty,
    /// A matrix that is not symmetric.
    #[error(
        "\"{key}\" is not symmetric: {} in row {} and column {}, {} across the diagonal",
        six(.found[0]), .entry[0], .entry[1], six(.found[1])
    )]
    Unsymmetric {
        /// The key.
        key: &'static str,
        /// Row and column, from one.
        entry: [usize; 2],
        /// The entry and its counterpart, as written.
        found: [f64; 2],
    },
    /// A matrix with a negative eigenvalue.
    #[error(
        "\"{key}\" has a negative eigenvalue ({} of the matrix scaled to a unit diagonal), expected none",
        six(*.least)
    )]
    Indefinite {
        /// The key.
        key: &'static str,
        /// The eigenvalue [-].
        least: f64,
    },
    /// A beam whose law does not hold it together.
    #[error(
        "{beam}: the law has no positive definite stiffness at rest (least eigenvalue {} of the matrix scaled to a unit diagonal)",
        six(*.least)
    )]
    SoftBeam {
        /// The beam, in words.
        beam: String,
        /// The eigenvalue [-].
        least: f64,
    },
    /// A law beside properties whose own law has the effect of prestress.
    #[error("{beam}: a \"law\" takes the place of the stiffness, and with it of \"prestress\"")]
    LawAndPrestress {
        /// The beam, in words.
        beam: String,
    },
    /// A viscoelastic law without viscosity, or with two.
    #[error("the viscoelastic law needs a \"viscosity\" or a \"time\", and not both")]
    OneViscosity,
    /// A force or a slope at rest that is not finite.
    #[error("the law has a force or a slope of {found} at zero strain, expected finite numbers")]
    NotFinite {
        /// What it is [unit of force, or of force by that of strain].
        found: f64,
    },
    /// A polynomial without a coefficient.
    #[error(
        "the cubic law has no \"stiffness\", \"quadratic\" or \"cubic\", expected at least one"
    )]
    NoCoefficient,
    /// A table or an expression for no component.
    #[error("\"{key}\" names no component, expected at least one of {names}")]
    NoComponent {
        /// The key.
        key: &'static str,
        /// Names of the components.
        names: String,
    },
    /// A table whose strains do not grow.
    #[error("the strain {} follows {}, expected growing strains", six(*.found), six(*.before))]
    NotAscending {
        /// The strain before, as written.
        before: f64,
        /// The strain, as written.
        found: f64,
    },
    /// Fewer than two points.
    #[error("the table has {found} rows, expected at least two")]
    FewPoints {
        /// Number of rows.
        found: usize,
    },
    /// A table without a value at rest.
    #[error("the points do not reach the strain zero, beyond them there is no force")]
    NoRest,
    /// The stiffness of a section where there is none.
    #[error("the law \"section\" is that of the properties of a beam, but there are none")]
    NoSection,
    /// A drive of nothing.
    #[error("\"{drive_key}\" drives \"{key}\", which is not given")]
    NothingDriven {
        /// What would be driven.
        key: &'static str,
        /// The key found.
        drive_key: &'static str,
    },
    /// A rod whose ends are at one place.
    #[error("{rod} has no length: its ends are at one place")]
    NoLength {
        /// The rod, in words.
        rod: String,
    },
    /// A rod or a spring with another number of nodes.
    #[error("\"nodes\" lists {found}, expected one (the other end is in the frame) or two")]
    Ends {
        /// Their number.
        found: usize,
    },
    /// Stiffness or damping of a spring that is not a list of three.
    #[error("\"{key}\" is not a list, expected three numbers, one for each axis of the spring")]
    OneNumber {
        /// The key.
        key: &'static str,
    },
    /// A spring without a law.
    #[error("{spring} has no law and no stiffness or damping, expected one of them")]
    NoLaw {
        /// The spring, in words.
        spring: String,
    },
    /// Two keys for one thing.
    #[error("\"{first}\" and \"{second}\" say the same, expected one of them")]
    Twice {
        /// One key.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// An end in the frame without a place.
    #[error("{rod} has one node and no \"at\", expected the place of its other end in the frame")]
    NoAnchor {
        /// The rod, in words.
        rod: String,
    },
    /// A spring between two nodes that should stand in the world.
    #[error("\"stands_in\" is for springs of one node with \"stiffness\" and \"damping\"")]
    Stand,
    /// A force between nodes without a force.
    #[error("nothing acts between the nodes, expected \"tension\", \"force\" or \"moment\"")]
    NoForce,
}

impl Explain for LawProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::Unsymmetric { .. } => "a law with an energy has a symmetric matrix",
            Self::Indefinite { .. } => {
                "a law that pushes away, or feeds energy in, can be written as a table or an expression"
            }
            Self::SoftBeam { .. } => {
                "add a law that holds every component, such as { kind = \"section\" }"
            }
            Self::LawAndPrestress { .. } => "remove one of the two",
            Self::NoRest => {
                "add a point, or take outside = \"extend\" or \"hold\"; a \"prestrain\" moves \
                 the place of the zero"
            }
            Self::NotFinite { .. } => {
                "write it so that it is smooth at zero, such as x/sqrt(abs(x) + 1e-3) for the \
                 root of x with its sign"
            }
            Self::NoSection => "give the beam \"properties\", or another kind of law",
            Self::NothingDriven { .. } => {
                "the drive multiplies it: give its value for the drive one"
            }
            Self::NoLength { .. } => {
                "a rod acts along its line: between nodes at one place use a [[spring]]"
            }
            Self::OneNumber { key } if key.starts_with("rotational") => {
                "such as [0, 0, k]; about the axis of a hinge alone it is that of a [[hinge]]"
            }
            Self::OneNumber { .. } => {
                "such as [k, k, k]; along the line between its ends it is that of a [[rod]] \
                 with measure = \"elongation\" and a law, { kind = \"linear\", stiffness = k }"
            }
            Self::NoLaw { .. } => {
                "give it law = { kind = \"linear\", stiffness = ... }, or \"rotational_law\""
            }
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}

/// A number of a message.
fn six(value: f64) -> String {
    short_number(value, 6)
}
