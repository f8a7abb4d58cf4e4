//! Uniform beams: a swinging cantilever, and a beam whose root turns by a drive.

use beam_dynamics::assembly::System;
use beam_dynamics::case::Model;
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong, lumped_bodies,
};
use beam_dynamics::elements::bodies::RigidBody;
use beam_dynamics::elements::joints::{
    ConstraintJoint, JointEnds, Placing, Turning, axes_along, clamped,
};
use beam_dynamics::elements::loads::{self, LoadFactor, NodalForce, NodalLoad};
use beam_dynamics::model::{Drive, Node};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::models::node;

/// Properties of a uniform beam of length one along x.
pub struct Strip {
    pub elements: usize,
    pub stiffness: [f64; 6],
    /// Mass per length, and the inertia of the section about its axes.
    pub mass: [f64; 4],
    pub lumped: bool,
}

impl Strip {
    /// Model M: the swinging cantilever.
    pub fn swinging(elements: usize) -> Self {
        Self {
            elements,
            stiffness: [1e5, 4e4, 4e4, 1.2, 1.0, 3.0],
            mass: [0.6, 2.4e-5, 6e-6, 1.8e-5],
            lumped: true,
        }
    }

    /// Model K: unit length, mass and bending stiffness.
    pub fn rotating(elements: usize) -> Self {
        Self {
            elements,
            stiffness: [1e7, 1e7, 1e7, 1.0, 1.0, 1.0],
            mass: [1.0, 2e-7, 1e-7, 1e-7],
            lumped: false,
        }
    }

    /// Nodes along x, and the beams with their mass.
    pub fn parts(&self) -> (Vec<Node>, Vec<Box<dyn Element>>) {
        let count = 2 * self.elements;
        let position = |i: usize| i as f64 / count as f64 * Vector3::x();
        let nodes: Vec<_> = (0..=count)
            .map(|i| node(&format!("{i}"), position(i), Matrix3::identity()))
            .collect();
        let [m, jx, jy, jz] = self.mass;
        let section = Matrix6::from_diagonal(&Vector6::new(m, m, m, jx, jy, jz));
        let stiffness = [Matrix6::from_diagonal(&self.stiffness.into()); 2];
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
        let mut elements: Vec<Box<dyn Element>> = Vec::new();
        for e in 0..self.elements {
            let on = [2 * e, 2 * e + 1, 2 * e + 2];
            let ends = on.map(|i| &nodes[i]);
            let beam = Beam::elastic("beam", on, geometry, ends, stiffness);
            elements.push(Box::new(beam));
            let mass = MassAlong {
                at: &|_| section,
                breaks: &[],
                length: None,
            };
            if self.lumped {
                for (node, inertia) in on
                    .into_iter()
                    .zip(lumped_bodies(&geometry, ends, &mass).bodies)
                {
                    elements.push(Box::new(RigidBody::new("part", node, inertia)));
                }
            } else {
                elements.push(Box::new(BeamInertia::new(
                    "mass", on, geometry, ends, &mass,
                )));
            }
        }
        (nodes, elements)
    }
}

/// Clamped at the origin; a dead force of 4 N along y at the tip and gravity along -z.
pub fn swinging_cantilever(elements: usize) -> Model {
    let (nodes, mut parts) = Strip::swinging(elements).parts();
    parts.push(Box::new(clamped("root", 0, &nodes[0])));
    let tip = nodes.len() - 1;
    let load = NodalForce {
        force: 4.0 * Vector3::y(),
        moment: Vector3::zeros(),
        offset: Vector3::zeros(),
        turning: loads::Turning::Dead,
        factor: LoadFactor::Constant,
    };
    parts.push(Box::new(NodalLoad::new("load", tip, &nodes[tip], load)));
    let mut model = Model::new("swinging cantilever", System::new(nodes, parts));
    model.gravity = -9.81 * Vector3::z();
    model
}

/// Its root turns about z by the angle of a drive.
pub fn driven_beam(angle: Drive) -> Model {
    let (nodes, mut parts) = Strip::rotating(4).parts();
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let placing = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::z()));
    let turning = Some(Turning::Angle(angle.into()));
    let hub = ConstraintJoint::revolute("hub", &ends, &placing, turning);
    parts.push(Box::new(hub));
    Model::new("rotating beam", System::new(nodes, parts))
}
