//! Residual and Jacobian of all elements of a model, as in a time step.

use std::hint::black_box;
use std::sync::Arc;

use beam_dynamics::assembly::{Combination, Residual, Sparse, Variation};
use beam_dynamics::case::Model;
use beam_dynamics::model::{Conditions, State};
use cpu_time::ThreadTime;
use nalgebra::Matrix3;

use crate::factors::Scattered;

/// Relative change of all unknowns for central differences [-].
const DIFFERENCE: f64 = 1e-6;

/// A model at a state.
pub struct Elements<'a> {
    model: &'a Model,
    state: &'a State,
    conditions: Conditions,
    /// Variations of the rotations.
    variations: Vec<Variation>,
}

impl<'a> Elements<'a> {
    pub fn new(model: &'a Model, (time, state): &'a (f64, State)) -> Self {
        let variation = Variation {
            turn: Matrix3::identity(),
            rate_by_turn: Matrix3::zeros(),
            axes: None,
        };
        Self {
            model,
            state,
            conditions: model.conditions_at(*time),
            variations: vec![variation; model.system.nodes().len()],
        }
    }

    /// The matrix of a step with the given weights of unknowns and rates, and the processor time of
    /// one evaluation with its residual [s].
    pub fn evaluate(&self, weights: [f64; 2], repeats: u32) -> (Sparse, f64) {
        let system = &self.model.system;
        let mut matrix = Sparse::zero(Arc::clone(system.pattern()));
        let (mut residual, mut work) = (Residual::default(), system.workspace());
        let begin = ThreadTime::now();
        for _ in 0..repeats {
            let mut sums = [Combination {
                by_unknowns: weights[0],
                by_rates: weights[1],
                by_algebraic: 1.0,
                matrix: &mut matrix,
            }];
            let out = (&mut sums[..], Some(&mut residual));
            system.combine(
                self.state,
                &self.conditions,
                &self.variations,
                out,
                &mut work,
            );
            black_box(&residual);
        }
        let time = begin.elapsed().as_secs_f64() / f64::from(repeats);
        (matrix, time)
    }

    /// Largest difference of the Jacobian times a vector from central differences, relative
    /// to the largest of its values [-].
    pub fn error(&self) -> f64 {
        let system = &self.model.system;
        let mut scattered = Scattered(5);
        let change: Vec<_> = (0..system.numbering().unknowns())
            .map(|_| scattered.next())
            .collect();
        let moved = |by: f64| {
            let mut state = self.state.clone();
            state.correct(&change.iter().map(|x| by * x).collect::<Vec<_>>());
            system.residual(&state, &self.conditions).values
        };
        let (after, before) = (moved(DIFFERENCE), moved(-DIFFERENCE));
        let mut product = vec![0.0; change.len()];
        let (jacobian, _) = self.evaluate([1.0, 0.0], 1);
        jacobian.multiply_add(&change, &mut product);
        let rows = product.iter().zip(after.iter().zip(&before));
        let (mut largest, mut apart) = (0.0_f64, 0.0_f64);
        for (product, (after, before)) in rows {
            let difference = (after - before) / (2.0 * DIFFERENCE);
            largest = largest.max(product.abs());
            apart = apart.max((product - difference).abs());
        }
        apart / largest
    }
}
