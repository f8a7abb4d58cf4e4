//! Loads: forces and moments on nodes, imposed displacements, and their growth.
//!
//! Distributed loads are in [`super::beams`], weight in the bodies.

mod factor;
mod imposed;
mod internal;
mod load;
mod nodal;

pub use factor::{LoadFactor, Turning};
pub use imposed::{ImposedMotion, imposed};
pub use internal::{Between, InternalForce};
pub(in crate::elements) use load::{Add, Head, Load};
pub use nodal::{NodalForce, NodalLoad};
