//! The periodic motion by integration, period after period.
//!
//! With `r_j` the change of the state in period j, the largest multiplier is about
//! `r_j / r_{j-1}`, and the periods left are `ln(tolerance / r_j) / ln |mu|`.

use super::failure::PeriodicFailure;
use super::flow::Flow;
use super::passes::Passes;
use super::sizes::{seen, worst};
use crate::case::{Model, PeriodicSettings};
use crate::model::State;
use crate::result::PeriodicPass;

/// Periods over which the ratio of the changes is averaged.
const AVERAGED: usize = 10;
/// Change relative to the smallest so far above which the motion leaves the periodic one [-].
const LEAVING: f64 = 1e6;

/// Marches from `state`; returns the first state of the last period, and its end.
pub(super) fn march(
    flow: &mut Flow<'_>,
    (model, settings): (&Model, &PeriodicSettings),
    (mut state, algebraic, sizes): (State, &[bool], &[f64]),
    passes: &mut Passes<'_>,
) -> Result<[State; 2], PeriodicFailure> {
    let mut least = f64::INFINITY;
    loop {
        let end = flow.run(&state, &mut |_| true)?;
        let (index, part) = worst(&seen(&end, &state, algebraic), sizes);
        let name = model.system.unknown(index).off_by(part, sizes[index]);
        passes.push(PeriodicPass {
            residual: part,
            worst: name.clone(),
            products: 0,
            part: 1.0,
            reached: Vec::new(),
        });
        if part <= settings.tolerance {
            return Ok([state, end]);
        }
        least = least.min(part);
        let is_over = passes.list().len() >= settings.periods || !part.is_finite();
        if is_over || part > LEAVING * least {
            let ratio = ratio(passes.list());
            let left = (settings.tolerance / part).ln() / ratio.ln();
            return Err(PeriodicFailure::NotSettled {
                periods: passes.list().len(),
                worst: name,
                ratio,
                left: (ratio < 1.0).then_some(left),
            });
        }
        state = end;
    }
}

/// Mean ratio of the changes of the last periods [-].
fn ratio(passes: &[PeriodicPass]) -> f64 {
    let [.., last] = passes else { return 1.0 };
    let count = AVERAGED.min(passes.len() - 1);
    if count == 0 {
        return 1.0;
    }
    let before = &passes[passes.len() - 1 - count];
    (last.residual / before.residual).powf(1.0 / count as f64)
}
