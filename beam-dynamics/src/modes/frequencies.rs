//! Frequencies that bound the search for modes: the highest of a single node, and an upper
//! bound of all oscillations; and the parts of a tangent from which they follow.

use crate::assembly::{Sparse, Tangent};
use crate::model::{Equation, NODE_UNKNOWNS, Variable};

/// The highest frequency of a node on its own, `sqrt(|F_force,x| / |F_p,v|)`; of bodies
/// that only turn, `sqrt(|F_moment,theta| / |F_h,omega|)` or the speed of the frame \[1/s\].
/// `None` without mass or stiffness.
pub fn highest_of_a_node(tangent: &Tangent, nodes: usize) -> Option<f64> {
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
    let frequency = |balance: Equation, momentum: Equation, index: Variable| {
        let stiffness = largest(&tangent.by_unknowns, balance, index);
        let mass = largest(&tangent.by_rates, momentum, index);
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

/// A frequency \[1/s\] that no oscillation of the nodes is above: the largest of all forces
/// on an unknown by unit motions, in units of the roots of both masses. A larger value is
/// an infinite one that round-off has made finite.
pub(super) fn fastest(tangent: &Tangent, size: usize) -> f64 {
    let half = NODE_UNKNOWNS / 2;
    let of_motion =
        |row: usize, column: usize| row.max(column) < size && column % NODE_UNKNOWNS < half;
    let masses = masses(tangent, size);
    let mut sums = vec![0.0_f64; size];
    for (row, column, value) in tangent.by_unknowns.triplets() {
        if of_motion(row, column) && row % NODE_UNKNOWNS >= half {
            let mass = (masses[row - half] * masses[column]).sqrt();
            if mass > 0.0 {
                sums[row] += value.abs() / mass;
            }
        }
    }
    sums.into_iter().fold(0.0, f64::max).sqrt()
}

/// The mass of each unknown of the nodes; a momentum has the mass of its motion.
pub(super) fn masses(tangent: &Tangent, size: usize) -> Vec<f64> {
    let half = NODE_UNKNOWNS / 2;
    let mut masses = vec![0.0; size];
    for (row, column, value) in tangent.by_rates.triplets() {
        if row == column && row < size && row % NODE_UNKNOWNS < half {
            (masses[row], masses[row + half]) = (value.abs(), value.abs());
        }
    }
    masses
}

/// The same system without dampers, which are the forces and moments by the velocities;
/// `None` where it has none.
pub(super) fn undamped(tangent: &Tangent) -> Option<Tangent> {
    let is_damping = |&(row, column, value): &(usize, usize, f64)| {
        let half = NODE_UNKNOWNS / 2;
        value != 0.0 && row % NODE_UNKNOWNS >= half && column % NODE_UNKNOWNS < half
    };
    let mut result = tangent.clone();
    let indices: Vec<_> = tangent.by_rates.triplets().enumerate().collect();
    let damping = indices.iter().filter(|(_, entry)| is_damping(entry));
    let mut is_damped = false;
    for (index, _) in damping {
        result.by_rates.values_mut()[*index] = 0.0;
        is_damped = true;
    }
    is_damped.then_some(result)
}
