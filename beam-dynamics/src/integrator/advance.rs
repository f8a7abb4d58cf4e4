//! Accepted steps of a run.

use serde::{Deserialize, Serialize};

use super::corrector::Corrector;
use super::formula::{Formula, STAGES};
use super::lengths::{Accepted, Lengths, Plan, cut_by};
use super::limits::MOST_CROWDED;
use super::meter::Meter;
use super::prediction::Past;
use super::speeds::Speeds;
use super::{
    Corner, Counters, Dae, LocalError, Reason, Renewal, Scheme, StepFailure, StepLimits, Stepping,
};

mod errors;

/// An accepted step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepped {
    /// Time reached [s].
    pub time: f64,
    /// Length of the step [s].
    pub length: f64,
    /// Iterations of the step.
    pub iterations: usize,
    /// Longer steps that were tried before it.
    pub rejected: usize,
}

/// Integrates a system step by step.
#[derive(Debug)]
pub struct Integrator {
    scheme: Scheme,
    stepping: Stepping,
    limits: StepLimits,
    progress: Progress,
    corrector: Corrector,
    past: Past,
    /// Predicted changes of one stage.
    predicted: Vec<f64>,
    /// Predicted rates of all stages; empty for stages not used so far.
    rates: [Vec<f64>; STAGES],
    /// Predicted change at the last stage.
    end: Vec<f64>,
    /// Difference to a polynomial, of which errors are estimated.
    difference: Vec<f64>,
}

/// State of an integrator: together with the two latest accepted states of the system, the data
/// with which a continued run is identical to an uninterrupted one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// Time of the latest accepted state [s].
    pub time: f64,
    /// The effort so far.
    pub counters: Counters,
    /// Length of the last step; zero before the first [s].
    pub length: f64,
    /// Previous states with reliable rates: 0 to 2.
    known: usize,
    /// The corner just after which the system must be renewed.
    corner: Option<Corner>,
    /// Successive steps that corners made far shorter than wanted.
    #[serde(default)]
    crowded: usize,
    lengths: Lengths,
    /// Velocities of the previous states, for variable steps.
    #[serde(default)]
    speeds: Speeds,
}

impl Progress {
    /// Copies `other` without allocating.
    fn copy_from(&mut self, other: &Self) {
        let mut speeds = std::mem::take(&mut self.speeds);
        speeds.copy_from(&other.speeds);
        *self = Self { speeds, ..*other };
    }
}

/// Corners are crowded if they make steps shorter than this fraction of the wanted length,
/// [`MOST_CROWDED`] times in succession.
const CROWDED: f64 = 1e-4;

/// Largest extrapolation of the cubic through two states, in previous steps.
const REACH: f64 = 4.0;

/// Jump of a rate, relative to its change in the previous step, below which it is ignored. That
/// change is of the order of h: the jump adds once an error of the order of h^2 to a two-step
/// scheme, the order of the scheme's error over a whole run.
const SMALL_JUMP: f64 = 0.5;

/// Jump of a rate, relative to the rate, below which it is ignored: at an extremum of a rate, the
/// scheme's own error is more than the change of the rate in a step.
const SLIGHT_JUMP: f64 = 1e-3;

/// Jump of a rate, relative to the largest rate, below which it is ignored: the error left by the
/// iteration.
const ROUND_OFF: f64 = 1e-6;

/// Whether a rate jumps between `now` and `after` by more than its change since the state `before`.
/// Each rate is judged separately: a light body's is not hidden by the motion of a heavy one.
fn is_jump([before, now, after]: [&[f64]; 3]) -> bool {
    let largest = |rates: &[f64]| rates.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let least = ROUND_OFF * largest(now).max(largest(after));
    let rates = before.iter().zip(now).zip(after);
    let mut jumps = rates.map(|((before, now), after)| {
        let slight = SLIGHT_JUMP * now.abs().max(after.abs());
        let changed = SMALL_JUMP * (now - before).abs();
        (after - now).abs() > changed.max(slight).max(least)
    });
    jumps.any(|is_jump| is_jump)
}

impl Integrator {
    /// An integrator of `dae`, whose latest accepted state is at time `from` \[s\], rates included;
    /// earlier states are ignored.
    pub fn new(
        dae: &dyn Dae,
        scheme: Scheme,
        stepping: Stepping,
        limits: StepLimits,
        from: f64,
    ) -> Self {
        let n = dae.pattern().size();
        let zero = || vec![0.0; n];
        let mut speeds = Speeds::default();
        if matches!(stepping, Stepping::Variable(_)) {
            speeds.restart(dae, from);
        }
        Self {
            scheme,
            stepping,
            limits,
            progress: Progress {
                time: from,
                counters: Counters::default(),
                length: 0.0,
                known: 1,
                corner: None,
                crowded: 0,
                lengths: Lengths::new(&stepping, from),
                speeds,
            },
            corrector: Corrector::new(dae, scheme.formula(1.0).stages, &limits),
            past: Past::new(n),
            predicted: zero(),
            rates: Default::default(),
            end: zero(),
            difference: Vec::new(),
        }
    }

    /// Makes one accepted step towards `until` \[s\] and not beyond, with shorter trials if
    /// necessary; returns no step once `until` is reached. `until` and the corners of the system
    /// are reached exactly, to the last bit; at the end of a step to a corner, the conditions just
    /// before the corner apply. `clock` returns the elapsed time \[s\], for the times of the
    /// phases.
    ///
    /// # Errors
    ///
    /// If the least step fails; the latest accepted state is unchanged.
    pub fn step(
        &mut self,
        dae: &mut dyn Dae,
        until: f64,
        clock: &dyn Fn() -> f64,
    ) -> Result<Stepped, StepFailure> {
        let mut stepped = Stepped {
            time: self.progress.time,
            length: 0.0,
            iterations: 0,
            rejected: 0,
        };
        if until <= self.progress.time || until.is_nan() {
            return Ok(stepped);
        }
        if self.progress.crowded >= MOST_CROWDED {
            let length = self.progress.length;
            return Err(self.failure(dae, (Reason::Corners, None), length));
        }
        self.renew(dae);
        loop {
            let (time, lengths) = (self.progress.time, self.progress.lengths);
            let plan = lengths.plan(dae, &self.stepping, time, until);
            let formula = self.formula(plan.length);
            let found = self.attempt(dae, &formula, &plan, clock);
            let errors = found.ok().and_then(|_| self.errors(dae, &formula, &plan));
            let order = formula.order.min(3);
            let is_least = plan.length <= lengths.least(&self.stepping);
            let counted = errors.map(|errors| errors.counted(is_least));
            let reason = match (found, counted) {
                (Ok(_), Some(error)) if error > 1.0 || error.is_nan() => Reason::LocalError,
                (Ok(iterations), _) => {
                    let accepted = Accepted {
                        plan,
                        iterations,
                        was_cut: stepped.rejected > 0,
                        allowed: errors.map(|errors| errors.allowed(order)),
                    };
                    self.accept(dae, &formula, &accepted);
                    (stepped.time, stepped.length) = (plan.end, plan.length);
                    stepped.iterations = iterations;
                    return Ok(stepped);
                }
                (Err(reason), _) => reason,
            };
            stepped.rejected += 1;
            self.progress.counters.rejected += 1;
            let by = cut_by(counted, order, &self.stepping);
            let lengths = &mut self.progress.lengths;
            if !lengths.cut(&self.stepping, plan.length, by) {
                return Err(self.failure(dae, (reason, counted), plan.length));
            }
        }
    }

    /// After a corner, lets the system determine the jumps. If they are negligible, as at a kink of
    /// a force, the scheme continues to use the states before the corner.
    fn renew(&mut self, dae: &mut dyn Dae) {
        let Some(corner) = self.progress.corner.take() else {
            return;
        };
        let n = self.predicted.len();
        let [now, before, after] = &mut self.rates;
        for rates in [&mut *now, before, after] {
            rates.resize(n, 0.0);
        }
        dae.past(0.0, &mut self.predicted, now);
        self.progress.known = match dae.renew(&corner, self.progress.lengths.wish) {
            Renewal::Smooth => return,
            Renewal::Unknown => 0,
            Renewal::Velocities => 1,
            Renewal::Rates => {
                dae.past(0.0, &mut self.predicted, after);
                if self.progress.known > 1 {
                    dae.past(self.progress.length, &mut self.predicted, before);
                    if !is_jump([before, now, after]) {
                        return;
                    }
                }
                1
            }
        };
        self.progress.lengths.restart(&self.stepping);
        if matches!(self.stepping, Stepping::Variable(_)) {
            self.progress.speeds.restart(dae, self.progress.time);
        }
    }

    /// The formula of a step of `length`, chosen from the previous states.
    fn formula(&self, length: f64) -> Formula {
        let known = self.progress.known;
        let ratio = self.ratio(length);
        if known < 2 {
            return self.scheme.first_formula(known > 0);
        }
        if ratio <= self.scheme.largest_ratio() {
            self.scheme.formula(ratio)
        } else {
            self.scheme.first_formula(true)
        }
    }

    /// Ratio of a step to the previous one.
    fn ratio(&self, length: f64) -> f64 {
        length / self.progress.length
    }

    /// Predicts a step and iterates; returns the number of iterations.
    fn attempt(
        &mut self,
        dae: &mut dyn Dae,
        formula: &Formula,
        plan: &Plan,
        clock: &dyn Fn() -> f64,
    ) -> Result<usize, Reason> {
        let began = Meter::start(&self.progress.counters, clock);
        self.predict(dae, formula, plan);
        let mut meter = Meter::new(&mut self.progress.counters, clock, began);
        meter.end_phase(|counters| &mut counters.prediction_time);
        self.corrector
            .converge(dae, formula, plan.length, &self.limits, &mut meter)
    }

    /// Predicts the rates of all stages, and their changes by (D-100).
    fn predict(&mut self, dae: &mut dyn Dae, formula: &Formula, plan: &Plan) {
        let (past, length) = (&mut self.past, plan.length);
        dae.past(0.0, &mut past.before, &mut past.latest_rates);
        if self.progress.known > 1 {
            dae.past(
                self.progress.length,
                &mut past.before,
                &mut past.rates_before,
            );
        }
        let ratio = length / self.progress.length;
        let has_cubic = self.progress.known > 1 && ratio <= REACH;
        let positions = &formula.positions[..formula.stages];
        for (rates, position) in self.rates.iter_mut().zip(positions) {
            rates.resize(past.latest_rates.len(), 0.0);
            if has_cubic {
                past.rates((1.0 + position) * ratio, self.progress.length, rates)
            } else {
                rates.copy_from_slice(&past.latest_rates)
            }
            let algebraic = dae.algebraic().iter();
            let of_algebraic = rates.iter_mut().zip(algebraic).filter(|(_, is)| **is);
            of_algebraic.for_each(|(rate, _)| *rate = 0.0);
        }
        for stage in 0..formula.stages {
            self.predict_changes(dae.algebraic(), formula, stage, length);
            let since = (1.0 + formula.positions[stage]) * length;
            let time = match formula.positions[stage] < 0.0 {
                true => self.progress.time + since,
                // At a corner, the conditions before it.
                false => plan.corner.map_or(plan.end, |corner| corner.before),
            };
            dae.predict(stage, [time, since], &self.predicted, &self.rates[stage]);
        }
        std::mem::swap(&mut self.end, &mut self.predicted);
    }

    fn predict_changes(&mut self, algebraic: &[bool], formula: &Formula, stage: usize, h: f64) {
        let (past, weights) = (&self.past, &formula.weights[stage]);
        let latest = h * formula.latest_rates[stage];
        let before = h * formula.rates_before[stage];
        for (i, &is_algebraic) in algebraic.iter().enumerate() {
            if is_algebraic {
                self.predicted[i] = 0.0;
                continue;
            }
            let mut sum = latest * past.latest_rates[i];
            if self.progress.known > 1 {
                sum += formula.before * past.before[i] + before * past.rates_before[i];
            }
            for (rates, weight) in self.rates.iter().zip(&weights[..formula.stages]) {
                sum += h * weight * rates[i];
            }
            self.predicted[i] = sum;
        }
    }

    fn accept(&mut self, dae: &mut dyn Dae, formula: &Formula, accepted: &Accepted) {
        dae.accept(formula.stages - 1);
        let Plan {
            length,
            end,
            corner,
            ..
        } = accepted.plan;
        let progress = &mut self.progress;
        progress.time = end;
        progress.length = length;
        progress.known = (progress.known + 1).min(2);
        if matches!(self.stepping, Stepping::Variable(_)) {
            progress.speeds.accept(dae, end, length);
        }
        let is_short = length < CROWDED * self.stepping.wanted();
        progress.crowded = if corner.is_some() && is_short {
            progress.crowded + 1
        } else {
            0
        };
        progress.corner = corner;
        progress.counters.accept(length);
        progress
            .lengths
            .follow(accepted, &self.stepping, &self.scheme, &self.limits);
    }

    /// `error` is the local error relative to its tolerance, if it was computed.
    fn failure(
        &self,
        dae: &dyn Dae,
        (reason, error): (Reason, Option<f64>),
        length: f64,
    ) -> StepFailure {
        let worst = self.corrector.worst();
        let local_error = match (&self.stepping, error) {
            (Stepping::Variable(control), Some(error)) => Some(Box::new(LocalError {
                error: error * control.tolerance,
                tolerance: control.tolerance,
                unknown: dae.describe_error(&self.difference),
            })),
            _ => None,
        };
        StepFailure {
            reason,
            time: self.progress.time,
            length,
            least: self.progress.lengths.least(&self.stepping),
            worst,
            equation: Box::new(dae.name(worst.index)),
            local_error,
            history: self.corrector.history().to_vec(),
        }
    }

    /// Whether the equations of the latest step may be nearly singular.
    pub fn is_doubtful(&self) -> bool {
        self.corrector.is_doubtful()
    }

    /// Change of the unknowns of the last stage of the latest step if `right` is subtracted from
    /// its residual; overwrites `right`. `None` if the equations of the step are clearly not
    /// singular.
    pub fn response(&mut self, right: &mut [f64]) -> Option<()> {
        self.corrector.response(right)
    }

    /// Time of the latest accepted state \[s\].
    pub fn time(&self) -> f64 {
        self.progress.time
    }

    /// The effort so far.
    pub fn counters(&self) -> &Counters {
        &self.progress.counters
    }

    /// The data with which a run continues bit for bit. Data that are not restored, a kept Jacobian
    /// and its order of pivots, are dropped, so that this run continues like one that starts from
    /// the snapshot.
    pub fn snapshot(&mut self) -> Progress {
        self.corrector.forget();
        self.progress.clone()
    }

    /// The state of the integrator, as [`Self::snapshot`], for a run that does not continue itself.
    pub fn progress(&self) -> Progress {
        self.progress.clone()
    }

    /// Writes [`Self::progress`] to `known` without allocating.
    pub fn progress_into(&self, known: &mut Progress) {
        known.copy_from(&self.progress);
    }

    /// Continues from a snapshot; the system must have the two latest accepted states of that time.
    /// With the same scheme and stepping the run continues to the last bit; another stepping begins
    /// its grid here.
    pub fn restore(&mut self, progress: &Progress) {
        self.corrector.forget();
        self.progress = progress.clone();
        let (time, length) = (progress.time, progress.length);
        let lengths = &mut self.progress.lengths;
        lengths.resume(&self.stepping, time, length);
    }

    /// The corner at the latest accepted state, until the next step is made: conditions and driven
    /// motions may jump there.
    pub fn corner(&self) -> Option<Corner> {
        self.progress.corner
    }
}
