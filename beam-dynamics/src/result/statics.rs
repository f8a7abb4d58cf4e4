//! Static equilibria along a load path.

use nalgebra::{Matrix3, Vector3};

use crate::case::{BladeNodes, Model};
use crate::elements::{AirState, ElectrodeState, Reaction, SectionState};
use crate::model::Node;

/// The equilibrium at one factor of the proportional loads.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticStep {
    /// Factor of the proportional loads [-].
    pub factor: f64,
    /// Position of each node, model's axes [m].
    pub positions: Vec<Vector3<f64>>,
    /// Orientation of each node: its axes (columns) in the model's axes [-].
    pub rotations: Vec<Matrix3<f64>>,
    /// Newton iterations since the previous step, including shortened steps.
    pub iterations: usize,
    /// Largest residual relative to the largest term of its kind [-].
    pub residual: f64,
    /// Strains and internal forces at the evaluation points of all beams, beam by beam.
    pub sections: Vec<SectionState>,
    /// Reactions of the supports: forces and moments of the joints on their nodes.
    pub reactions: Vec<Reaction>,
    /// Voltages and charges of the electrodes.
    pub electrodes: Vec<ElectrodeState>,
    /// Strips in the air.
    pub air: Vec<AirState>,
}

/// A load path: equilibria in the order in which they were reached.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticResult {
    /// Name of the model.
    pub name: String,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// The undeformed nodes.
    pub nodes: Vec<Node>,
    /// Nodes of each beam, for drawing.
    pub beams: Vec<[usize; 3]>,
    /// Blades, for output along the span.
    pub blades: Vec<BladeNodes>,
    /// Equilibria; the first one under the constant loads only, with the factor zero.
    pub steps: Vec<StaticStep>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}

impl StaticResult {
    /// Without steps, at a rotor speed \[rad/s\].
    pub fn new(model: &Model, speed: f64) -> Self {
        Self {
            name: model.name.clone(),
            speed,
            nodes: model.system.nodes().to_vec(),
            beams: model.beams.clone(),
            blades: model.blades.clone(),
            steps: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// The last equilibrium that was reached.
    pub fn last(&self) -> Option<&StaticStep> {
        self.steps.last()
    }
}
