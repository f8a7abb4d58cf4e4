//! Number of operations for the elimination of a matrix.

use beam_dynamics::assembly::Sparse;
use nalgebra::DMatrix;

/// Least pivot as a fraction of the largest entry of its column (D-131) [-].
const THRESHOLD: f64 = 0.1;

/// Operations (divisions, products and sums) of the LU factorization whose pivots may fill the
/// fewest entries (D-132), without operations on zeros. Dense storage: for small matrices.
pub fn of(matrix: &Sparse) -> f64 {
    let n = matrix.pattern().size();
    let mut left = DMatrix::zeros(n, n);
    for (row, column, value) in matrix.triplets() {
        left[(row, column)] = value;
    }
    scale(&mut left);
    let (mut rows, mut columns): (Vec<_>, Vec<_>) = ((0..n).collect(), (0..n).collect());
    let mut operations = 0.0;
    while let Some((row, column)) = pivot(&left, &rows, &columns) {
        rows.retain(|&i| i != row);
        columns.retain(|&j| j != column);
        let below: Vec<_> = rows.iter().filter(|&&i| left[(i, column)] != 0.0).collect();
        let beside: Vec<_> = columns.iter().filter(|&&j| left[(row, j)] != 0.0).collect();
        for &&i in &below {
            let factor = left[(i, column)] / left[(row, column)];
            beside
                .iter()
                .for_each(|&&j| left[(i, j)] -= factor * left[(row, j)]);
        }
        operations += (below.len() * (1 + 2 * beside.len())) as f64;
    }
    operations
}

/// Divides rows and then columns by their largest entries.
fn scale(matrix: &mut DMatrix<f64>) {
    for mut row in matrix.row_iter_mut() {
        let largest = row.amax();
        row /= largest;
    }
    for mut column in matrix.column_iter_mut() {
        let largest = column.amax();
        column /= largest;
    }
}

/// Row and column of the pivot among the remaining rows and columns.
fn pivot(left: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> Option<(usize, usize)> {
    let mut in_row = vec![0_usize; left.nrows()];
    for &j in columns {
        for &i in rows {
            in_row[i] += usize::from(left[(i, j)] != 0.0);
        }
    }
    let mut best: Option<(usize, (usize, usize))> = None;
    for &j in columns {
        let column = || rows.iter().filter(|&&i| left[(i, j)] != 0.0);
        let largest = column().fold(0.0_f64, |most, &i| most.max(left[(i, j)].abs()));
        let in_column = column().count();
        for &i in column().filter(|&&i| left[(i, j)].abs() >= THRESHOLD * largest) {
            let filled = (in_row[i] - 1) * (in_column - 1);
            if best.is_none_or(|(fewest, _)| filled < fewest) {
                best = Some((filled, (i, j)));
            }
        }
    }
    best.map(|(_, position)| position)
}
