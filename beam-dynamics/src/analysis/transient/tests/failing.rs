//! Runs that cannot go on, and what they tell.

use std::sync::Arc;

use super::models::{driven_beam, pendulum, run};
use crate::case::TransientQuestion;
use crate::model::{Drive, DriveTable, Interpolation, Outside};

/// A number in the first tenth of a second; after it there is nothing.
fn short(value: f64) -> Drive {
    let rows = [[0.0, value], [0.1, value]];
    let table = DriveTable::new(&rows, Interpolation::Linear, Outside::Error);
    Drive::Table(Arc::new(table.unwrap()))
}

// A model that is not read from a file is not checked before it is run.
#[test]
fn a_drive_that_leaves_its_table_is_named_with_its_times() {
    let question = TransientQuestion::new(1.0, 0.01);
    let mut heavy = pendulum();
    heavy.gravity_drive = short(1.0);
    for (model, whose) in [(driven_beam(short(0.0)), "\""), (heavy, "gravity")] {
        let (kept, outcome) = run(&model, &question);
        let told = outcome.failure.unwrap().to_string();
        let expected = format!("likely cause: a drive of {whose}");
        assert!(told.contains(&expected), "{told}");
        let expected = "has values from 0 s to 0.1 s, and the step goes to 0.1";
        assert!(told.contains(expected), "{told}");
        // All that the table allows has been run.
        assert!((outcome.time - 0.1).abs() < 1e-12, "{}", outcome.time);
        assert_eq!(kept.states.len(), 11);
    }
}
