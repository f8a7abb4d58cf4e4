//! Systems of the motion of nodes and of multipliers, for initialization:
//!
//! ```text
//! [ K  C^T ] [ dy   ]   [ f ]
//! [ C   0  ] [ zeta ] = [ g ]
//! ```
//!
//! with six unknowns per node. Redundant constraints share their multiplier: a tiny number is added
//! to the diagonal of the second rows, and the solution is refined until this has no effect.

use std::sync::Arc;

use crate::assembly::{Pattern, Sparse, System, Tangent};
use crate::elements::Level;
use crate::model::{Equation, NODE_UNKNOWNS};
use crate::solver::LinearSolver;

/// Unknowns of the motion of a node.
pub(super) const MOTION: usize = 6;
/// Number added to the diagonal of multipliers, relative to its natural size.
const SOFT: f64 = 1e-11;
/// Refinements of a solution.
const REFINEMENTS: usize = 3;

/// Kinds of derivatives of the constraints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum By {
    /// By positions and rotations, of constraints of positions only.
    Positions,
    /// By the highest derivative of the motion in a constraint.
    Velocities,
}

/// A block matrix by its entries (row, column, value); equal positions add up.
#[derive(Debug, Clone, Default)]
pub(super) struct Saddle {
    pub entries: Vec<(usize, usize, f64)>,
}

impl Saddle {
    /// Adds the rows C of the constraints, and their transpose.
    pub fn constraints(&mut self, system: &System, tangent: &Tangent, by: By) {
        let first = MOTION * system.nodes().len();
        for (constraint, column, value) in constraint_rows(system, tangent, by) {
            self.entries.push((first + constraint, column, value));
            self.entries.push((column, first + constraint, value));
        }
    }

    /// Adds weights to the diagonal of K.
    pub fn diagonal(&mut self, weights: impl Iterator<Item = f64>) {
        let entries = weights.enumerate().map(|(i, weight)| (i, i, weight));
        self.entries.extend(entries);
    }

    /// Solves for all unknowns, of which the first `nodes` times six are motions; `None` if the
    /// matrix is singular. `stiffness` is the size of K.
    pub fn solve(&self, nodes: usize, stiffness: f64, right: &[f64]) -> Option<Vec<f64>> {
        let size = right.len();
        let soft = (MOTION * nodes..size).map(|i| (i, i, -SOFT / stiffness));
        let exact = matrix(size, self.entries.iter().copied());
        let entries = self.entries.iter().copied().chain(soft);
        let softened = matrix(size, entries);
        let solver = LinearSolver::new(softened.pattern());
        let factors = solver.factorize(softened)?;
        let mut x = vec![0.0; size];
        for _ in 0..=REFINEMENTS {
            let mut left = vec![0.0; size];
            exact.multiply_add(&x, &mut left);
            let mut change: Vec<_> = right.iter().zip(&left).map(|(b, ax)| b - ax).collect();
            factors.solve(&mut change)?;
            x.iter_mut().zip(&change).for_each(|(x, dx)| *x += dx);
        }
        Some(x)
    }
}

/// Derivatives of the constraints: constraint, index in the motion, value.
pub(super) fn constraint_rows(
    system: &System,
    tangent: &Tangent,
    by: By,
) -> Vec<(usize, usize, f64)> {
    let levels: &[Level] = match by {
        By::Positions => &[Level::Position],
        By::Velocities => &[Level::Position, Level::Velocity],
    };
    let rows = system.constraint_rows(tangent, levels).into_iter();
    rows.map(|(constraint, column, value)| (constraint, motion(column), value))
        .collect()
}

fn matrix(size: usize, entries: impl Iterator<Item = (usize, usize, f64)> + Clone) -> Sparse {
    let pattern = Arc::new(Pattern::of(size, |add| {
        let own = entries.clone();
        own.for_each(|(row, column, _)| add(row, column));
        (0..size).for_each(|i| add(i, i));
    }));
    let mut matrix = Sparse::zero(Arc::clone(&pattern));
    for (row, column, value) in entries {
        if let Some(index) = pattern.index(row, column) {
            matrix.values_mut()[index] += value;
        }
    }
    matrix
}

/// Index of an unknown, or of an equation, of a node among the six of its motion.
pub(super) fn motion(index: usize) -> usize {
    MOTION * (index / NODE_UNKNOWNS) + index % NODE_UNKNOWNS % Equation::Force.row()
}
