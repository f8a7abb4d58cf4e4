//! The linear systems of time integration: one pattern, many matrices.

use std::sync::Arc;

use super::{Factorization, LinearSolver};
use crate::assembly::{Pattern, Sparse};

/// Factorizes matrices on one pattern, one after the other, and solves with the last.
#[derive(Debug)]
pub struct StepSolver {
    solver: LinearSolver,
    last: Option<Factorization>,
}

impl StepSolver {
    /// Orders the unknowns of a pattern; `None` when it is structurally singular.
    pub fn new(pattern: &Arc<Pattern>) -> Option<Self> {
        Some(Self {
            solver: LinearSolver::new(pattern)?,
            last: None,
        })
    }

    /// Factorizes `matrix`; `None` when it is singular or not finite.
    pub fn factorize(&mut self, matrix: &Sparse) -> Option<()> {
        self.last = Some(self.solver.factorize(matrix.clone())?);
        Some(())
    }

    /// Forgets the last matrix and all that was kept of it, such as the order of its
    /// pivots: the next one is factorized as the first.
    pub fn forget(&mut self) {
        self.last = None;
    }

    /// Solves `A x = b` with the last matrix, `b` being replaced by x; `None` when there
    /// is no matrix, or x is not finite.
    pub fn solve(&mut self, b: &mut [f64]) -> Option<()> {
        self.last.as_ref()?.solve(b)
    }
}
