//! Why a run in time ended before its last instant, in words.

use std::fmt::Write;

use crate::analysis::steady::NoEquilibrium;
use crate::assembly::System;
use crate::assembly::massless::MasslessNode;
use crate::assembly::redundancy::Redundant;
use crate::case::Model;
use crate::integrator::{Reason, StepFailure};
use crate::model::State;
use crate::solver::Iteration;
use shared_geom::error::Explain;

use super::redundant::in_words;
use super::start::StartChange;

/// Rotation of a node in a step above which a formula is out of its depth \[rad\].
const LARGE_TURN: f64 = 0.5;
/// A local error, in sizes of the model and radians, that no step reaches.
const ROUND_OFF: f64 = 1e-12;
/// Iterations of the history that are told.
const TOLD: usize = 8;

/// Why a run in time ended before its last instant.
#[derive(Debug, Clone, thiserror::Error)]
pub enum TransientFailure {
    /// The equations cannot be solved for structural reasons.
    #[error("the equations of the model have no solution: some unknown is in none of them")]
    Structure,
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
        unit: &'static str,
    },
    /// Constraints that contradict others.
    #[error("contradicting constraints: {0}")]
    Contradicting(String),
    /// No equilibrium to start from.
    #[error("start: {0}")]
    Equilibrium(#[from] Box<NoEquilibrium>),
    /// No places fulfill the constraints.
    #[error(
        "start: no places of the nodes fulfill the constraints; worst: {constraint}, off by {value:.3e} {unit}"
    )]
    Places {
        /// The worst constraint in words.
        constraint: String,
        /// What it is off by [unit of the constraint].
        value: f64,
        /// The unit.
        unit: &'static str,
    },
    /// A driven rotation is held where its constraints are fulfilled too.
    #[error("at {time} s a driven rotation is held half a turn off: {constraint}")]
    TurnedOver {
        /// A constraint of the joint in words.
        constraint: String,
        /// When [s].
        time: f64,
    },
    /// No velocities fulfill the constraints.
    #[error(
        "start: no velocities of the nodes fulfill the constraints; worst: {constraint}, off by {value:.3e} {unit}"
    )]
    Velocities {
        /// The worst constraint in words.
        constraint: String,
        /// What it is off by [unit of the constraint/s].
        value: f64,
        /// The unit.
        unit: &'static str,
    },
    /// A part of a model that is to turn as a whole is held, or driven otherwise.
    #[error("start: the model does not go on to turn as a whole: {change}")]
    Held {
        /// The largest change that the constraints ask for.
        change: StartChange,
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
            Self::Structure | Self::Equilibrium(_) => {
                "hold what is free, or take away the load that nothing can carry"
            }
            Self::Places { .. } => {
                "look for lengths that cannot meet and for drives that start elsewhere, or place \
                 the nodes nearer to where they fit"
            }
            Self::TurnedOver { .. } => {
                "let the drive start nearer to the attitude in which the nodes are given, or take \
                 shorter steps"
            }
            Self::Velocities { .. } => {
                "look for joints that say the same twice and for a position at which the \
                 mechanism is locked"
            }
            Self::SingularPosition(_) => "start the mechanism a little beside this position",
            Self::Broken { .. } => {
                "take joints that hold each direction once, and leave out redundant = \"remove\""
            }
            Self::Contradicting(_) => "drive one of them only, or both alike",
            Self::Held { .. } => {
                "drive what holds the model at the speed of the start, for instance by a joint \
                 whose angle is a ramp"
            }
            Self::Resume { .. } => "continue with the model and the file that were run before",
            Self::Recorder { .. } => "look at what output says",
        };
        fixed.to_owned()
    }
}

/// A step that could not be made, and what it may come from.
#[derive(Debug, Clone, PartialEq)]
pub struct StepTrouble {
    /// The failure of the integrator.
    pub failure: StepFailure,
    /// The likely cause in words.
    pub cause: String,
}

impl std::fmt::Display for StepTrouble {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}; {}", self.failure, self.cause)?;
        if self.failure.local_error.is_some() {
            // Its iterations converged.
            return Ok(());
        }
        let told = history(&self.failure.history);
        match told.is_empty() {
            true => Ok(()),
            false => write!(f, "; residual and correction of its iterations: {told}"),
        }
    }
}

impl std::error::Error for StepTrouble {}

impl StepTrouble {
    fn remedy(&self) -> String {
        self.failure.reason.remedies().join("; ")
    }
}

/// The iterations in short: relative residual and size of the correction.
fn history(iterations: &[Iteration]) -> String {
    let mut text = String::new();
    for (i, iteration) in iterations.iter().take(TOLD).enumerate() {
        let comma = if i > 0 { ", " } else { "" };
        let (residual, correction) = (iteration.worst.relative, iteration.correction);
        // Writing to a string does not fail.
        let _ = write!(text, "{comma}{residual:.1e} {correction:.1e}");
    }
    if iterations.len() > TOLD {
        let _ = write!(text, " and {} more", iterations.len() - TOLD);
    }
    text
}

/// The failure of a step with what it likely comes from, as the latest state shows it;
/// `step` is the length that was wanted \[s\].
pub(super) fn trouble(
    failure: StepFailure,
    model: &Model,
    state: &State,
    step: f64,
) -> StepTrouble {
    let cause = cause(&failure, model, state, step);
    StepTrouble { failure, cause }
}

fn cause(failure: &StepFailure, model: &Model, state: &State, step: f64) -> String {
    if failure.reason == Reason::NotFinite {
        return without_value(failure, model);
    }
    let (fastest, turn) = fastest(&model.system, state, step);
    if turn > LARGE_TURN {
        return format!(
            "likely cause: node \"{fastest}\" turns by {turn:.2} rad in a step of {step:.3e} s, \
             which is too long for it"
        );
    }
    match failure.reason {
        Reason::Singular => {
            "likely cause: a mechanism that is locked or can go two ways here, or constraints \
             that say the same"
        }
        Reason::LocalError => match failure.local_error.as_ref() {
            Some(local) if local.tolerance < ROUND_OFF => {
                "likely cause: a local error below what round-off leaves was asked for"
            }
            _ => {
                "likely cause: steps that may not be as short as the motion is fast, or a jump \
                 of a load or of a stiffness that no drive tells"
            }
        },
        _ => {
            "likely cause: a step too long for the fastest motion, or a mechanism near a position \
             where it is locked"
        }
    }
    .to_owned()
}

/// What has no value at the end of a step: a drive that has left its table, or else
/// something that is unknown here.
fn without_value(failure: &StepFailure, model: &Model) -> String {
    let time = failure.time + failure.length;
    let has_left = |[first, last]: [f64; 2]| time < first || time > last;
    let words = |whose: &str, [first, last]: [f64; 2]| {
        format!(
            "likely cause: a drive of {whose} has values from {first} s to {last} s, and the step \
             goes to {time} s"
        )
    };
    let gravity = model.gravity_drive.domain();
    if has_left(gravity) {
        return words("gravity", gravity);
    }
    let mut elements = model.system.elements();
    match elements.find(|element| has_left(element.domain())) {
        Some(element) => words(&format!("\"{}\"", element.label()), element.domain()),
        None => "likely cause: a law, a drive or a load has no value there".to_owned(),
    }
}

/// The node that turns most in a step, and its angle \[rad\].
fn fastest(system: &System, state: &State, step: f64) -> (String, f64) {
    let turns = state.nodes.iter().zip(system.nodes());
    let turns = turns.map(|(motion, node)| (&node.label, step * motion.angular_velocity.norm()));
    let most = turns.max_by(|a, b| a.1.total_cmp(&b.1));
    most.map_or_else(|| (String::new(), 0.0), |(node, turn)| (node.clone(), turn))
}
