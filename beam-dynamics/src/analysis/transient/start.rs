//! The first state of a run: positions, velocities, momenta, rates and multipliers.

use nalgebra::Vector3;

use crate::analysis::steady::equilibrium;
use crate::assembly::{MasslessMotions, System};
use crate::case::{InitialMotion, Model, Start, StartAccelerations, TransientSettings};
use crate::elements::{Level, Queries};
use crate::model::{Conditions, Drive, NODE_UNKNOWNS, State, TurningFrame};
use crate::modes::EigenProblem;
use crate::solver::LinearSolver;

use super::change::{StartChange, changes};
use super::dummy::dummy_rates;
use super::failure::TransientFailure;
use super::gravity;
use super::placing::{Unfulfilled, place, set_moving};
use super::rates::{consistent_rates, find_momenta};
use super::scalars::{self, Settling};
use super::shape;

/// Changes of the velocities of a rotating equilibrium up to this part of the fastest are ignored.
const TURNS: f64 = 1e-6;

/// Number of real eigenvalues computed, nearest to zero, and their multiplicity.
const COUNT: usize = 4;
/// Growth over a run, as an exponent of e, above the round-off of motions at rest.
const SEEN: f64 = 0.1;
/// Relative residual below which an eigenvalue is accepted.
const SURE: f64 = 1e-6;

/// Largest number of rounds in which scalars and the joints that follow them are made consistent,
/// and the tolerance, relative to the scalar or absolute.
const ROUNDS: usize = 30;
const AGREED: f64 = 1e-9;

/// Difference of driven velocities, as a part of the speed at which a model should turn, above
/// which they belong to another motion; the deformation causes smaller ones.
const FAR: f64 = 0.1;

/// The first state, and its remarks.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct Started {
    /// The state.
    pub state: State,
    /// Changes of the given state.
    pub changes: Vec<StartChange>,
    /// Remarks.
    pub remarks: Vec<String>,
}

/// The first state of a run.
pub(in crate::analysis) fn start(
    model: &Model,
    settings: &TransientSettings,
) -> Result<Started, TransientFailure> {
    let system = &model.system;
    let conditions = model.conditions_at(settings.from);
    let (kind, remarks) = given(model, settings, &conditions)?;
    let given = with_velocities(kind, &model.initial);
    let (mut state, remark) = placed(model, settings, &conditions, &given)?;
    let changes = changes(model, &given, &state);
    let settle = |state: &mut State| {
        let settled = scalars::settle(system, state, &conditions, Settling::InMotion);
        settled.map_err(TransientFailure::Scalars)
    };
    settle(&mut state)?;
    if !state.memory.is_empty() {
        // The memory of the start applies from there on.
        system.begin_memory(&mut state, &conditions);
        settle(&mut state)?;
    }
    find_momenta(system, &mut state, &conditions);
    let mut started = Started {
        state,
        changes,
        remarks: remarks.into_iter().chain(remark).collect(),
    };
    find_rates(model, settings, &conditions, &mut started)?;
    Ok(started)
}

/// Positions, velocities and scalars that are consistent with each other, as near to the `given`
/// ones as the constraints allow, and a remark if they are not at rest as required.
fn placed(
    model: &Model,
    settings: &TransientSettings,
    conditions: &Conditions,
    given: &State,
) -> Result<(State, Option<String>), TransientFailure> {
    let system = &model.system;
    let mut state = given.clone();
    if settings.start != Start::Given {
        return Ok((moved(model, settings, conditions, &state)?, None));
    }
    scalars::begin(system, &mut state);
    let at_rest = |state: &mut State| {
        let settled = scalars::settle(system, state, conditions, Settling::AtRest);
        settled.map_err(TransientFailure::Scalars)
    };
    let mut held = system.elements().filter(|one| one.multipliers() > 0);
    if held.all(|one| one.scalars().is_empty()) {
        state = moved(model, settings, conditions, &state)?;
        at_rest(&mut state)?;
        return Ok((state, None));
    }
    // Joints follow scalars, which may follow the motion of the joints.
    at_rest(&mut state)?;
    for _ in 0..ROUNDS {
        let from = State {
            scalars: state.scalars,
            scalar_rates: state.scalar_rates,
            ..given.clone()
        };
        let found = moved(model, settings, conditions, &from)?;
        let mut again = found.clone();
        at_rest(&mut again)?;
        if scalars::apart(&again.scalars, &found.scalars) < AGREED {
            return Ok((found, None));
        }
        state = again;
    }
    state = moved(model, settings, conditions, &state)?;
    let remark = "joints follow signals that depend on the motion of the joints: no start was \
                  found at which all required unknowns are at rest";
    Ok((state, Some(remark.to_owned())))
}

/// Positions and velocities that fulfill the constraints, as near to the `given` ones as the
/// weights of the nodes determine.
fn moved(
    model: &Model,
    settings: &TransientSettings,
    conditions: &Conditions,
    given: &State,
) -> Result<State, TransientFailure> {
    let system = &model.system;
    let not_placed = |off: Unfulfilled| {
        let constraint = system.equation(off.index);
        if off.is_turned_over {
            TransientFailure::TurnedOver {
                constraint: constraint.to_string(),
                time: settings.from,
            }
        } else {
            TransientFailure::Positions {
                constraint,
                value: off.value,
                is_singular: off.is_singular,
            }
        }
    };
    let placed = place(system, given, conditions, &model.initial).map_err(not_placed)?;
    let not_moving = |off: Unfulfilled| TransientFailure::Velocities {
        constraint: system.equation(off.index),
        value: off.value,
    };
    set_moving(system, &placed, conditions, &model.initial).map_err(not_moving)
}

/// Positions and velocities of the requested kind of start, and its remarks.
fn given(
    model: &Model,
    settings: &TransientSettings,
    conditions: &Conditions,
) -> Result<(State, Vec<String>), TransientFailure> {
    let alone;
    let model = match model.system.independent() {
        None => model,
        Some(system) => {
            alone = Model {
                system,
                ..model.clone()
            };
            &alone
        }
    };
    match settings.start {
        Start::Given => Ok((model.system.rest(), Vec::new())),
        Start::Equilibrium => {
            let turning = turning(model, conditions, 0.0);
            let (mut state, unstable) = steady(model, settings, &turning)?;
            add_shape(model, settings, &turning, &mut state)?;
            into_space(&mut state, &turning.frame);
            Ok((state, unstable.into_iter().collect()))
        }
        Start::Rotating { speed } => rotating(model, settings, conditions, speed),
    }
}

/// Conditions of the equilibrium in axes that turn with the model at `speed` \[rad/s\].
fn turning(model: &Model, conditions: &Conditions, speed: f64) -> Conditions {
    let mut turning = *conditions;
    turning.loading.start();
    turning.frame = TurningFrame {
        angular_velocity: speed * model.frame_rotation.axis,
        center: model.frame_rotation.center,
    };
    turning
}

/// The steady rotation at `speed` \[rad/s\], with the periodic response to gravity across the axis,
/// and its remarks.
fn rotating(
    model: &Model,
    settings: &TransientSettings,
    conditions: &Conditions,
    speed: f64,
) -> Result<(State, Vec<String>), TransientFailure> {
    let mut turning = turning(model, conditions, speed);
    let gravity::Parts { axial, across } =
        gravity::parts(&model.gravity, &model.frame_rotation.axis);
    let factor = model.gravity_drive.at(settings.from).value;
    let is_across = speed != 0.0 && across != Vector3::zeros();
    if is_across {
        turning.loading.gravity = factor * axial;
    }
    if let Some((joint, off)) = driven_otherwise(&model.system, conditions, &turning.frame) {
        return Err(TransientFailure::DrivenOtherwise { joint, off, speed });
    }
    let (mut state, unstable) = steady(model, settings, &turning)?;
    let mut remarks: Vec<_> = unstable.into_iter().collect();
    let mut mean = state.clone();
    into_space(&mut mean, &turning.frame);
    turns_as_a_whole(model, conditions, &mean, speed)?;
    if is_across && factor == 0.0 {
        remarks.push(gravity::later());
    } else if is_across {
        let held = held(model);
        let model = held.as_ref().unwrap_or(model);
        let solver = LinearSolver::new(model.system.pattern());
        let at = (&mut state, &turning);
        remarks.push(gravity::add_response(
            model,
            &solver,
            at,
            &(factor * across),
        ));
    }
    add_shape(model, settings, &turning, &mut state)?;
    into_space(&mut state, &turning.frame);
    Ok((state, remarks))
}

/// Adds the requested shape of a mode to an equilibrium, at rest in the axes of `turning`.
fn add_shape(
    model: &Model,
    settings: &TransientSettings,
    turning: &Conditions,
    state: &mut State,
) -> Result<(), TransientFailure> {
    let Some(requested) = settings.shape else {
        return Ok(());
    };
    let omega = turning.frame.angular_velocity;
    let mut model = held(model).unwrap_or_else(|| model.clone());
    model.gravity = turning.loading.gravity;
    model.gravity_drive = Drive::Constant(1.0);
    let speed = omega.dot(&model.frame_rotation.axis);
    shape::add(&model, (requested, speed), state)
}

/// The model with velocity-driven parts held, if it has some.
fn held(model: &Model) -> Option<Model> {
    model.system.held().map(|system| Model {
        system,
        ..model.clone()
    })
}

/// The equilibrium under the conditions `turning`, at rest in their axes, and a remark if it is
/// unstable.
fn steady(
    model: &Model,
    settings: &TransientSettings,
    turning: &Conditions,
) -> Result<(State, Option<String>), TransientFailure> {
    let rest = model.system.rest();
    let held = held(model);
    let model = held.as_ref().unwrap_or(model);
    let solver = LinearSolver::new(model.system.pattern());
    let from = (&Conditions::at_rest(), &rest);
    let state = equilibrium(model, &solver, from, turning)?.state;
    let growth = growth(model, &solver, (&state, turning));
    let is_seen = |growth: &f64| growth * (settings.to - settings.from) > SEEN;
    let remark = growth.filter(is_seen).map(|growth| {
        format!(
            "the equilibrium of the start is unstable: a motion grows with {growth:.3e} 1/s, and \
             the model leaves it after any disturbance"
        )
    });
    Ok((state, remark))
}

/// Velocities and rates in the axes of the turning `frame` become those in space: at this instant
/// its axes and the fixed axes coincide.
fn into_space(state: &mut State, frame: &TurningFrame) {
    for node in &mut state.nodes {
        node.velocity = node.velocity_in_space(frame);
        node.angular_velocity = node.angular_velocity_in_space(frame);
        let omega = frame.angular_velocity;
        node.momentum_rate = omega.cross(&node.momentum);
        node.angular_momentum_rate = omega.cross(&node.angular_momentum);
    }
}

/// The fastest growth without oscillation of a small motion about an equilibrium, among the
/// slowest motions \[1/s\].
fn growth(
    model: &Model,
    solver: &LinearSolver,
    (state, conditions): (&State, &Conditions),
) -> Option<f64> {
    let tangent = model.system.tangent(state, conditions);
    let massless = MasslessMotions::new(&model.system, &tangent);
    let problem = EigenProblem::about_zero(solver, &tangent, &massless, COUNT)?;
    let all = problem.real(COUNT).into_iter();
    let sure = all.filter(|pair| pair.residual < SURE);
    let growths = sure.map(|pair| pair.growth).filter(|growth| *growth > 0.0);
    growths.reduce(f64::max)
}

/// The first element whose driven velocities are far from the velocities of the undeformed model
/// turning as a whole, and the difference of one of them \[rad/s, m/s\].
fn driven_otherwise(
    system: &System,
    conditions: &Conditions,
    frame: &TurningFrame,
) -> Option<(String, f64)> {
    let omega = frame.angular_velocity;
    if omega.norm() == 0.0 {
        return None;
    }
    let mut state = system.rest();
    for node in &mut state.nodes {
        node.velocity = omega.cross(&(node.position - frame.center));
        node.angular_velocity = omega;
    }
    let least = FAR * omega.norm() * system.size().max(1.0);
    let off = system.residual(&state, conditions).values;
    let first = NODE_UNKNOWNS * state.nodes.len();
    let mut off = off[first..].iter();
    system.elements().find_map(|element| {
        let own = off.by_ref().take(element.multipliers()).enumerate();
        let driven = own.filter(|(i, _)| element.level(*i) == Level::Velocity);
        let largest = driven.fold(0.0_f64, |a, (_, b)| if b.abs() > a.abs() { *b } else { a });
        (largest.abs() > least).then(|| (element.label().to_owned(), largest.abs()))
    })
}

/// Adds the given velocities of the nodes.
fn with_velocities(mut state: State, initial: &[InitialMotion]) -> State {
    for (node, initial) in state.nodes.iter_mut().zip(initial) {
        node.velocity += initial.velocity.unwrap_or_default();
        node.angular_velocity += initial.angular_velocity.unwrap_or_default();
    }
    state
}

fn find_rates(
    model: &Model,
    settings: &TransientSettings,
    conditions: &Conditions,
    started: &mut Started,
) -> Result<(), TransientFailure> {
    let state = &mut started.state;
    match settings.start_accelerations {
        StartAccelerations::Zero => {
            for node in &mut state.nodes {
                node.momentum_rate.fill(0.0);
                node.angular_momentum_rate.fill(0.0);
            }
            state.multipliers.fill(0.0);
            return Ok(());
        }
        StartAccelerations::Consistent | StartAccelerations::AtRest => {
            let seen = match settings.start_accelerations {
                StartAccelerations::AtRest => at_rest(state),
                _ => state.clone(),
            };
            if let Some(found) = consistent_rates(&model.system, &seen, conditions) {
                take_rates(state, &found);
                return Ok(());
            }
            let remark = match model.system.constraint_rates(state, conditions) {
                None => {
                    "the second derivative of some constraint is not known: the first \
                     accelerations and reactions were found by dummy steps"
                }
                Some(_) => {
                    "the equations of the first accelerations and reactions have no solution: \
                     they were found by dummy steps"
                }
            };
            started.remarks.push(remark.to_owned());
        }
        StartAccelerations::Dummy => {}
    }
    *state = dummy_rates(model, settings, state)?;
    Ok(())
}

/// The same positions without motion.
fn at_rest(state: &State) -> State {
    let mut state = state.clone();
    for node in &mut state.nodes {
        node.velocity.fill(0.0);
        node.angular_velocity.fill(0.0);
        node.momentum.fill(0.0);
        node.angular_momentum.fill(0.0);
    }
    state
}

/// Copies only rates and multipliers.
fn take_rates(state: &mut State, found: &State) {
    for (node, found) in state.nodes.iter_mut().zip(&found.nodes) {
        node.momentum_rate = found.momentum_rate;
        node.angular_momentum_rate = found.angular_momentum_rate;
    }
    state.multipliers.clone_from(&found.multipliers);
    state.scalars.clone_from(&found.scalars);
    state.scalar_rates.clone_from(&found.scalar_rates);
}

/// A rotating equilibrium must continue to rotate: no part of it may be held in space.
fn turns_as_a_whole(
    model: &Model,
    conditions: &Conditions,
    turning: &State,
    speed: f64,
) -> Result<(), TransientFailure> {
    let all = vec![InitialMotion::default(); turning.nodes.len()];
    let fastest = (speed * model.system.size()).abs();
    let Ok(held) = set_moving(&model.system, turning, conditions, &all) else {
        return Ok(());
    };
    let changes = changes(model, turning, &held).into_iter();
    let mut large = changes.filter(|change| (change.to - change.from).abs() > TURNS * fastest);
    match large.next() {
        Some(change) => Err(TransientFailure::Held { change }),
        None => Ok(()),
    }
}
