//! Positions and velocities that fulfill the constraints, and the reports of them.

use nalgebra::{Matrix3, Vector3};

use super::models::{body, node, pendulum, run, spherical, states};
use beam_dynamics::analysis::transient::{Changed, StartChange, TransientFailure};
use beam_dynamics::assembly::System;
use beam_dynamics::case::{InitialMotion, Model, Redundant, StartAccelerations, TransientSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::joints::{
    ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along, clamped, partly_clamped,
};
use beam_dynamics::integrator::{StepControl, Stepping};
use beam_dynamics::model::{Drive, Node, Ramp};

fn distance(nodes: &[Node], b: usize, length: f64) -> Box<dyn Element> {
    let ends = JointEnds {
        a: None,
        b: (b, &nodes[b]),
    };
    let placing = Placing {
        points: [Vector3::zeros(), nodes[b].position],
        axes: [Matrix3::identity(); 2],
    };
    let length = Drive::Constant(length);
    Box::new(ConstraintJoint::distance("rod", &ends, &placing, length))
}

// The point of a circle of radius 2 next to (3, 4) is at 2/5 of it; the component of the velocity
// (1, 0) along the tangent (-4, 3)/5 is (16, -12)/25. Newton's method to round-off.
#[test]
fn a_point_goes_to_the_nearest_position_and_velocity() {
    let nodes = vec![node("p", Vector3::new(3.0, 4.0, 0.0), Matrix3::identity())];
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        distance(&nodes, 0, 2.0),
    ];
    let mut model = Model::new("circle", System::new(nodes, elements));
    model.initial[0].velocity = Some(Vector3::x());
    let (kept, outcome) = run(&model, &TransientSettings::new(0.01, 0.01));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let start = &kept.states[0].nodes[0];
    let off = start.position - Vector3::new(1.2, 1.6, 0.0);
    assert!(off.norm() < 1e-12, "{}", start.position);
    let off = start.velocity - Vector3::new(0.64, -0.48, 0.0);
    assert!(off.norm() < 1e-12, "{}", start.velocity);
    let reported: Vec<_> = outcome.changes.iter().map(ToString::to_string).collect();
    assert_eq!(
        reported,
        [
            "position of node \"p\" along x: from 3 to 1.2 m",
            "position of node \"p\" along y: from 4 to 1.6 m",
            "velocity of node \"p\" along x: from 1 to 0.64 m/s",
            "velocity of node \"p\" along y: from 0 to -0.48 m/s",
        ]
    );
}

/// Two bodies at one position, joined there, one of which moves.
fn pair(weights: [Option<f64>; 2]) -> Model {
    let nodes: Vec<_> = ["a", "b"]
        .map(|label| node(label, Vector3::zeros(), Matrix3::identity()))
        .into();
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        body(1, 1.0, Vector3::zeros(), [1.0; 3]),
        spherical(&nodes, Some(0), 1, Vector3::zeros()),
    ];
    let mut model = Model::new("pair", System::new(nodes, elements));
    for i in 0..2 {
        model.initial[i] = InitialMotion {
            velocity: Some([Vector3::x(), Vector3::zeros()][i]),
            velocity_weight: weights[i],
            ..InitialMotion::default()
        };
    }
    model
}

// Dynamics theory 4.2: weights (1, 1) give the mean, (1, 3) a quarter. Velocities that are not
// given follow, up to their weight of 1e-8.
#[test]
fn velocities_that_conflict_meet_by_their_weights() {
    let start = |model: &Model| {
        let found = states(model, &TransientSettings::new(0.01, 0.01));
        found[0].nodes[1].velocity.x
    };
    assert!((start(&pair([None, None])) - 0.5).abs() < 1e-12);
    assert!((start(&pair([Some(1.0), Some(3.0)])) - 0.25).abs() < 1e-12);
    let mut follows = pair([None, None]);
    follows.initial[1].velocity = None;
    assert!((start(&follows) - 1.0).abs() < 1e-7);
    let changes = run(&follows, &TransientSettings::new(0.01, 0.01)).1.changes;
    let of_b = |change: &&StartChange| change.node == "b" && change.what == Changed::Velocity;
    assert_eq!(changes.iter().filter(of_b).count(), 1, "{changes:?}");
}

// Rods that cannot meet: 3 long from one point and 1 long from another point at a distance of 5.
#[test]
fn positions_that_do_not_exist_are_reported() {
    let nodes = vec![node("p", Vector3::new(1.0, 0.0, 0.0), Matrix3::identity())];
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        distance(&nodes, 0, 2.0),
        distance(&nodes, 0, 3.0),
    ];
    let model = Model::new("rods", System::new(nodes, elements));
    let failure = run(&model, &TransientSettings::new(0.1, 0.01))
        .1
        .failure
        .unwrap();
    let text = failure.to_string();
    assert!(
        matches!(failure, TransientFailure::Positions { .. }),
        "{text}"
    );
    assert!(text.contains("\"rod\""), "{text}");
    // The smallest violation is half a meter; at the given positions it is two.
    let TransientFailure::Positions { value, .. } = failure else {
        unreachable!("it has been asserted above");
    };
    assert!((0.5 - 1e-9..=2.0).contains(&value.abs()), "{text}");
}

// A body that is clamped twice: six constraints are redundant. Each clamp then carries half of the
// weight, 20 N.
#[test]
fn constraints_that_follow_from_others_are_refused_or_left_out() {
    let nodes = vec![node("p", Vector3::zeros(), Matrix3::identity())];
    let elements: Vec<Box<dyn Element>> = vec![
        body(0, 2.0, Vector3::zeros(), [1.0; 3]),
        Box::new(clamped("one", 0, &nodes[0])),
        Box::new(clamped("two", 0, &nodes[0])),
    ];
    let mut model = Model::new("twice", System::new(nodes, elements));
    model.gravity = -10.0 * Vector3::z();
    let mut settings = TransientSettings::new(0.1, 0.01);
    let failure = run(&model, &settings).1.failure.unwrap();
    let text = failure.to_string();
    assert!(
        text.contains("redundant constraints") && text.contains("\"two\""),
        "{text}"
    );
    settings.redundant = Redundant::Remove;
    let (kept, outcome) = run(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    assert!(!outcome.remarks.is_empty());
    for state in &kept.states {
        assert!((state.multipliers[8].abs() - 10.0).abs() < 1e-9);
        assert!((state.multipliers[2].abs() - 10.0).abs() < 1e-9);
    }
}

#[test]
fn a_loose_node_without_mass_is_named() {
    let nodes = vec![
        node("p", Vector3::zeros(), Matrix3::identity()),
        node("loose", Vector3::x(), Matrix3::identity()),
    ];
    let elements = vec![body(0, 1.0, Vector3::zeros(), [1.0; 3])];
    let model = Model::new("loose", System::new(nodes, elements));
    let failure = run(&model, &TransientSettings::new(0.1, 0.01))
        .1
        .failure
        .unwrap();
    let text = failure.to_string();
    assert!(text.starts_with("node \"loose\" has no "), "{text}");
    assert!(failure.remedy().contains("[[body]]"));
}

// A body on a rail along x, two to the right of a point next to the rail, on a rod from this point
// that shortens from sqrt(5) to less than the distance one of the rail: at one no position exists
// any more, after (sqrt(5) - 1)/(sqrt(5) - 0.5) of the ramp of one second, 0.712 s.
#[test]
fn a_step_that_cannot_be_made_is_explained_and_the_rest_is_kept() {
    let nodes = vec![node(
        "slider",
        Vector3::new(2.0, 0.0, 0.0),
        Matrix3::identity(),
    )];
    let held = [false, true, true, true, true, true];
    let rail = partly_clamped("rail", 0, &nodes[0], &Matrix3::identity(), held);
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let placing = Placing {
        points: [Vector3::y(), nodes[0].position],
        axes: [Matrix3::identity(); 2],
    };
    let length = Drive::Ramp(Ramp {
        from: 5.0_f64.sqrt(),
        to: 0.5,
        start: 0.0,
        end: 1.0,
        smooth: false,
    });
    let rod = ConstraintJoint::distance("rod", &ends, &placing, length);
    let elements: Vec<Box<dyn Element>> = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        Box::new(rail),
        Box::new(rod),
    ];
    let model = Model::new("rail", System::new(nodes, elements));
    let (kept, outcome) = run(&model, &TransientSettings::new(1.0, 0.01));
    let failure = outcome.failure.unwrap();
    let text = failure.to_string();
    assert!(matches!(failure, TransientFailure::Step(_)), "{text}");
    assert!((outcome.time - 0.712).abs() < 0.01, "{}", outcome.time);
    assert_eq!(kept.times.last(), Some(&outcome.time));
    for part in ["no step from 0.7", "worst equation: ", "likely cause: "] {
        assert!(text.contains(part), "{part}: {text}");
    }
    // The model has no law.
    let remedy = failure.remedy();
    assert!(!remedy.is_empty());
    let of_laws = |text: &str| {
        ["law", "jump", "kink"]
            .iter()
            .any(|word| text.contains(word))
    };
    assert!(!of_laws(&text) && !of_laws(&remedy), "{text} {remedy}");
    // The slider follows the rod: x^2 + 1 = length^2.
    for (time, state) in kept.times.iter().zip(&kept.states).take(60) {
        let length = 5.0_f64.sqrt() + (0.5 - 5.0_f64.sqrt()) * time;
        let x = state.nodes[0].position.x;
        assert!((x * x + 1.0 - length * length).abs() < 1e-9, "{time}: {x}");
    }
}

// A rod of one millimeter that is given too short by a part of 5e-10: the tolerance is relative to
// the size of the model, whose nodes are one millimeter apart, and not in meters.
#[test]
fn small_models_are_placed_as_well_as_large_ones() {
    let size = 1e-3;
    let nodes = vec![
        node("p", Vector3::zeros(), Matrix3::identity()),
        node("q", size * Vector3::x(), Matrix3::identity()),
    ];
    let length = size * (1.0 + 5e-10);
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [1.0; 3]),
        body(1, 1.0, Vector3::zeros(), [1.0; 3]),
        distance(&nodes, 1, length),
    ];
    let model = Model::new("small", System::new(nodes, elements));
    let found = states(&model, &TransientSettings::new(0.01, 0.01));
    let off = found[0].nodes[1].position.norm() / length - 1.0;
    assert!(off.abs() < 1e-11, "{off:e}");
}

// Dummy steps are iterated like the steps of the run.
#[test]
fn dummy_steps_keep_the_limits_of_the_run() {
    let mut settings = TransientSettings::new(0.1, 0.01);
    settings.start_accelerations = StartAccelerations::Dummy;
    settings.newton.iterations = 1;
    (settings.newton.residual, settings.newton.correction) = (1e-300, 1e-300);
    let failure = run(&pendulum(), &settings).1.failure.unwrap();
    let text = failure.to_string();
    assert!(matches!(failure, TransientFailure::Dummy(_)), "{text}");
    assert!(text.contains("did not converge"), "{text}");
    assert!(!failure.remedy().is_empty());
}

// A local error below round-off: the unknown is named, and the requested tolerance is the cause.
#[test]
fn a_local_error_is_reported_by_its_unknown() {
    let mut settings = TransientSettings::new(1.0, 0.01);
    settings.stepping = Stepping::Variable(StepControl {
        first: 1e-3,
        least: 1e-4,
        most: 0.1,
        tolerance: 1e-14,
    });
    let failure = run(&pendulum(), &settings).1.failure.unwrap();
    let text = failure.to_string();
    for part in ["largest error: ", "of node \"bob\"", "tolerance 1.000e-14"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    for part in ["worst equation", "jump"] {
        assert!(!text.contains(part), "{part}: {text}");
    }
}

// A revolute joint about y turns (1, 0, 0) to (cos, 0, -sin) of its angle, at any angle; a total
// joint with a driven rotation about z to (cos, sin, 0). The tolerance is the tolerance of Newton's
// method.
#[test]
fn driven_rotations_start_at_their_angle_however_large() {
    let rig = |joint: fn(&JointEnds<'_>, f64) -> ConstraintJoint, angle: f64| {
        let nodes = vec![node("a", Vector3::x(), Matrix3::identity())];
        let ends = JointEnds {
            a: None,
            b: (0, &nodes[0]),
        };
        let joint = joint(&ends, angle.to_radians());
        let elements: Vec<Box<dyn Element>> =
            vec![body(0, 1.0, Vector3::zeros(), [1.0; 3]), Box::new(joint)];
        let model = Model::new("turned", System::new(nodes, elements));
        let (kept, outcome) = run(&model, &TransientSettings::new(0.02, 0.01));
        assert!(outcome.failure.is_none(), "{angle}: {:?}", outcome.failure);
        kept.states[0].nodes[0]
    };
    let about_y = |ends: &JointEnds<'_>, angle: f64| {
        let at = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::y()));
        let turning = Turning::Angle(Drive::Constant(angle).into());
        ConstraintJoint::revolute("motor", ends, &at, Some(turning))
    };
    let about_z = |ends: &JointEnds<'_>, angle: f64| {
        let at = Placing::at(&Vector3::zeros(), &Matrix3::identity());
        let mut freedoms = [const { Freedom::Locked }; 6];
        freedoms[5] = Freedom::Driven(Drive::Constant(angle).into());
        ConstraintJoint::total("motor", ends, &at, freedoms)
    };
    for angle in [-170.0_f64, 45.0, 90.0, 120.0, 180.0, 200.0, 270.0, 3690.0] {
        let (sin, cos) = angle.to_radians().sin_cos();
        let off = rig(about_y, angle).rotation * Vector3::x() - Vector3::new(cos, 0.0, -sin);
        assert!(off.amax() < 1e-9, "{angle}: {off}");
        let off = rig(about_z, angle).rotation * Vector3::x() - Vector3::new(cos, sin, 0.0);
        assert!(off.amax() < 1e-9, "{angle}: {off}");
    }
}

/// Messages of a run of a body at the origin under two joints, whose redundant constraints are
/// removed.
fn refusal(joints: [Box<dyn Element>; 2], nodes: Vec<Node>) -> String {
    let mut elements = vec![body(0, 1.0, Vector3::zeros(), [1.0; 3])];
    elements.extend(joints);
    let model = Model::new("two", System::new(nodes, elements));
    let mut settings = TransientSettings::new(0.02, 0.01);
    settings.redundant = Redundant::Remove;
    let failure = run(&model, &settings).1.failure;
    failure.map_or_else(String::new, |failure| failure.to_string())
}

fn ramp(slope: f64) -> Drive {
    Drive::Ramp(Ramp {
        from: 0.0,
        to: slope,
        start: 0.0,
        end: 1.0,
        smooth: false,
    })
}

// A clamp and a displacement of 1 m/s; motors of 100 and of 50 rad/s on one axis.
#[test]
fn constraints_that_contradict_are_never_left_out() {
    let nodes = vec![node("a", Vector3::zeros(), Matrix3::identity())];
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let at = Placing::at(&Vector3::zeros(), &Matrix3::identity());
    let mut freedoms = [const { Freedom::Free }; 6];
    freedoms[0] = Freedom::Driven(ramp(1.0).into());
    let moved = ConstraintJoint::total("moved", &ends, &at, freedoms);
    let held = clamped("clamp", 0, &nodes[0]);
    let text = refusal([Box::new(held), Box::new(moved)], nodes.clone());
    let expected = "contradicting constraints, from 0 s on: constraint 1 (along x) of \"moved\" \
        contradicts \"clamp\", by 1 m/s";
    assert_eq!(text, expected);
    let motor = |name: &str, slope: f64| -> Box<dyn Element> {
        let turning = Some(Turning::Angle(ramp(slope).into()));
        Box::new(ConstraintJoint::revolute(name, &ends, &at, turning))
    };
    let text = refusal([motor("fast", 100.0), motor("slow", 50.0)], nodes.clone());
    let contradicts = text.contains("of \"slow\" contradicts \"fast\", by 50 rad/s");
    assert!(contradicts, "{text}");
    let alike = refusal([motor("one", 50.0), motor("two", 50.0)], nodes.clone());
    assert_eq!(alike, "");
}

// A point between two rods that are stretched out in one line: the second rod follows from the
// first there only. Then two motors of one axis whose angles diverge later: a ramp of 1/0.02 rad/s
// against zero.
#[test]
fn constraints_that_follow_in_one_position_only_are_not_left_out() {
    let nodes = vec![node("p", Vector3::x(), Matrix3::identity())];
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let rod = |name: &str, from: f64, length: f64| -> Box<dyn Element> {
        let at = Placing {
            points: [from * Vector3::x(), nodes[0].position],
            axes: [Matrix3::identity(); 2],
        };
        let length = Drive::Constant(length);
        Box::new(ConstraintJoint::distance(name, &ends, &at, length))
    };
    let text = refusal([rod("near", 0.0, 1.0), rod("far", 3.0, 2.0)], nodes.clone());
    assert!(text.starts_with("singular position"), "{text}");
    assert!(text.contains("\"far\" follows from \"near\""), "{text}");
    let late = Drive::Ramp(Ramp {
        from: 0.0,
        to: 1.0,
        start: 0.005,
        end: 0.025,
        smooth: false,
    });
    let motor = |name: &str, angle: Drive| -> Box<dyn Element> {
        let at = Placing::at(&Vector3::zeros(), &Matrix3::identity());
        let turning = Some(Turning::Angle(angle.into()));
        Box::new(ConstraintJoint::revolute(name, &ends, &at, turning))
    };
    let text = refusal(
        [motor("rests", Drive::Constant(0.0)), motor("late", late)],
        nodes.clone(),
    );
    let expected = "contradicting constraints, from 0.005 s on: ";
    assert!(text.starts_with(expected), "{text}");
    assert!(
        text.ends_with("of \"late\" contradicts \"rests\", by 50 rad/s"),
        "{text}"
    );
}

// A plane parallelogram of revolutes has three redundant constraints everywhere, and a fourth when
// its links lie in one line, where it can move in two ways.
#[test]
fn a_parallelogram_at_its_dead_point_is_refused_and_beside_it_runs() {
    let attempt = |angle: f64| {
        let arm = Vector3::new(angle.cos(), angle.sin(), 0.0);
        let base = 2.0 * Vector3::x();
        let middles = [0.5 * arm, arm + 0.5 * base, base + 0.5 * arm];
        let nodes = ["crank", "coupler", "rocker"].into_iter().zip(middles);
        let nodes: Vec<_> = nodes
            .map(|(label, position)| node(label, position, Matrix3::identity()))
            .collect();
        let mut elements: Vec<_> = (0..3)
            .map(|i| body(i, 1.0, Vector3::zeros(), [1.0; 3]))
            .collect();
        for (name, a, b, position) in [
            ("O", None, 0, Vector3::zeros()),
            ("A", Some(0), 1, arm),
            ("B", Some(1), 2, arm + base),
            ("C", None, 2, base),
        ] {
            let ends = JointEnds {
                a: a.map(|a: usize| (a, &nodes[a])),
                b: (b, &nodes[b]),
            };
            let at = Placing::at(&position, &axes_along(&Vector3::z()));
            elements.push(Box::new(ConstraintJoint::revolute(name, &ends, &at, None)));
        }
        let mut model = Model::new("parallelogram", System::new(nodes, elements));
        model.gravity = -10.0 * Vector3::y();
        let mut settings = TransientSettings::new(0.1, 0.01);
        settings.redundant = Redundant::Remove;
        run(&model, &settings).1
    };
    let failure = attempt(0.0).failure.unwrap();
    assert!(
        matches!(failure, TransientFailure::SingularPosition(_)),
        "{failure}"
    );
    let beside = attempt(1.0);
    assert!(beside.failure.is_none(), "{:?}", beside.failure);
    assert_eq!(beside.remarks.len(), 3, "{:?}", beside.remarks);
}

// A motor that turns by half a turn within a step and rests before and after it: its constraints
// are fulfilled at its old position too.
#[test]
fn a_rotation_that_a_step_leaves_half_a_turn_off_ends_the_run() {
    let nodes = vec![node("a", Vector3::x(), Matrix3::identity())];
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let at = Placing::at(&Vector3::zeros(), &Matrix3::identity());
    let jump = Drive::Ramp(Ramp {
        from: 0.0,
        to: std::f64::consts::PI,
        start: 0.011,
        end: 0.012,
        smooth: true,
    });
    let motor = ConstraintJoint::revolute("motor", &ends, &at, Some(Turning::Angle(jump.into())));
    let elements: Vec<Box<dyn Element>> =
        vec![body(0, 1.0, Vector3::zeros(), [1.0; 3]), Box::new(motor)];
    let model = Model::new("jump", System::new(nodes, elements));
    let failure = run(&model, &TransientSettings::new(0.05, 0.01)).1.failure;
    let text = failure.map_or_else(String::new, |failure| failure.to_string());
    let expected = "at 0.02 s a driven rotation settled 180 deg away from its prescribed value: \
                    \"motor\"";
    assert_eq!(text, expected);
}
