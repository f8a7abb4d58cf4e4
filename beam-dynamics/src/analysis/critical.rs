//! Critical points on the way from one equilibrium to another.
//!
//! Between two tangents `K_a` and `K_b` there is one where a small motion has no stiffness,
//! if one on the straight way between them is singular:
//!
//! ```text
//! (K_a + mu (K_b - K_a)) v = 0      0 < mu < 1
//! ```
//!
//! Of symmetric matrices of which both are positive definite none between them is singular.

use crate::assembly::{Sparse, Tangent};
use crate::modes::EigenProblem;
use crate::solver::LinearSolver;

/// Eigenvalues looked at, those nearest to zero, and copies of each.
const COUNT: usize = 4;

/// The first mu; `None` where there is none, or where `from` is singular itself.
pub(super) fn critical_part(
    solver: &LinearSolver,
    nodes: usize,
    from: Sparse,
    to: &Sparse,
) -> Option<f64> {
    let change = to.plus(-1.0, &from);
    if change.values().iter().all(|value| *value == 0.0) {
        return None;
    }
    let pencil = Tangent {
        by_unknowns: from,
        by_rates: change,
    };
    let problem = EigenProblem::about_zero(solver, &pencil, nodes, COUNT)?;
    let parts = problem.real(COUNT).into_iter().map(|pair| pair.growth);
    let inside = parts.filter(|part| *part > 0.0 && *part < 1.0);
    inside.reduce(f64::min)
}
