//! Work of the steps so far.

use serde::{Deserialize, Serialize};

/// Work of all steps so far.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Counters {
    /// Accepted steps.
    pub steps: usize,
    /// Rejected steps that were tried again with a shorter one.
    pub rejected: usize,
    /// Newton iterations, including rejected steps.
    pub iterations: usize,
    /// Jacobians that were assembled and factorized.
    pub jacobians: usize,
    /// Factorizations that chose new pivots.
    pub pivotings: usize,
    /// Shortest accepted step; zero before the first [s].
    pub least_step: f64,
    /// Longest accepted step [s].
    pub most_step: f64,
    /// Time spent in predictions, including the sharing of loads between constraints [s].
    #[serde(default)]
    pub prediction_time: f64,
    /// Time spent in residuals [s].
    pub residual_time: f64,
    /// Time spent in Jacobians [s].
    pub jacobian_time: f64,
    /// Time spent in factorizations [s].
    pub factorization_time: f64,
    /// Time spent in solutions with factors [s].
    pub solution_time: f64,
}

impl Counters {
    /// Counts an accepted step of `length` \[s\].
    pub(super) fn accept(&mut self, length: f64) {
        self.least_step = match self.steps {
            0 => length,
            _ => self.least_step.min(length),
        };
        self.most_step = self.most_step.max(length);
        self.steps += 1;
    }
}
