//! Model M, a swinging cantilever.

use beam_dynamics::assembly::System;
use beam_dynamics::case::Model;
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::loads::{self, LoadFactor, NodalForce, NodalLoad};
use nalgebra::{Matrix3, Vector3};

use crate::line::{Inertia, Parts, Section};

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
