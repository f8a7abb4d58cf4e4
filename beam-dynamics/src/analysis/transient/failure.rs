//! Reasons for a run in time that ended before its last instant, as text.

use shared_geom::error::Explain;
use shared_geom::units::rounded;

use super::change::StartChange;
use crate::analysis::steady::{NoEquilibrium, rpm};
use crate::assembly::massless::MasslessNode;
use crate::assembly::redundancy::Redundant;
use crate::elements::PositionJump;
use crate::integrator::StepFailure;
use crate::model::Name;

mod step;

pub use step::StepTrouble;
pub(super) use step::quoted;

/// Remedy if scalars have no start.
const UNDETERMINED: &str = "look for unknowns that no equation determines, as an output \
     that is its own input, an integrating system that should settle (give it a \"start\"), a \
     loop of voltages, and for laws without a value at the start";

/// Reason for a run in time that ended before its last instant.
#[derive(Debug, Clone, thiserror::Error)]
pub enum TransientFailure {
    /// A node with a motion that no mass, stiffness or damping determines.
    #[error(transparent)]
    Massless(#[from] MasslessNode),
    /// Redundant constraints.
    #[error("redundant constraints: {}", in_words(.0))]
    Redundant(Vec<Redundant>),
    /// Constraints that are redundant at the start only.
    #[error(
        "singular position: the mechanism starts where it is locked or can go two ways; there \
         only, {0}"
    )]
    SingularPosition(String),
    /// A redundant constraint is no longer redundant.
    #[error(
        "at {} s {constraint} at the start, but no longer: their violation is \
         {value:.3e} {unit}",
        rounded(*.time)
    )]
    Broken {
        /// The constraint and the constraints from which it followed, as text.
        constraint: String,
        /// Time [s].
        time: f64,
        /// Its violation [unit of the constraint].
        value: f64,
        /// The unit.
        unit: String,
    },
    /// Constraints that contradict others.
    #[error("contradicting constraints, from {} s on: {constraints}", rounded(*.time))]
    Contradicting {
        /// The constraints, and the contradicted ones, as text.
        constraints: String,
        /// Beginning of the contradiction [s].
        time: f64,
    },
    /// No equilibrium to start from.
    #[error("start: {0}")]
    Equilibrium(#[from] Box<NoEquilibrium>),
    /// No mode whose shape the start has.
    #[error("start: \"shape\" has no mode: {reason}")]
    NoShape {
        /// The reason, as text.
        reason: String,
    },
    /// No positions fulfill the constraints.
    #[error(
        "start: no positions of the nodes were found that fulfill the constraints; the worst at \
         the nearest positions found is {constraint}, off by {value:.3e} {}",
        .constraint.unit
    )]
    Positions {
        /// The worst constraint.
        constraint: Name,
        /// Its violation [unit of the constraint].
        value: f64,
        /// Whether the constraints lose rank at the given positions.
        is_singular: bool,
    },
    /// A driven rotation settled half a turn away, where its constraints are fulfilled too.
    #[error(
        "at {} s a driven rotation settled 180 deg away from its prescribed value: {constraint}",
        rounded(*.time)
    )]
    TurnedOver {
        /// A constraint of the joint, as text.
        constraint: String,
        /// Time [s].
        time: f64,
    },
    /// The angle of a spring has passed half a turn, for a hinge relative to its relaxed angle.
    #[error(
        "at {} s the spring \"{spring}\" has turned by half a turn: its moment would jump \
         and change its sign",
        rounded(*.time)
    )]
    Wound {
        /// The spring or hinge.
        spring: String,
        /// Time [s].
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
        /// Its violation [unit of the constraint/s].
        value: f64,
    },
    /// No values of the scalar unknowns agree with the motion.
    #[error(
        "start: no values of the scalar unknowns fulfill their equations at the given motion; \
         the worst is {0}"
    )]
    Scalars(Name),
    /// A driven velocity with which the model does not turn as a whole.
    #[error(
        "start: the model does not turn as a whole at {}: \"{joint}\" drives a velocity that is \
         off by {off:.3e} rad/s or m/s",
        rpm(*.speed)
    )]
    DrivenOtherwise {
        /// The joint.
        joint: String,
        /// Difference of its velocity [rad/s or m/s].
        off: f64,
        /// The speed of rotation [rad/s].
        speed: f64,
    },
    /// A part of a model that should turn as a whole is held, or driven otherwise.
    #[error("start: the model does not continue to turn as a whole: {change}")]
    Held {
        /// The largest change required by the constraints.
        change: StartChange,
    },
    /// A driven position jumps.
    #[error(
        "the drive of \"{joint}\" jumps at {} s: its {} from {} to {} {}",
        rounded(*.time), .jump.what, rounded(.jump.from), rounded(.jump.to), .jump.unit
    )]
    Jump {
        /// The joint.
        joint: String,
        /// The jumping quantity, with its values before and after.
        jump: PositionJump,
        /// Time [s].
        time: f64,
    },
    /// A dummy step failed.
    #[error("start: dummy steps: {0}")]
    Dummy(Box<StepFailure>),
    /// A step failed.
    #[error("{0}")]
    Step(Box<StepTrouble>),
    /// A snapshot of another model.
    #[error("the run cannot be continued: {reason}")]
    Resume {
        /// The mismatch, as text.
        reason: String,
    },
    /// The recorder ended the run.
    #[error("output ended the run at {} s", rounded(*.time))]
    Recorder {
        /// Time reached [s].
        time: f64,
    },
}

/// Remedy for given positions at which the correction is singular.
const SINGULAR_START: &str = "the given positions may be singular, such as links in line, where no \
    direction reduces the violation: start slightly away from them; else look for lengths that \
    cannot meet and for drives that start elsewhere";

impl TransientFailure {
    /// Names of the joints concerned, each once, if there are several.
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

    /// The remedy.
    pub fn remedy(&self) -> String {
        let fixed = match self {
            Self::Step(trouble) => return trouble.remedy(),
            Self::Dummy(failure) => return failure.reason.remedies().join("; "),
            Self::Massless(node) => return node.help().unwrap_or_default(),
            Self::Redundant(found) => {
                return found.first().and_then(Explain::help).unwrap_or_default();
            }
            Self::Equilibrium(_) => {
                "constrain the free motion, or remove the load that nothing carries"
            }
            Self::NoShape { .. } => {
                "see the modes with `beam-dynamics modes`, and give \"mode\" a number of its table"
            }
            Self::Positions {
                is_singular: true, ..
            } => SINGULAR_START,
            Self::Positions { .. } => {
                "look for lengths that cannot meet and for drives that start elsewhere, or place \
                 the nodes nearer to matching positions"
            }
            Self::TurnedOver { .. } => {
                "let the drive start nearer to the attitude in which the nodes are given, or take \
                 shorter steps"
            }
            Self::Wound { .. } => {
                "limit the rotation of the part by a stiffer spring or a stop, or drive a \
                 relaxed angle no faster than the part follows; the angle of a spring is known \
                 within half a turn in both directions: for a hinge from its relaxed angle, or \
                 from half of it if it is constant and above 150 degrees; for a [[spring]] from its \
                 undeformed state"
            }
            Self::Velocities { .. } => {
                "look for redundant joints and for a position at which the mechanism is \
                 locked"
            }
            Self::Scalars(_) => UNDETERMINED,
            Self::SingularPosition(_) => "start the mechanism slightly away from this position",
            Self::Broken { .. } => {
                "use joints that constrain each direction once, and remove redundant = \"remove\""
            }
            Self::Contradicting { .. } => "drive one of them only, or both alike",
            Self::DrivenOtherwise { .. } => {
                "drive the joint at the speed of the start, with its sign, or give the start \
                 another \"speed\"; joints inside the model have the speed zero there"
            }
            Self::Held { .. } => {
                "drive the supports of the model at the speed of the start, for instance by a \
                 joint whose angle is a ramp"
            }
            Self::Jump { .. } => {
                "no motion can follow a jump of a position: use a ramp, which may be steep, or \
                 drive the speed, which may jump"
            }
            Self::Resume { .. } => "continue with the model and the file that were run before",
            Self::Recorder { .. } => "see the message of the output",
        };
        fixed.to_owned()
    }
}

/// Redundant constraints as text, the first few of them.
fn in_words(found: &[Redundant]) -> String {
    let reported: Vec<_> = found.iter().map(ToString::to_string).collect();
    listed(&reported)
}

/// The first few of many.
pub(super) fn listed(found: &[String]) -> String {
    const MOST_REPORTED: usize = 10;
    let more = match found.len().saturating_sub(MOST_REPORTED) {
        0 => String::new(),
        count => format!("; and {count} more"),
    };
    let reported = &found[..found.len().min(MOST_REPORTED)];
    format!("{}{more}", reported.join("; "))
}
