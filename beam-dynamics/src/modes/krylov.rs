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
//! The start vectors have been through the operator already: what belongs to its zero
//! eigenvalues, which are defective, is gone.

use faer::{Mat, MatRef, c64};

use super::dense::{Eigenvectors, eigenvalues};

/// Change of the wanted eigenvalues while the space grows by an eighth at which they
/// count as found, relative: near enough for inverse iteration, which gives the last
/// digits.
const FOUND: f64 = 1e-10;
/// Vectors of the space at most, in parts of the wanted number of eigenvalues.
const MOST: usize = 8;
/// A column that keeps less than this part of its size beside the space is inside it.
const INSIDE: f64 = 1e-12;
/// Products that purge the start vectors: the chains of the zero eigenvalues are not
/// longer (a multiplier, a momentum, a place).
const PURGES: usize = 3;

/// Entry of a start vector: without structure and without chance (the finalizer of
/// the splitmix generator applied to its place).
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

/// The `sure` eigenvalues of largest magnitude, falling, from a space that is led by
/// `wanted`, which are a few more; copies up to `block` of one eigenvalue are told apart from one.
/// Those of which the operator knows no more than that they are in a cluster may move in it.
pub(super) fn largest(
    operator: &impl Operator,
    wanted: usize,
    sure: usize,
    block: usize,
) -> Vec<c64> {
    let n = operator.size();
    let most = (MOST * wanted).min(n);
    let mut space = Space::new(operator, block.min(n), most);
    let mut before: Vec<c64> = Vec::new();
    let mut check = 2 * wanted + block;
    loop {
        space.grow(operator);
        let is_whole = space.dimension + space.block > most;
        if space.dimension < check && !is_whole {
            continue;
        }
        let mut values = eigenvalues(space.projection());
        values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        values.truncate(wanted);
        let in_cluster = |value: &c64| operator.is_in_cluster(value);
        if is_whole || stand_still(&values, &before, sure, in_cluster) {
            values.truncate(sure);
            return values;
        }
        before = values;
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
    Eigenvectors::new(space.projection()).firsts(basis)
}

/// Whether the magnitudes of the first `sure` values have not changed, but for those in a
/// cluster.
fn stand_still(
    now: &[c64],
    before: &[c64],
    sure: usize,
    in_cluster: impl Fn(&c64) -> bool,
) -> bool {
    let close = |(a, b): (&c64, &c64)| {
        let is_same = (a.norm() - b.norm()).abs() <= FOUND * b.norm();
        is_same || (in_cluster(a) && in_cluster(b))
    };
    let sure = sure.min(now.len());
    sure > 0 && before.len() >= sure && now.iter().zip(before).take(sure).all(close)
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
        let room = most + block;
        let mut basis = Mat::zeros(n, room);
        basis.subcols_mut(0, block).copy_from(&start);
        Self {
            basis,
            projected: Mat::zeros(room, room),
            dimension: 0,
            block,
            drawn: n * block,
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
        let mut next = self.basis.subcols(first, b).to_owned();
        operator.multiply(&mut next);
        let sizes: Vec<_> = (0..b).map(|j| next.col(j).norm_l2()).collect();
        let basis = self.basis.subcols(0, known);
        // Twice: once leaves the round-off of what was taken away.
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
        for _ in 0..2 {
            for k in 0..j {
                let other = self.basis.col(known + k);
                let along = other.transpose() * &column;
                column -= other * faer::Scale(along);
                self.projected[(known + k, first + j)] += along;
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
        let found = largest(&Diagonal(values), 40, 30, 4);
        assert!(found.len() >= 30);
        for (i, value) in found.iter().take(30).enumerate() {
            let expected = ((1 + i / 3) as f64).powi(-2);
            assert!((value.norm() - expected).abs() < 1e-13, "{i}: {value}");
        }
    }

    /// An operator of rank five: the space ends there, and what is beyond it is zero.
    #[test]
    fn a_space_that_ends_is_no_trouble() {
        let values = (0..100).map(|i| if i < 5 { 2.0 + i as f64 } else { 0.0 });
        let found = largest(&Diagonal(values.collect()), 8, 8, 3);
        for (value, expected) in found.iter().zip([6.0, 5.0, 4.0, 3.0, 2.0, 0.0]) {
            assert!(
                (value.norm() - expected).abs() < 1e-12,
                "{value} {expected}"
            );
        }
    }
}
