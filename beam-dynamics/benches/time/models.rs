//! Model M, a swinging cantilever, and model T, a rotor of four blades on flap hinges.

use beam_dynamics::assembly::System;
use beam_dynamics::case::Model;
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{
    Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong, lumped_bodies,
};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{
    ConstraintJoint, JointEnds, Placing, Turning, axes_along, clamped,
};
use beam_dynamics::elements::loads::{self, LoadFactor, NodalForce, NodalLoad};
use beam_dynamics::model::{Drive, Node};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Speed of the rotor [rad/s].
pub const SPEED: f64 = 44.4;
/// Beams of a blade of the rotor.
pub const BEAMS_OF_A_BLADE: usize = 20;
const BLADES: usize = 4;

/// Inertia of the beams.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Inertia {
    Lumped,
    Consistent,
}

/// Stiffness and mass of a beam.
struct Section {
    stiffness: [f64; 6],
    mass: f64,
    moments: [f64; 3],
    inertia: Inertia,
}

/// Nodes and elements so far.
#[derive(Default)]
struct Parts {
    nodes: Vec<Node>,
    elements: Vec<Box<dyn Element>>,
}

impl Parts {
    fn node(&mut self, position: Vector3<f64>, rotation: Matrix3<f64>) -> usize {
        let label = format!("n{}", self.nodes.len());
        self.nodes.push(Node {
            label,
            position,
            rotation,
        });
        self.nodes.len() - 1
    }

    fn add(&mut self, element: impl Element + 'static) {
        self.elements.push(Box::new(element));
    }

    /// Straight beams along the first of `axes`; their first and
    /// last node.
    fn line(
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

/// Clamped along x, under its weight and a force at its tip.
pub fn cantilever(beams: usize, inertia: Inertia) -> Model {
    let mut parts = Parts::default();
    let section = Section {
        stiffness: [1e5, 4e4, 4e4, 1.2, 1.0, 3.0],
        mass: 0.6,
        moments: [2.4e-5, 6e-6, 1.8e-5],
        inertia,
    };
    let axes = Matrix3::identity();
    let (root, tip) = parts.line(Vector3::zeros(), &axes, (1.0, beams), &section);
    let clamp = clamped("root", root, &parts.nodes[root]);
    parts.add(clamp);
    let force = NodalForce {
        force: Vector3::new(0.0, 4.0, 0.0),
        moment: Vector3::zeros(),
        offset: Vector3::zeros(),
        turning: loads::Turning::Dead,
        factor: LoadFactor::Constant,
    };
    let load = NodalLoad::new("push", tip, &parts.nodes[tip], force);
    parts.add(load);
    let mut model = Model::new("cantilever", System::new(parts.nodes, parts.elements));
    model.gravity = Vector3::new(0.0, 0.0, -9.81);
    model
}

/// Four blades on flap hinges at a hub that is driven at constant speed about z.
pub fn rotor(inertia: Inertia) -> Model {
    let mut parts = Parts::default();
    let hub = parts.node(Vector3::zeros(), Matrix3::identity());
    parts.add(RigidBody::new(
        "hub",
        hub,
        RigidInertia::about_node(10.0, &Vector3::zeros(), &Matrix3::identity()),
    ));
    let about_z = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::z()));
    let ends = JointEnds {
        a: None,
        b: (hub, &parts.nodes[hub]),
    };
    let turning = Some(Turning::Speed(Drive::Constant(SPEED).into()));
    let drive = ConstraintJoint::revolute("drive", &ends, &about_z, turning);
    parts.add(drive);
    let section = Section {
        stiffness: [1e8, 3e7, 3e7, 5e3, 9e3, 1.2e5],
        mass: 5.5,
        moments: [0.08, 0.002, 0.078],
        inertia,
    };
    for blade in 0..BLADES {
        let (sine, cosine) = (std::f64::consts::FRAC_PI_2 * blade as f64).sin_cos();
        let x = Vector3::new(cosine, sine, 0.0);
        let axes = Matrix3::from_columns(&[x, Vector3::z().cross(&x), Vector3::z()]);
        let at = (4.912 - 0.3, BEAMS_OF_A_BLADE);
        let (root, _) = parts.line(0.3 * x, &axes, at, &section);
        let ends = JointEnds {
            a: Some((hub, &parts.nodes[hub])),
            b: (root, &parts.nodes[root]),
        };
        let flap = Placing::at(&(0.3 * x), &axes_along(&axes.column(1).into_owned()));
        let hinge = ConstraintJoint::revolute("flap", &ends, &flap, None);
        parts.add(hinge);
    }
    let mut model = Model::new("rotor", System::new(parts.nodes, parts.elements));
    let spin = Vector3::new(0.0, 0.0, SPEED);
    let moving = model.initial.iter_mut().zip(model.system.nodes());
    for (motion, node) in moving {
        motion.velocity = Some(spin.cross(&node.position));
        motion.angular_velocity = Some(spin);
    }
    model
}
