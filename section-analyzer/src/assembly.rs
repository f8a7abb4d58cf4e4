//! Assembly of the central problem of a section.
//!
//! [`Domain`] is the section in the solver's form (attached nodes, centered and scaled).
//! [`Pattern`] lists the unknowns that share a cell. [`SectionMatrices`] are the matrices
//! E, R, A of the system to factor. [`State`] with its forces and energy replaces the
//! products with all six matrices by integration of stresses. [`distributed_forces`] are
//! the nodal forces of distributed loads. The rigid motions serve to check the identities
//! of the matrices.

mod cell;
mod distributed;
mod domain;
mod electric;
mod external;
mod forces;
mod imposed;
mod mass;
mod matrices;
mod model;
mod parts;
mod pattern;
mod rigid;
mod scaling;
mod stress;
mod voltage;

pub use cell::DomainCell;
pub use distributed::distributed_forces;
pub use domain::Domain;
pub use electric::{DomainElectrode, Electric, Fingered, dielectric_cells};
pub use external::{EXTERNAL_IDENTITIES, ExternalDomain};
pub use forces::{Rate, SectionForces, State};
pub use imposed::{ImposedForces, imposed_forces};
pub use mass::{mass_of_moments, mass_per_length};
pub use matrices::{Scalar, SectionMatrices};
pub use model::Model;
pub use parts::structural_parts;
pub use pattern::Pattern;
pub use rigid::{
    ASSEMBLED_IDENTITIES, IDENTITIES, add_rigid_motions, check_assembled_identities,
    check_identities, resultant,
};
pub use scaling::Scaling;
pub(crate) use scaling::largest;
pub use stress::section_forces;
pub(crate) use stress::take_columns;
pub use voltage::{VoltageForces, charges, voltage_forces};

#[cfg(test)]
mod tests;
