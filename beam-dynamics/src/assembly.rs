//! The system of equations: nodes, elements, and their sum in a fixed sparse pattern.

pub mod massless;
pub mod mechanism;
pub mod redundancy;
pub mod symmetry;

mod combination;
mod elimination;
mod momenta;
mod system;

pub use combination::{Combination, Variation};
pub use momenta::{Entry, MasslessMotions};
pub use sparse_solver::{Pattern, Sparse};
pub use system::{
    Contradiction, Loop, Residual, ScalarScales, Sharing, Slack, System, Tangent, Workspace,
};
