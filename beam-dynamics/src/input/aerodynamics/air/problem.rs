//! Problems of the wind of `[air]`.

use shared_geom::error::Explain;

use crate::input::short_number;

/// A problem of `[air]` or of a table in it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AirProblem {
    /// A key that another one needs.
    #[error("\"{key}\" is missing, which {user} needs")]
    Missing {
        /// The missing key.
        key: &'static str,
        /// The key or table that needs it, as text.
        user: &'static str,
    },
    /// A key without effect.
    #[error("\"{key}\" has no effect: {reason}")]
    Useless {
        /// The key.
        key: &'static str,
        /// The reason, as text.
        reason: &'static str,
    },
    /// A wrong value that depends on other keys.
    #[error("\"{key}\" is {found}, expected {expected}")]
    Value {
        /// The key.
        key: &'static str,
        /// The value found.
        found: String,
        /// The value expected.
        expected: String,
        /// The remedy.
        help: &'static str,
    },
    /// A wind that a rotating model does not see as steady.
    #[error(
        "the wind has {cause}, and equilibria, modes or critical loads are requested at up to {} rpm: \
         expected a constant wind along the axis of rotation, the only steady one for a rotor",
        short_number(*.rpm, 6)
    )]
    GoesRound {
        /// The part that varies, as text.
        cause: String,
        /// The highest speed \[rpm\].
        rpm: f64,
    },
}

impl Explain for AirProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Missing { key, .. } => format!("add \"{key}\""),
            Self::Useless { key, .. } => format!("remove \"{key}\""),
            Self::Value { help, .. } => (*help).to_owned(),
            Self::GoesRound { .. } => {
                "give a constant wind along the axis, analyze speed 0 at one \
                 azimuth after the other, or the motion in time: [transient]"
                    .to_owned()
            }
        })
    }
}
