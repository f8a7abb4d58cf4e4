//! The largest eigenvalues of an operator, by a block Krylov space.
//!
//! From a block of start vectors B the space of `B, T B, T^2 B, ...` is built, with an
//! orthonormal basis V and the projection of the operator on it,
//!
//! ```text
//! T V_k = V H_k + V_(k+1) R_(k+1)          H = V^T T V
//! ```
//!
//! the eigenvalues of H tending to the largest of T. A block sees as many copies of a
//! repeated eigenvalue as it has vectors, in one space of a few times the wanted number
//! of vectors; iterating a whole space costs ten times as many products.
//!
//! The operator was applied to the start vectors already, which removes the parts of its zero
//! eigenvalues; these are defective.

use faer::{Mat, MatRef, c64};

use crate::solver::Eigenvectors;

/// Relative error of a vector up to which its value counts as found: near enough for inverse
/// iteration, which gives the last digits, and for counting the copies of a value.
const FOUND: f64 = 1e-7;
/// Largest number of vectors in the space, as a multiple of the wanted eigenvalues.
const MOST: usize = 8;
/// A column that keeps less than this part of its size beside the space is inside it.
const INSIDE: f64 = 1e-12;
/// Vectors for which a space has memory at first.
const FIRST: usize = 128;
/// Products that purge the start vectors: the chains of the zero eigenvalues are not
/// longer (a multiplier, a momentum, a position).
const PURGES: usize = 3;

/// Entry of a start vector: without structure and without chance (the finalizer of
/// the splitmix generator applied to its index).
pub(super) fn start_value(i: usize) -> f64 {
    let mut z = (i as u64)
        .wrapping_add(1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}

/// An operator on columns: replaces each by its product.
pub(super) trait Operator {
    /// Length of the columns.
    fn size(&self) -> usize;

    /// `x <- T x`, column by column.
    fn multiply(&self, x: &mut Mat<f64>);

    /// Whether an eigenvalue is one of a cluster in which round-off moves them.
    fn is_in_cluster(&self, value: &c64) -> bool;
}

/// Eigenvalues of an operator with approximations of their vectors.
pub(super) struct Found {
    /// The eigenvalues of largest magnitude, descending.
    pub values: Vec<c64>,
    /// Approximate vectors of the values, of a conjugate pair the first one only.
    pub ritz: Vec<Ritz>,
    basis: Mat<f64>,
}

/// An approximate eigenvector in a Krylov space.
pub(super) struct Ritz {
    /// Its eigenvalue.
    pub value: c64,
    /// `|T x - mu x| / |mu x|`.
    pub error: f64,
    /// Real and imaginary part of the coordinates in the basis.
    coordinates: Mat<f64>,
}

impl Found {
    /// Vectors of the operator from their coordinates: real and imaginary part of each, two
    /// columns.
    pub fn vectors(&self, ritz: &[&Ritz]) -> Mat<f64> {
        let d = self.basis.ncols();
        let part = |i: usize, j: usize| ritz[j / 2].coordinates[(i, j % 2)];
        &self.basis * Mat::from_fn(d, 2 * ritz.len(), part)
    }
}

/// The `sure` eigenvalues of largest magnitude, descending. Convergence is judged on them; the
/// size of the space follows from `wanted` values, a few more; multiplicities up to `block` are
/// resolved. Values in a cluster, in which round-off moves them, count as converged.
pub(super) fn largest(operator: &impl Operator, wanted: usize, sure: usize, block: usize) -> Found {
    let n = operator.size();
    let most = (MOST * wanted).min(n);
    let mut space = Space::new(operator, block.min(n), most);
    let mut check = 2 * wanted + block;
    loop {
        space.grow(operator);
        let is_whole = space.dimension + space.block > most;
        if space.dimension < check && !is_whole {
            continue;
        }
        let (values, ritz) = space.ritz(wanted);
        let is_found = |ritz: &Ritz| ritz.error <= FOUND || operator.is_in_cluster(&ritz.value);
        let least = values.get(sure.min(values.len()).saturating_sub(1));
        let least = least.map_or(0.0, |value| value.norm());
        let mut judged = ritz.iter().filter(|ritz| ritz.value.norm() >= least);
        if is_whole || (values.len() >= sure.min(n) && judged.all(is_found)) {
            return space.found((values, ritz), sure);
        }
        check = space.dimension + space.dimension / 8;
    }
}
/// Approximations of the largest eigenvalues from `steps` products of a block, of a pair the
/// first, with real and imaginary part of their vectors.
pub(super) fn rough(operator: &impl Operator, block: usize, steps: usize) -> Vec<(c64, Mat<f64>)> {
    let n = operator.size();
    let block = block.min(n);
    let mut space = Space::new(operator, block, (steps * block).min(n));
    for _ in 0..steps.min(n / block.max(1)) {
        space.grow(operator);
    }
    let basis = space.basis.subcols(0, space.dimension);
    let firsts = Eigenvectors::new(space.projection()).firsts().into_iter();
    firsts
        .map(|(value, parts)| (value, basis * &parts))
        .collect()
}

/// A growing orthonormal basis and the projection of the operator on it.
struct Space {
    /// Columns: the basis, with the block that comes next at its end.
    basis: Mat<f64>,
    /// `V^T T V`, with the rows of the next block.
    projected: Mat<f64>,
    /// Basis vectors whose products are in the projection.
    dimension: usize,
    block: usize,
    /// Start values used so far.
    drawn: usize,
}

impl Space {
    fn new(operator: &impl Operator, block: usize, most: usize) -> Self {
        let n = operator.size();
        let mut start = Mat::from_fn(n, block, |i, j| start_value(i + j * n));
        for _ in 0..PURGES {
            operator.multiply(&mut start);
            start = start.qr().compute_thin_Q();
        }
        let mut space = Self {
            basis: start,
            projected: Mat::new(),
            dimension: 0,
            block,
            drawn: n * block,
        };
        space.reserve(most.min(FIRST) + block);
        space
    }

    /// Gives the space a capacity of at least `columns` vectors.
    fn reserve(&mut self, columns: usize) {
        if self.projected.ncols() < columns {
            let n = self.basis.nrows();
            self.basis.resize_with(n, columns, |_, _| 0.0);
            self.projected.resize_with(columns, columns, |_, _| 0.0);
        }
    }

    /// Relative error of a vector of the space, with real and imaginary part of its
    /// coordinates as columns, as an eigenvector of `value`:
    /// `|T x - mu x| = |R y|`, y the coordinates in the last block.
    fn error(&self, value: c64, coordinates: &Mat<f64>) -> f64 {
        let (d, first) = (self.dimension, self.dimension - self.block);
        let last = coordinates.subrows(first, self.block);
        let rest = self.projected.submatrix(d, first, self.block, self.block) * last;
        rest.norm_l2() / (value.norm() * coordinates.norm_l2())
    }

    /// The `wanted` eigenvalues of largest magnitude of the projection, descending, and their
    /// vectors.
    fn ritz(&self, wanted: usize) -> (Vec<c64>, Vec<Ritz>) {
        let all = Eigenvectors::new(self.projection());
        let mut values = all.values.clone();
        values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        values.truncate(wanted);
        let least = values.last().map_or(0.0, |value| value.norm());
        let mut ritz: Vec<_> = all
            .firsts()
            .into_iter()
            .filter(|(value, _)| value.norm() >= least)
            .map(|(value, coordinates)| Ritz {
                value,
                error: self.error(value, &coordinates),
                coordinates,
            })
            .collect();
        ritz.sort_by(|a, b| b.value.norm().total_cmp(&a.value.norm()));
        (values, ritz)
    }

    /// The result: the first `sure` values, and the basis of their vectors.
    fn found(mut self, (mut values, ritz): (Vec<c64>, Vec<Ritz>), sure: usize) -> Found {
        values.truncate(sure);
        self.basis.truncate(self.basis.nrows(), self.dimension);
        Found {
            values,
            ritz,
            basis: self.basis,
        }
    }

    /// The projection on the vectors whose products are known.
    fn projection(&self) -> MatRef<'_, f64> {
        self.projected
            .submatrix(0, 0, self.dimension, self.dimension)
    }

    /// Takes the products of the last block in, and finds the next block.
    fn grow(&mut self, operator: &impl Operator) {
        let (first, b) = (self.dimension, self.block);
        let known = first + b;
        if known + b > self.projected.ncols() {
            self.reserve(known + b + known / 4);
        }
        let mut next = self.basis.subcols(first, b).to_owned();
        operator.multiply(&mut next);
        let sizes: Vec<_> = (0..b).map(|j| next.col(j).norm_l2()).collect();
        let basis = self.basis.subcols(0, known);
        // Twice: the first projection leaves the round-off of the removed part.
        for _ in 0..2 {
            let along = basis.transpose() * &next;
            next -= basis * &along;
            let mut columns = self.projected.submatrix_mut(0, first, known, b);
            columns += &along;
        }
        self.dimension = known;
        for (j, size) in sizes.into_iter().enumerate() {
            self.append(next.col(j).to_owned(), size, j);
        }
    }

    /// Adds column `j` of the next block, orthogonal to the basis but not yet to the
    /// block's columns before it; a fresh vector where nothing of it is left.
    fn append(&mut self, mut column: faer::Col<f64>, size: f64, j: usize) {
        let (known, first) = (self.dimension, self.dimension - self.block);
        let others = self.basis.subcols(known, j);
        for _ in 0..2 {
            let along = others.transpose() * &column;
            column -= others * &along;
            for k in 0..j {
                self.projected[(known + k, first + j)] += along[k];
            }
        }
        let mut norm = column.norm_l2();
        if norm <= INSIDE * size || norm == 0.0 {
            column = self.fresh(known + j);
            norm = 0.0;
        } else {
            column *= faer::Scale(1.0 / norm);
        }
        self.projected[(known + j, first + j)] = norm;
        self.basis.col_mut(known + j).copy_from(&column);
    }

    /// A unit vector orthogonal to the first `count` columns of the basis.
    fn fresh(&mut self, count: usize) -> faer::Col<f64> {
        let n = self.basis.nrows();
        let drawn = self.drawn;
        self.drawn += n;
        let mut column = faer::Col::from_fn(n, |i| start_value(drawn + i));
        for _ in 0..2 {
            let along = self.basis.subcols(0, count).transpose() * &column;
            column -= self.basis.subcols(0, count) * &along;
        }
        let norm = column.norm_l2();
        // A basis of the whole space leaves nothing.
        let scale = if norm > 0.0 { 1.0 / norm } else { 0.0 };
        column * faer::Scale(scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A diagonal operator.
    struct Diagonal(Vec<f64>);

    impl Operator for Diagonal {
        fn size(&self) -> usize {
            self.0.len()
        }

        fn is_in_cluster(&self, _: &c64) -> bool {
            false
        }

        fn multiply(&self, x: &mut Mat<f64>) {
            for j in 0..x.ncols() {
                for (i, factor) in self.0.iter().enumerate() {
                    x[(i, j)] *= factor;
                }
            }
        }
    }

    /// Values 1/k^2, each three times: a block of four finds all copies of the first
    /// ten, to the round-off of numbers of order one.
    #[test]
    fn copies_are_all_found() {
        let values = (0..600).map(|i| ((1 + i / 3) as f64).powi(-2)).collect();
        let found = largest(&Diagonal(values), 40, 30, 4).values;
        assert!(found.len() >= 30);
        for (i, value) in found.iter().take(30).enumerate() {
            let expected = ((1 + i / 3) as f64).powi(-2);
            assert!((value.norm() - expected).abs() < 1e-13, "{i}: {value}");
        }
    }

    /// An operator of rank five: the space ends there, and all other eigenvalues are zero.
    #[test]
    fn a_space_that_ends_is_no_trouble() {
        let values = (0..100).map(|i| if i < 5 { 2.0 + i as f64 } else { 0.0 });
        let found = largest(&Diagonal(values.collect()), 8, 8, 3).values;
        for (value, expected) in found.iter().zip([6.0, 5.0, 4.0, 3.0, 2.0, 0.0]) {
            assert!(
                (value.norm() - expected).abs() < 1e-12,
                "{value} {expected}"
            );
        }
    }
}
