//! Interface of a differential-algebraic system to the integrators.

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
    /// The time just after it, at which conditions are evaluated [s].
    pub after: f64,
}

/// Jumps that a system finds just after a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Renewal {
    /// Unknown: the next step does not use the rates.
    Unknown,
    /// No relevant jump: all previous states remain usable.
    Smooth,
    /// The rates, which may have jumped: if they have, no state before the latest is usable.
    Rates,
    /// Velocities have jumped, and the rates with them: no state before the latest is usable.
    Velocities,
}

/// A system `F(y, y', t) = 0` with its two latest accepted states and the trial states.
///
/// The integration schemes use numbers: y is the change of each unknown since the latest accepted
/// state, where all are zero. Unknowns that are rotations are Gibbs-Rodrigues parameters relative
/// to it, with the angular velocity as rate there. A trial state, one per stage of the formula, is
/// set by a prediction and moved by corrections `dy`, `dy'` from it: sums for most unknowns,
/// compositions with the predicted orientation for rotations. Algebraic unknowns have no rate: the
/// entries of the rates at their indices are zero and ignored.
///
/// After the first steps nothing here allocates.
pub trait Dae {
    /// The pattern of `F_y` and `F_y'`, with the whole diagonal.
    fn pattern(&self) -> &Arc<Pattern>;

    /// Whether each unknown is algebraic: a multiplier, without rate.
    fn algebraic(&self) -> &[bool];

    /// The latest accepted state, for zero, or the one before it, for the length of the step between
    /// them `ago` \[s\]: its change from the latest, which is zero for the latest, and its rates.
    fn past(&self, ago: f64, y: &mut [f64], rates: &mut [f64]);

    /// Makes the latest accepted state consistent with the conditions just after a corner: the
    /// rates of momenta and the multipliers, which jump with forces, and the velocities, which jump
    /// with the rates of driven motions. `step` is the step wanted after it \[s\]: jumps that move
    /// nothing in it are ignored.
    fn renew(&mut self, _corner: &Corner, _step: f64) -> Renewal {
        Renewal::Unknown
    }

    /// Sets trial state `stage` (0 to 2), with the conditions of a time and the time since the latest
    /// accepted state \[s\], from a prediction of its change from that state, and of its rates.
    fn predict(&mut self, stage: usize, times: [f64; 2], y: &[f64], rates: &[f64]);

    /// Moves trial state `stage` from its prediction by the total corrections so far.
    fn correct(&mut self, stage: usize, y: &[f64], rates: &[f64]);

    /// The residual of trial state `stage`, with the sizes of its terms.
    fn residual(&mut self, stage: usize, out: &mut Residual);

    /// Sums of derivatives at trial state `stage` by the corrections, and the residual if it is
    /// requested.
    fn jacobian(
        &mut self,
        stage: usize,
        out: &mut [Combination<'_>],
        residual: Option<&mut Residual>,
    );

    /// Remembers the predictions of the step as the ones at which a Jacobian is computed that later
    /// steps may use.
    fn hold(&mut self) {}

    /// Turns numbers of the equations of trial state `stage` back to the attitudes at the remembered
    /// prediction, at which the kept Jacobian is known.
    fn turn_back(&self, _stage: usize, _equations: &mut [f64]) {}

    /// Turns corrections of the unknowns of trial state `stage`, found with the kept Jacobian, to the
    /// present attitudes.
    fn turn_forth(&self, _stage: usize, _unknowns: &mut [f64]) {}

    /// Makes trial state `stage` the latest accepted one; the latest so far becomes the previous
    /// one.
    fn accept(&mut self, stage: usize);

    /// The first time after `time` at which the system has a corner or a jump \[s\];
    /// infinite when there is none.
    fn next_corner(&self, time: f64) -> f64;

    /// The longest step from `time` that does not skip a prescribed change in time, such as a short
    /// pulse \[s\].
    fn longest_step(&self, _time: f64) -> f64 {
        f64::INFINITY
    }

    /// The equation with the largest residual relative to the largest term of its kind.
    fn worst(&self, residual: &Residual) -> Worst;

    /// Size of a correction of trial state `stage` relative to the sizes of the unknowns [-].
    fn size(&self, stage: usize, correction: &[f64]) -> f64;

    /// Size of a local error, of positions and rotations alone [-].
    fn error(&self, difference: &[f64]) -> f64;

    /// Size of a local error of the scalars alone, in a step to trial state `stage` with too few
    /// previous states for [`Self::drift`] [-].
    fn error_of_scalars(&self, _stage: usize, _difference: &[f64]) -> f64 {
        0.0
    }

    /// Velocities, and other quantities whose rates jump with forces or voltages, of trial state
    /// `stage`, or of the latest accepted state; in numbers that are smooth as long as the
    /// conditions are.
    fn speeds(&self, stage: Option<usize>, out: &mut Vec<f64>);

    /// Size of a local error `missed` of these numbers; errors of velocities are measured by the
    /// motion in `time` \[s\]; `now` are the numbers themselves, and the largest so far [-].
    fn drift(&self, missed: &[f64], now: [&[f64]; 2], time: f64) -> f64;

    /// The unknown with the largest local error as text: quantity, owner, error, and the reference
    /// of the error.
    fn describe_error(&self, difference: &[f64]) -> String;

    /// An equation as text: quantity, owner and unit.
    fn name(&self, index: usize) -> Name;
}
