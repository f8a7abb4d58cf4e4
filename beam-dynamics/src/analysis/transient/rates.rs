//! Rates of momenta, and multipliers, consistent with the last derivative of the constraints.
//!
//! The momenta are functions of the motion, `beta = b(x, R, v, omega)`, so that with the
//! accelerations a (of displacement and rotation)
//!
//! ```text
//! beta' = q + M a           q = b_x v + b_theta omega,   M = b_v
//! M a - F_lambda lambda = F_0 - q
//! C a                   = -convective
//! ```
//!
//! with `F_0` the forces, without multipliers, of the state, and C the derivatives of the
//! constraints. If a motion moves no mass, its acceleration follows from the constraints or is
//! irrelevant: a tiny mass is added to M in these directions, and left out again in the rates.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::assembly::massless::without_mass;
use crate::assembly::{Sharing, System, Tangent};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State, Variable};

use super::saddle::{By, MOTION, Saddle, constraint_rows, motion};
use super::scalars::{self, Settling};

/// Added mass of motions without mass, as a part of the largest mass.
const NEXT_TO_NOTHING: f64 = 1e-9;

/// Largest number of rounds in which scalars that read reactions are made consistent with them, and
/// the tolerance, relative to the scalar or absolute.
const ROUNDS: usize = 30;
const AGREED: f64 = 1e-10;
/// Singular values of differences below this part of the largest are round-off.
const LINEAR: f64 = 1e-10;

/// Momenta from their definitions.
pub(super) fn find_momenta(system: &System, state: &mut State, conditions: &Conditions) {
    let residual = system.residual(state, conditions).values;
    let rows = residual.chunks(NODE_UNKNOWNS);
    for (node, rows) in state.nodes.iter_mut().zip(rows) {
        node.momentum -= Vector3::from_column_slice(&rows[..3]);
        node.angular_momentum -= Vector3::from_column_slice(&rows[3..6]);
    }
}

/// `state` with rates of momenta and multipliers consistent with its motion and the conditions, and
/// with scalars consistent with them; `None` if an element does not define the rates of its
/// constraints, or if there is no solution.
pub(in crate::analysis) fn consistent_rates(
    system: &System,
    state: &State,
    conditions: &Conditions,
) -> Option<State> {
    let mut state = rates_at_scalars(system, state, conditions)?;
    if !system.scalars_read_multipliers() {
        return Some(state);
    }
    let mut search = FixedPoint::default();
    for _ in 0..ROUNDS {
        let before = DVector::from_column_slice(&state.scalars);
        scalars::settle(system, &mut state, conditions, Settling::InMotion).ok()?;
        if scalars::apart(&state.scalars, before.as_slice()) < AGREED {
            return Some(state);
        }
        let next = search.next(before, &DVector::from_column_slice(&state.scalars))?;
        state.scalars.copy_from_slice(next.as_slice());
        state = rates_at_scalars(system, &state, conditions)?;
    }
    None
}

/// The search for x = g(x) from all values of `f = g(x) - x` so far, which finds it in as many
/// rounds as g has dimensions if g is linear, for any growth of g:
///
/// ```text
/// x_{k+1} = x_k + f_k - (dX + dF) c ,     c: least | f_k - dF c |
/// ```
///
/// with the differences of earlier x and f as columns of dX and dF. References: [Anderson1965].
#[derive(Debug, Default)]
struct FixedPoint {
    latest: Option<[DVector<f64>; 2]>,
    differences: [Vec<DVector<f64>>; 2],
}

impl FixedPoint {
    /// The next x, from x and g(x).
    fn next(&mut self, x: DVector<f64>, found: &DVector<f64>) -> Option<DVector<f64>> {
        let f = found - &x;
        if let Some([earlier_x, earlier_f]) = self.latest.take() {
            self.differences[0].push(&x - earlier_x);
            self.differences[1].push(&f - earlier_f);
        }
        let mut next = &x + &f;
        if !self.differences[0].is_empty() {
            let [by_x, by_f] = self
                .differences
                .each_ref()
                .map(|all| DMatrix::from_columns(all));
            let all = by_f.clone().svd(true, true);
            let part = all.solve(&f, LINEAR * all.singular_values.max()).ok()?;
            next -= (by_x + by_f) * part;
        }
        self.latest = Some([x, f]);
        Some(next)
    }
}

/// As [`consistent_rates`], with the scalars unchanged.
fn rates_at_scalars(system: &System, state: &State, conditions: &Conditions) -> Option<State> {
    let (_, convective) = system.constraint_rates(state, conditions)?;
    let mut state = state.clone();
    for node in &mut state.nodes {
        node.momentum_rate.fill(0.0);
        node.angular_momentum_rate.fill(0.0);
    }
    state.multipliers.fill(0.0);
    let nodes = state.nodes.len();
    let tangent = system.tangent(&state, conditions);
    let forces = system.residual(&state, conditions).values;
    let carried = carried(&state, &tangent);
    let first = MOTION * nodes;
    let equations = Accelerated::new(system, &state, &tangent);
    // Two matrices of the whole system, of which nothing more is needed.
    drop(tangent);

    let mut right = vec![0.0; first + state.multipliers.len()];
    for (row, force) in forces[..NODE_UNKNOWNS * nodes].iter().enumerate() {
        if row % NODE_UNKNOWNS >= Equation::Force.row() {
            right[motion(row)] += force;
        }
    }
    right.iter_mut().zip(&carried).for_each(|(f, q)| *f -= q);
    for (value, convective) in right[first..].iter_mut().zip(&convective) {
        *value = -convective;
    }
    let solution = equations.solve(nodes, &right)?;
    state.multipliers.copy_from_slice(&solution[first..]);
    Sharing::new(system, &state, conditions).take_surplus(&mut state.multipliers);
    let mut rates = carried;
    for &(row, column, mass) in equations.masses() {
        rates[row] += mass * solution[column];
    }
    for (node, rates) in state.nodes.iter_mut().zip(rates.chunks(MOTION)) {
        node.momentum_rate.copy_from_slice(&rates[..3]);
        node.angular_momentum_rate.copy_from_slice(&rates[3..]);
    }
    Some(state)
}

/// The equations of changes of velocities, of accelerations or of impulses: `M` and
/// `-F_lambda` above `C` and zero.
pub(super) struct Accelerated {
    saddle: Saddle,
    /// Number of the entries of M, without the added mass: the first entries.
    masses: usize,
    heaviest: f64,
}

impl Accelerated {
    pub fn new(system: &System, state: &State, tangent: &Tangent) -> Self {
        let nodes = state.nodes.len();
        let mut saddle = Saddle {
            entries: masses(nodes, tangent),
        };
        let masses = saddle.entries.len();
        let sizes = saddle.entries.iter().map(|entry| entry.2.abs());
        let heaviest = sizes.fold(0.0, f64::max);
        saddle.entries.extend(multiplier_columns(
            [nodes, state.multipliers.len()],
            tangent,
        ));
        let first = MOTION * nodes;
        let rows = constraint_rows(system, tangent, By::Velocities);
        let rows = rows.into_iter().map(|(i, j, value)| (first + i, j, value));
        saddle.entries.extend(rows);
        let heaviest = if heaviest > 0.0 { heaviest } else { 1.0 };
        soften(&mut saddle, system, tangent, heaviest);
        Self {
            saddle,
            masses,
            heaviest,
        }
    }

    /// M, without the added mass.
    fn masses(&self) -> &[(usize, usize, f64)] {
        &self.saddle.entries[..self.masses]
    }

    /// Changes of the motion of the nodes, then multipliers; `None` if there are none.
    pub fn solve(&self, nodes: usize, right: &[f64]) -> Option<Vec<f64>> {
        self.saddle.solve(nodes, self.heaviest, right)
    }
}

/// M: derivatives of the momenta by the velocities, none of them zero.
fn masses(nodes: usize, tangent: &Tangent) -> Vec<(usize, usize, f64)> {
    let entries = tangent.by_rates.triplets();
    let is_mass = |&(row, column, value): &(usize, usize, f64)| {
        value != 0.0 && is_momentum_by_motion(nodes, row, column)
    };
    entries
        .filter(is_mass)
        .map(|(row, column, value)| (motion(row), motion(column), -value))
        .collect()
}

/// q: rates of the momenta of nodes without acceleration.
fn carried(state: &State, tangent: &Tangent) -> Vec<f64> {
    let nodes = state.nodes.len();
    let speed = |column: usize| {
        let node = &state.nodes[column / NODE_UNKNOWNS];
        match column % NODE_UNKNOWNS {
            i @ 0..3 => node.velocity[i],
            i => node.angular_velocity[i - 3],
        }
    };
    let mut carried = vec![0.0; MOTION * nodes];
    for (row, column, value) in tangent.by_unknowns.triplets() {
        if is_momentum_by_motion(nodes, row, column) {
            carried[motion(row)] -= value * speed(column);
        }
    }
    carried
}

fn is_momentum_by_motion(nodes: usize, row: usize, column: usize) -> bool {
    let is_node = row.max(column) < NODE_UNKNOWNS * nodes;
    is_node
        && row % NODE_UNKNOWNS < Equation::Force.row()
        && column % NODE_UNKNOWNS < Variable::Momentum.column()
}

/// `-F_lambda`.
fn multiplier_columns(
    [nodes, multipliers]: [usize; 2],
    tangent: &Tangent,
) -> Vec<(usize, usize, f64)> {
    let first = NODE_UNKNOWNS * nodes;
    let multipliers = first..first + multipliers;
    let entries = tangent.by_unknowns.triplets();
    let is_force = |&(row, column, _): &(usize, usize, f64)| {
        multipliers.contains(&column) && row < first && row % NODE_UNKNOWNS >= Equation::Force.row()
    };
    entries
        .filter(is_force)
        .map(|(row, column, value)| (motion(row), MOTION * nodes + column - first, -value))
        .collect()
}

/// Adds a small mass to motions without mass.
fn soften(saddle: &mut Saddle, system: &System, tangent: &Tangent, heaviest: f64) {
    let size = system.size();
    let scale = |i: usize| if i < 3 { 1.0 } else { size };
    for (node, basis) in without_mass(system, tangent, size).iter().enumerate() {
        let mass = NEXT_TO_NOTHING * heaviest * basis * basis.transpose();
        for i in 0..MOTION {
            for j in 0..MOTION {
                let value = scale(i) * mass[(i, j)] * scale(j);
                if value != 0.0 {
                    saddle
                        .entries
                        .push((MOTION * node + i, MOTION * node + j, value));
                }
            }
        }
    }
}
