//! A beam of the model, as its card defines it.

use super::beam_properties::BeamProperties;
use super::formulation::Inertia;
use crate::elements::beams::BeamGeometry;

/// A beam with its properties.
#[derive(Debug, Clone)]
pub(super) struct Beam {
    pub label: String,
    pub nodes: [usize; 3],
    pub geometry: BeamGeometry,
    pub properties: BeamProperties,
    pub inertia: Inertia,
}
