//! Sparse Cholesky factorization of E with pinned unknowns.
//!
//! Pinned rows and columns keep their diagonal entry only: the structure stays
//! that of E, and the solution is zero there when the right-hand side is.

//!
//! The unknowns are eliminated in their order: [`elimination_order`] finds one that
//! keeps the factor small, and the domain is numbered in it from the start, so that
//! neither matrix nor solutions need a second copy in another order.

use super::pins::Pins;
use crate::assembly::{Domain, Pattern, Scalar, largest};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::linalg::cholesky::simplicial::{
    prefactorize_symbolic_cholesky, prefactorize_symbolic_cholesky_scratch,
};
use faer::sparse::linalg::cholesky::supernodal::{
    SupernodalLltRef, SymbolicSupernodalCholesky, factorize_supernodal_numeric_llt,
    factorize_supernodal_numeric_llt_scratch, factorize_supernodal_symbolic_cholesky,
    factorize_supernodal_symbolic_cholesky_scratch,
};
use faer::sparse::linalg::{SymbolicSupernodalParams, amd};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::traits::ComplexField as FactorScalar;
use faer::{Conj, MatMut, Par, Spec};
use sprs::CsMatI;

/// A number that can be factored: real or complex.
pub trait Entry: Scalar + FactorScalar {}

impl<T: Scalar + FactorScalar> Entry for T {}

/// One thread: the result is the same on every machine and every run.
const SEQUENTIAL: Par = Par::Seq;

/// The smallest pivot of a factorization.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pivot {
    /// Node of the domain that the unknown belongs to.
    pub node: usize,
    /// Pivot relative to the diagonal entry of the matrix \[-\].
    pub ratio: f64,
}

/// Why a factorization failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FactorError {
    /// The matrix is not positive definite: at this pivot.
    NotPositive(Pivot),
    /// The section has no stiffness against some generalized strain.
    NoStiffness,
    /// No memory.
    OutOfMemory,
}

/// `L L^H = E_ff`, with E_ff the pinned E.
#[derive(Debug)]
pub struct Factor<T> {
    symbolic: SymbolicSupernodalCholesky<u32>,
    values: Vec<T>,
    pins: Pins,
    norm: f64,
    smallest_pivot: Pivot,
}

impl<T: Entry> Factor<T> {
    /// Factors the Hermitian matrix with lower triangle `e`, of the structure of
    /// `pattern`, after pinning. The matrix is given away: next to its factor it would
    /// take the largest part of the memory.
    ///
    /// # Errors
    /// [`FactorError`], also when a pivot is not a number.
    pub fn new(mut e: CsMatI<T, u32>, pattern: &Pattern, pins: Pins) -> Result<Self, FactorError> {
        pin(&mut e, pattern, &pins);
        let norm = one_norm(&e);
        let (symbolic, values) = factored(&e, pattern)?;
        let smallest_pivot = smallest_pivot(&symbolic, &values, &e);
        if smallest_pivot.ratio > 0.0 {
            Ok(Self {
                symbolic,
                values,
                pins,
                norm,
                smallest_pivot,
            })
        } else {
            Err(FactorError::NotPositive(smallest_pivot))
        }
    }

    /// Replaces the columns of `x` (n x k, column by column) by the solutions of
    /// `E_ff x = b`, pinned unknowns zero; `None` when there is no memory for it.
    pub fn solve(&self, x: &mut [T]) -> Option<()> {
        let rows = self.symbolic.nrows();
        let columns = x.len() / rows;
        self.clear_pinned(x);
        let request = self
            .symbolic
            .solve_in_place_scratch::<T>(columns, SEQUENTIAL);
        let mut memory = MemBuffer::try_new(request).ok()?;
        SupernodalLltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, rows, columns),
            SEQUENTIAL,
            MemStack::new(&mut memory),
        );
        Some(())
    }

    /// Sets the rows of pinned unknowns to zero in `x` (n x k, column by column).
    pub fn clear_pinned(&self, x: &mut [T]) {
        for column in x.chunks_exact_mut(self.symbolic.nrows()) {
            for &pin in self.pins.unknowns() {
                column[pin] = T::from_real(0.0);
            }
        }
    }

    /// Number of entries of L, the zeros that its blocks hold included.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Largest sum of the absolute values of a column of the pinned matrix \[-\].
    pub fn norm(&self) -> f64 {
        self.norm
    }

    /// The smallest pivot: how close the matrix is to being singular.
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

type Factored<T> = (SymbolicSupernodalCholesky<u32>, Vec<T>);

/// Structure and values of the factor of `e`.
fn factored<T: Entry>(e: &CsMatI<T, u32>, pattern: &Pattern) -> Result<Factored<T>, FactorError> {
    let symbolic = analyze(pattern).ok_or(FactorError::OutOfMemory)?;
    let mut values = vec![T::from_real(0.0); symbolic.len_val()];
    let starts = e.indptr();
    let structure = SymbolicSparseColMatRef::new_checked(
        e.rows(),
        e.cols(),
        starts.raw_storage(),
        None,
        e.indices(),
    );
    let parameters = Spec::default();
    let request =
        factorize_supernodal_numeric_llt_scratch::<u32, T>(&symbolic, SEQUENTIAL, parameters);
    let mut memory = MemBuffer::try_new(request).map_err(|_| FactorError::OutOfMemory)?;
    let outcome = factorize_supernodal_numeric_llt(
        &mut values,
        SparseColMatRef::new(structure, e.data()),
        LltRegularization::default(),
        &symbolic,
        SEQUENTIAL,
        MemStack::new(&mut memory),
        parameters,
    );
    if let Err(LltError::NonPositivePivot { index }) = outcome.map(|_| ()) {
        let node = index.min(symbolic.nrows().saturating_sub(1)) / 3;
        return Err(FactorError::NotPositive(Pivot { node, ratio: 0.0 }));
    }
    Ok((symbolic, values))
}

/// Zeros in the rows and columns of pins, off the diagonal.
fn pin<T: Scalar>(e: &mut CsMatI<T, u32>, pattern: &Pattern, pins: &Pins) {
    for &pin in pins.unknowns() {
        // the column below the diagonal entry, which comes first
        let column = e.indptr().outer_inds_sz(pin);
        e.data_mut()[column]
            .iter_mut()
            .skip(1)
            .for_each(|v| *v = T::zero());

        // the row left of the diagonal entry
        let (node, axis) = (pin / 3, pin % 3);
        for &other in pattern.neighbors(node) {
            let left = 3 * other as usize..pin.min(3 * other as usize + 3);
            let starts = match other as usize > node {
                true => continue,
                false => pattern.block(node as u32, other),
            };
            for column in left {
                let b = column % 3;
                let skipped = if other as usize == node { b } else { 0 };
                e.data_mut()[starts[b] + axis - skipped] = T::zero();
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

/// Structure of the factor; `None` without memory.
fn analyze(pattern: &Pattern) -> Option<SymbolicSupernodalCholesky<u32>> {
    let (starts, rows) = pattern.upper_structure()?;
    let n = 3 * pattern.node_count();
    let upper = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);

    let request = prefactorize_symbolic_cholesky_scratch::<u32>(n, rows.len())
        .or(factorize_supernodal_symbolic_cholesky_scratch::<u32>(n));
    let mut memory = MemBuffer::try_new(request).ok()?;
    let stack = MemStack::new(&mut memory);
    let (mut tree, mut counts) = (vec![0; n], vec![0; n]);
    let tree = prefactorize_symbolic_cholesky(&mut tree, &mut counts, upper, stack);
    let parameters = SymbolicSupernodalParams::default();
    factorize_supernodal_symbolic_cholesky(upper, tree, &counts, stack, parameters).ok()
}

/// `domain` with its nodes numbered as they are best eliminated, and its pattern;
/// `pattern` is that of the present numbers. `None` without memory.
pub fn in_elimination_order(domain: Domain, pattern: &Pattern) -> Option<(Domain, Pattern)> {
    let domain = domain.renumbered(&elimination_order(pattern)?);
    let pattern = Pattern::new(&domain);
    Some((domain, pattern))
}

/// An order of the nodes that keeps the factor small (approximate minimum degree), as
/// the list of nodes by place; `None` without memory.
///
/// It is found on the graph of nodes, nine times smaller than that of the unknowns and
/// with the same fill: the three unknowns of a node have the same neighbors.
pub fn elimination_order(pattern: &Pattern) -> Option<Vec<u32>> {
    let (starts, neighbors) = pattern.adjacency();
    let n = pattern.node_count();
    let graph = SymbolicSparseColMatRef::new_checked(n, n, starts, None, neighbors);

    let mut forward = vec![0; n];
    let mut inverse = vec![0; n];
    let request = amd::order_scratch::<u32>(n, neighbors.len());
    let mut memory = MemBuffer::try_new(request).ok()?;
    amd::order(
        &mut forward,
        &mut inverse,
        graph,
        amd::Control::default(),
        MemStack::new(&mut memory),
    )
    .ok()?;
    Some(forward)
}

/// The smallest ratio of a squared diagonal entry of the factor to the diagonal
/// entry of the matrix; a ratio that is not a number counts as smallest.
fn smallest_pivot<T: Scalar>(
    blocks: &SymbolicSupernodalCholesky<u32>,
    factor: &[T],
    e: &CsMatI<T, u32>,
) -> Pivot {
    let mut smallest = Pivot {
        node: 0,
        ratio: f64::INFINITY,
    };
    for s in 0..blocks.n_supernodes() {
        let begin = blocks.supernode_begin()[s] as usize;
        let end = blocks.supernode_end()[s] as usize;
        let first = blocks.col_ptr_for_val()[s] as usize;
        let rows = (blocks.col_ptr_for_val()[s + 1] as usize - first) / (end - begin);
        for column in begin..end {
            let local = column - begin;
            let pivot = factor[first + local * rows + local].modulus_squared();
            let diagonal = e.data()[e.indptr().outer_inds_sz(column).start].real();
            let ratio = pivot / diagonal;
            if ratio.is_nan() || ratio < smallest.ratio {
                smallest = Pivot {
                    node: column / 3,
                    ratio,
                };
            }
        }
    }
    smallest
}
