//! Solution of systems of equations, independent of nodes and elements.

mod general;
mod gmres;
mod linear;
mod lu;
mod newton;
mod scales;
mod step;

pub use gmres::{Gmres, gmres, norm, orthogonalize};
pub use linear::{ComplexFactorization, Factorization, LinearSolver};
pub use newton::{
    Equations, Iteration, Jacobian, Newton, NewtonReport, NewtonStatus, Worst, solve,
};
pub use step::{LinearCounts, StepSolver};
