//! Solution of systems of equations; knows nothing of nodes and elements.

mod linear;
mod newton;

pub use linear::{ComplexFactorization, Factorization, LinearSolver};
pub use newton::{Equations, Iteration, Newton, NewtonReport, NewtonStatus, Worst, solve};
