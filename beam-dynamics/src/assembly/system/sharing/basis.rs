//! Orthonormal bases of columns by the Gram-Schmidt method: each time from the longest of the
//! remaining columns, with reorthogonalization.

use std::ops::Range;

use nalgebra::DMatrix;

/// Length of a remaining column, relative to the longest of all, below which it is zero [-].
const ZERO: f64 = 1e-10;

/// Moves an orthonormal basis of the columns, with at most `most` columns, to the front; returns
/// their number. The remaining columns hold the remainders.
pub(super) fn gather(columns: &mut DMatrix<f64>, most: usize) -> usize {
    let count = columns.ncols();
    let longest = |columns: &DMatrix<f64>, from: usize| {
        let norms = (from..count).map(|j| (j, columns.column(j).norm_squared()));
        norms.fold((from, -1.0), |a, b| if b.1 > a.1 { b } else { a })
    };
    let all = longest(columns, 0).1;
    let mut found = 0;
    while found < most.min(count) {
        let (column, norm) = longest(columns, found);
        if norm <= ZERO * ZERO * all || !norm.is_finite() {
            break;
        }
        columns.swap_columns(found, column);
        take_from(columns, found, 0..found);
        let norm = columns.column(found).norm();
        columns.column_mut(found).unscale_mut(norm);
        for other in found + 1..count {
            take_from(columns, other, found..found + 1);
        }
        found += 1;
    }
    found
}

/// Makes a column orthogonal to other columns of length one.
fn take_from(columns: &mut DMatrix<f64>, column: usize, others: Range<usize>) {
    for other in others {
        let along = columns.column(other).dot(&columns.column(column));
        for i in 0..columns.nrows() {
            columns[(i, column)] -= along * columns[(i, other)];
        }
    }
}

/// Writes `I - Q Q^T`, with Q the first `count` columns of `basis`.
pub(super) fn beside(basis: &DMatrix<f64>, count: usize, out: &mut DMatrix<f64>) {
    let basis = basis.columns(0, count);
    out.fill_with_identity();
    for j in 0..out.ncols() {
        for i in 0..out.nrows() {
            out[(i, j)] -= basis.row(i).dot(&basis.row(j));
        }
    }
}
