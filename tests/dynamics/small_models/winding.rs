//! Springs that turn by half a turn, whose relaxed angle is given, driven or a prestrain.

use nalgebra::{Matrix3, Vector3};

use super::models::{body, moving, node, run};
use beam_dynamics::analysis::transient::{TransientFailure, TransientOutcome};
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::joints::{Hinge, HingeSpring};
use beam_dynamics::elements::laws::{Driven, Law, LawKind, Term};
use beam_dynamics::elements::springs::{Spring, SpringLaw};
use beam_dynamics::model::{Drive, Node, Ramp};

/// 5 rad/s, for 10 s.
fn turning() -> Drive {
    Drive::Ramp(Ramp {
        from: 0.0,
        to: 50.0,
        start: 0.0,
        end: 10.0,
        smooth: false,
    })
}

/// A body with the moment of inertia `inertia` about z that starts at `speed`, relative to a body
/// practically at rest, or to the frame.
fn model(inertia: f64, speed: f64, spring: impl Fn(&[Node]) -> Box<dyn Element>) -> Model {
    let nodes: Vec<_> = ["heavy", "turning"]
        .map(|label| node(label, Vector3::zeros(), Matrix3::identity()))
        .into();
    let elements = vec![
        body(0, 1e6, Vector3::zeros(), [1e6; 3]),
        body(1, 1.0, Vector3::zeros(), [inertia; 3]),
        spring(&nodes),
    ];
    let mut model = Model::new("coil", System::new(nodes, elements));
    model.initial[1] = moving(Vector3::zeros(), speed * Vector3::z());
    model
}

/// A hinge about z, relaxed at a given or a turning angle.
fn hinge(stiffness: f64, angle: Option<f64>) -> impl Fn(&[Node]) -> Box<dyn Element> {
    move |nodes| {
        let spring = HingeSpring {
            stiffness,
            damping: 0.0,
            angle: angle.unwrap_or_default(),
        };
        let on = [&nodes[0], &nodes[1]];
        let hinge = Hinge::new("coil", [0, 1], on, &Vector3::zeros(), &Vector3::z(), spring);
        Box::new(match angle {
            Some(_) => hinge,
            None => hinge.relaxed_by(turning()),
        })
    }
}

/// A rotational spring from the frame.
fn spring(term: Term<3>) -> impl Fn(&[Node]) -> Box<dyn Element> {
    move |nodes| {
        let law = SpringLaw::of_rotation(Law::sum(vec![term.clone()]));
        let axes = Matrix3::identity();
        Box::new(Spring::new(
            "coil",
            (&[1], nodes),
            &Vector3::zeros(),
            &axes,
            law,
        ))
    }
}

/// Time at which the spring `coil` has turned by half a turn.
fn wound_at(outcome: TransientOutcome) -> f64 {
    match outcome.failure {
        Some(TransientFailure::Wound { spring, time }) if spring == "coil" => time,
        other => panic!("{other:?}"),
    }
}

// 13 rad are more than two turns. With J = 1 kg m^2 and k = 1000 N m a body that starts with the
// relaxed angle follows it.
#[test]
fn a_hinge_follows_its_relaxed_angle_over_turns() {
    let model = model(1.0, 5.0, hinge(1000.0, None));
    let (kept, outcome) = run(&model, &TransientSettings::new(2.6, 0.01));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    // In a step of 0.05 rad the rotation agrees with its velocity to (0.05)^2 / 12 = 2e-4 of it.
    for state in &kept.states {
        let speed = state.nodes[1].angular_velocity.z;
        assert!((speed - 5.0).abs() < 2e-3, "{speed}");
    }
}

// A body that cannot follow: 5 t reaches half a turn at pi/5 = 0.628 s, and phi = k 5 t^3/(6 J) =
// 2e-4 rad later by 4e-5 s; the first step of 0.01 s after it ends at 0.63 s.
#[test]
fn a_hinge_that_cannot_follow_its_relaxed_angle_ends_the_run() {
    let model = model(1000.0, 0.0, hinge(1.0, None));
    let outcome = run(&model, &TransientSettings::new(1.0, 0.01)).1;
    let remedy = outcome.failure.as_ref().map(TransientFailure::remedy);
    assert!(remedy.is_some_and(|remedy| remedy.contains("from its relaxed angle")));
    let time = wound_at(outcome);
    assert!((time - 0.63).abs() < 1e-9, "{time}");
}

// Relaxed at 2 rad and turned away from it at 12 rad/s, J = 1, k = 20: phi - 2 = -A sin(w t + e)
// with w = sqrt(20), A = sqrt(4 + 144/20) = 3.347, sin e = 2/A reaches -pi at 0.1293 s, where
// phi is -1.14 rad only. At 10 rad/s, A = 3, it swings: phi goes to 5 rad at 0.89 s,
// beyond half a turn of the undeformed state.
#[test]
fn half_a_turn_counts_from_the_relaxed_angle() {
    let settings = TransientSettings::new(1.0, 0.01);
    let time = wound_at(run(&model(1.0, -12.0, hinge(20.0, Some(2.0))), &settings).1);
    assert!((time - 0.13).abs() < 1e-9, "{time}");
    let outcome = run(&model(1.0, -10.0, hinge(20.0, Some(2.0))), &settings).1;
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
}

fn driven(vector: [f64; 3], drive: Drive) -> Option<Driven<3>> {
    let vector = vector.into();
    let signal = drive.into();
    Some(Driven { vector, signal })
}

fn linear(stiffness: [f64; 3]) -> LawKind<3> {
    LawKind::Linear {
        stiffness: Matrix3::from_diagonal(&stiffness.into()),
    }
}

// The rotation vector of a spring jumps half a turn from the undeformed state, for any prestrain,
// and its moment with it: 5 t reaches it at 0.628 s.
#[test]
fn a_spring_that_follows_its_prestrain_ends_the_run_at_half_a_turn() {
    let coil = spring(Term {
        kind: linear([1000.0; 3]),
        prestrain: driven([0.0, 0.0, 1.0], turning()),
        prestress: None,
    });
    let outcome = run(&model(1.0, 5.0, coil), &TransientSettings::new(1.0, 0.01)).1;
    let time = wound_at(outcome);
    assert!((time - 0.63).abs() < 1e-9, "{time}");
}

// A moment about the free axis of a spring is the same on both sides of half a turn: a motor
// of 0.5 N m turns J = 1 kg m^2 from 10 rad/s to 10.5 rad/s in 1 s, one and a half turns. The
// scheme is exact for a constant moment.
#[test]
fn a_prestress_about_a_free_axis_turns_on() {
    let motor = || Term {
        kind: linear([3.0, 3.0, 0.0]),
        prestrain: None,
        prestress: driven([0.0, 0.0, -0.5], Drive::Constant(1.0)),
    };
    let settings = TransientSettings::new(1.0, 0.01);
    let (kept, outcome) = run(&model(1.0, 10.0, spring(motor())), &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let last = kept
        .states
        .last()
        .map(|state| state.nodes[1].angular_velocity);
    let speed = last.map_or(f64::NAN, |speed| speed.z);
    assert!((speed - 10.5).abs() < 1e-6, "{speed}");
    // About an axis across the free one it is not: the moment changes its sign with the rotation
    // vector.
    let across = Term {
        prestress: driven([0.5, 0.0, 0.0], Drive::Constant(1.0)),
        kind: linear([300.0, 300.0, 0.0]),
        ..motor()
    };
    let time = wound_at(run(&model(1.0, 10.0, spring(across)), &settings).1);
    assert!((time - 0.32).abs() < 0.02, "{time}");
}

// A boom that is folded by half a turn and more: k = 20, J = 1, at rest at phi = 0, swings about
// phi_0 as phi = phi_0 (1 - cos(w t)), w = sqrt(20), to 2 phi_0: its range ends at
// phi_0/2 + pi. With 200 deg = 3.491 rad this is at 4.887 rad, cos(w t) = -0.4, t = 0.4432 s; the
// step of 1 ms shifts the motion by less than (w h)^2/12 of the time. The speed at phi_0 is
// phi_0 w = 15.61 rad/s, at pi/(2 w) = 0.3512 s.
#[test]
fn a_spring_relaxed_beyond_half_a_turn_unfolds() {
    let relaxed = 200.0_f64.to_radians();
    for sense in [1.0, -1.0] {
        let model = model(1.0, 0.0, hinge(20.0, Some(sense * relaxed)));
        let (kept, outcome) = run(&model, &TransientSettings::new(1.0, 0.001));
        let speed = |time: f64| {
            let step = kept.times.iter().position(|own| *own >= time - 1e-9);
            kept.states[step.unwrap()].nodes[1].angular_velocity.z
        };
        let most = sense * relaxed * 20.0_f64.sqrt();
        for time in [0.1, 0.2, 0.351] {
            let expected = most * (20.0_f64.sqrt() * time).sin();
            assert!((speed(time) / expected - 1.0).abs() < 2e-4, "{time}");
        }
        let time = wound_at(outcome);
        assert!((time - 0.4432).abs() < 1.5e-3, "{time}");
    }
}
