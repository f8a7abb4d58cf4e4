//! A block Krylov space: an orthonormal basis V of `B, T B, T^2 B, ...` and the
//! projection of the operator T on it,
//!
//! ```text
//! T V_k = V H_k + V_(k+1) R_(k+1)          H = V^T T V
//! ```
//!
//! with eigenvalues of H that converge to the eigenvalues of T, the largest magnitude
//! first. A block finds as many copies of a repeated eigenvalue as it has vectors.

use nalgebra::{DMatrix, DVector};

/// A column whose component normal to the space is less than this part of its size is in
/// the space.
const INSIDE: f64 = 1e-12;

/// A growing basis, and the projection of an operator on it.
pub(super) struct Space {
    /// The basis, with the next block at its end.
    basis: Vec<DVector<f64>>,
    /// `V^T T V`, with the rows of the next block.
    projected: DMatrix<f64>,
    /// Basis vectors whose products are in the projection.
    dimension: usize,
    block: usize,
    /// Maximum number of vectors.
    most: usize,
    /// Whether the last block was empty: the space contains all its products.
    is_whole: bool,
}

impl Space {
    /// The space of the block `start`, of at most `most` vectors.
    pub fn new(start: &DMatrix<f64>, most: usize) -> Self {
        let block = start.ncols();
        let capacity = most.max(block) + block;
        let mut space = Self {
            basis: Vec::with_capacity(capacity),
            projected: DMatrix::zeros(capacity, capacity),
            dimension: 0,
            block,
            most,
            is_whole: false,
        };
        for column in start.column_iter() {
            let (column, _) = space.beside(column.into_owned());
            space.basis.push(column);
        }
        space
    }

    /// The vectors whose products are not yet known.
    pub fn last_block(&self) -> DMatrix<f64> {
        DMatrix::from_columns(&self.basis[self.dimension..self.dimension + self.block])
    }

    /// Adds the products of the last block, and computes the next block.
    pub fn grow(&mut self, products: DMatrix<f64>) {
        let (first, block) = (self.dimension, self.block);
        let known = first + block;
        let mut left = 0;
        for (j, product) in products.column_iter().enumerate() {
            let size = product.norm();
            let (column, along) = self.beside(product.into_owned());
            self.projected
                .view_mut((0, first + j), (known + j, 1))
                .copy_from(&along.rows(0, known + j));
            let rest = along[known + j];
            let is_inside = rest <= INSIDE * size;
            self.projected[(known + j, first + j)] = if is_inside { 0.0 } else { rest };
            left += usize::from(!is_inside);
            let column = if is_inside { self.fresh() } else { column };
            self.basis.push(column);
        }
        self.dimension = known;
        self.is_whole = left == 0;
    }

    /// The projection on the vectors whose products are known.
    pub fn projection(&self) -> DMatrix<f64> {
        let size = (self.dimension, self.dimension);
        self.projected.view((0, 0), size).into_owned()
    }

    /// Number of vectors whose products are known.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Whether the space has no capacity for another block.
    pub fn is_full(&self) -> bool {
        self.is_whole || self.dimension + self.block > self.most
    }

    /// Whether the space contains the products of all its vectors: its eigenvalues are
    /// exact.
    pub fn is_whole(&self) -> bool {
        self.is_whole
    }

    /// The unit vector of the part of `column` normal to the basis, with the components of
    /// `column` along the basis and, last, the size of that part.
    fn beside(&self, mut column: DVector<f64>) -> (DVector<f64>, DVector<f64>) {
        let count = self.basis.len();
        let mut along = DVector::zeros(count + 1);
        // twice: one pass leaves the round-off of the removed part
        for _ in 0..2 {
            for (known, sum) in self.basis.iter().zip(along.iter_mut()) {
                let part = known.dot(&column);
                column.axpy(-part, known, 1.0);
                *sum += part;
            }
        }
        let norm = column.norm();
        along[count] = norm;
        if norm > 0.0 {
            column /= norm;
        }
        (column, along)
    }

    /// A unit vector normal to the basis.
    fn fresh(&self) -> DVector<f64> {
        let n = self.basis.first().map_or(0, DVector::len);
        let drawn = (1 + self.basis.len()) * n;
        let column = DVector::from_fn(n, |i, _| start_value(drawn + i));
        self.beside(column).0
    }
}

/// Entry of a start vector: unstructured but deterministic (the finalizer of the splitmix
/// generator applied to its index).
pub(super) fn start_value(i: usize) -> f64 {
    let mut z = (i as u64)
        .wrapping_add(1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 / (1u64 << 53) as f64 - 0.5
}
