//! Geometrically exact three-node beam by finite volumes, and its inertia.

mod constitutive;
mod distributed;
mod elastic;
mod geometry;
mod inertia;
mod interpolation;
mod piezo;
mod portions;
mod strain_rate;
mod viscous;

#[cfg(test)]
mod objectivity_tests;

pub use constitutive::LawBeam;
pub use distributed::{DistributedLoad, LineLoad};
pub use elastic::ElasticBeam;
pub use geometry::{BeamGeometry, BeamNode};
pub use inertia::{BeamInertia, MassAlong, lumped_bodies};
pub use piezo::{BeamElectrode, PiezoBeam, Potential};
pub use viscous::ViscousBeam;
