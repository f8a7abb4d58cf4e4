//! One step of Radau IIA as a map of its first state alone.
//!
//! Nothing but the first state determines the step: all stages are corrected from that state
//! without a prediction, so that with `xi_i` the change of stage i and `K_i` its rates
//!
//! ```text
//! xi_i = h sum_j a_ij K_j        F(y_0 o xi_i, K_i, lambda_i, t_i) = 0               (D-450)
//! ```
//!
//! The derivative of the end by the first state then follows from the matrix of the stages at the
//! converged step, which [`OneStep::matrix`] assembles, and from the derivative of F by the first
//! state at fixed `xi_i` and `K_i`.
//!
//! References: [HairerWanner1996].

use std::sync::Arc;

use super::corrector::{Corrector, StageMatrix};
use super::meter::Meter;
use super::{Counters, Dae, Formula, Reason, STAGES, StepFailure, StepLimits};
use crate::assembly::{Pattern, Sparse};

/// Steps by Radau IIA with two or three stages.
#[derive(Debug)]
pub struct OneStep {
    formula: Formula,
    limits: StepLimits,
    corrector: Corrector,
    matrix: StageMatrix,
    counters: Counters,
    zero: Vec<f64>,
    /// Rates from which the iteration begins.
    guess: Vec<f64>,
}

impl OneStep {
    /// Steps of `dae` with three stages, or with two.
    pub fn new(dae: &dyn Dae, has_three_stages: bool, limits: StepLimits) -> Self {
        let formula = if has_three_stages {
            Formula::radau_three()
        } else {
            Formula::parabolic(-2.0 / 3.0)
        };
        let pattern = dae.pattern();
        Self {
            corrector: Corrector::new(dae, formula.stages, &limits),
            matrix: StageMatrix::new(pattern, formula.stages, dae.algebraic()),
            counters: Counters::default(),
            zero: vec![0.0; pattern.size()],
            guess: vec![0.0; pattern.size()],
            limits,
            formula,
        }
    }

    /// Number of stages.
    pub fn stages(&self) -> usize {
        self.formula.stages
    }

    /// The weights a of the rates, one row per stage, times the length of a step \[s\].
    pub fn weights(&self, length: f64) -> [[f64; STAGES]; STAGES] {
        self.formula.step_weights(length)
    }

    /// Pattern of the matrix of the stages: stage s of unknown i is number `stages i + s`.
    pub fn pattern(&self) -> &Arc<Pattern> {
        self.matrix.pattern()
    }

    /// Work so far.
    pub fn counters(&self) -> &Counters {
        &self.counters
    }

    /// Converges the stages of a step from the latest accepted state at `from` to `to` \[s\], with
    /// the conditions of the time `last` at its end; the step is not accepted. Returns the number
    /// of iterations.
    ///
    /// # Errors
    /// The iteration does not converge: the step is not repeated with a shorter one.
    pub fn converge(
        &mut self,
        dae: &mut dyn Dae,
        [from, to]: [f64; 2],
        last: f64,
    ) -> Result<usize, StepFailure> {
        let length = to - from;
        for stage in 0..self.formula.stages {
            let position = self.formula.positions[stage];
            let since = (1.0 + position) * length;
            let time = if position < 0.0 { from + since } else { last };
            dae.predict(stage, [time, since], &self.zero, &self.zero);
        }
        let mut changes = std::mem::take(&mut self.guess);
        let mut rates = vec![0.0; changes.len()];
        dae.past(0.0, &mut changes, &mut rates);
        let algebraic = dae.algebraic().iter();
        let of_algebraic = rates.iter_mut().zip(algebraic).filter(|(_, is)| **is);
        of_algebraic.for_each(|(rate, _)| *rate = 0.0);
        self.guess = rates;
        let weights = self.formula.step_weights(length);
        let clock = || 0.0;
        let mut meter = Meter::new(&mut self.counters, &clock, 0.0);
        let (guess, limits) = (&self.guess, &self.limits);
        let found = (self.corrector).converge_from(dae, &weights, guess, limits, &mut meter);
        self.counters.accept(length);
        found.map_err(|reason| self.failure(dae, reason, [from, length]))
    }

    /// The matrix of all stages at the converged step of `length` \[s\], before it is accepted:
    /// `h a_st F_xi + delta_st F_K`, the columns of algebraic unknowns `delta_st F_lambda`.
    pub fn matrix(&mut self, dae: &mut dyn Dae, length: f64) -> Sparse {
        let mut matrix = Sparse::zero(Arc::clone(self.matrix.pattern()));
        let weights = self.formula.step_weights(length);
        self.matrix.combine(dae, &weights, (&mut matrix, None));
        matrix
    }

    fn failure(&self, dae: &dyn Dae, reason: Reason, [time, length]: [f64; 2]) -> StepFailure {
        let worst = self.corrector.worst();
        StepFailure {
            reason,
            time,
            length,
            least: length,
            worst,
            equation: Box::new(dae.name(worst.index)),
            local_error: None,
            history: self.corrector.history().to_vec(),
        }
    }
}
