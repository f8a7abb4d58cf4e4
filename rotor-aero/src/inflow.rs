//! Inflow of rotors: induced velocity over the disk, on states that follow the loads.
//!
//! Velocities are over the tip speed `Omega R`, and positive down through the disk, against the
//! thrust. The azimuth psi is zero aft, where the air leaves the disk, and positive in the
//! direction of rotation; radii are over R. An [`InflowModel`] gives one row per state,
//! `g(l, l', flow, loads) = 0`, for an implicit scheme, and the induced velocity at a point.
//!
//! Loads are thrust and first moments of the aerodynamic loads of the blades, see [`RotorLoads`].

mod disk;
mod drees;
mod ground;
mod mangler_squire;
mod mass_flow;
mod model;
mod pitt_peters;
mod rotor;
#[cfg(test)]
mod tests;
mod uniform;
mod without;

pub use disk::{Disk, DiskFlow, DiskLoads};
pub use drees::Drees;
pub use ground::{ground_effect, ground_effect_of_thrust};
pub use mangler_squire::{Loading, ManglerSquire};
pub use mass_flow::{MassFlow, steady_uniform};
pub use model::InflowModel;
pub use pitt_peters::PittPeters;
pub use rotor::{Inflow, RotorFlow, RotorLoads};
pub use uniform::Uniform;
pub use without::Without;
