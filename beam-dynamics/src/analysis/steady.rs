//! Steady equilibrium in the turning frame: `F(y, 0) = 0`.
//!
//! The conditions change from the conditions of a known state to the requested ones, in steps that
//! are cut if Newton's method fails and grow again if it converges fast. If the tangent of the
//! first state is singular, masses help (`analysis/settling.rs`).

use crate::assembly::System;
use crate::case::Model;
use crate::model::{Conditions, Loading, State, TurningFrame};
use crate::solver::{LinearSolver, Newton, NewtonReport, NewtonStatus, solve};

use super::balance::{Balance, worst_equation};
use super::settling::{free_motion, settle, settle_freely};

/// Smallest step, as a part of the change of the conditions.
const SMALLEST_STEP: f64 = 1.0 / 256.0;
/// Largest number of iterations after which the next step is twice as long.
const QUICK: usize = 6;
/// Correction of the shortest step, relative to the size of the model or in radians, beyond which a start has hardly
/// any stiffness, as a blade above its stop.
const WEAK: f64 = 0.1;
/// Largest number of times that the states of annuli begin again at an equilibrium.
const MOST_BEGUN: usize = 4;
/// Difference of scalars, in parts of them, from the ones at which they begin: flaps and the Mach number with
/// induction, which the latter leave out, change them less.
const NEAR: f64 = 0.02;
/// Difference of scalars, in parts of them, of the same equilibrium.
const SAME: f64 = 1e-6;

/// An equilibrium and its effort.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    /// The state, at rest in the turning frame.
    pub state: State,
    /// Loads and other conditions.
    pub conditions: Conditions,
    /// Newton iterations, including the iterations of intermediate steps.
    pub iterations: usize,
    /// Largest residual relative to the largest term of its kind [-].
    pub residual: f64,
}

/// Reason why no equilibrium was found.
#[derive(Debug, Clone, thiserror::Error)]
#[error(
    "no steady equilibrium at {}{}: {reason}; worst equation: {equation}",
    rpm(*speed),
    part_of_loads(*part)
)]
pub struct NoEquilibrium {
    /// Speed of rotation [rad/s].
    pub speed: f64,
    /// The last part of the change to the requested conditions that was tried [-].
    pub part: f64,
    /// End of the iteration, as text.
    pub reason: String,
    /// The worst equation as text, with its residual.
    pub equation: String,
    /// Its residual relative to the largest term of its kind [-].
    pub residual: f64,
    /// The last iteration's history.
    pub report: NewtonReport,
    /// The last equilibrium on the way.
    pub last: State,
}

fn part_of_loads(part: f64) -> String {
    if part < 1.0 {
        format!(", {:.3} of the full conditions", part)
    } else {
        String::new()
    }
}

/// A speed in the unit of messages, with the necessary digits.
pub(super) fn rpm(speed: f64) -> String {
    let speed = speed * 30.0 / std::f64::consts::PI;
    if speed.abs() < 1e7 {
        format!("{} rpm", (1e3 * speed).round() / 1e3)
    } else {
        format!("{speed:.3e} rpm")
    }
}

/// Conditions between two conditions, at a part of their difference.
fn between(from: &Conditions, to: &Conditions, part: f64) -> Conditions {
    if part == 1.0 {
        return *to;
    }
    let (a, b) = (&from.loading, &to.loading);
    let mix = |a: f64, b: f64| a + part * (b - a);
    Conditions {
        frame: TurningFrame {
            angular_velocity: from
                .frame
                .angular_velocity
                .lerp(&to.frame.angular_velocity, part),
            center: to.frame.center,
        },
        loading: Loading {
            gravity: a.gravity.lerp(&b.gravity, part),
            constant: mix(a.constant, b.constant),
            proportional: mix(a.proportional, b.proportional),
            released: mix(a.released, b.released),
            resting: b.resting,
            time: to.loading.time,
            turns: to.loading.turns,
            voltages: mix(a.voltages, b.voltages),
            air: mix(a.air, b.air),
        },
    }
}

/// Finds the equilibrium under the conditions `to` from a state known under `from`.
///
/// A model without loads stays undeformed.
///
/// # Errors
/// [`NoEquilibrium`] with the worst equation of the smallest step tried.
///
/// Voltages act in full from the start, as do time and temperature. If that fails they are raised
/// from zero, together with the other conditions.
pub fn equilibrium(
    model: &Model,
    solver: &LinearSolver,
    from: (&Conditions, &State),
    to: &Conditions,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let found = directly(model, solver, from, to).or_else(|failure| {
        let mut nothing = Conditions::turning(TurningFrame {
            center: to.frame.center,
            ..TurningFrame::at_rest()
        });
        let rest = model.system.rest();
        let with = model.system.residual(&rest, &nothing).values;
        nothing.loading.voltages = 0.0;
        let is_driven = model.system.residual(&rest, &nothing).values != with;
        let raised = is_driven.then(|| {
            let balance = Balance::new(&model.system, solver, *to, rest);
            advance(&balance, &nothing, to)
        });
        raised.and_then(Result::ok).ok_or(failure)
    });
    found.map(|found| with_begun_annuli(model, solver, found))
}

/// The equilibrium in which each annulus is in the state at which it begins, the first one from the plane of
/// rotation: in stall there may be several, and the last state, from which the equilibrium was continued, may
/// have had another one. The given equilibrium if no other is found.
fn with_begun_annuli(model: &Model, solver: &LinearSolver, mut known: Equilibrium) -> Equilibrium {
    let system = &model.system;
    if system.scalars().is_empty() || known.conditions.loading.air == 0.0 {
        return known;
    }
    let scales = system.scalar_scales(|_| true);
    let apart = |one: &State, other: &State| {
        let pairs = one.scalars.iter().zip(&other.scalars);
        let change: Vec<f64> = pairs.map(|(one, other)| one - other).collect();
        scales.largest(&change, |i| one.scalars[i].abs()).part
    };
    let start = Balance::new(system, solver, known.conditions, known.state.clone());
    for _ in 0..MOST_BEGUN {
        let begun = begun(&start, &known.conditions, &known.state);
        if apart(&begun, &known.state) < NEAR {
            break;
        }
        let (balance, report) = solved(&start, known.conditions, begun);
        known.iterations += report.history.len();
        let is_other = apart(&balance.state, &known.state) > SAME;
        if report.status != NewtonStatus::Converged || !is_other {
            break;
        }
        known.state = balance.state;
        known.residual = report.worst.relative;
    }
    known
}

/// The equilibrium of a model with motions that nothing resists and nothing drives, as of a free shaft
/// with the torque that its drag needs; `None` if there is none near the undeformed state.
pub(super) fn free_equilibrium(
    model: &Model,
    solver: &LinearSolver,
    to: &Conditions,
) -> Option<Equilibrium> {
    let mut balance = Balance::new(&model.system, solver, *to, model.system.rest());
    let residual = settle_freely(&mut balance)?;
    Some(Equilibrium {
        state: balance.state,
        conditions: *to,
        iterations: 0,
        residual,
    })
}

/// [`equilibrium`] with all voltages from the start.
fn directly(
    model: &Model,
    solver: &LinearSolver,
    from: (&Conditions, &State),
    to: &Conditions,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let system = &model.system;
    let rest = system.rest();
    if is_at_rest(system, solver, &rest, to) {
        return Ok(Equilibrium {
            state: rest,
            conditions: *to,
            iterations: 0,
            residual: 0.0,
        });
    }
    // The undeformed state is an equilibrium of a frame at rest without loads.
    let nothing = Conditions::turning(TurningFrame {
        center: to.frame.center,
        ..TurningFrame::at_rest()
    });
    if from.0.frame.angular_velocity.norm() == 0.0 && to.frame != nothing.frame {
        return spun_up(&Balance::new(system, solver, *to, rest), &nothing, to);
    }
    let known = if *from.1 == rest { &nothing } else { from.0 };
    let balance = Balance::new(system, solver, *to, from.1.clone());
    match advance(&balance, known, to) {
        // The given state was not an equilibrium: from rest.
        Err(_) if known == to => advance(&balance.at(*to, rest), &nothing, to),
        other => other,
    }
}

/// The equilibrium of a turning model from the undeformed state: first the rotation, then the
/// loads. A hinged blade needs its tension before it can carry loads: under the loads alone it
/// would hang, and swing up to a state beyond the hub.
fn spun_up(
    rest: &Balance<'_>,
    nothing: &Conditions,
    to: &Conditions,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let mut turning = Conditions::turning(to.frame);
    turning.loading.resting = to.loading.resting;
    let first = advance(rest, nothing, &turning)?;
    if turning == *to {
        return Ok(first);
    }
    let mut loaded = advance(&rest.at(*to, first.state), &turning, to)?;
    loaded.iterations += first.iterations;
    Ok(loaded)
}

/// Whether `to` has no effect on the undeformed state: the residual is identical to the residual
/// without loads, which is round-off unless springs are relaxed in another state.
fn is_at_rest(system: &System, solver: &LinearSolver, rest: &State, to: &Conditions) -> bool {
    if to.frame.angular_velocity.norm() > 0.0 {
        return false;
    }
    let nothing = Conditions::at_rest();
    let without = system.residual(rest, &nothing).values;
    system.residual(rest, to).values == without
        && Balance::new(system, solver, nothing, rest.clone()).is_round_off(&without)
}

/// Steps from `from`, under which the state of `start` is known, to `to`.
fn advance(
    start: &Balance<'_>,
    from: &Conditions,
    to: &Conditions,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let (mut reached, mut state) = (0.0, start.state.clone());
    let mut step = 1.0;
    let mut iterations = 0;
    // `reached` and `step` are parts of the change: no step is below SMALLEST_STEP.
    loop {
        let next: f64 = f64::min(reached + step, 1.0);
        // Where air sets in, all annuli begin at the same of several steady states that stall may have.
        let sets_in = reached == 0.0 && from.loading.air == 0.0;
        let begun = || from_begun_scalars(start, between(from, to, next), &state);
        let (mut balance, mut report) = sets_in
            .then(begun)
            .flatten()
            .unwrap_or_else(|| solved(start, between(from, to, next), state.clone()));
        iterations += report.history.len();
        let quick = report.history.len() <= QUICK;
        if report.status != NewtonStatus::Converged && reached == 0.0 && from != to {
            // Newton's method may fail at once for any length of the step.
            balance = start.at(between(from, to, next), state.clone());
            if is_singular(start, from, to, Newton::default().largest)
                && let Some(settled) = settle(&mut balance, false)
            {
                iterations += settled.history.len();
                report = settled;
            }
        }
        if report.status != NewtonStatus::Converged
            && !sets_in
            && let Some((begun, found)) = begun()
        {
            iterations += found.history.len();
            (balance, report) = (begun, found);
        }
        if report.status != NewtonStatus::Converged {
            step *= 0.5;
            if step < SMALLEST_STEP || from == to {
                let settled =
                    (reached == 0.0 && from != to).then(|| settled_slowly(start, from, to));
                let failure = || Box::new(no_equilibrium(&balance, (next, state), report));
                return settled.flatten().ok_or_else(failure);
            }
        } else if next < 1.0 {
            (reached, state) = (next, balance.state);
            step = if quick { 2.0 * step } else { step };
        } else {
            return Ok(Equilibrium {
                state: balance.state,
                conditions: *to,
                iterations,
                residual: report.worst.relative,
            });
        }
    }
}

/// The equilibrium under conditions by short steps, as of a blade that falls onto its stop.
fn settled_slowly(start: &Balance<'_>, from: &Conditions, to: &Conditions) -> Option<Equilibrium> {
    if !is_singular(start, from, to, WEAK) {
        return None;
    }
    let mut balance = start.at(*to, start.state.clone());
    let report = settle(&mut balance, true)?;
    Some(Equilibrium {
        state: balance.state,
        conditions: *to,
        iterations: report.history.len(),
        residual: report.worst.relative,
    })
}

/// Newton's method from a state whose scalars begin near their values at rest, as the velocities of annuli
/// at their own steady states: in stall there is none near the last ones. `None` without such scalars, and
/// where it does not converge.
fn from_begun_scalars<'a>(
    start: &Balance<'a>,
    conditions: Conditions,
    state: &State,
) -> Option<(Balance<'a>, NewtonReport)> {
    let begun = begun(start, &conditions, state);
    if begun == *state {
        return None;
    }
    let found = solved(start, conditions, begun);
    (found.1.status == NewtonStatus::Converged).then_some(found)
}

/// A state with the scalars at which it begins.
fn begun(start: &Balance<'_>, conditions: &Conditions, state: &State) -> State {
    let mut begun = state.clone();
    start.system.begin_scalars(&mut begun, conditions);
    begun
}

/// Newton's method from a state.
fn solved<'a>(
    start: &Balance<'a>,
    conditions: Conditions,
    state: State,
) -> (Balance<'a>, NewtonReport) {
    let mut balance = start.at(conditions, state);
    let report = solve(&mut balance, &Newton::default());
    (balance, report)
}

/// Whether Newton's method begins with corrections beyond `largest` even for the shortest step.
fn is_singular(start: &Balance<'_>, from: &Conditions, to: &Conditions, largest: f64) -> bool {
    let conditions = between(from, to, SMALLEST_STEP);
    let mut balance = start.at(conditions, start.state.clone());
    let limits = Newton {
        iterations: 2,
        ..Newton::default()
    };
    let report = solve(&mut balance, &limits);
    let astray = |size: f64| !size.is_finite() || size > largest;
    report.status == NewtonStatus::Singular
        || report.history.iter().any(|one| astray(one.correction))
}

fn no_equilibrium(
    balance: &Balance<'_>,
    (part, last): (f64, State),
    report: NewtonReport,
) -> NoEquilibrium {
    let singular = report.status == NewtonStatus::Singular
        || report
            .history
            .iter()
            .any(|one| !one.correction.is_finite() || one.correction > Newton::default().largest);
    let (system, conditions) = (balance.system, &balance.conditions);
    let undefined = system.first_without_value(&balance.state, conditions);
    let free = || singular.then(|| free_motion(balance)).flatten();
    let reason = match undefined.map_or_else(|| free().map(Err), |found| Some(Ok(found))) {
        Some(Ok((element, why))) => format!("\"{}\" has no value: {why}", element.label()),
        Some(Err(motion)) => format!(
            "the tangent is singular: the loads or the rotation drive a motion without stiffness, \
             mostly {motion}"
        ),
        None if report.status == NewtonStatus::Singular => "the tangent is singular".to_owned(),
        None => "Newton's method did not converge".to_owned(),
    };
    NoEquilibrium {
        speed: balance.conditions.frame.angular_velocity.norm(),
        part,
        reason,
        equation: worst_equation(balance.system, &report.worst),
        residual: report.worst.relative,
        report,
        last,
    }
}
