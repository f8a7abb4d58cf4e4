//! Positions and velocities that fulfill the constraints with the least change.
//!
//! ```text
//! positions    minimize 1/2 d^T W d,    d = (x - x_0, psi(R R_0^T))    with Phi = 0
//! velocities   minimize 1/2 (v - v_0)^T W (v - v_0)          with Phi_y v + Phi_t = 0
//! ```
//!
//! by Newton's method on the conditions of an extremum. The weights are given by the nodes, for
//! rotations times the square of the size of the model.

use nalgebra::Vector3;
use shared_geom::rotation::{gibbs, vector};

use super::saddle::{By, MOTION, Saddle, constraint_rows, motion};
use crate::analysis::balance::largest_motion;
use crate::assembly::{System, Tangent, redundancy};
use crate::case::InitialMotion;
use crate::elements::{Element, Level, Queries};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State, Variable};

mod search;

use search::Search;

/// Largest number of iterations.
const ITERATIONS: usize = 50;
/// Largest change of a step, relative to the size of the model and in radians.
const LARGEST: f64 = 0.5;
/// Size of the last correction, relative to the size of the model and in radians.
const SMALL: f64 = 1e-10;
/// Constraints that are fulfilled up to this part of the size of the model are not changed.
const FULFILLED: f64 = 1e-12;
/// Round-off of a constraint from positions and terms of order one.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;
/// Velocity below which a model is at rest, in sizes of the model per second \[1/s\].
const SLOWEST: f64 = 1e-3;
/// Weight of velocities that are not given.
const UNSAID: f64 = 1e-8;

/// Change of a constraint by driven rotations, in sizes of the model, above which they are
/// applied in parts.
const TURNED: f64 = 0.1;
/// Parts in which driven rotations are applied: no more than pi/16 at a time.
const PARTS: usize = 16;

/// Distance of trial positions from a position, relative to the size of the model and in radians.
const BESIDE: f64 = 0.01;

/// A constraint that cannot be fulfilled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unfulfilled {
    /// Its index among the equations.
    pub index: usize,
    /// Its violation [unit of the constraint].
    pub value: f64,
    /// Whether it is fulfilled, but half a turn away from its drive.
    pub is_turned_over: bool,
    /// Whether the constraints lose rank at the given positions.
    pub is_singular: bool,
}

/// The constraint of the largest violation.
fn worst(values: &[f64], first: usize) -> Unfulfilled {
    let indices = values.iter().enumerate().map(|(i, value)| Unfulfilled {
        index: first + i,
        value: *value,
        is_turned_over: false,
        is_singular: false,
    });
    let least = Unfulfilled {
        index: first,
        value: 0.0,
        is_turned_over: false,
        is_singular: false,
    };
    indices.fold(least, |a, b| {
        if b.value.abs() > a.value.abs() || b.value.is_nan() {
            b
        } else {
            a
        }
    })
}

/// Values of the constraints of one level; zero for the others.
fn values(system: &System, state: &State, conditions: &Conditions, level: Level) -> Vec<f64> {
    let first = NODE_UNKNOWNS * system.nodes().len();
    let residual = system.residual(state, conditions).values;
    let values = residual[first..].iter().zip(system.levels());
    values
        .map(|(value, own)| if own == level { *value } else { 0.0 })
        .collect()
}

/// Weights of the motion of all nodes, six each.
fn weights(size: f64, initial: &[InitialMotion], of: fn(&InitialMotion) -> [f64; 2]) -> Vec<f64> {
    let turn = size * size;
    let of_node = |initial: &InitialMotion| {
        let [index, attitude] = of(initial);
        let attitude = turn * attitude;
        [index, index, index, attitude, attitude, attitude]
    };
    initial.iter().flat_map(of_node).collect()
}

/// Moves the nodes of `state`, by the least weighted change, until the constraints of positions are
/// fulfilled. Velocities are ignored.
///
/// Constraints cannot distinguish an attitude from the attitude half a turn away: large driven
/// rotations are applied in small parts.
pub(super) fn place(
    system: &System,
    state: &State,
    conditions: &Conditions,
    initial: &[InitialMotion],
) -> Result<State, Unfulfilled> {
    let is_over = |state: &State| system.turned_over(state, conditions).is_some();
    let mut now = state.clone();
    if is_over(&now) || turns_far(system, state, conditions) {
        for part in 0..PARTS {
            let mut conditions = *conditions;
            conditions.loading.turns = part as f64 / PARTS as f64;
            // If the mechanism cannot reach an intermediate position, only the final one is used.
            if let Ok(placed) = place_at_once(system, &now, &conditions, initial) {
                now = placed;
            }
        }
    }
    let placed = place_at_once(system, &now, conditions, initial)?;
    match system.turned_over(&placed, conditions) {
        None => Ok(placed),
        Some(element) => Err(half_a_turn_off(system, element)),
    }
}

/// Whether driven rotations are far from the attitudes of the nodes.
fn turns_far(system: &System, state: &State, conditions: &Conditions) -> bool {
    let now = still(state);
    let off = |turns: f64| {
        let mut conditions = *conditions;
        conditions.loading.turns = turns;
        values(system, &now, &conditions, Level::Position)
    };
    let is_fulfilled = off(1.0)
        .iter()
        .all(|off| off.abs() <= FULFILLED * system.size().max(1.0));
    let pairs = off(0.0).into_iter().zip(off(0.5));
    let change = pairs.map(|(none, half)| (half - none).abs());
    !is_fulfilled && change.fold(0.0, f64::max) > TURNED
}

/// The first constraint of an element that holds a rotation half a turn away.
fn half_a_turn_off(system: &System, element: &dyn Element) -> Unfulfilled {
    let all = system.elements();
    let before = all.take_while(|other| !std::ptr::addr_eq(*other, element));
    let constraints: usize = before.map(|other| other.multipliers()).sum();
    Unfulfilled {
        index: NODE_UNKNOWNS * system.nodes().len() + constraints,
        value: 0.0,
        is_turned_over: true,
        is_singular: false,
    }
}

/// The same, directly from the positions of the nodes: by full steps, and if they fail by steps
/// that are halved until the constraints converge.
fn place_at_once(
    system: &System,
    state: &State,
    conditions: &Conditions,
    initial: &[InitialMotion],
) -> Result<State, Unfulfilled> {
    let first = NODE_UNKNOWNS * state.nodes.len();
    let start = still(state);
    let off = worst(&values(system, &start, conditions, Level::Position), first);
    if off.value.abs() <= fulfilled(FULFILLED, system, state) {
        return Ok(state.clone());
    }
    let weights = weights(system.size(), initial, |one| [one.weight; 2]);
    let search = Search {
        system,
        conditions,
        start,
        weights,
    };
    let mut nearest = off;
    let placed = [false, true].into_iter().find_map(|is_damped| {
        let placed = search.run(is_damped, &mut nearest)?;
        Some(with_motion_of(placed, state))
    });
    placed.ok_or_else(|| Unfulfilled {
        is_singular: !redundancy::find(system, &search.start, conditions).is_empty(),
        ..nearest
    })
}

/// Largest violation of a constraint: a part of the size of the model, or round-off \[m\].
fn fulfilled(part: f64, system: &System, state: &State) -> f64 {
    let indices = state.nodes.iter().map(|node| node.position.amax());
    f64::max(
        part * system.size(),
        ROUND_OFF * indices.fold(1.0, f64::max),
    )
}

/// At rest, without multipliers.
fn still(state: &State) -> State {
    let mut still = state.clone();
    for node in &mut still.nodes {
        node.velocity = Vector3::zeros();
        node.angular_velocity = Vector3::zeros();
    }
    still.multipliers.fill(0.0);
    still
}

/// The positions of `placed` with the velocities of `state`.
fn with_motion_of(placed: State, state: &State) -> State {
    let mut all = state.clone();
    for (node, placed) in all.nodes.iter_mut().zip(&placed.nodes) {
        (node.position, node.rotation) = (placed.position, placed.rotation);
    }
    all
}

fn move_by(state: &mut State, step: &[f64], part: f64) {
    let nodes = state.nodes.len();
    for (node, step) in state.nodes.iter_mut().zip(step.chunks(MOTION)) {
        node.position += part * Vector3::from_column_slice(&step[..3]);
        let turn = part * Vector3::from_column_slice(&step[3..]);
        node.rotation = gibbs::to_rotation(&turn) * node.rotation;
    }
    for (zeta, change) in state.multipliers.iter_mut().zip(&step[MOTION * nodes..]) {
        *zeta += part * change;
    }
}

/// One step to the extremum, from `now`, whose multipliers belong to the extremum.
fn place_step(
    system: &System,
    (start, now): (&State, &State),
    conditions: &Conditions,
    weights: &[f64],
) -> Option<Vec<f64>> {
    let nodes = now.nodes.len();
    let first = MOTION * nodes;
    let tangent = system.tangent(now, conditions);
    let mut saddle = Saddle::default();
    saddle.constraints(system, &tangent, By::Positions);
    saddle.diagonal(weights.iter().copied());
    saddle
        .entries
        .extend(curvature(system, now, conditions, &tangent));

    let mut right = vec![0.0; first + now.multipliers.len()];
    for (i, (node, origin)) in now.nodes.iter().zip(&start.nodes).enumerate() {
        let moved = node.position - origin.position;
        let turned = vector::from_rotation(&(node.rotation * origin.rotation.transpose()));
        for k in 0..3 {
            right[MOTION * i + k] = -weights[MOTION * i + k] * moved[k];
            right[MOTION * i + 3 + k] = -weights[MOTION * i + 3 + k] * turned[k];
        }
    }
    for (constraint, column, value) in constraint_rows(system, &tangent, By::Positions) {
        right[column] -= value * now.multipliers[constraint];
    }
    let off = values(system, now, conditions, Level::Position);
    for (value, off) in right[first..].iter_mut().zip(off) {
        *value = -off;
    }
    saddle.solve(nodes, largest_of(weights), &right)
}

fn largest_of(weights: &[f64]) -> f64 {
    weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max)
}

/// `d(Phi_y^T zeta)/dy`: the constraint forces are `-Phi_y^T zeta`, and all other forces do
/// not depend on zeta.
fn curvature(
    system: &System,
    now: &State,
    conditions: &Conditions,
    tangent: &Tangent,
) -> Vec<(usize, usize, f64)> {
    let mut without = now.clone();
    without.multipliers.fill(0.0);
    let without = system.tangent(&without, conditions).by_unknowns;
    let first = NODE_UNKNOWNS * now.nodes.len();
    let change = tangent.by_unknowns.plus(-1.0, &without);
    let entries = change.triplets().filter(|&(row, column, value)| {
        let is_force = row < first && row % NODE_UNKNOWNS >= Equation::Force.row();
        let is_motion = column < first && column % NODE_UNKNOWNS < Variable::Momentum.column();
        value != 0.0 && is_force && is_motion
    });
    entries
        .map(|(row, column, value)| (motion(row), motion(column), -value))
        .collect()
}

/// Changes the velocities of `state`, by the least weighted change, until they fulfill all
/// constraints.
pub(super) fn set_moving(
    system: &System,
    state: &State,
    conditions: &Conditions,
    initial: &[InitialMotion],
) -> Result<State, Unfulfilled> {
    let nodes = state.nodes.len();
    let index = NODE_UNKNOWNS * nodes;
    let of = |one: &InitialMotion| {
        [one.velocity, one.angular_velocity].map(|said| {
            let standard = if said.is_some() { 1.0 } else { UNSAID };
            one.velocity_weight.unwrap_or(standard)
        })
    };
    let weights = weights(system.size(), initial, of);
    let mut now = state.clone();
    let mut off = velocity_constraints(system, &now, conditions);
    let limit = |state: &State| FULFILLED * fastest(system, state).max(f64::MIN_POSITIVE);
    for _ in 0..ITERATIONS {
        if worst(&off, index).value.abs() <= limit(&now) {
            return Ok(now);
        }
        let tangent = system.tangent(&now, conditions);
        let mut saddle = Saddle::default();
        saddle.constraints(system, &tangent, By::Velocities);
        saddle.diagonal(weights.iter().copied());
        let mut right = vec![0.0; MOTION * nodes];
        right.extend(off.iter().map(|off| -off));
        let step = saddle
            .solve(nodes, largest_of(&weights), &right)
            .ok_or(worst(&off, index))?;
        for (node, step) in now.nodes.iter_mut().zip(step.chunks(MOTION)) {
            node.velocity += Vector3::from_column_slice(&step[..3]);
            node.angular_velocity += Vector3::from_column_slice(&step[3..]);
        }
        let before = worst(&off, index).value.abs();
        off = velocity_constraints(system, &now, conditions);
        let after = worst(&off, index);
        // Round-off of large terms: no step reduces it.
        let speed = fastest(system, &now).max(SLOWEST * system.size());
        if after.value.abs() <= 1e-9 * speed && after.value.abs() > 0.1 * before {
            return Ok(now);
        }
    }
    Err(worst(&off, index))
}

/// Largest velocity, or size of the model times angular velocity \[m/s\].
fn fastest(system: &System, state: &State) -> f64 {
    let size = system.size();
    let of = state.nodes.iter().map(|node| {
        node.velocity
            .norm()
            .max(size * node.angular_velocity.norm())
    });
    of.fold(0.0, f64::max)
}

/// Values of the constraints of positions; zero for the others.
pub(super) fn position_values(system: &System, state: &State, conditions: &Conditions) -> Vec<f64> {
    values(system, &still(state), conditions, Level::Position)
}

/// `state` moved a little in a free direction of the constraints, one of several; `None` if there
/// is none.
pub(super) fn beside(
    system: &System,
    state: &State,
    conditions: &Conditions,
    direction: usize,
) -> Option<State> {
    let mut now = still(state);
    let nodes = now.nodes.len();
    let size = system.size();
    let tangent = system.tangent(&now, conditions);
    let mut saddle = Saddle::default();
    saddle.constraints(system, &tangent, By::Velocities);
    let turn = size * size;
    let weight = |i: usize| if i % MOTION < 3 { 1.0 } else { turn };
    saddle.diagonal((0..MOTION * nodes).map(weight));
    // Irregular numbers: a direction in which no model is likely to be built.
    let any = |i: usize| (1.0 + 2.7 * direction as f64 + 1.3 * i as f64 + (i * i) as f64).sin();
    let right = (0..MOTION * nodes).map(|i| match i % MOTION {
        0..3 => size * any(i),
        _ => weight(i) * any(i),
    });
    let mut right: Vec<_> = right.collect();
    right.resize(MOTION * nodes + now.multipliers.len(), 0.0);
    let step = saddle.solve(nodes, turn.max(1.0), &right)?;
    let largest = largest_motion(step[..MOTION * nodes].chunks(MOTION), size);
    if largest <= FULFILLED || !largest.is_finite() {
        return None;
    }
    move_by(&mut now, &step, BESIDE / largest);
    now.multipliers.fill(0.0);
    Some(now)
}

/// Rates of the constraints with all nodes at rest.
pub(super) fn own_rates(system: &System, state: &State, conditions: &Conditions) -> Vec<f64> {
    velocity_constraints(system, &still(state), conditions)
}

/// First derivative of the constraints of positions, and the constraints of velocities.
pub(super) fn velocity_constraints(
    system: &System,
    state: &State,
    conditions: &Conditions,
) -> Vec<f64> {
    let mut off = values(system, state, conditions, Level::Velocity);
    let by_time = by_time(system, state, conditions);
    let levels = system.levels();
    for (i, value) in by_time.into_iter().enumerate() {
        if levels[i] == Level::Position {
            off[i] = value;
        }
    }
    let tangent = system.tangent(state, conditions);
    for (constraint, column, value) in constraint_rows(system, &tangent, By::Positions) {
        let node = &state.nodes[column / MOTION];
        off[constraint] += value
            * match column % MOTION {
                i @ 0..3 => node.velocity[i],
                i => node.angular_velocity[i - 3],
            };
    }
    off
}

/// `Phi_t`, by central differences if an element does not define it.
fn by_time(system: &System, state: &State, conditions: &Conditions) -> Vec<f64> {
    /// The error of differences is about 1e-10 of the drive.
    const DELAY: f64 = 1e-5;
    if let Some((by_time, _)) = system.constraint_rates(state, conditions) {
        return by_time;
    }
    let at = |delay: f64| {
        let mut conditions = *conditions;
        conditions.loading.time += delay;
        values(system, state, &conditions, Level::Position)
    };
    let pairs = at(DELAY).into_iter().zip(at(-DELAY));
    pairs
        .map(|(later, before)| (later - before) / (2.0 * DELAY))
        .collect()
}
