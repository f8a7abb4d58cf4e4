//! Vectors of repeated eigenvalues: the ones of a dense solver may be nearly parallel. Copies of an eigenvalue mu
//! have the null space of `H - mu`, whose orthonormal basis are the right singular vectors of its smallest
//! singular values.

use faer::{Mat, c64};

/// An eigenvalue with real and imaginary part of its vector.
pub(super) type Pair = (c64, Mat<f64>);

/// Distance of copies relative to their size.
const COPIES: f64 = 1e-8;
/// Largest singular value of a null space, relative to the eigenvalue: a space that is smaller than the number
/// of its copies has no basis of vectors.
const NULL: f64 = 1e-6;

/// Replaces the vectors of copies by an orthonormal basis of their space.
pub(super) fn separate(h: &Mat<f64>, pairs: &mut [Pair]) {
    for first in 0..pairs.len() {
        let value = pairs[first].0;
        let is_copy = |pair: &Pair| (pair.0 - value).norm() <= COPIES * value.norm();
        let copies: Vec<_> = (0..pairs.len()).filter(|i| is_copy(&pairs[*i])).collect();
        if copies.len() < 2 || copies[0] != first {
            continue;
        }
        let sum = copies
            .iter()
            .fold(c64::new(0.0, 0.0), |sum, i| sum + pairs[*i].0);
        let mean = sum / copies.len() as f64;
        let Some(basis) = null_space(h, mean, copies.len()) else {
            continue;
        };
        for (vector, index) in basis.into_iter().zip(copies) {
            pairs[index].1 = vector;
        }
    }
}

/// A basis of the null space of `H - value` of a dimension; `None` if its dimension is smaller.
fn null_space(h: &Mat<f64>, value: c64, dimension: usize) -> Option<Vec<Mat<f64>>> {
    let n = h.nrows();
    let shifted = Mat::from_fn(n, n, |i, j| {
        let own = c64::new(h[(i, j)], 0.0);
        if i == j { own - value } else { own }
    });
    let parts = shifted.svd().ok()?;
    let (sizes, vectors) = (parts.S().column_vector(), parts.V());
    let first = n.checked_sub(dimension)?;
    let is_null = (first..n).all(|k| sizes[k].norm() <= NULL * value.norm());
    let of_column = |k: usize| {
        // A real matrix has real vectors, up to a phase.
        let column = vectors.col(k);
        let largest = column.iter().fold(c64::new(0.0, 0.0), |largest, own| {
            if own.norm() > largest.norm() {
                *own
            } else {
                largest
            }
        });
        let phase = largest.conj() / largest.norm();
        Mat::from_fn(n, 2, |i, part| {
            let own = column[i] * phase;
            match part {
                0 => own.re,
                _ if value.im == 0.0 => 0.0,
                _ => own.im,
            }
        })
    };
    is_null.then(|| (first..n).map(of_column).collect())
}
