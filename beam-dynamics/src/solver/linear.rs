//! Sparse unsymmetric factorization on a fixed pattern.
//!
//! The rows and then the columns are scaled to a largest entry of one, so that
//! forces of 1e7 N and angles of 1e-3 rad meet on equal terms in the pivoting.
//! The factorization reports no error on singular matrices; solutions are therefore
//! checked for finite values and refined once.

use std::sync::Arc;

use faer::prelude::Solve;
use faer::reborrow::ReborrowMut;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{ColMut, Mat, MatMut, c64};

use crate::assembly::{Pattern, Sparse};

/// Analyses of a pattern, to be shared by all matrices on it.
#[derive(Debug)]
pub struct LinearSolver {
    symbolic: SymbolicLu<usize>,
    pattern: Arc<Pattern>,
}

/// A factorized matrix.
#[derive(Debug)]
pub struct Factorization {
    lu: Lu<usize, f64>,
    matrix: Sparse,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
}

impl LinearSolver {
    /// Orders the unknowns of a pattern; `None` when it is structurally singular.
    pub fn new(pattern: &Arc<Pattern>) -> Option<Self> {
        let symbolic = SymbolicLu::try_new(symbolic(pattern)).ok()?;
        Some(Self {
            symbolic,
            pattern: Arc::clone(pattern),
        })
    }

    /// Factorizes `matrix`; `None` when it is singular or not finite.
    pub fn factorize(&self, matrix: Sparse) -> Option<Factorization> {
        debug_assert!(Arc::ptr_eq(&self.pattern, matrix.pattern()));
        if matrix.values().iter().any(|value| !value.is_finite()) {
            return None;
        }
        let magnitudes: Vec<_> = matrix.values().iter().map(|value| value.abs()).collect();
        let (row_scale, column_scale) = scales(&self.pattern, &magnitudes)?;
        let scaled: Vec<_> = matrix
            .triplets()
            .map(|(i, j, value)| row_scale[i] * value * column_scale[j])
            .collect();
        let view = SparseColMatRef::new(symbolic(&self.pattern), &scaled[..]);
        let lu = Lu::try_new_with_symbolic(self.symbolic.clone(), view).ok()?;
        Some(Factorization {
            lu,
            matrix,
            row_scale,
            column_scale,
        })
    }
}

fn symbolic(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    let n = pattern.size();
    SymbolicSparseColMatRef::new_checked(n, n, pattern.column_starts(), None, pattern.rows())
}

/// Scales of rows and columns from the magnitudes of the entries; `None` when a row
/// or column is zero.
pub(super) fn scales(pattern: &Pattern, magnitudes: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
    let n = pattern.size();
    let mut rows = vec![0.0_f64; n];
    for (&i, magnitude) in pattern.rows().iter().zip(magnitudes) {
        rows[i] = rows[i].max(*magnitude);
    }
    let mut columns = vec![0.0_f64; n];
    for (j, column) in columns.iter_mut().enumerate() {
        for place in pattern.column_starts()[j]..pattern.column_starts()[j + 1] {
            let row = rows[pattern.rows()[place]].max(f64::MIN_POSITIVE);
            *column = column.max(magnitudes[place] / row);
        }
    }
    let inverse = |sizes: Vec<f64>| -> Option<Vec<f64>> {
        let invert = |size: f64| (size > 0.0 && size.is_finite()).then(|| 1.0 / size);
        sizes.into_iter().map(invert).collect()
    };
    Some((inverse(rows)?, inverse(columns)?))
}

/// A factorized complex matrix `A + s B` on the pattern of A and B.
#[derive(Debug)]
pub struct ComplexFactorization {
    lu: Lu<usize, c64>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
}

impl LinearSolver {
    /// Factorizes `a + s b`; `None` when it is singular to working precision.
    pub fn factorize_complex(
        &self,
        a: &Sparse,
        s: c64,
        b: &Sparse,
    ) -> Option<ComplexFactorization> {
        let values = a.values().iter().zip(b.values());
        let mut values: Vec<c64> = values.map(|(a, b)| s * *b + *a).collect();
        let magnitudes: Vec<_> = values.iter().map(|value| value.norm()).collect();
        let (row_scale, column_scale) = scales(&self.pattern, &magnitudes)?;
        for j in 0..self.pattern.size() {
            for place in self.pattern.column_starts()[j]..self.pattern.column_starts()[j + 1] {
                values[place] *= row_scale[self.pattern.rows()[place]] * column_scale[j];
            }
        }
        let view = SparseColMatRef::new(symbolic(&self.pattern), &values[..]);
        let lu = Lu::try_new_with_symbolic(self.symbolic.clone(), view).ok()?;
        Some(ComplexFactorization {
            lu,
            row_scale,
            column_scale,
        })
    }
}

impl ComplexFactorization {
    /// Solves `A x = b`, `b` being replaced by x; `None` when x is not finite.
    pub fn solve(&self, b: &mut [c64]) -> Option<()> {
        for (value, scale) in b.iter_mut().zip(&self.row_scale) {
            *value *= scale;
        }
        self.lu
            .solve_in_place(ColMut::from_slice_mut(b).as_mat_mut());
        for (value, scale) in b.iter_mut().zip(&self.column_scale) {
            *value *= scale;
        }
        b.iter().all(|value| value.is_finite()).then_some(())
    }
}

impl Factorization {
    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.row_scale.len()
    }

    /// Solves `A x = b`, `b` being replaced by x, with one step of refinement;
    /// `None` when the solution is not finite.
    pub fn solve(&self, b: &mut [f64]) -> Option<()> {
        let mut columns = Mat::from_fn(b.len(), 1, |i, _| b[i]);
        self.solve_columns(&mut columns)?;
        b.iter_mut()
            .enumerate()
            .for_each(|(i, value)| *value = columns[(i, 0)]);
        Some(())
    }

    /// Solves `A X = B` as [`Self::solve`] does, column by column.
    pub fn solve_columns(&self, b: &mut Mat<f64>) -> Option<()> {
        let mut x = b.clone();
        self.solve_once(x.as_mut());
        for (row, column, value) in self.matrix.triplets() {
            for j in 0..b.ncols() {
                b[(row, j)] -= value * x[(column, j)];
            }
        }
        self.solve_once(b.as_mut());
        *b += &x;
        b.is_all_finite().then_some(())
    }

    fn solve_once(&self, mut b: MatMut<'_, f64>) {
        for j in 0..b.ncols() {
            let scaled = b.rb_mut().col_mut(j).iter_mut().zip(&self.row_scale);
            scaled.for_each(|(value, scale)| *value *= scale);
        }
        self.lu.solve_in_place(b.rb_mut());
        for j in 0..b.ncols() {
            let scaled = b.rb_mut().col_mut(j).iter_mut().zip(&self.column_scale);
            scaled.for_each(|(value, scale)| *value *= scale);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solver(places: Vec<(usize, usize)>, values: &[f64]) -> (LinearSolver, Sparse) {
        let n = places.iter().map(|place| place.0 + 1).max().unwrap_or(0);
        let pattern = Arc::new(Pattern::new(n, places));
        let mut matrix = Sparse::zero(Arc::clone(&pattern));
        matrix.values_mut().copy_from_slice(values);
        (LinearSolver::new(&pattern).unwrap(), matrix)
    }

    #[test]
    fn badly_scaled_unsymmetric_systems_are_solved() {
        // [1e9 2e-3; 3e4 0], x = (2, -5e8): b = (2e9 - 1e6, 6e4).
        let places = vec![(0, 0), (1, 0), (0, 1)];
        let (solver, matrix) = solver(places, &[1e9, 3e4, 2e-3]);
        let factorization = solver.factorize(matrix).unwrap();
        let mut b = [2e9 - 1e6, 6e4];
        factorization.solve(&mut b).unwrap();
        assert!((b[0] - 2.0).abs() < 1e-12);
        assert!((b[1] / -5e8 - 1.0).abs() < 1e-10);
    }

    #[test]
    fn singular_matrices_give_no_solution() {
        let places = vec![(0, 0), (1, 0), (0, 1), (1, 1)];
        let (solver, matrix) = solver(places, &[1.0, 1.0, 1.0, 1.0]);
        let solution = solver.factorize(matrix).and_then(|f| {
            let mut b = [1.0, 2.0];
            f.solve(&mut b)
        });
        assert!(solution.is_none());
    }
}
