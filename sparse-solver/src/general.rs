//! The factorization that chooses pivots for every matrix, used if no kept pivots are good
//! enough.

use std::sync::{Arc, OnceLock};

use faer::ColMut;
use faer::prelude::Solve;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};

use super::number::Number;
use super::scales::{Scales, scaled, scales};
use crate::pattern::Pattern;

/// Analysis of a pattern, made at its first use.
#[derive(Debug, Clone)]
pub(crate) struct GeneralSolver {
    pattern: Arc<Pattern>,
    /// Rows of the pattern in the format of the analysis, and the analysis.
    symbolic: OnceLock<(Vec<usize>, Option<SymbolicLu<usize>>)>,
}

/// Factors of a matrix.
#[derive(Debug)]
pub(crate) struct GeneralLu<T> {
    lu: Lu<usize, T>,
    scales: Scales,
}

impl GeneralSolver {
    pub fn new(pattern: &Arc<Pattern>) -> Self {
        Self {
            pattern: Arc::clone(pattern),
            symbolic: OnceLock::new(),
        }
    }

    /// Factorizes the matrix of the given values; `None` if it is singular or not finite.
    pub fn factorize<T: Number>(&self, values: &[T]) -> Option<GeneralLu<T>> {
        let pattern = &self.pattern;
        let (n, starts) = (pattern.size(), pattern.column_starts());
        let analyzed = self.symbolic.get_or_init(|| {
            let rows: Vec<_> = pattern.rows().iter().map(|&row| row as usize).collect();
            let indices = SymbolicSparseColMatRef::new_checked(n, n, starts, None, &rows);
            let symbolic = SymbolicLu::try_new(indices).ok();
            (rows, symbolic)
        });
        let (rows, symbolic) = analyzed;
        let indices = SymbolicSparseColMatRef::new_checked(n, n, starts, None, rows);
        if values.iter().any(|value| !value.size().is_finite()) {
            return None;
        }
        let scales = scales(pattern, values)?;
        let scaled = scaled(pattern, values, &scales);
        let view = SparseColMatRef::new(indices, &scaled[..]);
        let lu = Lu::try_new_with_symbolic(symbolic.clone()?, view).ok()?;
        Some(GeneralLu { lu, scales })
    }
}

impl<T: Number> GeneralLu<T> {
    /// Scale of each equation.
    pub fn row_scales(&self) -> &[f64] {
        &self.scales.0
    }

    /// Replaces b by x.
    pub fn solve(&self, b: &mut [T]) {
        let scale = |b: &mut [T], scales: &[f64]| {
            let scaled = b.iter_mut().zip(scales);
            scaled.for_each(|(value, scale)| *value = *value * *scale);
        };
        scale(b, &self.scales.0);
        self.lu
            .solve_in_place(ColMut::from_slice_mut(b).as_mat_mut());
        scale(b, &self.scales.1);
    }
}
