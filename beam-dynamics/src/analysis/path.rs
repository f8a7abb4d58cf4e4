//! Equilibrium path with the factor of the loads, `F(y, lambda) = 0`.
//!
//! From a state the next one is predicted along the rate of the solution,
//!
//! ```text
//! dy/d lambda = -F_y^-1 F_lambda
//! ```
//!
//! and corrected by Newton's method at a fixed factor. A step is cut if the iteration fails, or if
//! the displacement between the states disagrees with the rates at both ends: the solution has then
//! jumped to another branch. Just before a limit point the rate grows like one over the square root
//! of the distance, from which its position is extrapolated.

use shared_geom::figure::tick_label;

use crate::model::{Conditions, State};
use crate::solver::{Equations, Newton, NewtonReport, NewtonStatus, solve};

use super::balance::{Balance, worst_equation};
use super::settling::free_motion;

/// Part of a displacement that may differ from the rates at its ends.
const UNEXPLAINED: f64 = 0.25;
/// Motion below which a step is not checked: relative to the size of the model, or radians. The
/// error of the iteration is 1e-9.
const SMALL: f64 = 1e-7;
/// Largest rotation of one step that a rotation vector represents \[rad\].
const TURN: f64 = 2.0;
/// Least step, as a part of the whole path.
const SMALLEST: f64 = 1e-5;
/// Growth of the rate, relative to its smallest value so far, at which a limit point is recognized.
const GROWN: f64 = 4.0;
/// First step if none is given, as a part of the whole path.
const FIRST: f64 = 0.1;
/// Iterations up to which the next step is longer.
const QUICK: usize = 7;

/// An equilibrium on a path.
#[derive(Debug, Clone)]
pub(super) struct Point {
    pub factor: f64,
    pub state: State,
    /// Newton iterations since the previous point, including the iterations of cut steps.
    pub iterations: usize,
    /// Largest residual relative to the largest term of its kind.
    pub residual: f64,
}

/// Reason for a path that ends before the requested factor.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PathEnd {
    /// The loads cannot grow further.
    #[error(
        "limit point near the load factor {factor:.4}: the loads can grow no further along \
         this path; worst equation there: {equation}"
    )]
    LimitPoint {
        /// Its factor, extrapolated from the rates of the last states [-].
        factor: f64,
        /// The worst equation of the last trial step, as text.
        equation: String,
    },
    /// The loads drive a motion without stiffness.
    #[error(
        "no equilibrium beyond the load factor 0: the loads drive a motion without stiffness{}",
        mostly(.motion)
    )]
    Free {
        /// The motion as text, if it is known.
        motion: Option<String>,
    },
    /// An element is undefined beyond.
    #[error("no equilibrium beyond the load factor {}: \"{element}\": {why}", tick_label(*.factor, 0.0))]
    WithoutValue {
        /// The last factor reached [-].
        factor: f64,
        /// Name of the element.
        element: String,
        /// The reason, as text.
        why: String,
    },
    /// The iteration fails for any length of the step.
    #[error(
        "no equilibrium beyond the load factor {}: {reason}; worst equation: {equation}",
        tick_label(*.factor, 0.0)
    )]
    Stuck {
        /// The last factor reached [-].
        factor: f64,
        /// End of the iteration, as text.
        reason: &'static str,
        /// The worst equation, as text.
        equation: String,
    },
    /// The allowed number of steps is used up.
    #[error("the load factor {wanted} was not reached in {steps} steps; the last is {}", tick_label(*.factor, 0.0))]
    OutOfSteps {
        /// The last factor reached [-].
        factor: f64,
        /// The requested factor [-].
        wanted: f64,
        /// Steps taken.
        steps: usize,
    },
}

fn mostly(motion: &Option<String>) -> String {
    let words = motion.as_ref().map(|motion| format!(", mostly {motion}"));
    words.unwrap_or_default()
}

/// Points reached, and the reason if the end was not reached.
pub(super) type Walk = (Vec<Point>, Option<PathEnd>);

/// Start and end of a path.
pub(super) struct Walker<'a> {
    /// The balance at the start, whose state is an equilibrium.
    pub balance: Balance<'a>,
    /// Factor at the end.
    pub to: f64,
    /// Requested steps.
    pub steps: Option<usize>,
    /// Largest number of steps.
    pub most_steps: usize,
}

/// A state with its rate.
struct Here {
    factor: f64,
    state: State,
    rate: Vec<f64>,
    /// Length of the rate.
    speed: f64,
}

impl<'a> Walker<'a> {
    pub fn conditions(&self, factor: f64) -> Conditions {
        let mut conditions = self.balance.conditions;
        conditions.loading.proportional = factor;
        conditions
    }

    /// The balance at a factor, from a state.
    pub fn at(&self, factor: f64, state: &State) -> Balance<'a> {
        self.balance.at(self.conditions(factor), state.clone())
    }

    /// Continues to the end by steps of the factor.
    pub fn by_factor(&self) -> Walk {
        let (mut points, mut between) = (Vec::new(), None);
        let end = self.walk(&mut points, &mut between).err();
        // The last state of a path that ends early is kept too.
        points.extend(end.as_ref().and(between));
        (points, end)
    }

    /// Fills `points`, and `between` with the state after the last of them.
    fn walk(&self, points: &mut Vec<Point>, between: &mut Option<Point>) -> Result<(), PathEnd> {
        let mut here = self.start()?;
        let mut rates = Rates::new(&here);
        let targets = self.steps.unwrap_or(1);
        let mut step = self.to * self.steps.map_or(FIRST, |steps| 1.0 / steps as f64);
        let (mut iterations, mut taken) = (0, 0);
        for target in 1..=targets {
            let goal = if target == targets {
                self.to
            } else {
                self.to * target as f64 / targets as f64
            };
            while here.factor != goal {
                let next = if (goal - here.factor).abs() <= 1.001 * step.abs() {
                    goal
                } else {
                    here.factor + step
                };
                let (found, report) = self.step(&here, next);
                iterations += report.history.len();
                let Some(there) = found else {
                    step *= 0.5;
                    if step.abs() < SMALLEST * self.to.abs() {
                        return Err(self.end(&here, &rates, &report));
                    }
                    continue;
                };
                let quick = report.history.len() <= QUICK;
                (here, step) = (there, if quick { 2.0 * step } else { step });
                rates.add(&here);
                taken += 1;
                let point = Point {
                    factor: here.factor,
                    state: here.state.clone(),
                    iterations,
                    residual: report.worst.relative,
                };
                *between = Some(point);
                if self.steps.is_none() || here.factor == goal {
                    points.extend(between.take());
                    iterations = 0;
                }
                if taken >= self.most_steps && here.factor != self.to {
                    return Err(PathEnd::OutOfSteps {
                        factor: here.factor,
                        wanted: self.to,
                        steps: taken,
                    });
                }
            }
        }
        Ok(())
    }

    /// The state without the loads, whose rate must be finite.
    fn start(&self) -> Result<Here, PathEnd> {
        let free = || PathEnd::Free {
            motion: self.free_motion(),
        };
        let here = self.here(0.0, self.balance.state.clone());
        let here = here.ok_or_else(free)?;
        if self.balance.is_free(&here.rate) {
            Err(free())
        } else {
            Ok(here)
        }
    }

    /// The motion without stiffness that the loads drive.
    pub fn free_motion(&self) -> Option<String> {
        free_motion(&self.at(self.to, &self.balance.state))
    }

    fn here(&self, factor: f64, state: State) -> Option<Here> {
        let balance = self.at(factor, &state);
        let rate = balance.rate(&balance.factorize()?)?;
        let speed = balance.length(&rate);
        speed.is_finite().then_some(Here {
            factor,
            state,
            rate,
            speed,
        })
    }

    /// The equilibrium at the factor `next`, if it belongs to the same path.
    fn step(&self, here: &Here, next: f64) -> (Option<Here>, NewtonReport) {
        let change = next - here.factor;
        let mut balance = self.at(next, &here.state);
        let foreseen: Vec<_> = here.rate.iter().map(|rate| change * rate).collect();
        if balance.size(&foreseen) <= 1.0 {
            balance.correct(&foreseen);
        }
        let report = solve(&mut balance, &Newton::default());
        if report.status != NewtonStatus::Converged {
            return (None, report);
        }
        let moved = balance.moved_from(&here.state);
        let there = self.here(next, balance.state.clone());
        let there = there.filter(|there| {
            let rates = here.rate.iter().zip(&there.rate);
            let explained = rates.map(|(a, b)| 0.5 * change * (a + b));
            let rest: Vec<_> = moved.iter().zip(explained).map(|(m, e)| m - e).collect();
            let way = balance.length(&moved).max(SMALL);
            balance.size(&foreseen) <= TURN
                && balance.size(&moved) <= TURN
                && balance.length(&rest) <= UNEXPLAINED * way
        });
        (there, report)
    }

    /// An element that is undefined a little further along the path, with its name.
    fn without_value(&self, here: &Here) -> Option<(String, String)> {
        let further = 2.0 * SMALLEST * self.to;
        let mut balance = self.at(here.factor + further, &here.state);
        let change: Vec<_> = here.rate.iter().map(|rate| further * rate).collect();
        balance.correct(&change);
        let conditions = self.conditions(here.factor + further);
        let system = self.balance.system;
        let (element, why) = system.first_without_value(&balance.state, &conditions)?;
        Some((element.label().to_owned(), why))
    }

    fn end(&self, here: &Here, rates: &Rates, report: &NewtonReport) -> PathEnd {
        let equation = worst_equation(self.balance.system, &report.worst);
        if let Some((element, why)) = self.without_value(here) {
            let factor = here.factor;
            return PathEnd::WithoutValue {
                factor,
                element,
                why,
            };
        }
        if let Some(factor) = rates.limit() {
            return PathEnd::LimitPoint { factor, equation };
        }
        let reason = match report.status {
            NewtonStatus::Singular => "the tangent is singular",
            NewtonStatus::NotConverged => "Newton's method does not converge",
            NewtonStatus::Converged => "the solution jumps",
        };
        PathEnd::Stuck {
            factor: here.factor,
            reason,
            equation,
        }
    }
}

/// The lengths of the rates on a path, from which a limit point is extrapolated.
struct Rates {
    slowest: f64,
    /// Factor and length of the rate of the last two states.
    last: [(f64, f64); 2],
}

impl Rates {
    fn new(here: &Here) -> Self {
        Self {
            slowest: here.speed,
            last: [(here.factor, here.speed); 2],
        }
    }

    fn add(&mut self, here: &Here) {
        self.slowest = self.slowest.min(here.speed);
        self.last = [self.last[1], (here.factor, here.speed)];
    }

    /// The factor at which `1 / |dy/d lambda|^2`, which falls linearly before a limit point, is
    /// zero.
    fn limit(&self) -> Option<f64> {
        let [(a, slow), (b, fast)] = self.last;
        let [before, now] = [slow, fast].map(|speed| 1.0 / (speed * speed));
        let grown = fast > GROWN * self.slowest && before > now;
        grown.then(|| b + now * (b - a) / (before - now))
    }
}
