//! Problems of a joint.

use shared_geom::error::Explain;

/// A problem of a `[[joint]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum JointProblem {
    /// Rotation prescribed twice.
    #[error("the joint has \"angle\" and \"speed\", expected one of them")]
    AngleAndSpeed,
    /// A spin joint without an angle or speed.
    #[error("the joint has neither \"angle\" nor \"speed\", expected one of them")]
    NoSpin,
    /// A joint that holds nothing.
    #[error("the joint holds nothing, expected at least one component of {keys}")]
    NothingHeld {
        /// Keys of the held components.
        keys: &'static str,
    },
    /// A freedom that is locked and driven.
    #[error("\"{freedom}\" is locked and driven, expected one of them")]
    LockedAndDriven {
        /// The freedom.
        freedom: &'static str,
    },
    /// Axes without direction.
    #[error("an axis in \"axes\" has no direction: its length is zero")]
    NoDirection,
    /// Parallel axes of a universal joint.
    #[error("the two axes of the universal joint are parallel, expected axes at an angle")]
    ParallelAxes,
    /// A distance of zero.
    #[error("the points of joint \"{joint}\" coincide, expected a distance between them")]
    NoDistance {
        /// Name of the joint.
        joint: String,
    },
}

impl Explain for JointProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::NoSpin => "give the angular velocity, for example speed = \"30 rad/s\"",
            Self::NothingHeld { .. } => {
                "name the held components, for example { x = 0, z = \"= 0.1 * sin(t)\" }"
            }
            Self::ParallelAxes => {
                "axes = [[1, 0, 0], [0, 1, 0]]: the first on the first end, the second on the second"
            }
            Self::NoDistance { .. } => {
                "a \"spherical\" joint holds points together; or give other points: \"at\", \"from\""
            }
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
