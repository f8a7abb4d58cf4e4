//! Sparse Cholesky factorization of a Hermitian matrix, by blocks of columns (supernodes).
//!
//! ```text
//! A = L L^H      A positive definite
//! A = L D L^H    A quasi-definite: the signs of D follow from the matrix in any order
//! ```
//!
//! The unknowns are eliminated in their order: [`minimum_degree`] gives one that keeps the factor
//! small. One thread: the result is the same on every machine and in every run.
//!
//! # References
//! - [Vanderbei1995]: quasi-definite matrices are strongly factorizable.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
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
use faer::traits::ComplexField;
use faer::{Conj, MatMut, Par, Spec, c64};

const SEQUENTIAL: Par = Par::Seq;

/// Which form of the factorization a matrix has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Definiteness {
    /// `L L^H`.
    Positive,
    /// `L D L^H`.
    Quasi,
}

/// Reason why a factorization failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CholeskyError {
    /// The pivot of this row is not positive, or zero for a quasi-definite matrix.
    Pivot(usize),
    /// Insufficient memory.
    OutOfMemory,
}

/// A triangle of a square matrix, column by column.
#[derive(Debug, Clone, Copy)]
pub struct Triangle<'a> {
    /// Index of the first entry of each column, and the number of entries.
    pub starts: &'a [u32],
    /// Row of each entry, increasing in a column.
    pub rows: &'a [u32],
}

/// The blocks of a factor.
#[derive(Debug)]
pub struct CholeskyBlocks(SymbolicSupernodalCholesky<u32>);

impl CholeskyBlocks {
    /// Of the factor of a matrix with the structure `upper` of its upper triangle; `None` if
    /// memory is insufficient.
    ///
    /// # Panics
    /// If `upper` is no triangle with its diagonal.
    pub fn new(upper: Triangle<'_>) -> Option<Self> {
        let structure = upper.structure();
        let n = structure.nrows();
        let mut memory = memory(
            prefactorize_symbolic_cholesky_scratch::<u32>(n, upper.rows.len())
                .or(factorize_supernodal_symbolic_cholesky_scratch::<u32>(n)),
        )?;
        let stack = MemStack::new(&mut memory);
        let (mut tree, mut counts) = (vec![0; n], vec![0; n]);
        let tree = prefactorize_symbolic_cholesky(&mut tree, &mut counts, structure, stack);
        let parameters = SymbolicSupernodalParams::default();
        factorize_supernodal_symbolic_cholesky(structure, tree, &counts, stack, parameters)
            .ok()
            .map(Self)
    }
}

/// The factor of a matrix.
#[derive(Debug)]
pub struct Cholesky<T> {
    blocks: CholeskyBlocks,
    values: Vec<T>,
    definiteness: Definiteness,
}

/// A number that can be factored: real, or complex.
pub trait CholeskyNumber: ComplexField + Copy {
    /// Values of the factor of the matrix with the lower triangle `lower`.
    ///
    /// # Errors
    /// [`CholeskyError`].
    fn factorize(
        blocks: &CholeskyBlocks,
        lower: (Triangle<'_>, &[Self]),
        definiteness: Definiteness,
    ) -> Result<Vec<Self>, CholeskyError>;

    /// The solutions of [`Cholesky::solve`].
    fn solve(factor: &Cholesky<Self>, x: &mut [Self]) -> Option<()>;
}

impl<T: CholeskyNumber> Cholesky<T> {
    /// Factors the Hermitian matrix with lower triangle `lower` of entries `entries`, of the
    /// structure of `blocks`.
    ///
    /// # Errors
    /// [`CholeskyError`]. NaN is no error: see [`Cholesky::pivots`].
    ///
    /// # Panics
    /// If `lower` is no triangle with its diagonal.
    pub fn new(
        blocks: CholeskyBlocks,
        lower: (Triangle<'_>, &[T]),
        definiteness: Definiteness,
    ) -> Result<Self, CholeskyError> {
        let values = T::factorize(&blocks, lower, definiteness)?;
        Ok(Self {
            blocks,
            values,
            definiteness,
        })
    }

    /// Replaces the columns of `x` (n x k, column by column) by the solutions of `A x = b`;
    /// `None` if memory is insufficient.
    pub fn solve(&self, x: &mut [T]) -> Option<()> {
        T::solve(self, x)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.blocks.0.nrows()
    }

    /// Number of entries of L, including the zeros in its blocks.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// The diagonal entry of each row of L, or of D for a quasi-definite matrix.
    pub fn pivots(&self) -> impl Iterator<Item = T> + '_ {
        let blocks = &self.blocks.0;
        (0..blocks.n_supernodes()).flat_map(move |s| {
            let begin = blocks.supernode_begin()[s] as usize;
            let columns = blocks.supernode_end()[s] as usize - begin;
            let first = blocks.col_ptr_for_val()[s] as usize;
            let rows = (blocks.col_ptr_for_val()[s + 1] as usize - first) / columns;
            (0..columns).map(move |column| self.values[first + column * rows + column])
        })
    }
}

impl<'a> Triangle<'a> {
    fn structure(self) -> SymbolicSparseColMatRef<'a, u32> {
        let n = self.starts.len().saturating_sub(1);
        SymbolicSparseColMatRef::new_checked(n, n, self.starts, None, self.rows)
    }
}

/// An order of the nodes of a symmetric graph that keeps the factor small (approximate minimum
/// degree), as the list of nodes by position; `None` if memory is insufficient.
///
/// The graph has the neighbors of all nodes, node by node.
pub fn minimum_degree(graph: Triangle<'_>) -> Option<Vec<u32>> {
    let n = graph.starts.len().saturating_sub(1);
    let (mut forward, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = memory(amd::order_scratch::<u32>(n, graph.rows.len()))?;
    amd::order(
        &mut forward,
        &mut inverse,
        graph.structure(),
        amd::Control::default(),
        MemStack::new(&mut memory),
    )
    .ok()?;
    Some(forward)
}

fn memory(request: StackReq) -> Option<MemBuffer> {
    MemBuffer::try_new(request).ok()
}

/// Values of the factor of the matrix with the lower triangle `lower`.
fn factorized<T: ComplexField + Copy>(
    CholeskyBlocks(blocks): &CholeskyBlocks,
    (lower, entries): (Triangle<'_>, &[T]),
    definiteness: Definiteness,
) -> Result<Vec<T>, CholeskyError> {
    let matrix = SparseColMatRef::new(lower.structure(), entries);
    let mut values = vec![T::zero_impl(); blocks.len_val()];
    let into = &mut values[..];
    let spec = Spec::default();
    let request = match definiteness {
        Definiteness::Positive => {
            factorize_supernodal_numeric_llt_scratch::<u32, T>(blocks, SEQUENTIAL, spec)
        }
        Definiteness::Quasi => {
            factorize_supernodal_numeric_ldlt_scratch::<u32, T>(blocks, SEQUENTIAL, Spec::default())
        }
    };
    let mut memory = memory(request).ok_or(CholeskyError::OutOfMemory)?;
    let stack = MemStack::new(&mut memory);
    let failed_at = match definiteness {
        Definiteness::Positive => {
            let regular = LltRegularization::default();
            factorize_supernodal_numeric_llt(into, matrix, regular, blocks, SEQUENTIAL, stack, spec)
                .err()
                .map(|LltError::NonPositivePivot { index }| index)
        }
        Definiteness::Quasi => {
            let regular = LdltRegularization::default();
            let spec = Spec::default();
            factorize_supernodal_numeric_ldlt(
                into, matrix, regular, blocks, SEQUENTIAL, stack, spec,
            )
            .err()
            .map(|LdltError::ZeroPivot { index }| index)
        }
    };
    let last = blocks.nrows().saturating_sub(1);
    match failed_at {
        Some(index) => Err(CholeskyError::Pivot(index.min(last))),
        None => Ok(values),
    }
}

/// The solutions of [`Cholesky::solve`].
fn solved<T: ComplexField + Copy>(factor: &Cholesky<T>, x: &mut [T]) -> Option<()> {
    let blocks = &factor.blocks.0;
    let (rows, columns) = (blocks.nrows(), x.len() / blocks.nrows());
    let mut memory = memory(blocks.solve_in_place_scratch::<T>(columns, SEQUENTIAL))?;
    let stack = MemStack::new(&mut memory);
    let x = MatMut::from_column_major_slice_mut(x, rows, columns);
    let values = &factor.values;
    match factor.definiteness {
        Definiteness::Positive => SupernodalLltRef::new(blocks, values).solve_in_place_with_conj(
            Conj::No,
            x,
            SEQUENTIAL,
            stack,
        ),
        Definiteness::Quasi => SupernodalLdltRef::new(blocks, values).solve_in_place_with_conj(
            Conj::No,
            x,
            SEQUENTIAL,
            stack,
        ),
    }
    Some(())
}

/// The kernels for one type of numbers: functions that are compiled in this crate.
macro_rules! kernels {
    ($number:ty) => {
        impl CholeskyNumber for $number {
            fn factorize(
                blocks: &CholeskyBlocks,
                lower: (Triangle<'_>, &[Self]),
                definiteness: Definiteness,
            ) -> Result<Vec<Self>, CholeskyError> {
                factorized(blocks, lower, definiteness)
            }

            fn solve(factor: &Cholesky<Self>, x: &mut [Self]) -> Option<()> {
                solved(factor, x)
            }
        }
    };
}

kernels!(f64);
kernels!(c64);
