//! Problems of the wind: at a point, of a value, of a box that is too small.

use shared_geom::error::Explain;

/// A problem of the wind.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WindProblem {
    /// A time at which a box has no wind.
    #[error(
        "{name}: no turbulence at x = {} m and t = {} s: the box has steps 0 to {last}, requested {}",
        short(*.x),
        short(*.time),
        short(*.step)
    )]
    Time {
        /// The box.
        name: String,
        /// Downwind position of the point [m].
        x: f64,
        /// Time [s].
        time: f64,
        /// The last step of the box.
        last: usize,
        /// The requested step [-].
        step: f64,
    },
    /// A point beside a box.
    #[error(
        "{name}: the point y = {} m, z = {} m is outside the box, y from {} to {} m, z from {} to {} m",
        short(*.y),
        short(*.z),
        short(-*.half),
        short(*.half),
        short(*.bottom),
        short(*.top)
    )]
    Outside {
        /// The box.
        name: String,
        /// Lateral position [m].
        y: f64,
        /// Height above the ground [m].
        z: f64,
        /// Half the width of the box [m].
        half: f64,
        /// Height of its lowest points [m].
        bottom: f64,
        /// Height of its highest points [m].
        top: f64,
    },
    /// A plane that cannot be read any more.
    #[error("{file}: plane {plane} of the box cannot be read: {reason}")]
    Read {
        /// The file.
        file: String,
        /// The plane, from zero.
        plane: usize,
        /// The reason of the system.
        reason: String,
    },
    /// A wrong value.
    #[error("{what}: found {found}, expected {expected}")]
    Value {
        /// The meaning of the value.
        what: String,
        /// The value found.
        found: String,
        /// The values expected.
        expected: String,
        /// The remedy.
        help: String,
    },
}

/// A number with six digits at most, without those that say nothing.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    rounded.to_string()
}

impl WindProblem {
    /// A wrong number.
    pub(super) fn value(what: &str, found: f64, expected: &str, help: &str) -> Self {
        Self::Value {
            what: what.to_owned(),
            found: short(found),
            expected: expected.to_owned(),
            help: help.to_owned(),
        }
    }
}

impl Explain for WindProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Time { .. } => Some(
                "use a longer box, a shorter run, or a box that is made and read as periodic"
                    .to_owned(),
            ),
            Self::Outside { .. } => Some(
                "use a larger box, or extend its outermost values to all points outside".to_owned(),
            ),
            Self::Read { .. } => {
                Some("do not move or change the file of a box during a run".to_owned())
            }
            Self::Value { help, .. } => Some(help.clone()),
        }
    }
}
