//! Critical points between two equilibria.
//!
//! Between two tangents `K_a` and `K_b` a small motion has no stiffness somewhere, if a tangent on
//! the straight line between them is singular:
//!
//! ```text
//! (K_a + mu (K_b - K_a)) v = 0      0 < mu < 1
//! ```
//!
//! Between two positive definite symmetric matrices none is singular. Tangents of states that are
//! turned relative to each other are not compared: these tangents are balances of forces at the
//! nodes and not symmetric.

use crate::assembly::{MasslessMotions, Sparse, Tangent};
use shared_geom::rotation::vector;

use crate::model::{NODE_UNKNOWNS, NodeMotion, State};
use crate::modes::EigenProblem;
use crate::solver::LinearSolver;

/// Largest turn of a node between two states whose tangents are compared \[rad\].
const TURN: f64 = 0.02;

/// Eigenvalues computed, nearest to zero, and multiplicity of each.
const COUNT: usize = 4;

/// The first mu between two states with their tangents, which are requested only if the states can
/// be compared; `None` if there is none, if the first tangent is singular itself, or if they cannot
/// be compared.
pub(super) fn critical_part(
    solver: &LinearSolver,
    from: (&State, impl FnOnce() -> Sparse),
    to: (&State, impl FnOnce() -> Sparse),
) -> Option<f64> {
    if turn(from.0, to.0) > TURN {
        return None;
    }
    let nodes = from.0.nodes.len();
    let by_unknowns = (from.1)();
    let change = (to.1)().plus(-1.0, &by_unknowns);
    let own = |(i, j, value): (usize, usize, f64)| value == 0.0 || i.max(j) < NODE_UNKNOWNS * nodes;
    if !change.triplets().all(own) || change.values().iter().all(|value| *value == 0.0) {
        return None;
    }
    let pencil = Tangent {
        by_unknowns,
        by_rates: change,
    };
    let all = MasslessMotions::none(nodes);
    let problem = EigenProblem::about_zero(solver, &pencil, &all, COUNT)?;
    let parts = problem.real(COUNT).into_iter().map(|pair| pair.growth);
    let inside = parts.filter(|part| *part > 0.0 && *part < 1.0);
    inside.reduce(f64::min)
}

/// The largest turn of a node from one state to the other \[rad\].
fn turn(from: &State, to: &State) -> f64 {
    let pairs = from.nodes.iter().zip(&to.nodes);
    let turn = |(a, b): (&NodeMotion, &NodeMotion)| {
        vector::from_rotation(&(b.rotation * a.rotation.transpose())).norm()
    };
    pairs.map(turn).fold(0.0, f64::max)
}
