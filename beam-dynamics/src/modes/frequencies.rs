//! Frequencies that say where to look for modes: the highest of a node, the lowest of a rough
//! view.

use faer::c64;

use crate::assembly::{Sparse, Tangent};
use crate::model::{Equation, NODE_UNKNOWNS, Variable};

/// The highest frequency of a node on its own, `sqrt(|F_force,x| / |F_p,v|)`; of bodies
/// that only turn, `sqrt(|F_moment,theta| / |F_h,omega|)` or the speed of the frame \[1/s\].
/// `None` without mass or stiffness.
pub(super) fn highest_of_a_node(tangent: &Tangent, nodes: usize) -> Option<f64> {
    let largest = |matrix: &Sparse, row: Equation, column: Variable| {
        let (row, column) = (row.row(), column.column());
        let of_nodes = matrix
            .triplets()
            .filter(|(i, j, _)| i.max(j) < &(NODE_UNKNOWNS * nodes));
        let block = of_nodes.filter(|(i, j, _)| {
            (row..row + 3).contains(&(i % NODE_UNKNOWNS))
                && (column..column + 3).contains(&(j % NODE_UNKNOWNS))
        });
        block.map(|(_, _, value)| value.abs()).fold(0.0, f64::max)
    };
    let frequency = |balance: Equation, momentum: Equation, place: Variable| {
        let stiffness = largest(&tangent.by_unknowns, balance, place);
        let mass = largest(&tangent.by_rates, momentum, place);
        (stiffness / mass).sqrt()
    };
    let is_some = |frequency: &f64| *frequency > 0.0 && frequency.is_finite();
    let along = frequency(Equation::Force, Equation::Momentum, Variable::Position);
    if is_some(&along) {
        return Some(along);
    }
    let about = frequency(
        Equation::Moment,
        Equation::AngularMomentum,
        Variable::Rotation,
    );
    let turning = largest(&tangent.by_unknowns, Equation::Force, Variable::Momentum);
    let found = [about, turning].into_iter().filter(is_some);
    found.max_by(f64::total_cmp)
}

/// Magnitude of the lowest eigenvalue above `zero`, among rough ones.
pub(super) fn lowest_oscillation(values: &[c64], zero: f64) -> Option<f64> {
    let sizes = values.iter().map(|s| s.norm());
    let above = sizes.filter(|size| size.is_finite() && *size > zero);
    above.min_by(f64::total_cmp)
}
