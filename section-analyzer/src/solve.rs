//! The central solutions: warping and generalized strain per unit internal force.
//!
//! Six [`Pins`] hold the rigid motions, [`Factor`] is the one sparse Cholesky
//! factorization, [`CentralSystem`] borders it with the six generalized strains and
//! corrects its solutions by the imbalance of their stresses,
//! [`CentralSolution`] is the linear and then the constant step, and
//! [`Decoupled`] the same solutions with the rigid part of the warping removed.

mod central;
mod decouple;
mod factor;
mod pins;
mod system;

pub use central::CentralSolution;
pub use decouple::Decoupled;
pub use factor::{Factor, FactorError, Pivot, elimination_order, in_elimination_order};
pub use pins::Pins;
pub use system::CentralSystem;

#[cfg(test)]
mod tests;
