//! Controls by an auto-pilot: the motion is integrated, and the controls follow the errors of the
//! targets.
//!
//! With the momentary values m of the targets, their means over a step, a filter of first order, and the
//! derivative J of the means over a period by the controls at the start,
//!
//! ```text
//! tau m_f' = m - m_f ,     u' = -G J^-1 ( m_f - m* )                              (D-322)
//! ```
//!
//! with tau and 1/G in periods. The integral over a step is exact, so that the targets need no sensors
//! of their own. A control is constant within a step.
//!
//! The controls of a period change by no more than turns a node by the angle of a correction of Newton's
//! method, because the motion follows them later, and J holds up to stall only.
//!
//! The controls do not rest, and keep weakly damped motions of the blades alive. Where the change of the
//! motion no longer falls, or a period with constant controls does not meet the targets, Newton's method finds
//! the end. Where the march fails, or does not meet the
//! targets, it begins again at the start, with targets that grow if needed.

use nalgebra::{DMatrix, DVector};

use super::approach::{approach, can_be_approached};
use super::failure::PeriodicFailure;
use super::flow::Flow;
use super::map::PeriodMap;
use super::passes::Passes;
use super::shooting::{Shooting, part_of};
use crate::analysis::effects;
use crate::case::AutoPilot;
use crate::model::State;
use crate::result::PeriodicPass;

/// Periods in which the change must fall to less than [`SLOW`] of the one before.
const RECENT: usize = 10;
/// See [`RECENT`] \[-\].
const SLOW: f64 = 0.5;

/// The filter and the controls.
struct Pilot<'a> {
    shooting: &'a Shooting<'a>,
    settings: AutoPilot,
    /// J^-1, of sizes one.
    inverse: DMatrix<f64>,
    /// Largest rotation of a node in the periodic motion by each control of unit size \[rad\].
    turns: Vec<f64>,
    /// Length of a step, in periods.
    step: f64,
    /// m_f.
    filtered: Vec<f64>,
    /// Integrals after the step before.
    before: Vec<f64>,
}

impl Pilot<'_> {
    /// The action after a step.
    fn act(&mut self, state: &mut State) {
        let border = self.shooting.border;
        let integrals = border.integrals(state);
        let length = self.step * self.shooting.settings.period;
        let part = 1.0 - (-self.step / self.settings.filter).exp();
        let changes = integrals.iter().zip(&self.before);
        for (filtered, (now, before)) in self.filtered.iter_mut().zip(changes) {
            *filtered += part * ((now - before) / length - *filtered);
        }
        self.before = integrals;
        let errors = DVector::from_vec(border.errors(&self.filtered));
        let change = &self.inverse * errors * -self.settings.gain;
        let turn = change.iter().zip(&self.turns);
        let turn = turn.map(|(change, turn)| change.abs() * turn).sum();
        let change = change * (part_of(turn, true) * self.step);
        let mut values = border.values(state);
        for (value, (change, scale)) in values.iter_mut().zip(change.iter().zip(border.scales())) {
            *value += change * scale;
        }
        border.set(state, &values);
    }
}

/// Marches from `state`, which becomes the last state, until the targets are met and the motion repeats;
/// returns the first state of the last period, and its end. If the march fails, Newton's method begins at
/// `state`.
pub(super) fn pilot(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    (state, settings): (&mut State, AutoPilot),
    passes: &mut Passes<'_>,
) -> Result<[State; 2], PeriodicFailure> {
    let begun = state.clone();
    match march(shooting, flow, (state, settings), passes) {
        Err(failure) if can_be_approached(&failure) => {
            state.copy_from(&begun);
            let orbit = approach(shooting, flow, state, passes)?;
            Ok([orbit.state, orbit.end])
        }
        found => found,
    }
}

/// Marches from `state` until the targets are met and the motion repeats, or its change no longer falls.
fn march(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    (state, settings): (&mut State, AutoPilot),
    passes: &mut Passes<'_>,
) -> Result<[State; 2], PeriodicFailure> {
    let border = shooting.border;
    let (mut pilot, map) = begun(shooting, flow, (state, settings))?;
    let rows = border.sizes(shooting.sizes);
    loop {
        border.begin(state);
        pilot.before = border.integrals(state);
        let end = flow.piloted(state, &mut |state| pilot.act(state))?;
        let (_, (index, part)) = shooting.residual(state, (&end, map.algebraic()), &rows);
        let worst = shooting.name(index, part, rows[index]);
        passes.push(PeriodicPass {
            residual: part,
            worst: worst.clone(),
            products: 0,
            part: 1.0,
            reached: border.reached(&end),
        });
        *state = end;
        if part <= settings.tolerance {
            // The controls of a harmonic of one blade change within a revolution: the trim is the one of
            // constant controls.
            border.begin(state);
            let end = flow.run(state, &mut |_| true)?;
            let (_, (_, held)) = shooting.residual(state, (&end, map.algebraic()), &rows);
            if held <= settings.tolerance {
                return Ok([state.clone(), end]);
            }
        }
        let is_done = part <= settings.tolerance;
        if is_done || is_slow(passes.list()) && border.at_bound(state).is_none() {
            let orbit = shooting.solve(flow, state, passes)?;
            return Ok([orbit.state, orbit.end]);
        }
        if passes.list().len() >= shooting.settings.periods || !part.is_finite() {
            return Err(match border.at_bound(state) {
                Some((control, bound)) => PeriodicFailure::bound(control, bound, worst),
                None => PeriodicFailure::NotConverged {
                    iterations: passes.list().len(),
                    worst,
                },
            });
        }
    }
}

/// The auto-pilot after a period from `state`, which becomes its end, and the linearized period.
fn begun<'a>(
    shooting: &'a Shooting<'a>,
    flow: &mut Flow<'_>,
    (state, settings): (&mut State, AutoPilot),
) -> Result<(Pilot<'a>, PeriodMap), PeriodicFailure> {
    let border = shooting.border;
    border.begin(state);
    let (end, map) = flow.linearized(state)?;
    let map = map.ok_or(PeriodicFailure::SingularStep)?;
    let singular = || PeriodicFailure::Singular {
        reason: "nothing determines the motion".to_owned(),
    };
    let response = shooting.responses(&map).ok_or_else(singular)?;
    if let Some(reason) = border.idle(&response.means, effects::EXACT) {
        return Err(PeriodicFailure::Idle { reason });
    }
    let pilot = Pilot {
        shooting,
        settings,
        inverse: response.means.try_inverse().ok_or_else(singular)?,
        turns: response.turns,
        step: 1.0 / flow.steps() as f64,
        filtered: border.reached(&end),
        before: Vec::new(),
    };
    *state = end;
    Ok((pilot, map))
}

/// Whether the smallest change of the last periods is not much smaller than the one of the periods before.
fn is_slow(passes: &[PeriodicPass]) -> bool {
    let least = |passes: &[PeriodicPass]| {
        let changes = passes.iter().map(|pass| pass.residual);
        changes.fold(f64::INFINITY, f64::min)
    };
    let Some(start) = passes.len().checked_sub(2 * RECENT) else {
        return false;
    };
    let (before, last) = passes[start..].split_at(RECENT);
    least(last) > SLOW * least(before)
}
