//! A line of three-node elements with loads, built node by node.

use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, StaticSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamNode, DistributedLoad, Formulation, LineLoad,
};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::loads::{
    ImposedMotion, LoadFactor, NodalForce, NodalLoad, Turning, imposed,
};
use beam_dynamics::model::Node;
use beam_dynamics::result::{StaticResult, StaticStep};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::parameters::Parametrization;

/// A plain force or moment, dead and proportional.
pub const DEAD: NodalForce = NodalForce {
    force: Vector3::new(0.0, 0.0, 0.0),
    moment: Vector3::new(0.0, 0.0, 0.0),
    offset: Vector3::new(0.0, 0.0, 0.0),
    turning: Turning::Dead,
    factor: LoadFactor::Proportional,
};

/// No node held, no node moved.
pub const FREE: ImposedMotion = ImposedMotion {
    displacement: [None; 3],
    rotation: [None; 3],
    axes: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    factor: LoadFactor::Proportional,
};

/// Nodes, elements and loads under construction.
pub struct Chain {
    pub nodes: Vec<Node>,
    pub elements: Vec<Box<dyn Element>>,
    pub beams: Vec<[usize; 3]>,
    /// Formulation of the added beams.
    pub formulation: Formulation,
}

/// The beam of the thesis.
pub const VOLUMES: Formulation = Formulation::FiniteVolume(Parametrization::Gibbs);

impl Chain {
    pub fn new() -> Self {
        Self {
            nodes: Vec::new(),
            elements: Vec::new(),
            beams: Vec::new(),
            formulation: Formulation::Variational,
        }
    }

    /// A line of `count` elements; `point` returns position and axes of a node from its part of the
    /// length. The first node may be an existing one.
    pub fn line(
        &mut self,
        first: Option<usize>,
        count: usize,
        stiffness: &Vector6<f64>,
        point: impl Fn(f64) -> (Vector3<f64>, Matrix3<f64>),
    ) -> Vec<usize> {
        let mut on = Vec::new();
        for i in 0..=2 * count {
            if let (0, Some(node)) = (i, first) {
                on.push(node);
                continue;
            }
            let (position, rotation) = point(i as f64 / (2 * count) as f64);
            let label = format!("n{}", self.nodes.len());
            on.push(self.nodes.len());
            self.nodes.push(Node {
                label,
                position,
                rotation,
            });
        }
        for e in 0..count {
            let nodes = [on[2 * e], on[2 * e + 1], on[2 * e + 2]];
            let section = |i: usize| {
                let (_, axes) = point(i as f64 / (2 * count) as f64);
                self.nodes[on[i]].rotation.transpose() * axes
            };
            let geometry = BeamGeometry::new(std::array::from_fn(|k| BeamNode {
                offset: Vector3::zeros(),
                orientation: section(2 * e + k),
            }))
            .formulated(self.formulation);
            let undeformed = nodes.map(|i| &self.nodes[i]);
            let stiffness = [Matrix6::from_diagonal(stiffness); 2];
            let label = format!("beam {}", self.beams.len());
            let beam = Beam::elastic(label, nodes, geometry, undeformed, stiffness);
            self.elements.push(Box::new(beam));
            self.beams.push(nodes);
        }
        on
    }

    /// A straight line from `a` to `b`, section axes x along it and z near `up`.
    pub fn straight(
        &mut self,
        first: Option<usize>,
        count: usize,
        stiffness: &Vector6<f64>,
        [a, b]: [Vector3<f64>; 2],
        up: Vector3<f64>,
    ) -> Vec<usize> {
        let x = (b - a).normalize();
        let y = up.cross(&x).normalize();
        let axes = Matrix3::from_columns(&[x, y, x.cross(&y)]);
        self.line(first, count, stiffness, |part| (a + (b - a) * part, axes))
    }

    pub fn clamp(&mut self, node: usize) {
        let clamp = clamped("clamp", node, &self.nodes[node]);
        self.elements.push(Box::new(clamp));
    }

    pub fn impose(&mut self, node: usize, motion: ImposedMotion) {
        let imposed = imposed("imposed", node, &self.nodes[node], motion);
        self.elements.push(Box::new(imposed));
    }

    pub fn load(&mut self, node: usize, load: NodalForce) {
        let load = NodalLoad::new("load", node, &self.nodes[node], load);
        self.elements.push(Box::new(load));
    }

    /// The same load per length on all beams, proportional.
    pub fn load_beams(&mut self, turning: Turning, load: LineLoad) {
        for nodes in &self.beams {
            let geometry = BeamGeometry::new([BeamNode::aligned(); 3]).formulated(self.formulation);
            let undeformed = nodes.map(|i| &self.nodes[i]);
            let kind = (turning, LoadFactor::Proportional);
            let load =
                DistributedLoad::new("line", *nodes, geometry, undeformed, kind, &[], |_| load);
            self.elements.push(Box::new(load));
        }
    }

    pub fn model(self) -> Model {
        let mut model = Model::new("chain", System::new(self.nodes, self.elements));
        model.beams = self.beams;
        model
    }

    /// Equilibria up to the factor one; all must be found.
    pub fn solve(self) -> StaticResult {
        let model = self.model();
        let outcome = beam_dynamics::analysis::statics::statics(&model, &up_to(1.0));
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        outcome.result
    }

    /// The last equilibrium.
    pub fn last(self) -> StaticStep {
        self.solve().steps.pop().unwrap()
    }
}

/// Loads grow up to a factor, in steps as large as possible.
pub fn up_to(to: f64) -> StaticSettings {
    StaticSettings {
        speed: 0.0,
        to,
        steps: None,
        arc_length: false,
        most_steps: 500,
        sweep: None,
    }
}
