//! Starts from equilibrium of joints that are driven by a speed; springs that turn far; steps too
//! long for a rotation.

use nalgebra::{Matrix3, Vector3};
use shared_geom::expression::{Expression, Names};

use super::models::{body, moving, node, run, states};
use super::rigid::free_body;
use super::strip::Strip;
use beam_dynamics::analysis::transient::TransientFailure;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, Start, TransientSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::joints::{
    ConstraintJoint, Hinge, HingeSpring, JointEnds, Placing, Turning, axes_along,
};
use beam_dynamics::elements::laws::Law;
use beam_dynamics::elements::springs::{Spring, SpringLaw};
use beam_dynamics::integrator::Reason;
use beam_dynamics::model::{Drive, Formula, Ramp};

/// A beam along x whose root turns about z.
fn beam(turning: Turning) -> Model {
    let (nodes, mut parts) = Strip::rotating(4).parts();
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let placing = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::z()));
    let hub = ConstraintJoint::revolute("hub", &ends, &placing, Some(turning));
    parts.push(Box::new(hub));
    Model::new("beam", System::new(nodes, parts))
}

fn rotating(speed: f64) -> TransientSettings {
    TransientSettings {
        start: Start::Rotating { speed },
        ..TransientSettings::new(0.25, 0.005)
    }
}

// Model K at eta = 6: an angle that grows evenly and its speed are the same motion. The first holds
// the angle, the second integrates it, by a scheme of second order: 0.03^2/12 of the angle at a
// step of 0.03 rad, and the response of the beam.
#[test]
fn a_driven_speed_starts_from_the_rotating_equilibrium() {
    let speed = 6.0;
    let ramp = Drive::Ramp(Ramp {
        from: 0.0,
        to: 100.0 * speed,
        start: 0.0,
        end: 100.0,
        smooth: false,
    });
    let by_angle = states(&beam(Turning::Angle(ramp.into())), &rotating(speed));
    let model = beam(Turning::Speed(Drive::Constant(speed).into()));
    let (kept, outcome) = run(&model, &rotating(speed));
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    assert_eq!(outcome.changes, []);
    let first = [&by_angle[0], &kept.states[0]].map(|state| state.nodes.last().unwrap().position);
    assert!((first[0] - first[1]).amax() < 1e-12, "{first:?}");
    for state in &kept.states {
        let radius = state.nodes.last().unwrap().position.norm();
        let off = (radius - 1.0 - speed * speed / 3e7).abs();
        assert!(off < 1e-6, "{off:e}");
    }
    let last = [&by_angle, &kept.states].map(|all| all.last().unwrap().nodes.last().unwrap());
    let off = (last[0].position - last[1].position).amax();
    assert!(off < 5e-4, "{off:e}");
}

// At rest under its weight, 1 N on EI = 1 N m^2: it stays at rest, and does not turn.
#[test]
fn a_driven_speed_starts_from_the_equilibrium_at_rest() {
    let mut model = beam(Turning::Speed(Drive::Constant(0.0).into()));
    model.gravity = Vector3::new(0.0, -0.3, -0.5);
    let settings = TransientSettings {
        start: Start::Equilibrium,
        ..TransientSettings::new(0.1, 0.005)
    };
    let found = states(&model, &settings);
    let tip = |i: usize| found[i].nodes.last().unwrap().position;
    assert!((tip(0) - Vector3::x()).norm() > 0.05, "{}", tip(0));
    let moved = (0..found.len()).map(|i| (tip(i) - tip(0)).norm());
    assert!(moved.fold(0.0, f64::max) < 1e-8);
}

// A velocity on a body next to the axis.
#[test]
fn imposed_velocities_that_go_with_the_rotation_are_kept() {
    let settings = rotating(2.0);
    let attempt = |along: f64| {
        let nodes = vec![node("a", Vector3::x(), Matrix3::identity())];
        let ends = JointEnds {
            a: None,
            b: (0, &nodes[0]),
        };
        let at = Placing::at(&nodes[0].position, &Matrix3::identity());
        let fixed = |value: f64| Some(Drive::Constant(value).into());
        let rates = [
            fixed(0.0),
            fixed(along),
            fixed(0.0),
            fixed(0.0),
            fixed(0.0),
            fixed(2.0),
        ];
        let belt = ConstraintJoint::velocity("belt", &ends, &at, rates);
        let elements: Vec<Box<dyn Element>> =
            vec![body(0, 1.0, Vector3::zeros(), [1.0; 3]), Box::new(belt)];
        let model = Model::new("belt", System::new(nodes, elements));
        run(&model, &settings)
    };
    let (kept, outcome) = attempt(2.0);
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    assert!((kept.states[0].nodes[0].position - Vector3::x()).norm() < 1e-12);
    assert!(attempt(0.0).1.failure.is_some());
}

#[test]
fn another_speed_than_that_of_the_start_is_refused_before_the_iteration() {
    let model = beam(Turning::Speed(Drive::Constant(-6.0).into()));
    let failure = run(&model, &rotating(6.0)).1.failure.unwrap();
    assert!(
        matches!(failure, TransientFailure::DrivenOtherwise { .. }),
        "{failure}"
    );
    let expected = "start: the model does not turn as a whole at 57.296 rpm: \"hub\" drives a \
                    velocity that is off by 1.200e1 rad/s or m/s";
    assert_eq!(failure.to_string(), expected);
    assert!(failure.remedy().contains("with its sign"));
}

/// A body that spins about z at 10 rad/s against a weak spring to the frame, or to a heavy body at
/// rest.
fn wound(is_hinge: bool, speed: f64) -> Model {
    let nodes: Vec<_> = ["heavy", "light"]
        .map(|label| node(label, Vector3::zeros(), Matrix3::identity()))
        .into();
    let mut elements = vec![
        body(0, 1e6, Vector3::zeros(), [1e6; 3]),
        body(1, 1.0, Vector3::zeros(), [1.0; 3]),
    ];
    let ends = [(0, &nodes[0]), (1, &nodes[1])];
    if is_hinge {
        let spring = HingeSpring {
            stiffness: 0.1,
            ..HingeSpring::default()
        };
        let positions = ends.map(|end| end.0);
        let on = ends.map(|end| end.1);
        let hinge = Hinge::new(
            "coil",
            positions,
            on,
            &Vector3::zeros(),
            &Vector3::z(),
            spring,
        );
        elements.push(Box::new(hinge));
    } else {
        let law = SpringLaw::of_rotation(Law::linear(0.1 * Matrix3::identity()));
        let axes = Matrix3::identity();
        let spring = Spring::new("coil", (&[1], &nodes), &Vector3::zeros(), &axes, law);
        elements.push(Box::new(spring));
    }
    let mut model = Model::new("coil", System::new(nodes, elements));
    model.initial[1] = moving(Vector3::zeros(), speed * Vector3::z());
    model
}

// 10 rad/s reach half a turn just after 0.31 s; at 0.5 rad/s the spring turns it back, with the
// amplitude 0.5/sqrt(0.1) = 1.58 rad.
#[test]
fn springs_that_turn_by_half_a_turn_end_the_run() {
    for is_hinge in [true, false] {
        let settings = TransientSettings::new(1.0, 0.01);
        let failure = run(&wound(is_hinge, 10.0), &settings).1.failure.unwrap();
        assert!(matches!(failure, TransientFailure::Wound { .. }));
        let text = failure.to_string();
        assert!(
            text.starts_with("at 0.32 s the spring \"coil\" has turned"),
            "{text}"
        );
        assert!(failure.remedy().contains("half a turn"));
        let settings = TransientSettings::new(20.0, 0.05);
        let outcome = run(&wound(is_hinge, 0.5), &settings).1;
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    }
}

// |omega| = sqrt(1 + 4 + 0.04) = 2.245 rad/s.
#[test]
fn a_node_that_turns_far_in_a_step_is_reported_once() {
    let outcome = run(&free_body(), &TransientSettings::new(1.0, 0.2)).1;
    let [remark] = &outcome.remarks[..] else {
        panic!("{:?}", outcome.remarks)
    };
    assert!(remark.starts_with("node \"body\" turns by 0.4"), "{remark}");
    assert!(remark.contains("at t = 0.2 s"), "{remark}");
    let outcome = run(&free_body(), &TransientSettings::new(1.0, 0.1)).1;
    assert!(outcome.remarks.is_empty(), "{:?}", outcome.remarks);
}

// A model that is not read from a file is not checked before it is run: corners every
// nanosecond end it.
#[test]
fn corners_without_end_end_the_run() {
    let names = Names {
        variables: &["t"],
        constants: &[],
    };
    let steps = Formula::new(Expression::parse("floor(1e9*t)", &names).unwrap(), 1.0);
    let mut model = free_body();
    model.gravity = 1e-9 * Vector3::z();
    model.gravity_drive = Drive::Formula(std::sync::Arc::new(steps));
    let failure = run(&model, &TransientSettings::new(1.0, 0.01))
        .1
        .failure
        .unwrap();
    let text = failure.to_string();
    let TransientFailure::Step(trouble) = &failure else {
        panic!("{text}")
    };
    assert_eq!(trouble.failure.reason, Reason::Corners);
    assert!(text.contains("too many corners in succession"), "{text}");
    assert!(text.contains("a drive of gravity"), "{text}");
    assert!(failure.remedy().contains("fewer corners"));
}
