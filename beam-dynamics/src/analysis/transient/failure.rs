//! Why a run in time ended before its last instant, in words.

use shared_geom::error::Explain;

use super::change::StartChange;
use crate::analysis::steady::{NoEquilibrium, rpm};
use crate::assembly::massless::MasslessNode;
use crate::assembly::redundancy::Redundant;
use crate::elements::PlaceJump;
use crate::integrator::StepFailure;
use crate::model::Name;

mod step;

pub use step::StepTrouble;
pub(super) use step::quoted;

/// A number as it was given, without the digits that round-off adds.
fn short(value: f64) -> f64 {
    format!("{value:.9e}").parse().unwrap_or(value)
}

/// Remedy where scalars have no start.
const UNDETERMINED: &str = "look for unknowns that no equation determines, as an output \
     that is its own input, a system that integrates and is to settle (give it a \"start\"), a \
     loop of voltages, and for laws without a value at the start";

/// Why a run in time ended before its last instant.
#[derive(Debug, Clone, thiserror::Error)]
pub enum TransientFailure {
    /// A node can move, although nothing says how.
    #[error(transparent)]
    Massless(#[from] MasslessNode),
    /// Constraints that follow from others.
    #[error("redundant constraints: {}", in_words(.0))]
    Redundant(Vec<Redundant>),
    /// Constraints that follow from others at the start only.
    #[error(
        "singular position: the mechanism starts where it is locked or can go two ways; there \
         only, {0}"
    )]
    SingularPosition(String),
    /// A constraint does not follow from the others any more.
    #[error(
        "at {time} s {constraint} at the start, but not any more: together they are off by \
         {value:.3e} {unit}"
    )]
    Broken {
        /// The constraint and what it followed from, in words.
        constraint: String,
        /// When [s].
        time: f64,
        /// What it is off by [unit of the constraint].
        value: f64,
        /// The unit.
        unit: String,
    },
    /// Constraints that contradict others.
    #[error("contradicting constraints, from {time} s on: {constraints}")]
    Contradicting {
        /// The constraints, and what they contradict, in words.
        constraints: String,
        /// When they begin to [s].
        time: f64,
    },
    /// No equilibrium to start from.
    #[error("start: {0}")]
    Equilibrium(#[from] Box<NoEquilibrium>),
    /// No places fulfill the constraints.
    #[error(
        "start: no places of the nodes were found that fulfill the constraints; at the nearest \
         found the worst is {constraint}, off by {value:.3e} {}",
        .constraint.unit
    )]
    Places {
        /// The worst constraint.
        constraint: Name,
        /// What it is off by [unit of the constraint].
        value: f64,
        /// Whether the constraints lose rank at the given places.
        is_singular: bool,
    },
    /// A driven rotation is held where its constraints are fulfilled too.
    #[error("at {time} s a driven rotation is held half a turn off: {constraint}")]
    TurnedOver {
        /// A constraint of the joint in words.
        constraint: String,
        /// When [s].
        time: f64,
    },
    /// The angle of a spring has passed half a turn, that of a hinge from its relaxed one.
    #[error(
        "at {time} s the spring \"{spring}\" has turned by half a turn: its moment would jump to \
         the other side"
    )]
    Wound {
        /// The spring or hinge.
        spring: String,
        /// When [s].
        time: f64,
    },
    /// No velocities fulfill the constraints.
    #[error(
        "start: no velocities of the nodes fulfill the constraints; worst: {constraint}, off by {value:.3e} {}{}",
        .constraint.unit,
        if .constraint.unit.ends_with("/s") { "" } else { "/s" }
    )]
    Velocities {
        /// The worst constraint.
        constraint: Name,
        /// What it is off by [unit of the constraint/s].
        value: f64,
    },
    /// No values of the scalar unknowns agree with the motion.
    #[error(
        "start: no values of the scalar unknowns fulfill their equations at the given motion; \
         the worst is {0}"
    )]
    Scalars(Name),
    /// A velocity is driven at which the model does not turn as a whole.
    #[error(
        "start: the model does not turn as a whole at {}: \"{joint}\" drives a velocity that is \
         off by {off:.3e} rad/s or m/s",
        rpm(*.speed)
    )]
    DrivenOtherwise {
        /// The joint.
        joint: String,
        /// What its velocity is off by [rad/s or m/s].
        off: f64,
        /// The speed of rotation [rad/s].
        speed: f64,
    },
    /// A part of a model that is to turn as a whole is held, or driven otherwise.
    #[error("start: the model does not go on to turn as a whole: {change}")]
    Held {
        /// The largest change that the constraints ask for.
        change: StartChange,
    },
    /// A drive jumps in what it holds in place.
    #[error(
        "the drive of \"{joint}\" jumps at {time} s: its {} from {} to {} {}",
        .jump.what, short(.jump.from), short(.jump.to), .jump.unit
    )]
    Jump {
        /// The joint.
        joint: String,
        /// What jumps, from where to where.
        jump: PlaceJump,
        /// When [s].
        time: f64,
    },
    /// A dummy step could not be made.
    #[error("start: dummy steps: {0}")]
    Dummy(Box<StepFailure>),
    /// A step could not be made.
    #[error("{0}")]
    Step(Box<StepTrouble>),
    /// A snapshot of another model.
    #[error("the run cannot be continued: {reason}")]
    Resume {
        /// What does not fit, in words.
        reason: String,
    },
    /// The recorder took no more.
    #[error("output ended the run at {time} s")]
    Recorder {
        /// Time reached [s].
        time: f64,
    },
}

impl TransientFailure {
    /// Names of the joints that it is about, each once, where it tells of several.
    pub fn joints(&self) -> Vec<&str> {
        if let Self::Jump { joint, .. } = self {
            return vec![joint];
        }
        let Self::Redundant(found) = self else {
            return Vec::new();
        };
        let mut names = Vec::new();
        for found in found {
            let all = std::iter::once(&found.joint).chain(&found.from);
            for name in all.map(String::as_str) {
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        }
        names
    }

    /// What to do about it.
    pub fn remedy(&self) -> String {
        let fixed = match self {
            Self::Step(trouble) => return trouble.remedy(),
            Self::Dummy(failure) => return failure.reason.remedies().join("; "),
            Self::Massless(node) => return node.help().unwrap_or_default(),
            Self::Redundant(found) => {
                return found.first().and_then(Explain::help).unwrap_or_default();
            }
            Self::Equilibrium(_) => {
                "hold what is free, or take away the load that nothing can carry"
            }
            Self::Places {
                is_singular: true, ..
            } => {
                "the given places may be a singular position, such as links in line, from where \
                 no direction leads on: start a little beside it; else look for lengths that \
                 cannot meet and for drives that start elsewhere"
            }
            Self::Places { .. } => {
                "look for lengths that cannot meet and for drives that start elsewhere, or place \
                 the nodes nearer to where they fit"
            }
            Self::TurnedOver { .. } => {
                "let the drive start nearer to the attitude in which the nodes are given, or take \
                 shorter steps"
            }
            Self::Wound { .. } => {
                "hold the part from turning so far, by a stiffer spring or a stop, or drive a \
                 relaxed angle no faster than the part follows; the angle of a spring is known \
                 from half a turn back to half a turn ahead: that of a hinge from its relaxed \
                 angle, that of a [[spring]] from its undeformed state"
            }
            Self::Velocities { .. } => {
                "look for joints that say the same twice and for a position at which the \
                 mechanism is locked"
            }
            Self::Scalars(_) => UNDETERMINED,
            Self::SingularPosition(_) => "start the mechanism a little beside this position",
            Self::Broken { .. } => {
                "take joints that hold each direction once, and leave out redundant = \"remove\""
            }
            Self::Contradicting { .. } => "drive one of them only, or both alike",
            Self::DrivenOtherwise { .. } => {
                "drive the joint at the speed of the start, with its sign, or give the start \
                 another \"speed\"; joints inside the model have the speed zero there"
            }
            Self::Held { .. } => {
                "drive what holds the model at the speed of the start, for instance by a joint \
                 whose angle is a ramp"
            }
            Self::Jump { .. } => {
                "no motion follows a jump of a place: let the drive get there by a ramp, which \
                 may be steep, or drive the speed, which may jump"
            }
            Self::Resume { .. } => "continue with the model and the file that were run before",
            Self::Recorder { .. } => "look at what output says",
        };
        fixed.to_owned()
    }
}

/// Redundant constraints in words, the first few of them.
fn in_words(found: &[Redundant]) -> String {
    let told: Vec<_> = found.iter().map(ToString::to_string).collect();
    listed(&told)
}

/// The first few of many.
pub(super) fn listed(found: &[String]) -> String {
    const TOLD: usize = 10;
    let more = match found.len().saturating_sub(TOLD) {
        0 => String::new(),
        count => format!("; and {count} more"),
    };
    let told = &found[..found.len().min(TOLD)];
    format!("{}{more}", told.join("; "))
}
