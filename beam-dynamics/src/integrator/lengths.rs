//! Length and end of the next step.

use serde::{Deserialize, Serialize};

use super::{Corner, Dae, Scheme, StepControl, StepLimits, Stepping};

/// Least fraction to which a constant step is reduced.
const LEAST_PART: f64 = 1.0 / 1024.0;

/// Difference of times, as a fraction of a step, below which they are the same.
const SAME_TIME: f64 = 1e-9;

/// Distance from a corner or from the end, in steps, below which a grid point is that point.
const SAME_POINT: f64 = 1e-6;

/// Fraction that is used of the step allowed by the local error, so that few steps are rejected.
const SAFETY: f64 = 0.9;

/// Largest reduction of a step at once.
const LARGEST_CUT: f64 = 0.2;

/// Growth below which a step is kept: the Jacobian is kept, the ratio is one.
const NOT_WORTH: f64 = 1.1;

/// Fractions of the iterations allowed above which steps do not grow, and shrink.
const MANY: f64 = 1.0 / 3.0;
const TOO_MANY: f64 = 2.0 / 3.0;

/// Reduction of a variable step whose iteration failed, or took too many iterations.
const FAILED: f64 = 0.25;
const TIRED: f64 = 0.7;

/// State from which the lengths of the next steps follow.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Lengths {
    /// Start of the grid of constant steps [s].
    pub from: f64,
    /// Grid points reached, without the start.
    pub points: u64,
    /// The next step wanted [s].
    pub wish: f64,
}

/// A step to be tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plan {
    /// Length [s].
    pub length: f64,
    /// Time at its end [s].
    pub end: f64,
    /// Whether the grid has one more point there.
    pub is_on_grid: bool,
    /// The corner at which the step ends.
    pub corner: Option<Corner>,
}

impl Lengths {
    /// The state at the start of a run.
    pub fn new(stepping: &Stepping, from: f64) -> Self {
        let wish = match stepping {
            Stepping::Constant { step } => *step,
            Stepping::Variable(control) => control.first.max(control.least).min(control.most),
        };
        Self {
            from,
            points: 0,
            wish,
        }
    }

    /// Continues at `time` after a step of `last`; if the stepping has changed, its grid begins
    /// here, and the first step is at most twice the last.
    pub fn resume(&mut self, stepping: &Stepping, time: f64, last: f64) {
        match stepping {
            Stepping::Constant { step } => {
                let beyond = (time - self.from) / step - self.points as f64;
                let is_other = !(-SAME_POINT..1.0).contains(&beyond);
                if is_other {
                    (self.from, self.points) = (time, 0);
                    self.wish = if last > 0.0 { 2.0 * last } else { *step };
                }
                self.wish = self.wish.min(*step);
            }
            Stepping::Variable(control) => {
                self.wish = self.wish.max(control.least).min(control.most);
            }
        }
    }

    /// The next step from `time`, to `until` at most.
    pub fn plan(&self, dae: &dyn Dae, stepping: &Stepping, time: f64, until: f64) -> Plan {
        let stop = self.stop(dae, time, until);
        match stepping {
            Stepping::Constant { step } => self.towards_grid(*step, time, &stop),
            Stepping::Variable(control) => {
                let longest = dae.longest_step(time).max(control.least);
                let wish = self.wish.min(longest);
                Self { wish, ..*self }.towards(time, &stop)
            }
        }
    }

    /// The next time that a step must reach exactly.
    fn stop(&self, dae: &dyn Dae, time: f64, until: f64) -> Plan {
        let same = SAME_TIME * self.wish;
        let corner = dae.next_corner(time + same);
        let mut stop = Plan {
            length: until - time,
            end: until,
            is_on_grid: false,
            corner: None,
        };
        if corner > time && corner < until + same {
            stop.end = if (corner - until).abs() < same {
                until
            } else {
                corner
            };
            stop.length = stop.end - time;
            // Corners that follow immediately are passed with it.
            let follows = dae.next_corner(corner) < corner + same;
            let after = if follows { corner + same } else { corner };
            stop.corner = Some(Corner {
                before: corner.min(stop.end).next_down(),
                after: after.max(stop.end),
            });
        }
        stop
    }

    fn towards_grid(&self, step: f64, time: f64, stop: &Plan) -> Plan {
        let point = self.from + (self.points + 1) as f64 * step;
        let mut goal = *stop;
        if (point - stop.end).abs() <= SAME_POINT * step {
            goal.is_on_grid = true;
        } else if point < stop.end {
            goal = Plan {
                length: point - time,
                end: point,
                is_on_grid: true,
                corner: None,
            };
        }
        // From grid point to grid point the step is the given number, to the last bit.
        let round_off = 4.0 * f64::EPSILON * goal.end.abs().max(step);
        if (goal.length - step).abs() <= round_off {
            goal.length = step;
        }
        self.towards(time, &goal)
    }

    /// Divides the way to a goal into steps of at most the wanted length; the last two are equal,
    /// so that none is tiny.
    fn towards(&self, time: f64, goal: &Plan) -> Plan {
        let steps = (goal.length / self.wish - SAME_POINT).ceil();
        if steps <= 1.0 || steps.is_nan() {
            return *goal;
        }
        let length = if steps == 2.0 {
            0.5 * goal.length
        } else {
            self.wish
        };
        Plan {
            length,
            end: time + length,
            is_on_grid: false,
            corner: None,
        }
    }

    /// The shortest step [s].
    pub fn least(&self, stepping: &Stepping) -> f64 {
        match stepping {
            Stepping::Constant { step } => LEAST_PART * step,
            Stepping::Variable(control) => control.least,
        }
    }

    /// Reduces the wanted step after one of `length` has failed; `false` if no shorter one is
    /// allowed.
    pub fn cut(&mut self, stepping: &Stepping, length: f64, by: f64) -> bool {
        let least = self.least(stepping);
        if length <= least {
            return false;
        }
        self.wish = (by * length).max(least);
        true
    }

    /// Sets the wanted step after a jump.
    pub fn restart(&mut self, stepping: &Stepping) {
        if let Stepping::Variable(control) = stepping {
            self.wish = self.wish.min(control.first).max(control.least);
        }
    }

    /// Sets the wanted step after an accepted step; `error` is its local error relative to the
    /// tolerance.
    pub fn follow(
        &mut self,
        accepted: &Accepted,
        stepping: &Stepping,
        scheme: &Scheme,
        limits: &StepLimits,
    ) {
        if accepted.plan.is_on_grid {
            self.points += 1;
        }
        let effort = accepted.iterations as f64 / limits.iterations.max(1) as f64;
        match stepping {
            Stepping::Constant { step } => {
                if self.wish < *step && effort <= MANY {
                    self.wish = step.min(2.0 * self.wish);
                }
            }
            Stepping::Variable(control) => self.adapt(accepted, effort, control, scheme),
        }
    }

    fn adapt(&mut self, accepted: &Accepted, effort: f64, control: &StepControl, scheme: &Scheme) {
        let growth = if effort > TOO_MANY {
            TIRED
        } else if effort > MANY || accepted.was_cut {
            1.0
        } else {
            scheme.growth()
        };
        let allowed = match accepted.allowed {
            Some(factor) => accepted.plan.length * factor,
            None => self.wish,
        };
        let wish = allowed.min(growth * self.wish).max(LARGEST_CUT * self.wish);
        let is_worth_it = wish < self.wish || wish >= NOT_WORTH * self.wish;
        if is_worth_it || growth < NOT_WORTH {
            self.wish = wish;
        }
        self.wish = self.wish.max(control.least).min(control.most);
    }
}

/// Data of an accepted step that determine the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accepted {
    /// The step.
    pub plan: Plan,
    /// Its iterations.
    pub iterations: usize,
    /// Whether longer ones were tried before.
    pub was_cut: bool,
    /// Ratio of the next step to this one that the local errors allow, if they were computed [-].
    pub allowed: Option<f64>,
}

/// Ratio of the next step to this one that brings the local error to its tolerance:
///
/// ```text
/// h_new / h = 0.9 ( tolerance / error )^(1 / (p + 1))                              (D-117)
/// ```
pub(super) fn factor(error: f64, order: usize) -> f64 {
    SAFETY
        * error
            .max(f64::MIN_POSITIVE)
            .powf(-1.0 / (order as f64 + 1.0))
}

/// Reduction of a step whose local error is too large, or whose iteration failed.
pub(super) fn cut_by(error: Option<f64>, order: usize, stepping: &Stepping) -> f64 {
    match (error, stepping) {
        (Some(error), _) => factor(error, order).clamp(LARGEST_CUT, SAFETY),
        (None, Stepping::Constant { .. }) => 0.5,
        (None, Stepping::Variable(_)) => FAILED,
    }
}
