//! Equilibrium from a singular tangent.
//!
//! A blade on a free hinge has no stiffness about it until it is in tension; Newton's
//! method cannot start. Backward steps of a motion that always begins at rest can:
//!
//! ```text
//! (F_y + sigma F_y') dy = -F
//! ```
//!
//! is one such step of length `1 / sigma`. Masses resist motions without stiffness. While the steps
//! succeed sigma falls; at zero this is Newton's method.
//!
//! The first step is short: the momenta of a turning model, zero at the start, jump to
//! `m omega x r`, which moves a free mass by `omega r / sigma` within it. The multipliers then
//! hold the turning model, and the tension in its parts makes the tangent regular.
//!
//! A step is linear: a rotation `phi` stretches a stiff part by `phi^2 / 2`, and the force of this stretch
//! may be far above the loads. Short steps, which are tried last, stretch it less: with them a blade falls
//! onto its stop, which has no stiffness before the contact.
//!
//! References: [KelleyKeyes1998], pseudo-transient continuation.

use super::balance::Balance;
use crate::model::{MOTION_WORDS, NODE_UNKNOWNS};
use crate::solver::{Equations, Iteration, Newton, NewtonReport, NewtonStatus, solve};

/// Largest correction of one step, relative to the size of the model or in radians.
const LARGEST: f64 = 0.3;
/// The same of short steps.
const SHORT_LARGEST: f64 = 0.02;
/// Correction below which Newton's method is tried from the state, over the largest one of a step.
const NEAR: f64 = 1.0 / 3.0;
/// Factor by which sigma falls after a step that succeeds, and rises after one that
/// does not.
const FALL: f64 = 3.0;
/// First sigma, relative to the speed of rotation.
const SHORT: f64 = 1e3;
/// Largest number of steps.
const STEPS: usize = 300;
/// Last sigma beside a free motion, relative to the speed of rotation or in 1/s.
const LAST: f64 = 1e-4;
/// Correction below which the equilibrium is found when the residual does not fall any more.
const SETTLED: f64 = 1e-7;

/// Moves `balance` to an equilibrium, by short steps or usual ones; the report of the last Newton iteration,
/// with all steps in its history, or `None` if none was found.
pub(super) fn settle(balance: &mut Balance<'_>, is_short: bool) -> Option<NewtonReport> {
    let largest = if is_short { SHORT_LARGEST } else { LARGEST };
    let start = balance.state.clone();
    let speed = balance.conditions.frame.angular_velocity.norm();
    let mut sigma = f64::max(1.0, SHORT * speed);
    let mut steps = Vec::new();
    while steps.len() < STEPS {
        let (residual, worst) = balance.residual();
        let found = step(balance, sigma, &residual);
        let size = found.as_ref().map_or(f64::NAN, |dy| balance.size(dy));
        steps.push(Iteration {
            worst,
            correction: size,
        });
        match found {
            Some(correction) if size <= largest => balance.correct(&correction),
            _ => {
                sigma *= FALL;
                continue;
            }
        }
        sigma /= FALL;
        if size > NEAR * largest {
            continue;
        }
        let mut trial = balance.clone();
        let limits = Newton {
            largest,
            ..Newton::default()
        };
        let mut report = solve(&mut trial, &limits);
        if report.status == NewtonStatus::Converged {
            balance.state = trial.state;
            steps.append(&mut report.history);
            report.history = steps;
            return Some(report);
        }
        steps.append(&mut report.history);
    }
    balance.state = start;
    None
}

/// Moves `balance` to an equilibrium with motions that nothing resists and nothing drives, as of a
/// free shaft: the steps continue with the last sigma, each of which leaves an error of sigma over the
/// frequency. After each step all nodes have the momenta of the turning model, so that no part falls
/// behind.
/// Returns the largest relative residual; `None` if the steps do not end.
pub(super) fn settle_freely(balance: &mut Balance<'_>) -> Option<f64> {
    let speed = balance.conditions.frame.angular_velocity.norm();
    let last = LAST * f64::max(1.0, speed);
    let mut sigma = f64::max(1.0, SHORT * speed);
    let mut before = f64::INFINITY;
    for _ in 0..STEPS {
        turn_along(balance);
        let (residual, worst) = balance.residual();
        let found = step(balance, sigma, &residual);
        let size = found.as_ref().map_or(f64::NAN, |dy| balance.size(dy));
        let Some(correction) = found.filter(|_| size <= LARGEST) else {
            sigma *= FALL;
            continue;
        };
        if sigma <= last && size <= SETTLED && worst.relative >= before {
            return Some(worst.relative);
        }
        balance.correct(&correction);
        before = worst.relative;
        sigma = f64::max(sigma / FALL, last);
    }
    None
}

/// Gives all nodes the momenta of the turning model.
fn turn_along(balance: &mut Balance<'_>) {
    let (residual, _) = balance.residual();
    let pairs = balance
        .state
        .nodes
        .iter_mut()
        .zip(residual.chunks(NODE_UNKNOWNS));
    for (node, rows) in pairs {
        for k in 0..3 {
            node.momentum[k] -= rows[k];
            node.angular_momentum[k] -= rows[3 + k];
        }
    }
}

fn step(balance: &Balance<'_>, sigma: f64, residual: &[f64]) -> Option<Vec<f64>> {
    let tangent = balance.system.tangent(&balance.state, &balance.conditions);
    let matrix = tangent.by_unknowns.plus(sigma, &tangent.by_rates);
    let mut correction: Vec<_> = residual.iter().map(|value| -value).collect();
    balance.solver.factorize(matrix)?.solve(&mut correction)?;
    Some(correction)
}

/// The node of the largest motion, and its direction, in the motion that only masses resist.
pub(super) fn free_motion(balance: &Balance<'_>) -> Option<String> {
    let system = balance.system;
    let nodes = system.nodes().len();
    let (residual, _) = balance.clone().residual();
    // Sigma so small that all motions with stiffness are negligible compared with the free one.
    let motion = [1e-6, 1e-4, 1e-2, 1.0]
        .into_iter()
        .find_map(|sigma| step(balance, sigma, &residual))?;
    // Displacements relative to the size of the model.
    let part = |i: &usize| match i % NODE_UNKNOWNS {
        0..3 => motion[*i].abs() / balance.reach(),
        3..6 => motion[*i].abs(),
        _ => 0.0,
    };
    let most = (0..NODE_UNKNOWNS * nodes).max_by(|a, b| part(a).total_cmp(&part(b)))?;
    let (node, unknown) = (most / NODE_UNKNOWNS, most % NODE_UNKNOWNS);
    let label = &system.nodes()[node].label;
    Some(format!(
        "{} of node \"{label}\"",
        MOTION_WORDS.get(unknown)?
    ))
}
