//! The Newton iteration of a step, for all stages of a scheme at once.
//!
//! Unknowns are the corrections `d_t` of the rates of each stage, and of the algebraic unknowns
//! themselves. A stage changes by `dy_s = h sum_t a_st d_t` and `dy'_s = d_s`, so that the
//! block of row s and column t is
//!
//! ```text
//! h a_st F_y + delta_st F_y'        (columns of algebraic unknowns: delta_st F_y)    (D-112)
//! ```
//!
//! A Jacobian that is kept over steps turns with the nodes, see [`Dae::turn_back`].

use std::sync::Arc;

use super::formula::{Formula, STAGES};
use super::meter::Meter;
use super::{Dae, Jacobians, Reason, StepLimits};
use crate::assembly::{Combination, Pattern, Residual, Sparse};
use crate::solver::{Iteration, StepSolver, Worst};

mod settling;
mod stages;

pub(super) use stages::StageMatrix;

/// Ratio of corrections above which a Jacobian kept over steps is computed anew.
const SLOW: f64 = 0.3;

/// Corrections with a Jacobian kept over steps of which the ratio is not judged: the first one
/// corrects the prediction, and the second one the errors of the Jacobian in other unknowns.
const FIRST_USES: usize = 2;

/// The same for a Jacobian kept in a step.
const SLOW_IN_STEP: f64 = 0.1;

/// Ratio to the limit at which corrections with a kept Jacobian end: they decrease at different
/// rates in different directions, and in a direction of little inertia, such as the spin of a
/// slender link, a small correction is a large change of the rate.
const OF_KEPT: f64 = 1e-2;

/// Least size of corrections with a kept Jacobian, and least residual that is waited for [-]: if a
/// smaller correction is required, full Newton does not keep a Jacobian.
const FLOOR: f64 = 1e-13;

/// Number of corrections in a step after which a kept Jacobian is computed anew: they then cost
/// as much as a Jacobian.
const USES: usize = 5;

/// Change of the weights of the scheme times the step above which a kept Jacobian is computed
/// anew: corrections would not decrease faster than this.
const CHANGED: f64 = 0.1;

/// Size above which a correction leads to another solution [sizes of the system, or rad].
const BEYOND_REASON: f64 = 10.0;

/// Growth of corrections, beyond the first one, that means divergence if it occurs twice.
const GROWTH: f64 = 2.0;

/// Initial capacity of the history of an iteration.
const INITIAL_CAPACITY: usize = 100;

/// The conditions for which a Jacobian was computed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Kept {
    /// Weights of the scheme times the step [s].
    weights: [[f64; STAGES]; STAGES],
    /// Whether it was computed in the current step.
    is_of_this_step: bool,
    /// Number of corrections found with it in this step.
    uses: usize,
}

/// Corrects the stages of a step, from their prediction, until the equations are satisfied.
#[derive(Debug)]
pub(super) struct Corrector {
    stages: usize,
    algebraic: Vec<bool>,
    matrix: StageMatrix,
    solver: StepSolver,
    kept: Option<Kept>,
    residuals: Vec<Residual>,
    /// Right side, then the correction: the stages of an unknown are adjacent.
    solution: Vec<f64>,
    /// Corrections so far, and the last one, of each stage.
    corrections: Vec<Vec<f64>>,
    last: Vec<Vec<f64>>,
    moved: Vec<f64>,
    rates: Vec<f64>,
    history: Vec<Iteration>,
    /// First iteration used for the rate of convergence.
    first: usize,
    worst: Worst,
}

impl Corrector {
    /// A corrector for schemes of `stages` stages.
    pub fn new(dae: &dyn Dae, stages: usize, limits: &StepLimits) -> Self {
        let pattern = dae.pattern();
        let n = pattern.size();
        let matrix = StageMatrix::new(pattern, stages, dae.algebraic());
        let zero = || vec![0.0; n];
        let residual = || Residual {
            values: zero(),
            sizes: zero(),
        };
        Self {
            stages,
            algebraic: dae.algebraic().to_vec(),
            solver: StepSolver::new(matrix.pattern()),
            matrix,
            kept: None,
            residuals: (0..stages).map(|_| residual()).collect(),
            solution: vec![0.0; stages * n],
            corrections: (0..stages).map(|_| zero()).collect(),
            last: (0..stages).map(|_| zero()).collect(),
            moved: zero(),
            rates: zero(),
            history: Vec::with_capacity(limits.iterations.min(INITIAL_CAPACITY)),
            first: 0,
            worst: Worst::default(),
        }
    }

    /// Removes the Jacobian and all data kept from it.
    pub fn forget(&mut self) {
        self.kept = None;
        self.solver.forget();
    }

    /// Iterations of the last step.
    pub fn history(&self) -> &[Iteration] {
        &self.history
    }

    /// The worst equation at the end of the last step.
    pub fn worst(&self) -> Worst {
        self.worst
    }

    /// Change of the last stage from its prediction.
    pub fn moved(&self) -> &[f64] {
        &self.moved
    }

    /// Iterates from the predicted stages; returns the number of iterations if they converge.
    pub fn converge(
        &mut self,
        dae: &mut dyn Dae,
        formula: &Formula,
        length: f64,
        limits: &StepLimits,
        meter: &mut Meter<'_>,
    ) -> Result<usize, Reason> {
        self.begin();
        self.iterate(dae, &formula.step_weights(length), limits, meter)
    }

    /// The same from other rates than predicted: `rates`, of each unknown, are added to the
    /// prediction at all stages.
    pub fn converge_from(
        &mut self,
        dae: &mut dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        rates: &[f64],
        limits: &StepLimits,
        meter: &mut Meter<'_>,
    ) -> Result<usize, Reason> {
        self.begin();
        for last in &mut self.last {
            last.copy_from_slice(rates);
        }
        self.apply(dae, weights);
        self.iterate(dae, weights, limits, meter)
    }

    fn iterate(
        &mut self,
        dae: &mut dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        limits: &StepLimits,
        meter: &mut Meter<'_>,
    ) -> Result<usize, Reason> {
        loop {
            // The first iterate is never the last: if its Jacobian is due, residuals and
            // derivatives come from one evaluation.
            let is_both = self.history.len() == self.first && self.is_due(weights, limits);
            if is_both {
                self.evaluate(dae, weights, meter)
            } else {
                self.find_residuals(dae, meter)
            }
            if let Err(reason) = self.find_worst(dae) {
                if is_both {
                    // The current factors belong to another matrix.
                    self.kept = None;
                }
                return Err(reason);
            }
            if self.is_settled(limits) {
                return Ok(self.history.len());
            }
            if self.history.len() >= limits.iterations {
                return Err(Reason::NotConverged);
            }
            if is_both || self.is_due(weights, limits) {
                if !is_both {
                    self.combine(dae, weights, meter);
                }
                self.factorize(weights, meter)?;
                if limits.jacobians == Jacobians::Modified {
                    dae.hold();
                }
            }
            let size = self.find_correction(dae, weights, meter)?;
            self.history.push(Iteration {
                worst: self.worst,
                correction: size,
            });
            if self.leads_astray(size)? {
                self.begin_again(dae, weights);
                continue;
            }
            self.apply(dae, weights);
            if self.is_last(size, limits) {
                return Ok(self.history.len());
            }
        }
    }

    fn begin(&mut self) {
        self.history.clear();
        self.first = 0;
        for correction in &mut self.corrections {
            correction.fill(0.0);
        }
        if let Some(kept) = &mut self.kept {
            kept.is_of_this_step = false;
            kept.uses = 0;
        }
    }

    /// Returns to the prediction, without the Jacobian of the diverging corrections.
    fn begin_again(&mut self, dae: &mut dyn Dae, weights: &[[f64; STAGES]; STAGES]) {
        for last in &mut self.last {
            last.fill(0.0);
        }
        for correction in &mut self.corrections {
            correction.fill(0.0);
        }
        self.apply(dae, weights);
        self.kept = None;
        self.first = self.history.len();
    }

    fn find_residuals(&mut self, dae: &mut dyn Dae, meter: &mut Meter<'_>) {
        for (stage, residual) in self.residuals.iter_mut().enumerate() {
            dae.residual(stage, residual);
        }
        meter.end_phase(|counters| &mut counters.residual_time);
    }

    /// The worst equation of all stages.
    fn find_worst(&mut self, dae: &dyn Dae) -> Result<(), Reason> {
        self.worst = Worst::default();
        for residual in &self.residuals {
            if let Some(index) = residual.values.iter().position(|value| !value.is_finite()) {
                let relative = f64::INFINITY;
                let scale = f64::INFINITY;
                self.worst = Worst {
                    relative,
                    index,
                    scale,
                };
                return Err(Reason::NotFinite);
            }
            let worst = dae.worst(residual);
            if worst.relative > self.worst.relative {
                self.worst = worst;
            }
        }
        Ok(())
    }

    fn is_due(&self, weights: &[[f64; STAGES]; STAGES], limits: &StepLimits) -> bool {
        let Some(kept) = &self.kept else {
            return true;
        };
        let all = || kept.weights.iter().flatten().zip(weights.iter().flatten());
        let most = all().fold(0.0_f64, |most, (kept, _)| most.max(kept.abs()));
        let has_changed = all().any(|(kept, now)| (kept - now).abs() > CHANGED * most);
        let (slow, is_old) = match limits.jacobians {
            Jacobians::Full => {
                let is_kept = kept.is_of_this_step && OF_KEPT * limits.correction >= FLOOR;
                (Some(SLOW_IN_STEP), !is_kept)
            }
            Jacobians::Modified if kept.is_of_this_step => (Some(SLOW_IN_STEP), false),
            Jacobians::Modified => ((kept.uses > FIRST_USES).then_some(SLOW), false),
        };
        let theta = self.shrinking();
        let is_slow = slow.is_some_and(|slow| theta.is_some_and(|theta| theta > slow));
        let is_stuck = !kept.is_of_this_step && self.is_at_floor();
        is_old || has_changed || is_slow || is_stuck || kept.uses >= USES
    }

    /// Residuals and derivatives of all stages in one evaluation.
    fn evaluate(
        &mut self,
        dae: &mut dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        meter: &mut Meter<'_>,
    ) {
        let residuals = &mut self.residuals[..];
        let out = (self.solver.matrix_mut(), Some(residuals));
        self.matrix.combine(dae, weights, out);
        meter.end_phase(|counters| &mut counters.jacobian_time);
    }

    /// Derivatives of all stages.
    fn combine(
        &mut self,
        dae: &mut dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        meter: &mut Meter<'_>,
    ) {
        let out = (self.solver.matrix_mut(), None);
        self.matrix.combine(dae, weights, out);
        meter.end_phase(|counters| &mut counters.jacobian_time);
    }

    fn factorize(
        &mut self,
        weights: &[[f64; STAGES]; STAGES],
        meter: &mut Meter<'_>,
    ) -> Result<(), Reason> {
        let pivotings = self.solver.counts().pivotings;
        let factorized = self.solver.factorize_written();
        meter.counters.pivotings += self.solver.counts().pivotings - pivotings;
        meter.counters.jacobians += 1;
        meter.end_phase(|counters| &mut counters.factorization_time);
        self.kept = None;
        factorized.ok_or_else(|| self.why_singular())?;
        self.kept = Some(Kept {
            weights: *weights,
            is_of_this_step: true,
            uses: 0,
        });
        Ok(())
    }

    /// Whether the last Jacobian may be nearly singular.
    pub fn is_doubtful(&self) -> bool {
        self.solver.is_doubtful()
    }

    /// Replaces `right` by the change of the unknowns of the last stage that reduces its
    /// residual by `right`; `None` if the last Jacobian is not doubtful, or not kept.
    pub fn response(&mut self, right: &mut [f64]) -> Option<()> {
        if !self.solver.is_doubtful() {
            return None;
        }
        let (stages, stage) = (self.stages, self.stages - 1);
        self.solution.fill(0.0);
        for (i, value) in right.iter().enumerate() {
            self.solution[stages * i + stage] = *value;
        }
        self.solver.respond(&mut self.solution)?;
        for (i, value) in right.iter_mut().enumerate() {
            *value = self.solution[stages * i + stage];
        }
        Some(())
    }

    /// The reason why the Jacobian was not factorized.
    fn why_singular(&self) -> Reason {
        if self.solver.is_finite() {
            Reason::Singular
        } else {
            Reason::NotFinite
        }
    }

    /// Solves for the last correction; returns its size.
    fn find_correction(
        &mut self,
        dae: &dyn Dae,
        weights: &[[f64; STAGES]; STAGES],
        meter: &mut Meter<'_>,
    ) -> Result<f64, Reason> {
        let stages = self.stages;
        let is_of_past = self.kept.is_some_and(|kept| !kept.is_of_this_step);
        for (stage, residual) in self.residuals.iter().enumerate() {
            let mut equations = &residual.values;
            if is_of_past {
                self.moved.copy_from_slice(equations);
                dae.turn_back(stage, &mut self.moved);
                equations = &self.moved;
            }
            for (i, value) in equations.iter().enumerate() {
                self.solution[stages * i + stage] = -value;
            }
        }
        let pivotings = self.solver.counts().pivotings;
        let solved = self.solver.solve(&mut self.solution);
        meter.counters.pivotings += self.solver.counts().pivotings - pivotings;
        meter.counters.iterations += 1;
        solved.ok_or(Reason::Singular)?;
        if let Some(kept) = &mut self.kept {
            kept.uses += 1;
        }
        for (stage, last) in self.last.iter_mut().enumerate() {
            for (i, value) in last.iter_mut().enumerate() {
                *value = self.solution[stages * i + stage];
            }
            if is_of_past {
                dae.turn_forth(stage, last);
            }
        }
        let mut size = 0.0_f64;
        for stage in 0..stages {
            self.move_by(stage, weights, Moves::Last);
            // `f64::max` ignores NaN: it must be checked separately.
            let is_finite = self.moved.iter().all(|moved| moved.is_finite());
            size = if is_finite {
                size.max(dae.size(stage, &self.moved))
            } else {
                f64::INFINITY
            };
        }
        meter.end_phase(|counters| &mut counters.solution_time);
        Ok(size)
    }

    /// Whether the iteration must restart with a new Jacobian.
    fn leads_astray(&self, size: f64) -> Result<bool, Reason> {
        let is_kept = self.kept.is_some_and(|kept| !kept.is_of_this_step);
        let history = &self.history[self.first..];
        let first = history.first().map_or(0.0, |first| first.correction);
        // Corrections may alternate while they become smaller.
        let grows =
            |pair: &&[Iteration]| pair[1].correction > first.max(GROWTH * pair[0].correction);
        let growths = history.windows(2).filter(grows).count();
        let is_astray = !size.is_finite() || size > BEYOND_REASON;
        if is_kept {
            let is_slow = self.shrinking().is_some_and(|theta| theta >= 1.0);
            return Ok(is_astray || is_slow);
        }
        if is_astray || growths > 1 {
            Err(Reason::Diverged)
        } else {
            Ok(false)
        }
    }

    /// Adds the last correction and updates the stages.
    fn apply(&mut self, dae: &mut dyn Dae, weights: &[[f64; STAGES]; STAGES]) {
        for (sum, last) in self.corrections.iter_mut().zip(&self.last) {
            for (sum, last) in sum.iter_mut().zip(last) {
                *sum += last;
            }
        }
        for stage in 0..self.stages {
            self.move_by(stage, weights, Moves::All);
            dae.correct(stage, &self.moved, &self.rates);
        }
    }

    /// Change of a stage by a correction of the rates of all stages.
    fn move_by(&mut self, stage: usize, weights: &[[f64; STAGES]; STAGES], moves: Moves) {
        let corrections = match moves {
            Moves::Last => &self.last,
            Moves::All => &self.corrections,
        };
        let own = &corrections[stage];
        for (i, &is_algebraic) in self.algebraic.iter().enumerate() {
            if is_algebraic {
                self.moved[i] = own[i];
                self.rates[i] = 0.0;
                continue;
            }
            let weighted = corrections.iter().zip(&weights[stage]);
            self.moved[i] = weighted.map(|(rates, weight)| weight * rates[i]).sum();
            self.rates[i] = own[i];
        }
    }
}

/// The corrections that change a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Moves {
    Last,
    All,
}
