//! Starts from singular positions, and from unstable equilibria.

use nalgebra::{Matrix3, Vector3};

use super::models::{body, node, revolute_about_z, run, spherical};
use beam_dynamics::analysis::transient::{TransientFailure, TransientOutcome};
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, Start, TransientSettings};
use beam_dynamics::elements::joints::{ConstraintJoint, JointEnds, Placing};
use beam_dynamics::model::Drive;

/// A crank of 1 m on a pin at the origin, turned from x, at a distance from (5, 0, 0) m.
fn crank(turned: f64, length: f64) -> TransientOutcome {
    let position = Vector3::new(turned.cos(), turned.sin(), 0.0);
    let nodes = vec![node("crank", position, Matrix3::identity())];
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let placing = Placing {
        points: [Vector3::new(5.0, 0.0, 0.0), position],
        axes: [Matrix3::identity(); 2],
    };
    let rod = ConstraintJoint::distance("rod", &ends, &placing, Drive::Constant(length));
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        spherical(&nodes, None, 0, Vector3::zeros()),
        Box::new(rod),
    ];
    let model = Model::new("crank", System::new(nodes, elements));
    run(&model, &TransientSettings::new(0.01, 0.01)).1
}

// In line the distance to the point, 4 m, does not change as the crank begins to turn, although it
// can be up to 6 m. The reported violation is no larger than at the start.
#[test]
fn a_start_in_line_is_reported_and_one_beside_it_is_placed() {
    for (length, at_start) in [(4.5, 0.5), (6.5, 2.5)] {
        let failure = crank(0.0, length).failure.unwrap();
        let help = failure.remedy();
        assert!(help.contains("slightly away"), "{failure}: {help}");
        let TransientFailure::Positions { value, .. } = failure else {
            panic!("{failure}");
        };
        assert!(value.abs() <= at_start + 1e-12, "{value}");
    }
    let failure = crank(0.1, 4.5).failure;
    assert!(failure.is_none(), "{failure:?}");
}

/// A rod on a pin in the plane of x and y, with its mass at `height` above it on y.
fn rod_at(height: f64) -> Vec<String> {
    let position = Vector3::new(0.0, height, 0.0);
    let nodes = vec![node("bob", position, Matrix3::identity())];
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [0.1; 3]),
        revolute_about_z(&nodes, 0),
    ];
    let mut model = Model::new("rod", System::new(nodes, elements));
    model.gravity = -9.81 * Vector3::y();
    let settings = TransientSettings {
        start: Start::Equilibrium,
        ..TransientSettings::new(1.0, 0.01)
    };
    let outcome = run(&model, &settings).1;
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.remarks
}

// Upright it falls with the rate sqrt(m g l / (m l^2 + J)) = sqrt(9.81/1.1) = 2.986 1/s.
#[test]
fn an_unstable_equilibrium_to_start_from_is_reported() {
    let upright = rod_at(1.0);
    let is_reported = |remark: &String| remark.contains("unstable") && remark.contains("2.986e0");
    assert!(upright.iter().any(is_reported), "{upright:?}");
    assert_eq!(rod_at(-1.0), Vec::<String>::new());
}
