//! Constraints agree with their names: a small motion of b changes the constraint of this name by
//! the same amount, and no other of its kind.
#![allow(clippy::unwrap_used, reason = "test helpers")]

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::samples::freedoms;
use super::{ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along};
use crate::elements::{Element, Level, Local, LocalResidual, LocalSize, Queries};
use crate::model::{Conditions, Drive, NODE_UNKNOWNS, Node, NodeMotion, Scalars};

/// A small motion: the second-order error is its square.
const SMALL: f64 = 1e-5;

fn constraints(joint: &ConstraintJoint, motions: &[NodeMotion]) -> Vec<f64> {
    let count = joint.multipliers();
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: motions,
        multipliers: &vec![0.0; count],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut out = LocalResidual::new(LocalSize::without_scalars(motions.len(), count));
    joint.residual(&at, &mut out);
    out.values()[NODE_UNKNOWNS * motions.len()..].to_vec()
}

fn joints(ends: &JointEnds<'_>, at: &Placing) -> Vec<ConstraintJoint> {
    use ConstraintJoint as Joint;
    let speed = || Turning::Speed(Drive::Constant(0.0).into());
    let rates = std::array::from_fn(|_| Some(Drive::Constant(0.0).into()));
    let mut joints = vec![
        Joint::clamp("clamp", ends, at),
        Joint::spherical("spherical", ends, at),
        Joint::revolute("revolute", ends, at, Some(speed())),
        Joint::cylindrical("cylindrical", ends, at, Freedom::Free, None),
        Joint::prismatic("prismatic", ends, at, Freedom::Free),
        Joint::in_line("in-line", ends, at),
        Joint::in_plane("in-plane", ends, at, None),
        Joint::plane_rotation("plane rotation", ends, at, None),
        Joint::spin("spin", ends, at, speed()),
        Joint::velocity("velocity", ends, at, rates),
    ];
    joints.extend((1..64).map(|bits| Joint::total("total", ends, at, freedoms(bits, None))));
    joints
}

/// Expects that the constraints called `name` about an axis change by `by`, and no others of that
/// kind.
#[track_caller]
fn expect(joint: &ConstraintJoint, motions: &[NodeMotion], (name, axis): (&str, usize), by: f64) {
    let prefix = format!("{name} {} of ", ["x", "y", "z"][axis]);
    for (i, value) in constraints(joint, motions).into_iter().enumerate() {
        let words = joint.constraint_words(i);
        if !words.held.starts_with(name) {
            continue;
        }
        let expected = if words.held.starts_with(&prefix) {
            by
        } else {
            0.0
        };
        let off = (value.abs() - expected).abs();
        assert!(
            off < 2.0 * SMALL * SMALL,
            "{}: {words:?}: {value}",
            joint.label()
        );
    }
}

// The point of the joint is b itself, so that a rotation does not move it.
#[test]
fn names_of_constraints_report_what_they_hold() {
    let node = |label: &str, position: Vector3<f64>, turn: Vector3<f64>| Node {
        label: label.to_owned(),
        position,
        rotation: vector::to_rotation(&turn),
    };
    let nodes = [
        node(
            "a",
            Vector3::new(0.3, -0.2, 0.5),
            Vector3::new(0.1, 0.9, -0.4),
        ),
        node(
            "b",
            Vector3::new(1.1, 0.4, -0.3),
            Vector3::new(-0.7, 0.2, 0.3),
        ),
    ];
    let ends = JointEnds {
        a: Some((0, &nodes[0])),
        b: (1, &nodes[1]),
    };
    let axes: Matrix3<f64> = axes_along(&Vector3::new(0.3, 0.7, -0.5));
    let at = Placing::at(&nodes[1].position, &axes);
    let rest: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    for joint in joints(&ends, &at) {
        for axis in 0..3 {
            let direction = axes.column(axis).into_owned();
            let with = |change: &dyn Fn(&mut NodeMotion)| {
                let mut motions = rest.clone();
                change(&mut motions[1]);
                motions
            };
            let moved = with(&|b| b.position += SMALL * direction);
            expect(&joint, &moved, ("offset along", axis), SMALL);
            expect(&joint, &moved, ("rotation about", axis), 0.0);
            let turned =
                with(&|b| b.rotation = vector::to_rotation(&(SMALL * direction)) * b.rotation);
            expect(&joint, &turned, ("rotation about", axis), SMALL);
            expect(&joint, &turned, ("offset along", axis), 0.0);
            let moving = with(&|b| b.velocity = direction);
            expect(&joint, &moving, ("velocity along", axis), 1.0);
            let turning = with(&|b| b.angular_velocity = direction);
            expect(&joint, &turning, ("angular velocity about", axis), 1.0);
        }
    }
}

// Units follow the level and the reaction; names of one joint are different.
#[test]
fn every_constraint_has_a_name_and_units_of_its_own() {
    let nodes = [[0.0, 0.0, 0.0], [1.0, 0.5, 0.0]].map(|position| Node {
        label: "n".to_owned(),
        position: Vector3::from(position),
        rotation: Matrix3::identity(),
    });
    let ends = JointEnds {
        a: Some((0, &nodes[0])),
        b: (1, &nodes[1]),
    };
    let at = Placing::at(&nodes[1].position, &Matrix3::identity());
    let apart = Placing {
        points: [nodes[0].position, nodes[1].position],
        ..at
    };
    let crossed = Placing {
        axes: [Matrix3::identity(), axes_along(&Vector3::y())],
        ..at
    };
    let mut joints = joints(&ends, &at);
    joints.push(ConstraintJoint::distance(
        "rod",
        &ends,
        &apart,
        Drive::Constant(1.0),
    ));
    joints.push(ConstraintJoint::universal("cardan", &ends, &crossed));
    for joint in joints {
        let words: Vec<_> = (0..joint.multipliers())
            .map(|i| joint.constraint_words(i))
            .collect();
        for (i, own) in words.iter().enumerate() {
            let is_rate = own.unit.ends_with("/s");
            assert_eq!(is_rate, joint.level(i) == Level::Velocity, "{own:?}");
            let is_force = ["m", "m/s"].contains(&own.unit);
            assert_eq!(is_force, own.reaction_unit == "N", "{own:?}");
            assert_eq!(is_force, own.reaction.starts_with("force "), "{own:?}");
            assert!(
                !words[..i].iter().any(|other| other.held == own.held),
                "{own:?}"
            );
        }
    }
}
