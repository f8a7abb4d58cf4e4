//! A uniform straight beam along x, clamped at its root or free, as a chain of three-node
//! elements.

use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, Formulation, MassAlong, lumped_bodies,
};
use beam_dynamics::elements::bodies::RigidBody;
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::model::Node;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use crate::chain::VOLUMES;

/// Inertia of the elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Inertia {
    /// Bodies by nodal weights.
    Lumped,
    Consistent,
    /// Bodies of portions, on beams by finite volumes.
    Portions,
}

/// Length one, mass per length one, bending stiffness one; extension and shear are stiff enough to
/// change the bending frequencies by less than 1e-6.
pub struct UniformBeam {
    pub elements: usize,
    pub inertia: Inertia,
    pub formulation: Formulation,
    /// Whether the root is held.
    pub clamped: bool,
    pub stiffness: Vector6<f64>,
    pub mass: Vector6<f64>,
}

impl UniformBeam {
    pub fn slender(elements: usize, inertia: Inertia) -> Self {
        Self {
            elements,
            inertia,
            formulation: match inertia {
                Inertia::Portions => VOLUMES,
                _ => Formulation::Variational,
            },
            clamped: true,
            stiffness: Vector6::new(1e8, 1e8, 1e8, 1.0, 1.0, 1.0),
            mass: Vector6::new(1.0, 1.0, 1.0, 2e-8, 1e-8, 1e-8),
        }
    }

    pub fn nodes(&self) -> Vec<Node> {
        let count = 2 * self.elements + 1;
        (0..count)
            .map(|i| Node {
                label: format!("n{i}"),
                position: Vector3::new(i as f64 / (count - 1) as f64, 0.0, 0.0),
                rotation: Matrix3::identity(),
            })
            .collect()
    }

    pub fn system(&self) -> System {
        let nodes = self.nodes();
        let elements = self.elements(&nodes);
        System::new(nodes, elements)
    }

    /// The elements on `nodes`.
    pub fn elements(&self, nodes: &[Node]) -> Vec<Box<dyn Element>> {
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]).formulated(self.formulation);
        let stiffness = Matrix6::from_diagonal(&self.stiffness);
        let mass = Matrix6::from_diagonal(&self.mass);
        let mut elements: Vec<Box<dyn Element>> = Vec::new();
        if self.clamped {
            elements.push(Box::new(clamped("root", 0, &nodes[0])));
        }
        for e in 0..self.elements {
            let on = [2 * e, 2 * e + 1, 2 * e + 2];
            let undeformed = on.map(|i| &nodes[i]);
            let name = format!("beam {e}");
            elements.push(Box::new(Beam::elastic(
                &name,
                on,
                geometry,
                undeformed,
                [stiffness; 2],
            )));
            match self.inertia {
                Inertia::Consistent => elements.push(Box::new(BeamInertia::new(
                    &name,
                    on,
                    geometry,
                    undeformed,
                    &MassAlong::smooth(&|_| mass),
                ))),
                Inertia::Lumped | Inertia::Portions => {
                    let bodies =
                        lumped_bodies(&geometry, undeformed, &MassAlong::smooth(&|_| mass)).bodies;
                    for (node, body) in on.into_iter().zip(bodies) {
                        elements.push(Box::new(RigidBody::new(&name, node, body)));
                    }
                }
            }
        }
        elements
    }

    /// Modes at the given speeds of rotation about z through the root [rad/s].
    pub fn case(&self, speeds: &[f64], count: usize) -> (Model, ModesSettings) {
        let settings = ModesSettings::new(speeds.to_vec(), count);
        (Model::new("uniform beam", self.system()), settings)
    }
}

/// Angular frequencies of the modes named by a word at speed index `speed` [rad/s].
pub fn frequencies(
    (model, settings): &(Model, ModesSettings),
    speed: usize,
    word: &str,
) -> Vec<f64> {
    let outcome = beam_dynamics::analysis::modes::modes(model, settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome
        .table
        .at_speed(speed)
        .into_iter()
        .filter(|(branch, _)| branch.name.starts_with(word))
        .map(|(_, point)| 2.0 * std::f64::consts::PI * point.frequency)
        .collect()
}
