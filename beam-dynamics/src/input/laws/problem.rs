//! Problems of laws, rods and springs.

use shared_geom::error::Explain;

use crate::input::short_number;

/// A problem of a law, or of the element with the law.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LawProblem {
    /// A list without a term.
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
    /// A beam whose law has no positive definite stiffness.
    #[error(
        "{beam}: the law has no positive definite stiffness at rest (least eigenvalue {} of the matrix scaled to a unit diagonal)",
        six(*.least)
    )]
    SoftBeam {
        /// The beam, as text.
        beam: String,
        /// The eigenvalue [-].
        least: f64,
    },
    /// A law for properties with `prestress = true`.
    #[error("{beam}: a \"law\" replaces the stiffness, and \"prestress\" with it")]
    LawAndPrestress {
        /// The beam, as text.
        beam: String,
    },
    /// A viscoelastic law without viscosity, or with two.
    #[error("the viscoelastic law needs a \"viscosity\" or a \"time\", and not both")]
    OneViscosity,
    /// A force or a slope at rest that is not finite.
    #[error("the law has a force or a slope of {found} at zero strain, expected finite numbers")]
    NotFinite {
        /// The value [unit of force, or unit of force per unit of strain].
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
    /// A table whose strains do not increase.
    #[error("the strain {} follows {}, expected increasing strains", six(*.found), six(*.before))]
    NotAscending {
        /// The previous strain, as written.
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
    #[error("the points do not reach zero strain, and outside of them there is no force")]
    NoRest,
    /// The stiffness of a section that does not exist.
    #[error("the law \"section\" is the stiffness of a beam's properties, but there are none")]
    NoSection,
    /// A drive without a quantity.
    #[error("\"{drive_key}\" drives \"{key}\", which is not given")]
    NothingDriven {
        /// The missing key.
        key: &'static str,
        /// The key found.
        drive_key: &'static str,
    },
    /// A rod whose ends coincide.
    #[error("{rod} has no length: its ends coincide")]
    NoLength {
        /// The rod, as text.
        rod: String,
    },
    /// A wrong number of nodes of a rod or a spring.
    #[error("\"nodes\" lists {found}, expected one (the other end is in the frame) or two")]
    Ends {
        /// Number of nodes.
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
        /// The spring, as text.
        spring: String,
    },
    /// Two keys for the same quantity.
    #[error("\"{first}\" and \"{second}\" are the same quantity, expected one of them")]
    Twice {
        /// One key.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// An end in the frame without a position.
    #[error("{rod} has one node and no \"at\", expected the position of the other end")]
    NoAnchor {
        /// The rod, as text.
        rod: String,
    },
    /// A spring between two nodes in the ground frame.
    #[error("\"fixed_to\" is for springs of one node with \"stiffness\" and \"damping\"")]
    SupportFrame,
    /// A force between nodes without a force.
    #[error("nothing acts between the nodes, expected \"tension\", \"force\" or \"moment\"")]
    NoForce,
}

impl Explain for LawProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::Unsymmetric { .. } => "a law with an energy has a symmetric matrix",
            Self::Indefinite { .. } => {
                "negative stiffness or energy input can be written as a table or an expression"
            }
            Self::SoftBeam { .. } => {
                "add a law that holds every component, for example { kind = \"section\" }"
            }
            Self::LawAndPrestress { .. } => "remove one of the two",
            Self::NoRest => {
                "add a point, or use outside = \"extend\" or \"hold\"; a \"prestrain\" moves \
                 the position of zero"
            }
            Self::NotFinite { .. } => {
                "write it so that it is smooth at zero, for example x/sqrt(abs(x) + 1e-3) for \
                 the root of x with its sign"
            }
            Self::NoSection => "give the beam \"properties\", or another kind of law",
            Self::NothingDriven { .. } => {
                "the drive multiplies it: give its value for the drive one"
            }
            Self::NoLength { .. } => {
                "a rod acts along its line: between nodes at the same position use a [[spring]]"
            }
            Self::OneNumber { key } if key.starts_with("rotational") => {
                "for example [0, 0, k]; a spring about the axis of a hinge belongs to a [[hinge]]"
            }
            Self::OneNumber { .. } => {
                "for example [k, k, k]; a spring along the line between its ends is a [[rod]] \
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

/// A number in a message.
fn six(value: f64) -> String {
    short_number(value, 6)
}
