//! Problems of rotors with the runs and periods of a file.

use shared_geom::error::{Explain, counted};

use crate::input::short_number;

/// A problem of a rotor in a run.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RotorRunProblem {
    /// A drive without a state of steady rotation.
    #[error(
        "rotor \"{name}\" has \"{key}\", which has no state of steady rotation: the azimuth may have any value"
    )]
    Unsteady {
        /// Name of the rotor.
        name: String,
        /// The key.
        key: &'static str,
    },
    /// A period in which the rotor does not turn a whole number of times.
    #[error(
        "rotor \"{name}\" turns {} times in the period of {} s of [periodic], expected a whole number \
         of turns",
        short_number(*.turns, 9),
        short_number(*.period, 9)
    )]
    Period {
        /// Name of the rotor.
        name: String,
        /// Its turns [-].
        turns: f64,
        /// The period [s].
        period: f64,
    },
    /// A start that turns the whole model, with a rotor on a part that stands.
    #[error(
        "\"start\" is \"rotating\", which turns the whole model, but rotor \"{name}\" turns on node \"{carrier}\", \
         which stands"
    )]
    CarriedStart {
        /// Name of the rotor.
        name: String,
        /// Node of the shaft.
        carrier: String,
    },
    /// Averaged coefficients of too few blades.
    #[error(
        "\"by\" is \"averaged\", but {subject} has {}, expected at least three",
        counted(*.blades, "blade")
    )]
    FewBlades {
        /// The rotor, or the model, as text.
        subject: String,
        /// Its number of blades.
        blades: usize,
    },
    /// A run whose first instant is between whole turns.
    #[error(
        "rotor \"{name}\" has turned by {} deg at the first instant, \"from\" of {card}, {} s, but the \
         model of the file is the one at azimuth zero",
        short_number(*.degrees, 6),
        short_number(*.from, 6)
    )]
    FirstInstant {
        /// Name of the rotor.
        name: String,
        /// The card of the run.
        card: &'static str,
        /// Its first instant \[s\].
        from: f64,
        /// Angle beyond whole turns \[deg\].
        degrees: f64,
        /// Time of a turn \[s\].
        turn: f64,
    },
}

impl Explain for RotorRunProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::Unsteady { .. } => {
                "remove it, so that the engine has the constant \"speed\" of the rotor, or compute the \
                 motion in time from start = \"given\""
            }
            Self::Period { .. } => {
                "give [periodic] the \"speed\" of the rotor with the same digits, or the common period of all rotors"
            }
            Self::CarriedStart { .. } => {
                "write start = \"given\", with which the rotor begins with its \"speed\" and its support at rest"
            }
            Self::FewBlades { .. } => {
                "write by = \"Floquet\": the coefficients of fewer blades are periodic, and their mean is no \
                 model of them"
            }
            Self::FirstInstant { turn, .. } => {
                return Some(format!(
                    "give \"from\" a whole number of turns, multiples of {} s; \"azimuth\" of the rotor \
                     places its blades",
                    short_number(*turn, 9)
                ));
            }
        };
        Some(fixed.to_owned())
    }
}
