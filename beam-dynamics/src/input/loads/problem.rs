//! Problems of loads.

use shared_geom::error::{Explain, nearest_name};

use crate::input::short_number;

/// A problem of a load, an imposed motion or gravity.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LoadProblem {
    /// A load without force and moment.
    #[error("the load has neither \"force\" nor \"moment\", expected one of them or both")]
    NoLoad,
    /// An imposed motion without components.
    #[error("nothing is imposed, expected \"displacement\", \"rotation\" or both")]
    NothingImposed,
    /// A node that is clamped and moved.
    #[error("node \"{node}\" is clamped, expected a node that can be moved")]
    Clamped {
        /// Name of the node.
        node: String,
    },
    /// A node with two imposed motions.
    #[error("node \"{node}\" has an imposed motion on {line} already, expected one card per node")]
    ImposedTwice {
        /// Name of the node.
        node: String,
        /// Line of the first, as text.
        line: String,
    },
    /// A distributed load without a line.
    #[error("the card has neither \"blade\" nor \"beams\", expected one of them")]
    NoLine,
    /// A load along a blade and along beams.
    #[error("the card has \"blade\" and \"beams\", expected one of them")]
    BladeAndBeams,
    /// An unknown name of a beam or blade.
    #[error("unknown {kind} \"{name}\" in \"{user}\"")]
    UnknownLine {
        /// `beam` or `blade`.
        kind: &'static str,
        /// The name.
        name: String,
        /// Name of the load.
        user: String,
        /// The names of this kind.
        known: Vec<String>,
    },
    /// No beam.
    #[error("\"beams\" is empty, expected the names of beams")]
    NoBeams,
    /// A beam twice along one load.
    #[error("\"beams\" lists \"{name}\" twice, expected each beam once")]
    BeamTwice {
        /// Name of the beam.
        name: String,
    },
    /// Too many coefficients.
    #[error("\"{key}\" has {found} rows of coefficients, expected at most {limit}")]
    Degree {
        /// The key.
        key: &'static str,
        /// Number of rows.
        found: usize,
        /// The largest number accepted.
        limit: usize,
    },
    /// A number of rows that differs from the number of positions.
    #[error("\"{key}\" has {found} rows, expected {expected}: one for each position of \"at\"")]
    Rows {
        /// The key.
        key: &'static str,
        /// Number of rows.
        found: usize,
        /// Number of positions.
        expected: usize,
    },
    /// A table of one position.
    #[error("\"at\" has {found} positions, expected at least two")]
    FewPositions {
        /// Number of positions.
        found: usize,
    },
    /// Positions that decrease.
    #[error(
        "\"at\" decreases from {} m to {} m, expected increasing arc lengths",
        short_number(*.before, 6),
        short_number(*.after, 6)
    )]
    Falling {
        /// A position \[m\].
        before: f64,
        /// The next \[m\].
        after: f64,
    },
    /// A table with an empty interval.
    #[error("\"at\" has only the position {} m, expected an interval", short_number(*.position, 6))]
    OnePosition {
        /// The position \[m\].
        position: f64,
    },
    /// A position beyond the line.
    #[error(
        "\"at\" has {} m, expected 0 to {} m, the length of the line",
        short_number(*.found, 6),
        short_number(*.length, 6)
    )]
    Beyond {
        /// The position \[m\].
        found: f64,
        /// Length of the line \[m\].
        length: f64,
    },
    /// A load that is constant and released.
    #[error("the load has \"release\" and \"constant\", expected one of them")]
    ReleasedAndConstant,
    /// A load of the start without an equilibrium at the start.
    #[error(
        "\"release\" is for a run in time that starts from an equilibrium, which the file does not \
         have"
    )]
    IdleRelease,
    /// Gravity across the axis of a rotating model.
    #[error(
        "gravity has {} m/s^2 across the axis of rotation, and the model turns at {} rpm: \
         it rotates relative to the model, so that there is no steady equilibrium",
        short_number(*.across, 6),
        short_number(*.rpm, 6)
    )]
    GravityGoesRound {
        /// The part across the axis \[m/s^2\].
        across: f64,
        /// The highest speed \[rpm\].
        rpm: f64,
    },
}

impl Explain for LoadProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::UnknownLine { name, known, .. } => {
                return Some(match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("known: {}", known.join(", ")),
                });
            }
            Self::NothingImposed => {
                "name the held components, for example displacement = { x = 0, z = 0 }"
            }
            Self::Clamped { .. } => {
                "remove the [[clamp]]: [[imposed]] holds the components that it names"
            }
            Self::ImposedTwice { .. } => "put all components of the motion into one [[imposed]]",
            Self::GravityGoesRound { .. } => {
                "give gravity along the axis, or analyze speed 0, at one azimuth after the other, \
                 or the motion in time, in a file without [modes], [static], [buckling] and [trim] at \
                 a speed: [transient] with start = \"rotating\" contains the response to gravity"
            }
            Self::ReleasedAndConstant => {
                "a released load acts in the equilibrium of the start and never later"
            }
            Self::IdleRelease => {
                "add [transient] with start = \"equilibrium\", or remove \"release\""
            }
            Self::OnePosition { .. } => "a load at one position is a [[load]] at a node",
            Self::Degree { .. } => "give a table: \"at\" with a row for each position",
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
