//! The central solutions: warping and generalized strain per unit internal force.
//!
//! Six [`Pins`] remove the rigid motions. [`Factor`] is the sparse Cholesky factorization.
//! [`CentralSystem`] borders it with the six generalized strains and corrects its solutions
//! by the imbalance of their stresses; [`CentralSystems`] are the systems of a beam of any
//! curvature. [`CentralSolution`] is the linear and then the constant step, [`Decoupled`]
//! the same solutions with the rigid part of the warping removed. [`ParticularSolution`] is
//! a state under other forces than internal ones, [`DistributedSolution`] the state of
//! distributed loads, and [`DecayRates`] are the decay rates of end effects. Changes of the
//! central solutions with the section are a [`Variation`] for one change, or the
//! [`DualStates`] for all changes.

mod central;
mod columns;
mod decay;
mod decouple;
mod distributed;
mod dual;
mod factor;
mod particular;
mod pins;
mod system;
mod variation;

pub use central::CentralSolution;
pub use columns::{CentralSystems, SystemError};
pub use decay::DecayRates;
pub use decouple::{Decoupled, electric_work};
pub use distributed::DistributedSolution;
pub use dual::{DualState, DualStates};
pub use factor::{
    Entry, Factor, FactorError, Pivot, elimination_order, in_elimination_order, require_positive,
};
pub use particular::{Load, ParticularSolution};
pub use pins::Pins;
pub use system::CentralSystem;
pub use variation::Variation;

#[cfg(test)]
mod distributed_tests;
#[cfg(test)]
mod tests;
