//! QR factors with column pivots that end where the rank ends.

use faer::{Mat, MatRef};

/// `M P = Q R` of the rank that the pivots show.
pub(super) struct Ranked {
    /// Vectors v of the reflections `1 - v v^T` whose product is Q; each begins in the row of its
    /// number.
    reflections: Vec<Vec<f64>>,
    /// R, as many rows as the rank.
    pub r: Mat<f64>,
    /// The column of M in each column of `M P`.
    pub order: Vec<usize>,
    /// Number of pivots above zero.
    pub rank: usize,
}

/// Replaces a part of a column by its reflection; returns the square of the length without the first
/// entry.
fn reflect(v: &[f64], column: &mut [f64]) -> f64 {
    let along: f64 = v.iter().zip(&*column).map(|(v, x)| v * x).sum();
    for (x, v) in column.iter_mut().zip(v) {
        *x -= along * v;
    }
    column.iter().skip(1).map(|x| x * x).sum()
}

/// The vector of the reflection of a column of a length to its first entry, and this entry.
fn reflection(column: &[f64], length: f64) -> (Vec<f64>, f64) {
    let first = column.first().copied().unwrap_or(0.0);
    let pivot = -length.copysign(first);
    let mut v = column.to_vec();
    if let Some(entry) = v.first_mut() {
        *entry -= pivot;
    }
    // |v|^2 = 2 length (length + |first|).
    let scale = (length * (length + first.abs())).sqrt();
    v.iter_mut().for_each(|entry| *entry /= scale);
    (v, pivot)
}

/// The factors of a finite matrix; pivots up to the part `zero` of the `scale`, or of the first pivot,
/// are zero.
pub(super) fn ranked(matrix: MatRef<'_, f64>, (zero, scale): (f64, Option<f64>)) -> Ranked {
    let (rows, columns) = matrix.shape();
    let mut work = matrix.to_owned();
    let mut order: Vec<_> = (0..columns).collect();
    let square = |j: usize| matrix.col(j).squared_norm_l2();
    let mut squares: Vec<_> = (0..columns).map(square).collect();
    let mut reflections = Vec::new();
    let mut least = scale.map(|scale| zero * scale);
    for k in 0..rows.min(columns) {
        let most = (k..columns).max_by(|a, b| squares[*a].total_cmp(&squares[*b]));
        let most = most.unwrap_or(k);
        let length = work.col_as_slice(most)[k..].iter().map(|x| x * x);
        let length = length.sum::<f64>().sqrt();
        let least = *least.get_or_insert(zero * length);
        if length <= least || length.is_nan() {
            break;
        }
        order.swap(k, most);
        squares.swap(k, most);
        if most != k {
            for i in 0..rows {
                (work[(i, k)], work[(i, most)]) = (work[(i, most)], work[(i, k)]);
            }
        }
        let (v, pivot) = reflection(&work.col_as_slice(k)[k..], length);
        work[(k, k)] = pivot;
        for (j, square) in squares.iter_mut().enumerate().skip(k + 1) {
            *square = reflect(&v, &mut work.col_as_slice_mut(j)[k..]);
        }
        reflections.push(v);
    }
    let rank = reflections.len();
    let r = Mat::from_fn(
        rank,
        columns,
        |i, j| if i <= j { work[(i, j)] } else { 0.0 },
    );
    Ranked {
        reflections,
        r,
        order,
        rank,
    }
}

impl Ranked {
    /// The regular part of R.
    fn pivots(&self) -> MatRef<'_, f64> {
        self.r.get(..self.rank, ..self.rank)
    }

    /// `R11^-1 M`.
    pub fn solved(&self, mut matrix: Mat<f64>) -> Mat<f64> {
        if self.rank > 0 && matrix.ncols() > 0 {
            let pivots = self.pivots();
            pivots.solve_upper_triangular_in_place(&mut matrix);
        }
        matrix
    }

    /// `R11^-1 R12`: the dependent columns by the independent ones.
    pub fn dependent(&self) -> Mat<f64> {
        self.solved(self.r.get(..self.rank, self.rank..).to_owned())
    }

    /// The columns of a matrix in the order of the pivots.
    pub fn ordered(&self, matrix: &Mat<f64>) -> Mat<f64> {
        Mat::from_fn(matrix.nrows(), matrix.ncols(), |i, j| {
            matrix[(i, self.order[j])]
        })
    }

    /// `Q^T M`: the rows of the rank, and the others.
    pub fn rows(&self, matrix: &Mat<f64>) -> [Mat<f64>; 2] {
        let mut product = matrix.clone();
        for j in 0..product.ncols() {
            for (k, v) in self.reflections.iter().enumerate() {
                reflect(v, &mut product.col_as_slice_mut(j)[k..]);
            }
        }
        let (above, below) = product.as_ref().split_at_row(self.rank);
        [above.to_owned(), below.to_owned()]
    }
}

/// The columns of a matrix before an index, and the others.
pub(super) fn split(matrix: &Mat<f64>, at: usize) -> [Mat<f64>; 2] {
    let (left, right) = matrix.as_ref().split_at_col(at);
    [left.to_owned(), right.to_owned()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `Q^T M P - R`, whose rows below the rank are zero.
    fn off(matrix: &Mat<f64>, found: &Ranked) -> f64 {
        let [above, below] = found.rows(&found.ordered(matrix));
        (above - &found.r).norm_max().max(below.norm_max())
    }

    // Columns by falling size: a cycle of three, and the sum of the first two.
    #[test]
    fn factors_give_the_matrix_and_its_rank() {
        let entries = [
            [1.0, 0.2, 90.0, 1.2],
            [0.5, 9.0, -1.0, 9.5],
            [0.0, 0.3, 2.0, 0.3],
            [0.1, 1.0, 0.7, 1.1],
        ];
        let matrix = Mat::from_fn(4, 4, |i, j| entries[i][j]);
        let found = ranked(matrix.as_ref(), (1e-12, None));
        assert_eq!(found.rank, 3);
        assert_eq!(found.order[..2], [2, 3]);
        assert!(off(&matrix, &found) < 1e-13);
        let [independent, dependent] = split(&found.ordered(&matrix), 3);
        let rest = independent * found.dependent() - dependent;
        assert!(rest.norm_max() < 1e-13, "{rest:?}");
    }

    // Exact zeros, in all columns and in some.
    #[test]
    fn zeros_have_no_rank() {
        let some = |i: usize, j: usize| {
            if i % 3 == 1 && j % 4 < 2 {
                (1.3 * i as f64 + 0.7 * (i * j) as f64).sin()
            } else {
                0.0
            }
        };
        for (matrix, rank) in [
            (Mat::zeros(1, 1), 0),
            (Mat::zeros(0, 2), 0),
            (Mat::zeros(5, 5), 0),
            (Mat::from_fn(20, 20, some), 7),
        ] {
            let found = ranked(matrix.as_ref(), (1e-12, Some(1.0)));
            assert_eq!(found.rank, rank);
            assert!(off(&matrix, &found) < 1e-14);
        }
    }
}
