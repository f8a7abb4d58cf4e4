//! Likely cause of a failed step, and remedies.
//!
//! Based on the reason, the history of the iteration, the latest accepted state, the times at which
//! drives have values, and the elements without a value at the last trial state.

use rotor_aero::strip::INDUCED_VELOCITY;
use shared_geom::units::rounded;

use crate::analysis::transient::energy::Finding;
use crate::analysis::transient::failure::quoted;
use crate::analysis::transient::multibody::Multibody;
use crate::case::{Model, TransientSettings};
use crate::elements::{Element, Queries};
use crate::integrator::{Jacobians, LocalError, Reason, Scheme, StepFailure, StepLimits, Stepping};
use crate::model::{NodeMotion, State};
use crate::solver::Iteration;

/// Magnitude treated as overflow, in SI units.
const BEYOND: f64 = 1e60;
/// Rotation of a node in a step above which the rotation formula is inaccurate \[rad\].
const LARGE_TURN: f64 = 0.5;
/// Local error, relative to the size of the model and in radians, that no step reaches.
const ROUND_OFF: f64 = 1e-12;
/// Distance from the undeformed position, and displacement in a step, relative to the size of the
/// model, of a motion that has grown beyond it.
const FAR: f64 = 100.0;
const FAST: f64 = 10.0;
/// Part of the wished step below which a step is not treated as too long for the motion.
const CUT: f64 = 1.0 / 500.0;
/// Required step, as a part of the least step, below which a jump is assumed.
const MUCH_SHORTER: f64 = 1e-2;
/// Corrections below this that do not fall are round-off, relative to the size of the model and in
/// radians.
const FLOOR: f64 = 1e-7;
/// Corrections that shrink by less are treated as not falling.
const SHRINKING: f64 = 0.8;
/// Number of iterations from which the history is judged.
const LATEST: usize = 4;

/// A likely cause, and remedies, the most likely first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cause {
    pub words: String,
    pub remedies: Vec<String>,
}

impl Cause {
    fn new(words: impl Into<String>, remedies: &[&str]) -> Self {
        Self {
            words: words.into(),
            remedies: remedies.iter().map(|remedy| (*remedy).to_owned()).collect(),
        }
    }
}

impl From<Finding> for Cause {
    fn from(gained: Finding) -> Self {
        let Finding {
            words,
            cause,
            remedies,
        } = gained;
        Self::new(format!("{words}; {cause}"), &remedies)
    }
}

/// Remedies of a step whose iteration failed at an induced velocity.
pub(in crate::analysis) fn in_wake(failure: &StepFailure) -> Option<&'static [&'static str]> {
    let is_iteration = !matches!(failure.reason, Reason::LocalError | Reason::NotFinite);
    (is_iteration && failure.equation.what.contains(INDUCED_VELOCITY)).then_some(&[
        "give the inflow wake = \"dynamic\", whose velocities cannot jump",
        "or choose another model of the sections, as \"separation_lag\" or \"oye\"",
    ])
}

/// Data of a failed step.
pub(super) struct FailureContext<'a> {
    failure: &'a StepFailure,
    model: &'a Model,
    /// The latest accepted state.
    state: &'a State,
    /// The wished length [s].
    wished: f64,
    settings: &'a TransientSettings,
    newton: StepLimits,
    dae: &'a Multibody<'a>,
    /// Unexplained gain of energy.
    gained: Option<Finding>,
}

impl<'a> FailureContext<'a> {
    pub fn new(
        failure: &'a StepFailure,
        (model, settings): (&'a Model, &'a TransientSettings),
        (dae, gained): (&'a Multibody<'a>, Option<Finding>),
    ) -> Self {
        let wished = match settings.stepping {
            Stepping::Constant { step } => step,
            Stepping::Variable(_) => failure.length,
        };
        Self {
            failure,
            model,
            state: dae.state(),
            wished,
            settings,
            newton: settings.newton,
            dae,
            gained,
        }
    }

    /// The likely cause.
    pub fn cause(&self) -> Cause {
        if self.failure.reason == Reason::Corners {
            return self.corners();
        }
        let is_without_value = self.failure.reason == Reason::NotFinite;
        let beyond_table = || is_without_value.then(|| self.beyond_table()).flatten();
        let without_value = || is_without_value.then(|| self.without_value());
        beyond_table()
            .or_else(|| self.gained.clone().map(Cause::from))
            .or_else(|| self.beyond_numbers())
            .or_else(|| self.grown())
            .or_else(without_value)
            .or_else(|| self.in_stall())
            .or_else(|| self.turned_far())
            .unwrap_or_else(|| match (self.failure.reason, &self.failure.local_error) {
                (Reason::LocalError, Some(error)) => self.inexact(error),
                (Reason::Singular, _) => self.singular(),
                _ => self.not_converged(),
            })
    }

    /// An endless sequence of corners.
    fn corners(&self) -> Cause {
        let next = self.model.next_corner(self.failure.time);
        let mut elements = self.model.system.elements();
        let has_next = |element: &&dyn Element| element.next_corner(self.failure.time) <= next;
        let whose = match elements.find(has_next) {
            Some(element) => format!("\"{}\"", element.label()),
            None => "gravity".to_owned(),
        };
        Cause::new(
            format!("a drive of {whose}, which has its next corner at {next} s"),
            self.failure.reason.remedies(),
        )
    }

    /// A drive that has left its table.
    fn beyond_table(&self) -> Option<Cause> {
        let time = self.failure.time + self.failure.length;
        let has_left = |[first, last]: &[f64; 2]| time < *first || time > *last;
        let gravity = self.model.gravity_drive.domain();
        let gravity = has_left(&gravity).then(|| ("gravity".to_owned(), gravity));
        let mut elements = self.model.system.elements();
        let of_element = || {
            let element = elements.find(|element| has_left(&element.domain()))?;
            Some((format!("\"{}\"", element.label()), element.domain()))
        };
        let (whose, [first, last]) = gravity.or_else(of_element)?;
        let [first, last, time] = [first, last, time].map(rounded);
        Some(Cause::new(
            format!(
                "a drive of {whose} has values from {first} s to {last} s, and the step goes to \
                 {time} s"
            ),
            &["give the table more rows, set outside = \"hold\", or end the run before"],
        ))
    }

    /// Terms larger than in any machine.
    fn beyond_numbers(&self) -> Option<Cause> {
        let worst = &self.failure.worst;
        let is_beyond = worst.scale.is_finite() && worst.scale > BEYOND;
        is_beyond.then(|| {
            Cause::new(
                format!(
                    "the terms of the worst equation are as large as {:.1e}: a mass, a load or \
                     another number of the model is unreasonably large",
                    worst.scale
                ),
                &["check the numbers and units of all elements on this node"],
            )
        })
    }

    /// A motion that has grown beyond the model.
    fn grown(&self) -> Option<Cause> {
        let size = self.model.system.size();
        let nodes = self.state.nodes.iter().zip(self.model.system.nodes());
        let far = nodes.map(|(motion, node)| {
            let way = (motion.position - node.position).norm() / size;
            let in_step = self.wished * motion.velocity.norm() / size;
            (way.max(in_step * FAR / FAST), motion, node)
        });
        let (most, motion, node) = far.max_by(|a, b| a.0.total_cmp(&b.0))?;
        if most <= FAR {
            return None;
        }
        let way = (motion.position - node.position).norm();
        let words = format!(
            "the motion has grown beyond the model: node \"{}\" is {way:.3e} m from its \
             undeformed position and moves at {:.3e} m/s, in a model of {size:.3e} m",
            node.label,
            motion.velocity.norm()
        );
        let feedback = self.feedback();
        Some(if feedback.is_empty() {
            Cause::new(
                words + "; it is driven and not restrained",
                &[
                    "look for a law, a damper or a drive of the wrong sign, and for a missing \
                     support or a missing end of a load: shorter steps do not help",
                ],
            )
        } else {
            Cause::new(
                format!(
                    "{words}; {} acts on sensed quantities and feeds the motion",
                    quoted(&feedback)
                ),
                &[
                    "check the sign and the gain of the drive with the sensor, and bound it by \
                     min() and max(): shorter steps do not help",
                ],
            )
        })
    }

    /// Elements that act on sensed quantities.
    fn feedback(&self) -> Vec<String> {
        let elements = self.model.system.elements();
        let sensing = elements.filter(|element| element.senses());
        sensing.map(|element| element.label().to_owned()).collect()
    }

    /// A law, drive or load without a value.
    fn without_value(&self) -> Cause {
        let Some((element, by_time, why)) = self.dae.without_value() else {
            return Cause::new(
                "a law, a drive or a load has no value there",
                &["look for drives and laws that are not defined at this time or strain"],
            );
        };
        if let Some(why) = why {
            let remedy = if element.drives().is_empty() && !element.senses() {
                "end the run before"
            } else {
                "bound its drive by min() and max(), or end the run before"
            };
            return Cause::new(
                format!("\"{}\" has no value: {why}", element.label()),
                &[remedy],
            );
        }
        let time = rounded(self.failure.time + self.failure.length);
        let what = match (by_time, element.senses()) {
            (true, _) => format!("has no value at {time} s, at any position of the nodes"),
            (false, true) => "has no value at the sensed quantities there".to_owned(),
            (false, false) => {
                "has no value at the strain or rate there: it is outside the points of its table \
                 or outside the domain of its expression"
                    .to_owned()
            }
        };
        let remedy = match (by_time, element.senses()) {
            (true, _) => "end the run before, or define the drive beyond",
            (false, true) => {
                "bound the expression of its drive by min() and max(), as in sqrt(max(0, ...))"
            }
            (false, false) => {
                "extend the table, set outside = \"extend\" or \"hold\", or bound the \
                 expression by min() and max()"
            }
        };
        Cause::new(format!("\"{}\" {what}", element.label()), &[remedy])
    }

    /// Induced velocities without a value near the last ones.
    fn in_stall(&self) -> Option<Cause> {
        in_wake(self.failure).map(|remedies| {
            let owner = &self.failure.equation.owner;
            Cause::new(
                format!(
                    "the induced velocity at {owner} has no value near the last one: where a section \
                     stalls, its lift falls as the angle of attack grows, and an annulus in equilibrium with \
                     it jumps to another state"
                ),
                remedies,
            )
        })
    }

    /// A node that turns too far in a step.
    fn turned_far(&self) -> Option<Cause> {
        let length = self.failure.length;
        let turn = |motion: &NodeMotion| length * motion.angular_velocity.norm();
        let nodes = self.state.nodes.iter().zip(self.model.system.nodes());
        let turns = nodes.map(|(motion, node)| (turn(motion), &node.label));
        let (most, node) = turns.max_by(|a, b| a.0.total_cmp(&b.0))?;
        (most > LARGE_TURN).then(|| {
            let longest = LARGE_TURN / most * length;
            Cause {
                words: format!(
                    "node \"{node}\" turns by {most:.2} rad in a step of {length:.3e} s, which is \
                     too long for it"
                ),
                remedies: vec![format!(
                    "allow steps of {longest:.1e} s and less: a tenth of a radian a step is \
                     {:.1e} s",
                    0.2 * longest
                )],
            }
        })
    }

    /// A local error that stays too large.
    fn inexact(&self, local: &LocalError) -> Cause {
        let least = self.failure.least;
        // The error falls as the square of the step at a jump of a force, else faster.
        let part = (local.tolerance / local.error).sqrt();
        let larger = format!("or allow a \"tolerance\" of {:.1e}", 2.0 * local.error);
        if part > MUCH_SHORTER && part.is_finite() {
            let needed = part * self.failure.length;
            return Cause {
                words: format!(
                    "the least step, {least:.3e} s, is too long for the fastest motion: about \
                     {needed:.1e} s are needed"
                ),
                remedies: vec![format!("set \"least\" to {needed:.1e} s, {larger}")],
            };
        }
        if local.tolerance < ROUND_OFF {
            return Cause::new(
                "a local error below round-off was requested",
                &["request a \"tolerance\" of 1e-10 or more"],
            );
        }
        if !self.model.has_kinks() {
            return Cause {
                words: format!(
                    "no step of {least:.3e} s or more has the tolerance: the motion is too fast for \
                     it, or a mechanism is near a locked position"
                ),
                remedies: vec![format!("set a shorter \"least\", {larger}")],
            };
        }
        let feedback = self.feedback();
        let who = if feedback.is_empty() {
            String::new()
        } else {
            format!(": {} acts on sensed quantities", quoted(&feedback))
        };
        Cause {
            words: format!(
                "a force or a stiffness jumps within the step, and no drive states when{who}"
            ),
            remedies: vec![
                format!("smooth the jump over a distance or a time, {larger}"),
                "jumps of drives in time are known ahead, and steps end at them".to_owned(),
            ],
        }
    }

    /// An iteration that did not converge.
    fn not_converged(&self) -> Cause {
        let (most, tolerance) = (self.newton.iterations, self.newton.correction);
        let history = &self.failure.history;
        let last = history.last().map_or(f64::INFINITY, |last| last.correction);
        let used_up = self.failure.reason == Reason::NotConverged;
        if used_up && is_falling(history) && last > tolerance {
            return Cause {
                words: format!(
                    "the iteration was still converging when its {most} iterations were used up"
                ),
                remedies: vec![format!(
                    "allow more: newton = {{ iterations = {} }} in [transient]",
                    (2 * most).max(15)
                )],
            };
        }
        if used_up && last < FLOOR {
            return Cause::new(
                format!(
                    "the corrections fall no further than {last:.1e}, which is round-off; \
                     {tolerance:.1e} was requested"
                ),
                &["remove \"tolerance\" of newton, or increase it"],
            );
        }
        let has_joints = self.model.system.numbering().multipliers() > 0;
        if has_joints && self.failure.length < CUT * self.wished {
            return self.locked();
        }
        if used_up && is_to_and_fro(history) && self.model.has_kinks() {
            return Cause::new(
                "the iteration oscillates: a law or a drive by sensed quantities has a kink or a \
                 jump near this state, as a contact has",
                &[
                    "make the law smoother there (a spline, a cubic, a softer second stiffness)",
                    "allow shorter steps",
                ],
            );
        }
        self.too_long()
    }

    /// A state from which no step succeeds.
    fn locked(&self) -> Cause {
        let words = "no step succeeds, however short: the mechanism is near a position at which it \
                     is locked or can go two ways, or it is driven to a position out of its reach";
        let check = "check the mechanism at this time: joints in line, a rod at its full stretch, a \
                     drive beyond the reach of the mechanism";
        let change = "end the run before, or change the lengths or the drive";
        if self.model.has_kinks() {
            let words = format!("{words}; or a force has a jump or a kink there, as a contact has");
            let change = format!("{change}; smooth a law that jumps");
            return Cause::new(words + &self.or_feedback(), &[check, &change]);
        }
        Cause::new(words, &[check, change])
    }

    /// A step that is too long.
    fn too_long(&self) -> Cause {
        let words = "a step too long for the fastest motion, or a mechanism near a locked \
                     position";
        let mut remedies = vec!["allow shorter steps".to_owned()];
        let settings = self.settings;
        if settings.simplified_jacobian || settings.newton.jacobians == Jacobians::Modified {
            remedies.push("use the exact Jacobian in every iteration".to_owned());
        }
        let radius = match settings.scheme {
            Scheme::TwoStep { radius } | Scheme::Cubic { radius } => radius,
            _ => 0.0,
        };
        if radius > 0.0 {
            remedies.push(
                "lower the asymptotic radius: it damps motions that the steps do not resolve"
                    .to_owned(),
            );
        }
        Cause {
            words: words.to_owned() + &self.or_feedback(),
            remedies,
        }
    }

    /// Equations without a unique solution.
    fn singular(&self) -> Cause {
        Cause::new(
            "a mechanism that is locked or can go two ways here, redundant constraints, \
             or a part without mass and stiffness",
            &[
                "check the mechanism at this time, and the joints of the worst equation",
                "give the part a mass, or constrain it",
            ],
        )
    }

    fn or_feedback(&self) -> String {
        let feedback = self.feedback();
        if feedback.is_empty() {
            String::new()
        } else {
            format!(
                "; or it comes from {}, acting on sensed quantities",
                quoted(&feedback)
            )
        }
    }
}

/// Whether the latest corrections shrink.
fn is_falling(history: &[Iteration]) -> bool {
    let mut pairs = history[history.len().saturating_sub(LATEST)..].windows(2);
    pairs.all(|pair| pair[1].correction < SHRINKING * pair[0].correction)
}

/// Whether the latest corrections are of about the same size.
fn is_to_and_fro(history: &[Iteration]) -> bool {
    if history.len() < LATEST {
        return false;
    }
    let latest = history[history.len() - LATEST..].iter();
    let sizes = latest.map(|iteration| iteration.correction);
    let (least, most) = sizes.fold((f64::INFINITY, 0.0_f64), |(least, most), size| {
        (least.min(size), most.max(size))
    });
    most < 4.0 * least
}
