//! Reasons why no periodic motion was found.

use shared_geom::error::counted;

use crate::analysis::transient::{TransientFailure, in_wake};
use crate::case::TrimControl;
use crate::integrator::StepFailure;
use crate::result::Stall;

/// Reason why no periodic motion was found.
#[derive(Debug, thiserror::Error)]
pub enum PeriodicFailure {
    /// The start.
    #[error(transparent)]
    Start(#[from] TransientFailure),
    /// A step of a period.
    #[error("{0}")]
    Step(#[from] StepFailure),
    /// Elements with memory.
    #[error(
        "\"{element}\" stores samples: the motion over a period is not differentiated with \
         respect to them"
    )]
    Memory {
        /// Name of an element.
        element: String,
    },
    /// The march did not settle.
    #[error(
        "the motion does not repeat after {}: {worst}; it changes by a factor of {ratio:.5} in a \
         period",
        counted(*periods, "period")
    )]
    NotSettled {
        /// Number of periods.
        periods: usize,
        /// The unknown with the largest change, as text.
        worst: String,
        /// Ratio of the changes of successive periods [-].
        ratio: f64,
        /// Periods still needed, if the change decays.
        left: Option<f64>,
    },
    /// Newton's method did not converge.
    #[error("the motion does not repeat after {}: {worst}", counted(*iterations, "iteration"))]
    NotConverged {
        /// Number of iterations.
        iterations: usize,
        /// The unknown with the largest change, as text.
        worst: String,
    },
    /// No motion between the last values of the controls and the targets.
    #[error("{worst}, and there is no motion nearer to the targets than with {controls}: {step}")]
    Unreached {
        /// The target that is not met, as text.
        worst: String,
        /// The last controls with their values, as text.
        controls: String,
        /// The step that fails beyond them.
        step: Box<StepFailure>,
    },
    /// Targets that grow from the means with the first guesses are met up to a part of the way only.
    #[error("{beyond}{way}, with {controls}{stall}; the search for all targets at once: {first}")]
    Limited {
        /// The failure of the search without growing targets.
        first: Box<PeriodicFailure>,
        /// The target that is out of reach as text, perhaps empty.
        beyond: String,
        /// The end of the way with the last values of the targets, as text.
        way: String,
        /// The controls with their values there, as text.
        controls: String,
        /// Stall there as text, perhaps empty.
        stall: String,
    },
    /// The equations of the shooting are singular.
    #[error("the equations of the periodic motion are singular: {reason}")]
    Singular {
        /// The free motion.
        reason: String,
    },
    /// The controls do not determine the targets.
    #[error("the equations of the periodic motion are singular: {reason}")]
    Idle {
        /// The controls and targets.
        reason: String,
    },
    /// The matrix of a step is singular.
    #[error("the matrix of a step is singular at the periodic motion")]
    SingularStep,
    /// A control is at a bound.
    #[error("the control \"{control}\" reaches its bound {bound}, and {worst}")]
    Bound {
        /// Name of the control.
        control: String,
        /// The bound \[unit of the control\].
        bound: f64,
        /// The target that is not met, as text.
        worst: String,
    },
    /// Controls without targets.
    #[error(
        "there are {} and {}, expected as many targets as controls",
        counted(*controls, "control"),
        counted(*targets, "target")
    )]
    Counts {
        /// Number of controls.
        controls: usize,
        /// Number of targets.
        targets: usize,
    },
    /// A control that the model does not have.
    #[error("the model has no state of \"{label}\"")]
    NoState {
        /// Label of the element.
        label: String,
    },
    /// The recorder ended the run.
    #[error("the results could not be written")]
    Recorder,
    /// The multipliers were not found.
    #[error("the multipliers were not found: a product with the linearized period is not finite")]
    NoMultipliers,
}

/// Remedies of a failed step of a period, whose steps have one length and damp without a parameter.
fn of_step(failure: &StepFailure) -> String {
    let own = "use more \"steps\" in the period; begin nearer to the periodic motion, with a larger \
               \"settle\": these periods are marched with shorter steps if needed; \
               let joints begin without an angle, which deforms elastic parts that are not built with it";
    let others = failure.reason.remedies().iter();
    let others = others.filter(|remedy| {
        let idle = ["shorter steps", "asymptotic radius"];
        !idle.iter().any(|word| remedy.contains(word))
    });
    let wake = in_wake(failure).unwrap_or_default().iter();
    let all = wake.chain(std::iter::once(&own)).chain(others);
    all.copied().collect::<Vec<_>>().join("; ")
}

impl PeriodicFailure {
    /// The failure of a control at a bound, given the worst equation as text.
    pub(super) fn bound(control: &TrimControl, bound: f64, worst: String) -> Self {
        let control = control.name.clone();
        Self::Bound {
            control,
            bound,
            worst,
        }
    }

    /// The failure with stall at the last motion of growing targets.
    pub(super) fn with_stall(mut self, found: Option<Stall>) -> Self {
        if let (Self::Limited { stall, .. }, Some(found)) = (&mut self, found) {
            *stall = format!("; there {}", found.text("over the period"));
        }
        self
    }

    /// The likeliest remedy.
    pub fn remedy(&self) -> String {
        let text = match self {
            Self::Start(failure) => return failure.remedy(),
            Self::Step(failure) => return of_step(failure),
            Self::Memory { .. } => {
                "use method = \"march\" without [periodic.floquet], or replace the sampled system \
                 by a continuous one"
            }
            Self::NotSettled {
                left: Some(left), ..
            } => {
                return format!(
                    "about {left:.0} more periods are needed: use method = \"shooting\", or a \
                     larger \"periods\""
                );
            }
            Self::NotSettled { left: None, .. } => {
                "the motion does not settle: use method = \"shooting\", which also finds unstable \
                 periodic motion, and look at the multipliers; check that the period is a multiple \
                 of all periods of drives and rotors"
            }
            Self::NotConverged { .. } => {
                "use more \"steps\" in the period, or begin nearer to the periodic motion with a larger \
                 \"settle\"; check that the period is a multiple of all periods of drives and rotors"
            }
            Self::Unreached { .. } | Self::Limited { .. } => {
                "require values of the targets that the model can reach (stall limits thrust), or give \
                 first guesses nearer to them"
            }
            Self::Singular { .. } => {
                "a motion that nothing resists has no definite position: hold it, give it a spring, \
                 or prescribe the speed of the shaft"
            }
            Self::Idle { .. } => {
                "replace a control that does not act, or a target that no control reaches"
            }
            Self::Bound { .. } => {
                "move the bound, require another value of the target, or replace the control"
            }
            Self::SingularStep | Self::NoMultipliers => "use more \"steps\"",
            Self::Counts { .. } => "give each control one target",
            Self::NoState { .. } => "name a control or target of this model",
            Self::Recorder => "check the disk and the folder of the results",
        };
        text.to_owned()
    }
}
