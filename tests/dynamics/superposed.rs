//! A superposed rigid displacement and uniform velocity change no strain and no reaction.

use beam_dynamics::case::{InitialMotion, TransientSettings};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{ConstraintJoint, JointEnds, Placing};
use nalgebra::{Matrix3, Rotation3, Vector3, Vector6};

use crate::chain::Chain;
use crate::in_time::Run;
use crate::record;

/// A rigid displacement with a uniform velocity.
struct Superposed {
    turn: Matrix3<f64>,
    shift: Vector3<f64>,
    velocity: Vector3<f64>,
}

/// A soft beam with a body on a spherical joint at its end, turning and flying free.
fn run(superposed: &Superposed) -> Run {
    let Superposed {
        turn,
        shift,
        velocity,
    } = superposed;
    let stiffness = Vector6::new(1e4, 4e3, 4e3, 20.0, 15.0, 30.0);
    let mut chain = Chain::new();
    let on = chain.line(None, 2, &stiffness, |part| {
        (turn * Vector3::new(part, 0.1, -0.2) + shift, *turn)
    });
    let end = chain.nodes[4].clone();
    let mut body = end.clone();
    body.label = "body".to_owned();
    body.position += turn * Vector3::new(0.2, 0.1, 0.0);
    chain.nodes.push(body);
    let masses = [0.1, 0.3, 0.2, 0.3, 0.1, 0.5];
    for (node, mass) in masses.into_iter().enumerate() {
        let inertia = Matrix3::from_diagonal(&Vector3::new(0.02, 0.01, 0.015)) * mass;
        let inertia = RigidInertia::about_node(mass, &Vector3::zeros(), &inertia);
        let body = RigidBody::new(format!("body {node}"), node, inertia);
        chain.elements.push(Box::new(body));
    }
    let ends = JointEnds {
        a: Some((on[4], &chain.nodes[4])),
        b: (5, &chain.nodes[5]),
    };
    let position = Placing::at(&end.position, turn);
    let joint = ConstraintJoint::spherical("joint", &ends, &position);
    chain.elements.push(Box::new(joint));
    let spin = Vector3::new(0.7, -1.1, 2.5);
    let motions = chain.nodes.iter().map(|node| {
        let from_first = turn.transpose() * (node.position - chain.nodes[0].position);
        InitialMotion {
            velocity: Some(turn * spin.cross(&from_first) + velocity),
            angular_velocity: Some(turn * spin),
            ..InitialMotion::default()
        }
    });
    let motions = motions.collect();
    let mut model = chain.model();
    model.initial = motions;
    let run = Run::of(model, &TransientSettings::new(0.5, 0.01), 10);
    run.check_end();
    run
}

/// Strains of the sections, in their axes, and the force of the joint on the body.
fn observed(run: &Run) -> Vec<(Vec<Vector6<f64>>, Vector3<f64>)> {
    let observed = run.instants.iter().map(|(time, state)| {
        let conditions = run.model.conditions_at(*time);
        let sections = run.model.system.observe(state, &conditions).sections;
        let strains = sections.iter().map(|section| section.strain).collect();
        let [force, _] = run.reaction_in(state, *time, "joint", 5);
        (strains, force)
    });
    observed.collect()
}

/// The iteration ends at 1e-8 of the size of the model: converging fast, its error is 1e-8 of the
/// largest strain and force.
#[test]
fn a_superposed_rigid_motion_changes_no_strain_and_no_reaction() {
    let plain = observed(&run(&Superposed {
        turn: Matrix3::identity(),
        shift: Vector3::zeros(),
        velocity: Vector3::zeros(),
    }));
    let strain = |observed: &[(Vec<Vector6<f64>>, Vector3<f64>)]| {
        let strains = observed.iter().flat_map(|(strains, _)| strains);
        strains.map(Vector6::amax).fold(0.0, f64::max)
    };
    let force = plain.iter().map(|(_, force)| force.norm());
    let sizes = [strain(&plain), force.fold(0.0, f64::max)];
    assert!(sizes[0] > 1e-3 && sizes[1] > 0.1, "{sizes:?}");
    for (turn, shift, velocity) in [
        ([1.2, -0.7, 2.1], [3.0, -1.0, 5.0], [0.0, 0.0, 0.0]),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [4.0, -2.0, 7.0]),
        ([-0.4, 2.6, 0.9], [-2.0, 8.0, 1.0], [-5.0, 3.0, 2.0]),
    ] {
        let turn = *Rotation3::new(Vector3::from(turn)).matrix();
        let other = observed(&run(&Superposed {
            turn,
            shift: shift.into(),
            velocity: velocity.into(),
        }));
        let mut errors = [0.0_f64; 2];
        for (one, two) in plain.iter().zip(&other) {
            for (a, b) in one.0.iter().zip(&two.0) {
                errors[0] = errors[0].max((a - b).amax() / sizes[0]);
            }
            errors[1] = errors[1].max((turn * one.1 - two.1).norm() / sizes[1]);
        }
        let source = "objectivity";
        let case = "free beam with a jointed body";
        record::largest(source, case, "strains, of the largest", errors[0], 1e-8);
        record::largest(source, case, "reaction, of the largest", errors[1], 1e-8);
        assert!(errors[0] < 1e-8 && errors[1] < 1e-8, "{errors:?}");
    }
}
