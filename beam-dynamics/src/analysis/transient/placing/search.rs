//! Newton's method from given positions to positions that fulfill the constraints, with steps that
//! may be damped.

use crate::analysis::balance::largest_motion;
use crate::assembly::System;
use crate::elements::Level;
use crate::model::{Conditions, NODE_UNKNOWNS, State};

use super::super::saddle::MOTION;
use super::{
    ITERATIONS, LARGEST, SMALL, Unfulfilled, fulfilled, move_by, place_step, values, worst,
};

/// Largest number of halvings of a step of damped iterations.
const HALVINGS: usize = 8;

/// A search for positions near the start.
pub(super) struct Search<'a> {
    pub system: &'a System,
    pub conditions: &'a Conditions,
    pub start: State,
    pub weights: Vec<f64>,
}

impl Search<'_> {
    /// The positions that fulfill the constraints, if they are found; `nearest` is the smallest
    /// violation of the constraints so far.
    pub fn run(&self, is_damped: bool, nearest: &mut Unfulfilled) -> Option<State> {
        let nodes = self.start.nodes.len();
        let size = self.system.size();
        let mut now = self.start.clone();
        for _ in 0..ITERATIONS {
            let (start, weights) = (&self.start, &self.weights);
            let step = place_step(self.system, (start, &now), self.conditions, weights)?;
            let largest = largest_motion(step[..MOTION * nodes].chunks(MOTION), size);
            if !largest.is_finite() {
                return None;
            }
            let part = f64::min(1.0, LARGEST / largest);
            let part = if is_damped {
                self.damped(&now, &step, part)
            } else {
                part
            };
            move_by(&mut now, &step, part);
            let off = self.off(&now);
            if off.value.abs() < nearest.value.abs() {
                *nearest = off;
            }
            if largest <= SMALL {
                // Contradicting constraints converge to a position between them.
                return (off.value.abs() <= fulfilled(SMALL, self.system, &self.start))
                    .then_some(now);
            }
        }
        None
    }

    /// The part of a step after which the violation is smaller.
    fn damped(&self, now: &State, step: &[f64], mut part: f64) -> f64 {
        let before = self.off(now).value.abs();
        for _ in 0..HALVINGS {
            let mut tried = now.clone();
            move_by(&mut tried, step, part);
            if self.off(&tried).value.abs() < before {
                break;
            }
            part *= 0.5;
        }
        part
    }

    /// The constraint of the largest violation.
    fn off(&self, state: &State) -> Unfulfilled {
        let first = NODE_UNKNOWNS * state.nodes.len();
        let values = values(self.system, state, self.conditions, Level::Position);
        worst(&values, first)
    }
}
