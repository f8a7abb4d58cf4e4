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
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::linalg::cholesky::simplicial::{
    prefactorize_symbolic_cholesky, prefactorize_symbolic_cholesky_scratch,
};
use faer::sparse::linalg::cholesky::supernodal::{
    SupernodalLdltRef, SupernodalLltRef, SymbolicSupernodalCholesky,
    factorize_supernodal_numeric_ldlt, factorize_supernodal_numeric_ldlt_scratch,
    factorize_supernodal_numeric_llt, factorize_supernodal_numeric_llt_scratch,
    factorize_supernodal_symbolic_cholesky, factorize_supernodal_symbolic_cholesky_scratch,
};
use faer::sparse::linalg::{SymbolicSupernodalParams, amd};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::traits::ComplexField as FactorScalar;
use faer::{Conj, MatMut, Par, Spec};
use sprs::CsMatI;

/// A number that can be factored: real or complex.
pub trait Entry: Scalar + FactorScalar {}

impl<T: Scalar + FactorScalar> Entry for T {}

/// One thread: the result is the same on every machine and in every run.
const SEQUENTIAL: Par = Par::Seq;

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
    symbolic: SymbolicSupernodalCholesky<u32>,
    values: Vec<T>,
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
        let (symbolic, values) = factored(&e, pattern)?;
        let smallest_pivot = smallest_pivot(&symbolic, &values, (&e, pattern));
        if smallest_pivot.ratio > 0.0 {
            Ok(Self {
                symbolic,
                values,
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
        let rows = self.symbolic.nrows();
        let columns = x.len() / rows;
        self.clear_pinned(x);
        let request = self
            .symbolic
            .solve_in_place_scratch::<T>(columns, SEQUENTIAL);
        let mut memory = MemBuffer::try_new(request).ok()?;
        let stack = MemStack::new(&mut memory);
        let Some(order) = &self.order else {
            let x = MatMut::from_column_major_slice_mut(x, rows, columns);
            SupernodalLltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
                Conj::No,
                x,
                SEQUENTIAL,
                stack,
            );
            return Some(());
        };
        let mut in_order = Vec::with_capacity(x.len());
        for column in x.chunks_exact(rows) {
            in_order.extend(order.iter().map(|&unknown| column[unknown as usize]));
        }
        SupernodalLdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut in_order, rows, columns),
            SEQUENTIAL,
            stack,
        );
        for (column, solved) in x.chunks_exact_mut(rows).zip(in_order.chunks_exact(rows)) {
            for (&unknown, value) in order.iter().zip(solved) {
                column[unknown as usize] = *value;
            }
        }
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

    /// Number of entries of L, including the zeros in its blocks.
    pub fn entries(&self) -> usize {
        self.values.len()
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
    let matrix = SparseColMatRef::new(structure, e.data());
    let is_definite = pattern.order().is_none();
    let request = match is_definite {
        true => factorize_supernodal_numeric_llt_scratch::<u32, T>(
            &symbolic,
            SEQUENTIAL,
            Spec::default(),
        ),
        false => factorize_supernodal_numeric_ldlt_scratch::<u32, T>(
            &symbolic,
            SEQUENTIAL,
            Spec::default(),
        ),
    };
    let mut memory = MemBuffer::try_new(request).map_err(|_| FactorError::OutOfMemory)?;
    let stack = MemStack::new(&mut memory);
    let (values_mut, blocks) = (&mut values[..], &symbolic);
    let failed_at = if is_definite {
        let regular = LltRegularization::default();
        let parameters = Spec::default();
        factorize_supernodal_numeric_llt(
            values_mut, matrix, regular, blocks, SEQUENTIAL, stack, parameters,
        )
        .err()
        .map(|LltError::NonPositivePivot { index }| index)
    } else {
        let regular = LdltRegularization::default();
        let parameters = Spec::default();
        factorize_supernodal_numeric_ldlt(
            values_mut, matrix, regular, blocks, SEQUENTIAL, stack, parameters,
        )
        .err()
        .map(|LdltError::ZeroPivot { index }| index)
    };
    if let Some(index) = failed_at {
        let (node, _) = pattern.node_of(index.min(symbolic.nrows().saturating_sub(1)));
        return Err(FactorError::NotPositive(Pivot { node, ratio: 0.0 }));
    }
    Ok((symbolic, values))
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

/// Structure of the factor; `None` if memory is insufficient.
fn analyze(pattern: &Pattern) -> Option<SymbolicSupernodalCholesky<u32>> {
    let (starts, rows) = pattern.upper_structure()?;
    let n = pattern.rows();
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

/// The smallest ratio of a pivot, a diagonal entry of D or a squared diagonal entry of L,
/// to the diagonal entry of the matrix; NaN is treated as smallest.
fn smallest_pivot<T: Scalar>(
    blocks: &SymbolicSupernodalCholesky<u32>,
    factor: &[T],
    (e, pattern): (&CsMatI<T, u32>, &Pattern),
) -> Pivot {
    let is_definite = pattern.order().is_none();
    let mut smallest = (0, f64::INFINITY);
    for s in 0..blocks.n_supernodes() {
        let begin = blocks.supernode_begin()[s] as usize;
        let end = blocks.supernode_end()[s] as usize;
        let first = blocks.col_ptr_for_val()[s] as usize;
        let rows = (blocks.col_ptr_for_val()[s + 1] as usize - first) / (end - begin);
        for column in begin..end {
            let local = column - begin;
            let entry = factor[first + local * rows + local];
            let pivot = if is_definite {
                entry.modulus_squared()
            } else {
                entry.real()
            };
            let diagonal = e.data()[e.indptr().outer_inds_sz(column).start].real();
            let ratio = pivot / diagonal;
            if ratio.is_nan() || ratio < smallest.1 {
                smallest = (column, ratio);
            }
        }
    }
    let (row, ratio) = smallest;
    Pivot {
        node: pattern.node_of(row).0,
        ratio,
    }
}
