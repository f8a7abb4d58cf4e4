//! Geometrically exact three-node beams, their inertia and loads along them.

mod attachment;
mod beam;
mod distributed;
mod electrodes;
mod forces;
mod formulation;
mod geometry;
mod gradient;
mod inertia;
mod interpolation;
mod line_point;
mod mass;
mod portions;
mod strain;
mod variational;

#[cfg(test)]
mod objectivity_tests;

pub use attachment::{BeamGeometry, BeamNode, EVALUATION_POINTS, Formulation};
pub use beam::Beam;
pub use distributed::{DistributedLoad, LineLoad};
pub use electrodes::{BeamElectrode, Potential};
pub use inertia::BeamInertia;
pub(in crate::elements) use line_point::{LinePoint, LineState};
pub use mass::{LumpedMass, MassAlong, lumped_bodies};
