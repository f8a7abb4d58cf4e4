//! From the section to its central problem.
//!
//! [`Domain`] is the section as the solver sees it (attached nodes, centered and
//! scaled), [`Pattern`] which unknowns meet in a cell, [`SectionMatrices`] the
//! matrices E, R, A of the system to factor, [`State`] with its forces and energy
//! the products with all six matrices by integration of stresses; the rigid motions are
//! what their identities are checked with.

mod domain;
mod mass;
mod matrices;
mod model;
mod outside;
mod pattern;
mod rigid;
mod stress;

pub(crate) use domain::largest;
pub use domain::{Domain, DomainCell, Scaling};
pub use mass::mass_per_length;
pub use matrices::{Scalar, SectionMatrices};
pub use model::Model;
pub use outside::{OUTSIDE_IDENTITIES, OutsideDomain};
pub use pattern::Pattern;
pub use rigid::{ASSEMBLED_IDENTITIES, add_rigid_motions, check_assembled_identities, resultant};
pub use stress::{Rate, SectionForces, State, section_forces};

#[cfg(test)]
mod tests;
