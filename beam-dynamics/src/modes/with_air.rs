//! Modes with air, followed from the ones without it.
//!
//! The air damps the flapping of blades so much that no system without lags has values near it. The
//! linearized system is affine in the part p of the forces of the air that acts,
//!
//! ```text
//! F(p) = F(1) + 2 (1 - p) (F(1/2) - F(1))
//! ```
//!
//! and each mode without air, p = 0, is followed to p = 1 in steps over which its shape changes little.

use std::cell::OnceCell;

use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use crate::assembly::{Sparse, System, Tangent};
use crate::model::{Conditions, State};

/// Largest number of steps.
const STEPS: usize = 16;
/// Overlap of the shapes before and after a step from which it is accepted, of one step and of several.
const SAME: [f64; 2] = [0.5, 0.95];

/// The linearized system with half of the forces of the air; `None` without states that air may have.
pub fn half_air(system: &System, state: &State, conditions: &Conditions) -> Option<Tangent> {
    let mut conditions = *conditions;
    conditions.loading.air *= 0.5;
    (!system.scalars().is_empty()).then(|| system.tangent(state, &conditions))
}

/// A matrix with a part of the forces of the air.
fn mixed(whole: &Sparse, half: &Sparse, part: f64) -> Sparse {
    let mut matrix = whole.clone();
    let pairs = matrix.values_mut().iter_mut().zip(half.values());
    for (value, half) in pairs {
        *value += 2.0 * (1.0 - part) * (half - *value);
    }
    matrix
}

impl EigenProblem<'_> {
    /// The `count` oscillations of lowest frequency of a system in which no air acts, and the other copies of
    /// the last one; scalars, such as states of the air, follow without lag.
    pub fn structural(&self, count: usize) -> Vec<Eigenpair> {
        match self.without_circuits(self.tangent()) {
            Some(alone) => {
                let problem = self.beside(&alone);
                problem.map_or_else(Vec::new, |problem| problem.lowest_complete(count))
            }
            None => self.lowest_complete(count),
        }
    }

    /// The modes without air of the lowest `count` frequencies, followed into this system, and how
    /// many are lost on the way. `half` has half of the forces of the air.
    pub(super) fn followed_from_vacuum(
        &self,
        half: &Tangent,
        count: usize,
    ) -> (Vec<Eigenpair>, usize) {
        let whole = self.tangent();
        let part = |step: usize| Tangent {
            by_unknowns: mixed(
                &whole.by_unknowns,
                &half.by_unknowns,
                step as f64 / STEPS as f64,
            ),
            by_rates: mixed(&whole.by_rates, &half.by_rates, step as f64 / STEPS as f64),
        };
        let Some(vacuum) = self.without_circuits(&part(0)) else {
            return (Vec::new(), 0);
        };
        let Some(problem) = self.beside(&vacuum) else {
            return (Vec::new(), 0);
        };
        let found = problem.lowest_complete(count);
        let tangents: [OnceCell<Tangent>; STEPS] = Default::default();
        let problems: [OnceCell<Option<EigenProblem<'_>>>; STEPS] = Default::default();
        let problem_at = |step: usize| {
            let tangent = tangents[step - 1].get_or_init(|| part(step));
            let problem = problems[step - 1].get_or_init(|| self.beside(tangent));
            problem.as_ref()
        };
        let follow = |pair: &Eigenpair, most: usize| {
            let (mut pair, mut at, mut stride) = (pair.clone(), 0, most);
            while at < STEPS {
                stride = stride.min(STEPS - at).min(most);
                let problem = problem_at(at + stride);
                let least = SAME[usize::from(stride > 1)];
                match problem.and_then(|problem| problem.corrected(&pair, least)) {
                    Some(next) => {
                        (pair, at) = (next, at + stride);
                        stride *= 2;
                    }
                    None if stride > 1 => stride /= 2,
                    None => return None,
                }
            }
            Some(pair)
        };
        // Where two modes exchange their shapes one of them may lead to the other: it is followed again,
        // in all steps.
        let follow = &follow;
        let candidates = |pair| {
            let strides = [STEPS, 1].into_iter();
            strides.filter_map(move |most| follow(pair, most))
        };
        self.new_ones(found.iter().map(candidates))
    }
}
