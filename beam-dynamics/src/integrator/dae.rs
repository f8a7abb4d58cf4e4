//! A differential-algebraic system as the integrators see it.

use std::sync::Arc;

use crate::assembly::{Combination, Pattern, Residual};
use crate::solver::Worst;

/// A system `F(y, y', t) = 0` with its accepted states and the states under trial.
///
/// The formulas of integration see numbers. Unknowns that are rotations are
/// Gibbs-Rodrigues parameters relative to the latest accepted state: there they are
/// zero, with the angular velocity as rate. A trial state, one a stage of the formula,
/// is placed by a prediction and moved by corrections `dy`, `dy'` from it, which are
/// composed with the prediction. Algebraic unknowns have no rate; their `dy` is what
/// they change by from the latest accepted state.
///
/// Nothing here allocates once a few steps are done.
pub trait Dae {
    /// The pattern of `F_y` and `F_y'`, with the whole diagonal.
    fn pattern(&self) -> &Arc<Pattern>;

    /// Whether each unknown is algebraic: a multiplier, without rate.
    fn algebraic(&self) -> &[bool];

    /// Accepted states that are kept at least.
    fn history(&self) -> usize;

    /// The accepted state `back` steps before the latest, by numbers relative to the
    /// latest, and its rates.
    fn past(&self, back: usize, y: &mut [f64], rates: &mut [f64]);

    /// Places trial state `stage` at `time` \[s\] by a prediction relative to the latest
    /// accepted state.
    fn predict(&mut self, stage: usize, time: f64, y: &[f64], rates: &[f64]);

    /// Moves trial state `stage` from its prediction by the whole corrections so far.
    fn correct(&mut self, stage: usize, y: &[f64], rates: &[f64]);

    /// The residual of trial state `stage`, with the sizes of its terms.
    fn residual(&mut self, stage: usize, out: &mut Residual);

    /// Sums of derivatives at trial state `stage` by the corrections.
    fn jacobian(&mut self, stage: usize, out: &mut [Combination<'_>]);

    /// Takes trial state `stage` as the latest accepted one.
    fn accept(&mut self, stage: usize);

    /// The first time after `time` at which the system has a corner \[s\].
    fn next_corner(&self, time: f64) -> f64;

    /// The equation that is farthest from being fulfilled, by the largest term of its kind.
    fn worst(&self, residual: &Residual) -> Worst;

    /// Size of a correction relative to the size of the system [-].
    fn size(&self, correction: &[f64]) -> f64;

    /// Size of a local error, of positions and rotations alone [-].
    fn error(&self, difference: &[f64]) -> f64;

    /// An equation in words: what and whose.
    fn describe(&self, place: usize) -> String;
}
