//! Sparse Cholesky factorization of E with pinned unknowns.
//!
//! Pinned rows and columns keep only their diagonal entry: the structure is the structure
//! of E, and the solution is zero there if the right-hand side is.
//!
//! Without potentials E is positive definite, `E = L L^H`. With them it is quasi-definite,
//! positive for displacements and negative for potentials, so that `E = L D L^H` exists in
//! any order of the unknowns, with the signs of D known.
//!
//! # References
//! - [Vanderbei1995]: quasi-definite matrices are strongly factorizable.
//!
//! The unknowns are eliminated in their order: [`elimination_order`] finds an order that
//! keeps the factor small, and the domain is numbered in this order, so that neither matrix
//! nor solutions need a second copy.

use super::pins::Pins;
use crate::assembly::{Domain, Pattern, Scalar, largest};
use sparse_solver::{
    Cholesky, CholeskyBlocks, CholeskyError, CholeskyNumber, Definiteness, Triangle, minimum_degree,
};
use sprs::CsMatI;

/// A number that can be factored: real or complex.
pub trait Entry: Scalar + CholeskyNumber {}

impl<T: Scalar + CholeskyNumber> Entry for T {}

/// The smallest pivot of a factorization.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pivot {
    /// Node of the domain of the unknown.
    pub node: usize,
    /// Pivot relative to the diagonal entry of the matrix \[-\].
    pub ratio: f64,
}

/// Reason why a factorization failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FactorError {
    /// The matrix is not positive definite, at this pivot.
    NotPositive(Pivot),
    /// The section has no stiffness against some generalized strain.
    NoStiffness,
    /// Insufficient memory.
    OutOfMemory,
}

/// `L L^H = E_ff`, or `L D L^H` with potentials, with E_ff the pinned E.
#[derive(Debug)]
pub struct Factor<T> {
    cholesky: Cholesky<T>,
    /// For each row its unknown, if potentials make the orders differ.
    order: Option<Vec<u32>>,
    pins: Pins,
    norm: f64,
    smallest_pivot: Pivot,
}

impl<T: Entry> Factor<T> {
    /// Factors the Hermitian matrix with lower triangle `e`, of the structure of `pattern`,
    /// after pinning. The matrix is consumed: after its factor it is the largest part of
    /// the memory.
    ///
    /// # Errors
    /// [`FactorError`], also when a pivot is NaN.
    pub fn new(mut e: CsMatI<T, u32>, pattern: &Pattern, pins: Pins) -> Result<Self, FactorError> {
        pin(&mut e, pattern, &pins);
        let norm = one_norm(&e);
        let cholesky = factored(&e, pattern)?;
        let smallest_pivot = smallest_pivot(&cholesky, (&e, pattern));
        if smallest_pivot.ratio > 0.0 {
            Ok(Self {
                cholesky,
                order: pattern.order().map(<[u32]>::to_vec),
                pins,
                norm,
                smallest_pivot,
            })
        } else {
            Err(FactorError::NotPositive(smallest_pivot))
        }
    }

    /// Replaces the columns of `x` (n x k, column by column) by the solutions of
    /// `E_ff x = b`, pinned unknowns zero; `None` if memory is insufficient.
    pub fn solve(&self, x: &mut [T]) -> Option<()> {
        self.clear_pinned(x);
        let Some(order) = &self.order else {
            return self.cholesky.solve(x);
        };
        let rows = self.cholesky.rows();
        let mut in_order = Vec::with_capacity(x.len());
        for column in x.chunks_exact(rows) {
            in_order.extend(order.iter().map(|&unknown| column[unknown as usize]));
        }
        self.cholesky.solve(&mut in_order)?;
        for (column, solved) in x.chunks_exact_mut(rows).zip(in_order.chunks_exact(rows)) {
            for (&unknown, value) in order.iter().zip(solved) {
                column[unknown as usize] = *value;
            }
        }
        Some(())
    }

    /// Sets the rows of pinned unknowns to zero in `x` (n x k, column by column).
    pub fn clear_pinned(&self, x: &mut [T]) {
        for column in x.chunks_exact_mut(self.cholesky.rows()) {
            for &pin in self.pins.unknowns() {
                column[pin] = T::from_real(0.0);
            }
        }
    }

    /// Number of entries of L, including the zeros in its blocks.
    pub fn entries(&self) -> usize {
        self.cholesky.entries()
    }

    /// Largest sum of the absolute values of a column of the pinned matrix \[-\].
    pub fn norm(&self) -> f64 {
        self.norm
    }

    /// The smallest pivot, a measure of the distance to a singular matrix.
    pub fn smallest_pivot(&self) -> Pivot {
        self.smallest_pivot
    }
}

/// Whether the symmetric matrix with lower triangle `e`, of the structure of `pattern`,
/// is positive definite.
///
/// # Errors
/// [`FactorError::NotPositive`] at the first node where it is not, or
/// [`FactorError::OutOfMemory`].
pub fn require_positive(e: &CsMatI<f64, u32>, pattern: &Pattern) -> Result<(), FactorError> {
    factored(e, pattern).map(|_| ())
}

/// The factor of `e`.
fn factored<T: Entry>(e: &CsMatI<T, u32>, pattern: &Pattern) -> Result<Cholesky<T>, FactorError> {
    let blocks = blocks(pattern).ok_or(FactorError::OutOfMemory)?;
    let starts = e.indptr();
    let lower = Triangle {
        starts: starts.raw_storage(),
        rows: e.indices(),
    };
    Cholesky::new(blocks, (lower, e.data()), definiteness(pattern)).map_err(|error| match error {
        CholeskyError::OutOfMemory => FactorError::OutOfMemory,
        CholeskyError::Pivot(row) => {
            let (node, _) = pattern.node_of(row);
            FactorError::NotPositive(Pivot { node, ratio: 0.0 })
        }
    })
}

/// The blocks of the factor; `None` if memory is insufficient.
fn blocks(pattern: &Pattern) -> Option<CholeskyBlocks> {
    let (starts, rows) = pattern.upper_structure()?;
    CholeskyBlocks::new(Triangle {
        starts: &starts,
        rows: &rows,
    })
}

/// Potentials have an order of their own.
fn definiteness(pattern: &Pattern) -> Definiteness {
    match pattern.order() {
        None => Definiteness::Positive,
        Some(_) => Definiteness::Quasi,
    }
}

/// Sets the rows and columns of pins to zero, except the diagonal, which is never zero.
fn pin<T: Scalar>(e: &mut CsMatI<T, u32>, pattern: &Pattern, pins: &Pins) {
    let rows = pattern.order().map(|order| {
        let mut rows = vec![0; order.len()];
        for (row, &unknown) in order.iter().enumerate() {
            rows[unknown as usize] = row;
        }
        rows
    });
    for &pin in pins.unknowns() {
        let row = rows.as_ref().map_or(pin, |rows| rows[pin]);
        // the column below the diagonal entry, which comes first
        let column = e.indptr().outer_inds_sz(row);
        let (diagonal, below) = e.data_mut()[column].split_at_mut(1);
        below.iter_mut().for_each(|v| *v = T::zero());
        if diagonal[0].is_zero() {
            diagonal[0] = T::one();
        }

        // the row left of the diagonal entry
        let (node, axis) = pattern.node_of(row);
        for &other in pattern.neighbors(node) {
            let is_own = other as usize == node;
            let columns = match is_own {
                true => axis,
                false if other as usize > node => continue,
                false => pattern.size(other as usize),
            };
            let starts = pattern.block(node as u32, other);
            for (b, start) in starts.into_iter().enumerate().take(columns) {
                let skipped = if is_own { b } else { 0 };
                e.data_mut()[start + axis - skipped] = T::zero();
            }
        }
    }
}

/// Largest sum of absolute values of a column of the Hermitian matrix whose lower
/// triangle is given.
fn one_norm<T: Scalar>(lower: &CsMatI<T, u32>) -> f64 {
    let mut sums = vec![0.0; lower.cols()];
    for (j, column) in lower.outer_iterator().enumerate() {
        for (i, value) in column.iter() {
            let size = value.modulus();
            sums[j] += size;
            if i != j {
                sums[i] += size;
            }
        }
    }
    sums.into_iter().fold(0.0, largest)
}

/// `domain` with its nodes numbered in the elimination order, and its pattern; `pattern`
/// belongs to the present numbers. `None` if memory is insufficient.
pub fn in_elimination_order(domain: Domain, pattern: &Pattern) -> Option<(Domain, Pattern)> {
    let domain = domain.renumbered(&elimination_order(pattern)?);
    let pattern = Pattern::new(&domain);
    Some((domain, pattern))
}

/// An order of the nodes that keeps the factor small (approximate minimum degree), as the
/// list of nodes by position; `None` if memory is insufficient.
///
/// It is computed on the graph of nodes, nine times smaller than the graph of unknowns and
/// with the same fill: the three unknowns of a node have the same neighbors.
pub fn elimination_order(pattern: &Pattern) -> Option<Vec<u32>> {
    let (starts, rows) = pattern.adjacency();
    minimum_degree(Triangle { starts, rows })
}

/// The smallest ratio of a pivot, a diagonal entry of D or a squared diagonal entry of L,
/// to the diagonal entry of the matrix; NaN is treated as smallest.
fn smallest_pivot<T: Entry>(
    cholesky: &Cholesky<T>,
    (e, pattern): (&CsMatI<T, u32>, &Pattern),
) -> Pivot {
    let is_definite = definiteness(pattern) == Definiteness::Positive;
    let mut smallest = (0, f64::INFINITY);
    for (row, entry) in cholesky.pivots().enumerate() {
        let pivot = if is_definite {
            entry.modulus_squared()
        } else {
            entry.real()
        };
        let diagonal = e.data()[e.indptr().outer_inds_sz(row).start].real();
        let ratio = pivot / diagonal;
        if ratio.is_nan() || ratio < smallest.1 {
            smallest = (row, ratio);
        }
    }
    let (row, ratio) = smallest;
    Pivot {
        node: pattern.node_of(row).0,
        ratio,
    }
}
