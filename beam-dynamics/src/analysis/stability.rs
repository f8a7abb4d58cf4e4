//! Whether the equilibria of a load path are stable.
//!
//! Every node is dragged by its velocity instead of its inertia, c on displacements and
//! c L^2 on rotations, L the size of the model. The model then creeps,
//!
//! ```text
//! (F_y + s C) v = 0
//! ```
//!
//! and leaves an equilibrium, s > 0, where the stiffness is no longer positive. That
//! needs no masses, tells both of two directions that give way together, of which the
//! sign of the determinant says nothing, and sees no flutter.

use crate::assembly::{Sparse, Tangent};
use crate::model::{Equation, NODE_UNKNOWNS, Variable};
use crate::modes::EigenProblem;

use super::balance::Balance;

/// Motions that are looked at: those that creep most slowly.
const LOOKED_AT: usize = 6;
/// Directions that may give way together.
const COPIES: usize = 4;
/// A growth below this part of the slowest decay at the start is none.
const ROUND_OFF: f64 = 1e-6;

/// Where the equilibria become unstable, from the balances of a path at its states in
/// order: the number of the first one that is, and its place between that and the one
/// before, from 0 to 1. `None` where the last one is stable, or the first is not.
pub(super) fn loss<'a>(
    count: usize,
    balance: impl Fn(usize) -> Balance<'a>,
) -> Option<(usize, f64)> {
    let (mut stable, mut unstable) = (0, count.checked_sub(1)?);
    let mut before = fastest(&balance(stable)).filter(|growth| *growth < 0.0)?;
    let limit = ROUND_OFF * before.abs();
    let mut after = fastest(&balance(unstable)).filter(|growth| *growth > limit)?;
    while unstable - stable > 1 {
        let middle = stable + (unstable - stable) / 2;
        let growth = fastest(&balance(middle))?;
        match growth > limit {
            true => (unstable, after) = (middle, growth),
            false => (stable, before) = (middle, growth),
        }
    }
    Some((unstable, (before / (before - after)).clamp(0.0, 1.0)))
}

/// The largest s of those nearest to zero.
fn fastest(balance: &Balance<'_>) -> Option<f64> {
    let tangent = balance.system.tangent(&balance.state, &balance.conditions);
    let nodes = balance.system.nodes().len();
    let creeping = Tangent {
        by_rates: drag(&tangent, nodes, balance.reach()),
        by_unknowns: tangent.by_unknowns,
    };
    let problem = EigenProblem::about_zero(balance.solver, &creeping, nodes, COPIES)?;
    let pairs = problem.real(LOOKED_AT);
    pairs.iter().map(|pair| pair.growth).max_by(f64::total_cmp)
}

/// The matrix C: the drag stands where the rate of the momentum does, with its sign.
fn drag(tangent: &Tangent, nodes: usize, size: f64) -> Sparse {
    let pattern = tangent.by_rates.pattern();
    let mut drag = Sparse::zero(std::sync::Arc::clone(pattern));
    let kinds = [
        (Equation::Force, Variable::Position, 1.0),
        (Equation::Moment, Variable::Rotation, size * size),
    ];
    for node in 0..nodes {
        for (equation, variable, factor) in kinds {
            for axis in 0..3 {
                let first = NODE_UNKNOWNS * node + axis;
                let (row, column) = (first + equation.row(), first + variable.column());
                let sign = tangent.by_rates.entry(row, first + equation.row());
                if let Some(place) = pattern.place(row, column) {
                    drag.values_mut()[place] = sign * factor;
                }
            }
        }
    }
    drag
}
