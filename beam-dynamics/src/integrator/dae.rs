//! A differential-algebraic system as the integrators see it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::assembly::{Combination, Pattern, Residual};
use crate::model::Name;
use crate::solver::Worst;

/// A corner of a system, or several at almost the same time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Corner {
    /// The last time before it [s].
    pub before: f64,
    /// The time just after which what acts is to be asked for [s].
    pub after: f64,
}

/// What a system finds just after a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Renewal {
    /// It cannot tell: the next step does not use the rates.
    Unknown,
    /// Nothing that counts jumps: all states behind the corner still serve.
    Smooth,
    /// The rates, which may have jumped: where they have, no state before the latest
    /// serves.
    Rates,
    /// Velocities have jumped, and the rates with them: no state before the latest serves.
    Velocities,
}

/// A system `F(y, y', t) = 0` with its two latest accepted states and the states under
/// trial.
///
/// The formulas of integration see numbers: y is what each unknown has changed by since
/// the latest accepted state, where all are zero. Unknowns that are rotations are
/// Gibbs-Rodrigues parameters relative to it, with the angular velocity as rate there. A
/// trial state, one a stage of the formula, is placed by a prediction and moved by
/// corrections `dy`, `dy'` from it: sums for most unknowns, compositions with the
/// predicted orientation for rotations. Algebraic unknowns have no rate: whatever stands
/// in its place is zero and does not count.
///
/// Nothing here allocates once a few steps are done.
pub trait Dae {
    /// The pattern of `F_y` and `F_y'`, with the whole diagonal.
    fn pattern(&self) -> &Arc<Pattern>;

    /// Whether each unknown is algebraic: a multiplier, without rate.
    fn algebraic(&self) -> &[bool];

    /// The accepted state `back` (0 or 1) steps before the latest: its change from the
    /// latest, and its rates. For 0 the changes are zero; 1 is asked for after a step.
    fn past(&self, back: usize, y: &mut [f64], rates: &mut [f64]);

    /// Makes the latest accepted state agree with what acts just after a corner: the
    /// rates of momenta and the multipliers, which jump with forces, and the velocities,
    /// which jump with the rates of what is driven. `step` is the step that is wished for
    /// after it \[s\]: what moves nothing in it does not count.
    fn renew(&mut self, _corner: &Corner, _step: f64) -> Renewal {
        Renewal::Unknown
    }

    /// Places trial state `stage` (0 to 2) at `time` \[s\] by a prediction of its change
    /// from the latest accepted state, and of its rates.
    fn predict(&mut self, stage: usize, time: f64, y: &[f64], rates: &[f64]);

    /// Moves trial state `stage` from its prediction by the whole corrections so far.
    fn correct(&mut self, stage: usize, y: &[f64], rates: &[f64]);

    /// The residual of trial state `stage`, with the sizes of its terms.
    fn residual(&mut self, stage: usize, out: &mut Residual);

    /// Sums of derivatives at trial state `stage` by the corrections, and the residual where
    /// that is wanted.
    fn jacobian(
        &mut self,
        stage: usize,
        out: &mut [Combination<'_>],
        residual: Option<&mut Residual>,
    );

    /// Takes trial state `stage` as the latest accepted one; the latest so far becomes
    /// the one before it.
    fn accept(&mut self, stage: usize);

    /// The first time after `time` at which the system has a corner or a jump \[s\];
    /// infinite when there is none.
    fn next_corner(&self, time: f64) -> f64;

    /// The longest step from `time` that does not pass over what is given over time, as a
    /// short pulse \[s\].
    fn longest_step(&self, _time: f64) -> f64 {
        f64::INFINITY
    }

    /// The equation that is farthest from being fulfilled, by the largest term of its kind.
    fn worst(&self, residual: &Residual) -> Worst;

    /// Size of a correction of trial state `stage` relative to the sizes of the unknowns [-].
    fn size(&self, stage: usize, correction: &[f64]) -> f64;

    /// Size of a local error, of positions and rotations alone [-].
    fn error(&self, difference: &[f64]) -> f64;

    /// Size of a local error of the scalars alone, in a step to trial state `stage` before
    /// which too little is known for [`Self::drift`] [-].
    fn error_of_scalars(&self, _stage: usize, _difference: &[f64]) -> f64 {
        0.0
    }

    /// Velocities, and what else jumps in its rate where forces or voltages do, of trial
    /// state `stage`, or of the latest accepted state; in numbers that are smooth as long as
    /// what acts is.
    fn speeds(&self, stage: Option<usize>, out: &mut Vec<f64>);

    /// Size of a local error `missed` of these numbers, that of velocities by what they move
    /// in `time` \[s\]; `now` are the numbers themselves, and the largest so far [-].
    fn drift(&self, missed: &[f64], now: [&[f64]; 2], time: f64) -> f64;

    /// The unknown of the largest local error in words: what, whose, its error, and by what
    /// that is measured.
    fn describe_error(&self, difference: &[f64]) -> String;

    /// An equation in words: what, whose, and its unit.
    fn name(&self, place: usize) -> Name;
}
