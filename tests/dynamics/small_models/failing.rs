//! Runs that fail, and their messages.

use std::sync::Arc;

use nalgebra::{Matrix1, Matrix3, Vector3};

use super::models::{body, node, pendulum, run};
use super::strip::driven_beam;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::laws::Law;
use beam_dynamics::elements::springs::{End, Measure, Rod};
use beam_dynamics::model::{Drive, DriveTable, Extrapolation, Interpolation, Ramp};

/// A number in the first tenth of a second; after it there is none.
fn short(value: f64) -> Drive {
    let rows = [[0.0, value], [0.1, value]];
    let table = DriveTable::new(&rows, Interpolation::Linear, Extrapolation::Error);
    Drive::Table(Arc::new(table.unwrap()))
}

// A model that is not read from a file is not checked before it is run.
#[test]
fn a_drive_that_leaves_its_table_is_named_with_its_times() {
    let settings = TransientSettings::new(1.0, 0.01);
    let mut heavy = pendulum();
    heavy.gravity_drive = short(1.0);
    for (model, whose) in [(driven_beam(short(0.0)), "\""), (heavy, "gravity")] {
        let (kept, outcome) = run(&model, &settings);
        let reported = outcome.failure.unwrap().to_string();
        let expected = format!("likely cause: a drive of {whose}");
        assert!(reported.contains(&expected), "{reported}");
        let expected = "has values from 0 s to 0.1 s, and the step goes to 0.1";
        assert!(reported.contains(expected), "{reported}");
        // The run reaches the end of the table.
        assert!((outcome.time - 0.1).abs() < 1e-12, "{}", outcome.time);
        assert_eq!(kept.states.len(), 11);
    }
}

// 1 m - 2 m/s t is zero after half a second; the weak rod leaves the body near 1 m until then.
#[test]
fn a_rod_whose_relaxed_length_gets_to_zero_is_named_with_the_cause() {
    let nodes = vec![node("bob", Vector3::x(), Matrix3::identity())];
    let ends = [
        End::Frame {
            position: Vector3::zeros(),
        },
        End::Node {
            node: 0,
            offset: Vector3::zeros(),
        },
    ];
    let law = (Measure::Elongation, Law::linear(Matrix1::new(1.0)));
    let length = Drive::Ramp(Ramp {
        from: 1.0,
        to: -1.0,
        start: 0.0,
        end: 1.0,
        smooth: false,
    });
    let rod = Rod::new("winch", ends, &nodes, Some(length.into()), law);
    let elements = vec![body(0, 1.0, Vector3::zeros(), [1.0; 3]), Box::new(rod)];
    let model = Model::new("winch", System::new(nodes, elements));
    let outcome = run(&model, &TransientSettings::new(1.0, 0.03)).1;
    let failure = outcome.failure.unwrap();
    let reported = failure.to_string();
    let expected = "likely cause: \"winch\" has no value: its relaxed length is zero or less: ";
    assert!(reported.contains(expected), "{reported}");
    assert!(failure.remedy().contains("max()"), "{}", failure.remedy());
    assert!((0.45..0.5).contains(&outcome.time), "{}", outcome.time);
}
