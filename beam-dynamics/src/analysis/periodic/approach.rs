//! Newton's method with controls where it fails from the first guesses: targets that change from the
//! means with these guesses to their values.
//!
//! ```text
//! m*_k = m_0 + a_k ( m* - m_0 ) ,     a_k = a_(k-1) + h ,   0 < a_k <= 1                       (D-343)
//! ```
//!
//! with the means m_0 of the periodic motion with the controls of the first guess. Each motion begins at
//! the one before; h is halved where Newton's method fails, and doubled after it succeeds. If it ends before
//! the values, one target after the other stays at its last mean: the one without which all others have a
//! motion is out of reach.

use super::border::Border;
use super::failure::PeriodicFailure;
use super::flow::Flow;
use super::passes::Passes;
use super::shooting::{Orbit, Shooting};
use crate::case::PeriodicSettings;
use crate::model::State;

/// First h.
const FIRST: f64 = 0.25;
/// Smallest h.
const LEAST: f64 = 1.0 / 32.0;
/// Largest number of iterations of a motion on the way.
const ITERATIONS: usize = 6;
/// Part of the scale of a target from which it counts as not met.
const NOT_MET: f64 = 1e-3;
/// Largest number of targets that are tried as the one out of reach.
const TRIED: usize = 3;

/// The periodic motion with controls near the first state `state`, which becomes the last state of the
/// search, or the last one with a motion.
pub(super) fn approach(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    state: &mut State,
    passes: &mut Passes<'_>,
) -> Result<Orbit, PeriodicFailure> {
    let begun = state.clone();
    let first = match shooting.solve(flow, state, passes) {
        Err(first) if can_be_approached(&first) && shooting.border.count() > 0 => first,
        found => return found,
    };
    let last = state.clone();
    state.copy_from(&begun);
    let within = |most: usize| PeriodicSettings {
        iterations: shooting.settings.iterations.min(most),
        ..shooting.settings.clone()
    };
    let (short, longer) = (within(ITERATIONS), within(2 * ITERATIONS));
    let held = shooting.border.held();
    let with_guess = Shooting {
        border: &held,
        ..*shooting
    };
    let Ok(orbit) = with_guess.solve(flow, state, passes) else {
        state.copy_from(&last);
        return Err(first);
    };
    // Of the motion of the first guess, which repeats: symmetries are exact in it.
    if let Some(reason) = shooting.idle(&orbit.map) {
        return Err(PeriodicFailure::Idle { reason });
    }
    let short = Shooting {
        settings: &short,
        ..*shooting
    };
    let (met, part) = grown(&short, flow, (state, orbit), passes);
    if part == 1.0 {
        return Ok(met);
    }
    let longer = Shooting {
        settings: &longer,
        ..*shooting
    };
    let (beyond, met) = match without_one(&longer, flow, (state, &met), passes) {
        Some((index, orbit)) => (Some(shooting.border.target_name(index)), orbit),
        None => (None, met),
    };
    state.copy_from(&met.state);
    let is_guess = part == 0.0 && beyond.is_none();
    Err(limited(shooting.border, (first, beyond), &met, is_guess))
}

/// The last motion that was found while the targets grow from one to their values, and the part of the way to these.
fn grown(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    (state, mut met): (&mut State, Orbit),
    passes: &mut Passes<'_>,
) -> (Orbit, f64) {
    let from = shooting.border.reached(&met.end);
    let (mut part, mut step) = (0.0, FIRST);
    while step >= LEAST {
        let next = f64::min(part + step, 1.0);
        let border = shooting.border.partly(&from, |_| next);
        let partly = Shooting {
            border: &border,
            ..*shooting
        };
        state.copy_from(&met.state);
        match partly.solve(flow, state, passes) {
            Ok(orbit) if next == 1.0 => return (orbit, next),
            Ok(orbit) => {
                (met, part) = (orbit, next);
                step = f64::min(2.0 * step, FIRST);
            }
            Err(_) => step *= 0.5,
        }
    }
    (met, part)
}

/// The index of a target without which the other ones are met, the farthest first, with the motion in which they
/// are; `None` without others, or if there is no such motion near the last one.
fn without_one(
    shooting: &Shooting<'_>,
    flow: &mut Flow<'_>,
    (state, met): (&mut State, &Orbit),
    passes: &mut Passes<'_>,
) -> Option<(usize, Orbit)> {
    let reached = shooting.border.reached(&met.end);
    let errors = shooting.border.errors(&reached);
    if errors.len() < 2 {
        return None;
    }
    let mut open: Vec<_> = (0..errors.len()).collect();
    open.retain(|index| errors[*index].abs() > NOT_MET);
    open.sort_by(|a, b| errors[*b].abs().total_cmp(&errors[*a].abs()));
    open.into_iter().take(TRIED).find_map(|index| {
        let is_free = |target| if target == index { 0.0 } else { 1.0 };
        let border = shooting.border.partly(&reached, is_free);
        let others = Shooting {
            border: &border,
            ..*shooting
        };
        state.copy_from(&met.state);
        let orbit = others.solve(flow, state, passes).ok()?;
        Some((index, orbit))
    })
}

/// The failure of a search that ended at a motion on its way, or at the one of the first guess.
fn limited(
    border: &Border,
    (first, beyond): (PeriodicFailure, Option<&str>),
    met: &Orbit,
    is_guess: bool,
) -> PeriodicFailure {
    let reached = border.reached(&met.end);
    let farthest = border.farthest(&reached);
    let differences = border.differences(&reached, NOT_MET);
    PeriodicFailure::Limited {
        first: Box::new(first),
        beyond: beyond.map_or_else(String::new, |name| {
            format!("\"{name}\" is out of reach while all other targets are met: ")
        }),
        way: if is_guess {
            format!(
                "no motion is nearer to the targets than the one of the first guess, in which \
                 \"{farthest}\" is farthest from its value: {differences}"
            )
        } else {
            format!(
                "targets that change from their values at the first guess are met up to \
                 {differences}"
            )
        },
        controls: border.written(&met.state),
        stall: String::new(),
    }
}

/// Whether the search failed on its way, not by its equations.
pub(super) fn can_be_approached(failure: &PeriodicFailure) -> bool {
    matches!(
        failure,
        PeriodicFailure::NotConverged { .. }
            | PeriodicFailure::Unreached { .. }
            | PeriodicFailure::Step(_)
    )
}
