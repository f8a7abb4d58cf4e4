//! Model T, a rotor of four blades on flap hinges.

use beam_dynamics::assembly::System;
use beam_dynamics::case::Model;
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{ConstraintJoint, JointEnds, Placing, Turning, axes_along};
use beam_dynamics::model::Drive;
use nalgebra::{Matrix3, Vector3};

use crate::line::{Inertia, Parts, Section};

/// Speed of the rotor [rad/s].
pub const SPEED: f64 = 44.4;
/// Beams of a blade of the rotor.
pub const BEAMS_OF_A_BLADE: usize = 20;
const BLADES: usize = 4;

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
