//! Solution of systems of equations, independent of nodes and elements: sparse LU on a fixed
//! pattern with pivots that are kept from matrix to matrix, sparse Cholesky factors, linear systems by
//! products alone, Newton's method with a status, eigenvalues of dense matrices and of maps, and the
//! minimal form of descriptor systems.
//!
//! A crate of its own, so that its kernels are optimized in every profile. Functions that take
//! time are therefore not generic: generic ones are compiled where they are used.
//!
//! # Example
//!
//! ```
//! use std::sync::Arc;
//!
//! use sparse_solver::{LinearSolver, Pattern, Sparse};
//!
//! // y = 1, 2 x + y = 4: the first entry of the diagonal is zero
//! let pattern = Arc::new(Pattern::new(2, vec![(0, 1), (1, 0), (1, 1)]));
//! let mut matrix = Sparse::zero(Arc::clone(&pattern));
//! for ((row, column), value) in [((0, 1), 1.0), ((1, 0), 2.0), ((1, 1), 1.0)] {
//!     let index = pattern.index(row, column).expect("an entry of the pattern");
//!     matrix.values_mut()[index] = value;
//! }
//! let factors = LinearSolver::new(&pattern).factorize(matrix).expect("a regular matrix");
//! let mut x = [1.0, 4.0];
//! factors.solve(&mut x).expect("a finite solution");
//! assert_eq!(x, [1.5, 1.0]);
//! ```

mod arnoldi;
mod cholesky;
mod dense;
mod descriptor;
mod general;
mod gmres;
mod linear;
mod lu;
mod newton;
mod number;
mod pattern;
mod scales;
mod step;

pub use arnoldi::{Largest, LinearMap, Ritz, largest};
pub use cholesky::{
    Cholesky, CholeskyBlocks, CholeskyError, CholeskyNumber, Definiteness, Triangle, minimum_degree,
};
pub use dense::{Eigenvectors, eigenvalues, eigenvalues_of};
pub use descriptor::{Descriptor, DescriptorState, Minimal, NotMinimal, minimal};
pub use gmres::{Gmres, gmres, norm, orthogonalize};
pub use linear::{ComplexFactorization, Factorization, LinearSolver};
pub use newton::{
    Equations, Iteration, Jacobian, Newton, NewtonReport, NewtonStatus, Worst, solve,
};
pub use pattern::{Pattern, Sparse};
pub use step::{LinearCounts, StepSolver};
