//! Models that are put together of straight lines of beams.

use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong, lumped_bodies,
};
use beam_dynamics::elements::bodies::RigidBody;
use beam_dynamics::model::Node;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Inertia of the beams.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Inertia {
    Lumped,
    Consistent,
}

/// Stiffness and mass of a beam.
pub struct Section {
    pub stiffness: [f64; 6],
    pub mass: f64,
    pub moments: [f64; 3],
    pub inertia: Inertia,
}

/// Nodes and elements so far.
#[derive(Default)]
pub struct Parts {
    pub nodes: Vec<Node>,
    pub elements: Vec<Box<dyn Element>>,
}

impl Parts {
    pub fn node(&mut self, position: Vector3<f64>, rotation: Matrix3<f64>) -> usize {
        let label = format!("n{}", self.nodes.len());
        self.nodes.push(Node {
            label,
            position,
            rotation,
        });
        self.nodes.len() - 1
    }

    pub fn add(&mut self, element: impl Element + 'static) {
        self.elements.push(Box::new(element));
    }

    /// Straight beams along the first of `axes`; their first and
    /// last node.
    pub fn line(
        &mut self,
        from: Vector3<f64>,
        axes: &Matrix3<f64>,
        (length, beams): (f64, usize),
        section: &Section,
    ) -> (usize, usize) {
        let first = self.nodes.len();
        for i in 0..=2 * beams {
            let along = length * i as f64 / (2 * beams) as f64;
            self.node(from + along * axes.column(0), *axes);
        }
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
        let stiffness = Matrix6::from_diagonal(&Vector6::from(section.stiffness));
        let (m, [x, y, z]) = (section.mass, section.moments);
        let mass = Matrix6::from_diagonal(&Vector6::new(m, m, m, x, y, z));
        let nodes = self.nodes.clone();
        for beam in 0..beams {
            let on = [0, 1, 2].map(|i| first + 2 * beam + i);
            let at = on.map(|i| &nodes[i]);
            let elastic = Beam::elastic("beam", on, geometry, at, [stiffness; 2]);
            self.add(elastic);
            if section.inertia == Inertia::Consistent {
                let mass = |_| mass;
                let mass = MassAlong::smooth(&mass);
                self.add(BeamInertia::new("inertia", on, geometry, at, &mass));
                continue;
            }
            let bodies = lumped_bodies(&geometry, at, &MassAlong::smooth(&|_| mass)).bodies;
            for (node, inertia) in on.into_iter().zip(bodies) {
                self.add(RigidBody::new("portion", node, inertia));
            }
        }
        (first, self.nodes.len() - 1)
    }
}
