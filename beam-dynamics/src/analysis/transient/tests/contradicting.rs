//! Redundant constraints whose drives begin to contradict each other during a run.

use nalgebra::{Matrix3, Vector3};

use super::models::{body, node, run};
use crate::analysis::transient::corner::after_impulse;
use crate::analysis::transient::{TransientFailure, TransientOutcome, redundant};
use crate::assembly::{Sharing, System};
use crate::case::{self, Model, TransientSettings};
use crate::elements::joints::{ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along};
use crate::model::{Drive, Ramp, Step};

/// Time at which the doors begin to turn \[s\], not on the grid of the steps.
const BEGIN: f64 = 0.105;
const STEP: f64 = 0.01;

/// A door of `size` \[m\] on two hinges of one line, with their drives; a second node on the door
/// defines the size of the model.
fn door(size: f64, drives: [Option<Turning>; 2]) -> Model {
    let center = size * Vector3::new(0.5, 0.0, 0.5);
    let nodes = vec![
        node("door", center, Matrix3::identity()),
        node("handle", center + size * Vector3::x(), Matrix3::identity()),
    ];
    let moments = [0.3, 0.4, 0.1].map(|of_size| of_size * size * size);
    let mut elements = vec![
        body(0, 2.0, Vector3::zeros(), moments),
        body(1, 0.1, Vector3::zeros(), moments),
    ];
    let ends = JointEnds {
        a: Some((0, &nodes[0])),
        b: (1, &nodes[1]),
    };
    let at = Placing::at(&nodes[1].position, &Matrix3::identity());
    let rigid = ConstraintJoint::total("grip", &ends, &at, [const { Freedom::Locked }; 6]);
    elements.push(Box::new(rigid));
    for (name, drive, height) in [("low", 0, 0.2), ("high", 1, 0.8)] {
        let ends = JointEnds {
            a: None,
            b: (0, &nodes[0]),
        };
        let at = Placing::at(&(height * size * Vector3::z()), &axes_along(&Vector3::z()));
        let turning = drives[drive].clone();
        elements.push(Box::new(ConstraintJoint::revolute(
            name, &ends, &at, turning,
        )));
    }
    Model::new("door", System::new(nodes, elements))
}

/// A final angle of 1 rad.
fn ramp(start: f64, end: f64, smooth: bool) -> Option<Turning> {
    Some(Turning::Angle(
        Drive::Ramp(Ramp {
            from: 0.0,
            to: 1.0,
            start,
            end,
            smooth,
        })
        .into(),
    ))
}

fn swing(drives: [Option<Turning>; 2]) -> TransientOutcome {
    let settings = TransientSettings {
        redundant: case::Redundant::Remove,
        ..TransientSettings::new(0.7, STEP)
    };
    run(&door(1.0, drives), &settings).1
}

/// Time and text of the contradiction of the drives.
fn contradiction(outcome: &TransientOutcome) -> (f64, String) {
    let failure = outcome.failure.as_ref().unwrap();
    assert!(failure.remedy().starts_with("drive one of them only"));
    match failure {
        TransientFailure::Contradicting { constraints, time } => (*time, constraints.clone()),
        other => panic!("{other}"),
    }
}

// One door is held while the other begins to turn, by 1 rad in 0.5 s: no impulse brings
// velocities that follow both.
#[test]
fn ramps_that_begin_apart_contradict_where_the_first_begins() {
    let outcome = swing([ramp(BEGIN, 0.605, false), ramp(0.205, 0.705, false)]);
    let (time, reported) = contradiction(&outcome);
    assert_eq!(time, BEGIN);
    let expected = "(rotation about z) of \"high\" contradicts \"low\", by 2 rad/s";
    assert!(reported.ends_with(expected), "{reported}");
    let mut remarks = outcome.remarks.iter();
    assert!(!remarks.any(|remark| remark.contains("impulse")));
    assert_eq!(outcome.time, BEGIN);
}

// Rates of 1/0.5 and 1/0.5001 rad/s.
#[test]
fn a_small_contradiction_is_one() {
    let outcome = swing([ramp(BEGIN, 0.605, false), ramp(BEGIN, 0.6051, false)]);
    let (time, reported) = contradiction(&outcome);
    assert_eq!(time, BEGIN);
    let by = reported.rsplit_once("by ").unwrap().1;
    let by: f64 = by.strip_suffix(" rad/s").unwrap().parse().unwrap();
    let expected = 1.0 / 0.5 - 1.0 / 0.5001;
    assert!((by - expected).abs() < 1e-6 * 2.0, "{by}");
}

// Both begin with the rate zero, and diverge slowly. The angles of smooth ramps of 1 rad in T are
// 10 (t/T)^3 at first, or quadratic: half the difference is 1e-4 rad within 0.1 s.
#[test]
fn a_contradiction_that_grows_ends_the_run_as_such() {
    let outcome = swing([ramp(BEGIN, 0.605, true), ramp(BEGIN, 0.705, true)]);
    let (time, reported) = contradiction(&outcome);
    assert!(time > BEGIN && time < BEGIN + 0.1, "{time}");
    assert!(
        reported.contains("of \"high\" contradicts \"low\""),
        "{reported}"
    );
}

#[test]
fn drives_that_are_alike_do_not_contradict() {
    let outcome = swing([ramp(BEGIN, 0.605, false), ramp(BEGIN, 0.605, false)]);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    // The other hinge follows if only one is driven.
    let outcome = swing([ramp(BEGIN, 0.605, false), None]);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
}

// The refusal of the impulse itself: no velocities follow both speeds.
#[test]
fn no_impulse_brings_velocities_that_contradict() {
    let speed = |to| {
        let step = Step {
            from: 0.0,
            to,
            time: BEGIN,
        };
        Some(Turning::Speed(Drive::Step(step).into()))
    };
    let after_impulse = |to: [f64; 2]| {
        let model = door(1.0, to.map(speed));
        let after = model.conditions_at(BEGIN);
        after_impulse(&model.system, &model.system.rest(), &after)
            .map(|after_impulse| after_impulse.0)
    };
    assert!(after_impulse([1.0, 2.0]).is_none());
    let turning = after_impulse([2.0, 2.0]).unwrap().nodes[0].angular_velocity;
    assert!(
        (turning - Vector3::new(0.0, 0.0, 2.0)).amax() < 1e-9,
        "{turning}"
    );
}

// Lengths are relative to the size of the model, angles absolute: for a door of 1 mm as for one of
// 100 m. In both the violation of a constraint of a length is its part times the size.
#[test]
fn what_gives_way_is_measured_by_the_size_of_lengths_and_as_it_is_of_angles() {
    for size in [1e-3, 100.0] {
        let model = door(size, [None, None]);
        let settings = TransientSettings {
            redundant: case::Redundant::Remove,
            ..TransientSettings::new(0.7, STEP)
        };
        let shared = redundant::independent(&model, &settings).unwrap().unwrap();
        let system = &shared.model.system;
        let (state, conditions) = (system.rest(), model.conditions_at(0.0));
        assert!((system.size() / size - 1.0).abs() < 1e-12);
        let mut sharing = Sharing::new(system, &state, &conditions);
        let count = state.multipliers.len();
        let mut multipliers: Vec<_> = (0..count).map(|i| (1.0 + i as f64).sin()).collect();
        sharing.take_surplus(&mut multipliers);
        let mut seen = [0, 0];
        for slack in sharing.slack() {
            let first = system.numbering().first_multiplier();
            let is_length = system.equation(first + slack.constraint).unit == "m";
            let scale = if is_length { size } else { 1.0 };
            let off = (slack.value - scale * slack.part).abs();
            assert!(off <= 1e-9 * slack.value.abs(), "{size} {slack:?}");
            seen[usize::from(is_length)] += 1;
        }
        assert_eq!(seen, [4, 6]);
    }
}
