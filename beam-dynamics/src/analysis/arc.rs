//! Equilibrium path by arc length, past limit points.
//!
//! State and factor move together: with the sum Dy of the corrections of a step and the
//! change Dl of the factor,
//!
//! ```text
//! F(y, lambda) = 0                  |Dy|^2 + (psi Dl)^2 = l^2
//! ```
//!
//! by Newton's method for both, `dy = dy_F + dl dy_lambda` with two solutions of one factorization.
//! Displacements are relative to the size of the model, rotations in radians, and psi is the length
//! of the rate `dy/d lambda` at the start, so that state and load have equal shares of the first
//! step. The sense of a step is the sense of the previous one.
//!
//! References: [Crisfield1981], spherical arc length.

use crate::model::State;
use crate::solver::{Equations, Newton, NewtonStatus, Worst, solve};

use super::balance::{Balance, worst_equation};
use super::path::{PathEnd, Point, Walk, Walker};

/// First step if none is given, as a part of the whole path.
const FIRST: f64 = 0.05;
/// Longest step, in first steps, if none is given.
const LONGEST: f64 = 4.0;
/// Shortest step, in first steps.
const SHORTEST: f64 = 1e-4;
/// Desired number of iterations: with fewer the next step is longer.
const WANTED: f64 = 5.0;
/// Largest number of iterations.
const ITERATIONS: usize = 15;
/// Size of the last correction, in sizes of the model or radians.
const CONVERGED: f64 = 1e-9;
/// Least cosine between the predicted direction and the direction of the step.
const TURNED: f64 = 0.7;

/// A point of the path, and the unit direction by which it was reached.
struct Here {
    factor: f64,
    state: State,
    direction: (Vec<f64>, f64),
}

/// A trial step: the point after it, if it was found, and its effort.
struct Tried {
    found: Option<Here>,
    iterations: usize,
    worst: Worst,
    singular: bool,
}

impl Walker<'_> {
    /// Continues to the end by steps along the path.
    pub fn by_length(&self) -> Walk {
        let mut points = Vec::new();
        let end = self.follow(&mut points).err();
        (points, end)
    }

    fn follow(&self, points: &mut Vec<Point>) -> Result<(), PathEnd> {
        let start = self.at(0.0, &self.balance.state);
        let rate = start.factorize().and_then(|tangent| start.rate(&tangent));
        let stiff = |rate: &Vec<f64>| start.length(rate).is_finite() && !start.is_free(rate);
        let rate = rate.filter(stiff).ok_or_else(|| PathEnd::Free {
            motion: self.free_motion(),
        })?;
        let speed = start.length(&rate);
        let arc = Arc {
            walker: self,
            psi: if speed > 0.0 { speed } else { 1.0 },
        };
        let mut here = Here {
            factor: 0.0,
            state: self.balance.state.clone(),
            direction: (vec![0.0; rate.len()], self.to.signum()),
        };
        let part = self.steps.map_or(FIRST, |steps| 1.0 / steps as f64);
        let first = 2.0_f64.sqrt() * arc.psi * part * self.to.abs();
        let longest = first * if self.steps.is_some() { 1.0 } else { LONGEST };
        let (mut length, mut iterations) = (first, 0);
        for _ in 0..self.most_steps {
            let tried = loop {
                let tried = arc.step(&here, length);
                iterations += tried.iterations;
                if tried.found.is_some() {
                    break tried;
                }
                length *= 0.5;
                if length < SHORTEST * first {
                    return Err(arc.stuck(&here, &tried));
                }
            };
            let Some(there) = tried.found else {
                return Ok(());
            };
            let growth = (WANTED / tried.iterations.max(1) as f64).sqrt();
            length = (length * growth.clamp(0.5, 2.0)).min(longest);
            let last = arc.landing(&here, &there);
            let (factor, state, residual) = match &last {
                Some((state, residual)) => (self.to, state.clone(), *residual),
                None => (there.factor, there.state.clone(), tried.worst.relative),
            };
            points.push(Point {
                factor,
                state,
                iterations: std::mem::take(&mut iterations),
                residual,
            });
            if last.is_some() {
                return Ok(());
            }
            here = there;
        }
        Err(PathEnd::OutOfSteps {
            factor: here.factor,
            wanted: self.to,
            steps: self.most_steps,
        })
    }
}

/// A walker with the scale of the loads.
struct Arc<'a, 'b> {
    walker: &'a Walker<'b>,
    psi: f64,
}

impl Arc<'_, '_> {
    /// Scalar product of two motions with their changes of the factor.
    fn product(&self, a: (&[f64], f64), b: (&[f64], f64)) -> f64 {
        self.walker.balance.product(a.0, b.0) + self.psi * self.psi * a.1 * b.1
    }

    /// The unit direction of the path at `here`, in the sense of the last step.
    fn tangent(&self, here: &Here) -> Option<(Vec<f64>, f64)> {
        let balance = self.walker.at(here.factor, &here.state);
        let rate = balance.rate(&balance.factorize()?)?;
        let length = self.product((&rate, 1.0), (&rate, 1.0)).sqrt();
        let (before, sense) = &here.direction;
        let along = self.product((&rate, 1.0), (before, *sense));
        let scale = along.signum() / length;
        scale
            .is_finite()
            .then(|| (rate.iter().map(|value| scale * value).collect(), scale))
    }

    fn step(&self, here: &Here, length: f64) -> Tried {
        let mut tried = Tried {
            found: None,
            iterations: 0,
            worst: Worst::default(),
            singular: false,
        };
        let Some((direction, factor)) = self.tangent(here) else {
            tried.singular = true;
            return tried;
        };
        let mut moved: Vec<_> = direction.iter().map(|value| length * value).collect();
        let mut change = length * factor;
        let mut balance = self.walker.at(here.factor + change, &here.state);
        balance.correct(&moved);
        while tried.iterations < ITERATIONS {
            tried.iterations += 1;
            let Some((dy, dl)) = self.correction(&mut balance, (&moved, change), length) else {
                tried.singular = true;
                return tried;
            };
            let size = balance.size(&dy);
            tried.worst = balance.residual().1;
            if !size.is_finite() || size > 10.0 * length.max(0.1) {
                return tried;
            }
            moved.iter_mut().zip(&dy).for_each(|(sum, d)| *sum += d);
            change += dl;
            balance.correct(&dy);
            balance.conditions = self.walker.conditions(here.factor + change);
            if size <= CONVERGED {
                tried.worst = balance.residual().1;
                let along = self.product((&moved, change), (&direction, factor)) / length;
                let whole = self.product((&moved, change), (&moved, change)).sqrt();
                tried.found = (along >= TURNED * whole / length).then(|| Here {
                    factor: here.factor + change,
                    state: balance.state.clone(),
                    direction: (
                        moved.iter().map(|value| value / whole).collect(),
                        change / whole,
                    ),
                });
                return tried;
            }
        }
        tried
    }

    /// The correction of state and factor.
    fn correction(
        &self,
        balance: &mut Balance<'_>,
        moved: (&[f64], f64),
        length: f64,
    ) -> Option<(Vec<f64>, f64)> {
        let (residual, _) = balance.residual();
        let tangent = balance.factorize()?;
        let mut of_residual: Vec<_> = residual.iter().map(|value| -value).collect();
        tangent.solve(&mut of_residual)?;
        let rate = balance.rate(&tangent)?;
        let excess = 0.5 * (self.product(moved, moved) - length * length);
        let along = self.product(moved, (&rate, 1.0));
        let dl = (-excess - self.product(moved, (&of_residual, 0.0))) / along;
        let sum = of_residual.iter().zip(&rate).map(|(f, r)| f + dl * r);
        dl.is_finite().then(|| (sum.collect(), dl))
    }

    /// The state at which the step passes the requested factor, and its residual.
    fn landing(&self, here: &Here, there: &Here) -> Option<(State, f64)> {
        let to = self.walker.to;
        let passed = (here.factor - to) * to < 0.0 && (there.factor - to) * to >= 0.0;
        if !passed {
            return None;
        }
        let part = (to - here.factor) / (there.factor - here.factor);
        let whole = self.walker.at(to, &there.state).moved_from(&here.state);
        let foreseen: Vec<_> = whole.iter().map(|value| part * value).collect();
        // Reactions are unknowns too: the first correction determines them.
        let mut balance = self.walker.at(to, &here.state);
        balance.correct(&foreseen);
        let report = solve(&mut balance, &Newton::default());
        let near = balance.length(&balance.moved_from(&here.state)) <= 2.0 * balance.length(&whole);
        let landed = report.status == NewtonStatus::Converged && near;
        landed.then_some((balance.state, report.worst.relative))
    }

    fn stuck(&self, here: &Here, tried: &Tried) -> PathEnd {
        PathEnd::Stuck {
            factor: here.factor,
            reason: if tried.singular {
                "the tangent is singular"
            } else {
                "the path is not found however short the step"
            },
            equation: worst_equation(self.walker.balance.system, &tried.worst),
        }
    }
}
