//! All variables of a run.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::gibbs;

use super::{NODE_UNKNOWNS, Node, Numbering, TurningFrame};

/// Position and motion of one node. Rates are relative to the model's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeMotion {
    /// Position [m].
    pub position: Vector3<f64>,
    /// Orientation, columns are the node's axes [-].
    pub rotation: Matrix3<f64>,
    /// Momentum of the masses that move with the node [kg m/s].
    pub momentum: Vector3<f64>,
    /// Angular momentum about the node [kg m^2/s].
    pub angular_momentum: Vector3<f64>,
    /// Velocity relative to the frame [m/s].
    pub velocity: Vector3<f64>,
    /// Angular velocity relative to the frame [rad/s].
    pub angular_velocity: Vector3<f64>,
    /// Rate of the components of the momentum [N].
    pub momentum_rate: Vector3<f64>,
    /// Rate of the components of the angular momentum [N m].
    pub angular_momentum_rate: Vector3<f64>,
}

impl NodeMotion {
    /// At rest in the frame, at the undeformed position of `node`.
    pub fn at_rest(node: &Node) -> Self {
        Self {
            position: node.position,
            rotation: node.rotation,
            momentum: Vector3::zeros(),
            angular_momentum: Vector3::zeros(),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            momentum_rate: Vector3::zeros(),
            angular_momentum_rate: Vector3::zeros(),
        }
    }

    /// Velocity in space [m/s].
    pub fn velocity_in_space(&self, frame: &TurningFrame) -> Vector3<f64> {
        frame.velocity(&self.position, &self.velocity)
    }

    /// Angular velocity in space [rad/s].
    pub fn angular_velocity_in_space(&self, frame: &TurningFrame) -> Vector3<f64> {
        self.angular_velocity + frame.angular_velocity
    }
}

/// The state of a model: motion of every node, the multipliers, and the scalars.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Motion of each node, in the order of the nodes.
    pub nodes: Vec<NodeMotion>,
    /// Multipliers, in the order of the numbering [unit of each].
    pub multipliers: Vec<f64>,
    /// Scalar unknowns, in the order of the numbering [unit of each].
    pub scalars: Vec<f64>,
    /// Rates of the scalars that have one, else zero [unit of each/s].
    pub scalar_rates: Vec<f64>,
    /// Memory of the elements from accepted steps, in their order [unit of each].
    pub memory: Vec<f64>,
}

impl State {
    /// The undeformed state at rest in the frame.
    pub fn at_rest(nodes: &[Node], numbering: &Numbering) -> Self {
        Self {
            nodes: nodes.iter().map(NodeMotion::at_rest).collect(),
            multipliers: vec![0.0; numbering.multipliers()],
            scalars: vec![0.0; numbering.scalars()],
            scalar_rates: vec![0.0; numbering.scalars()],
            memory: vec![0.0; numbering.memory()],
        }
    }

    /// Copies `other`, a state of the same model, without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.nodes.copy_from_slice(&other.nodes);
        self.multipliers.copy_from_slice(&other.multipliers);
        self.scalars.copy_from_slice(&other.scalars);
        self.scalar_rates.copy_from_slice(&other.scalar_rates);
        self.memory.copy_from_slice(&other.memory);
    }

    /// Adds a correction of the unknowns, in the order of the numbering: positions,
    /// momenta, multipliers and scalars by sum, rotations by composition with the
    /// Gibbs-Rodrigues rotation of the correction, `R <- R(g) R`.
    pub fn correct(&mut self, correction: &[f64]) {
        let (of_nodes, of_multipliers) = correction.split_at(NODE_UNKNOWNS * self.nodes.len());
        for (node, values) in self.nodes.iter_mut().zip(of_nodes.chunks(NODE_UNKNOWNS)) {
            let part = |i: usize| Vector3::new(values[i], values[i + 1], values[i + 2]);
            node.position += part(0);
            node.rotation = gibbs::to_rotation(&part(3)) * node.rotation;
            node.momentum += part(6);
            node.angular_momentum += part(9);
        }
        let numbers = self.multipliers.iter_mut().chain(&mut self.scalars);
        for (number, value) in numbers.zip(of_multipliers) {
            *number += value;
        }
    }
}
