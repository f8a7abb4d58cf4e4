//! Initial motion of a node.

use std::collections::BTreeSet;

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Vector};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::TransientProblem;
use crate::case::InitialMotion;
use crate::input::builder::ModelBuilder;
use crate::input::loads::LoadProblem;

keys! {
    /// Initial velocity in runs in time, in the axes of the model or of the frame of the card.
    pub(in crate::input) VELOCITY: Option<Vector3<f64>> = "velocity",
        [Vector(3, Dimension::VELOCITY)], optional, "[0, -1, 0]";
    /// Initial angular velocity in runs in time, in the same axes.
    pub(in crate::input) ANGULAR_VELOCITY: Option<Vector3<f64>> = "angular_velocity",
        [Vector(3, Dimension::ROTATION_SPEED)], optional, "[0, 0, \"-1 rad/s\"]";
    /// Weight of position and attitude in the start-up of a run, from 1e-9 to 1e9: the larger,
    /// the less they are changed to fulfill the constraints.
    pub(in crate::input) INITIAL_WEIGHT: f64 = "initial_weight",
        [Positive(Dimension::NUMBER)], or "1" = 1.0, "100";
    /// The same for velocities; without it 1 for given velocities, and almost zero for others.
    pub(in crate::input) VELOCITY_WEIGHT: Option<f64> = "velocity_weight",
        [Positive(Dimension::NUMBER)], optional, "100";
}

/// Reads `velocity`, `angular_velocity`, `initial_weight` and `velocity_weight` of a node.
pub(in crate::input) fn initial_motion(table: &Table<'_>) -> Option<InitialMotion> {
    let velocity = table.get(&VELOCITY);
    let angular_velocity = table.get(&ANGULAR_VELOCITY);
    let (weight, velocity_weight) = (
        weight(table, INITIAL_WEIGHT.name()),
        weight(table, VELOCITY_WEIGHT.name()),
    );
    Some(InitialMotion {
        velocity: velocity?,
        angular_velocity: angular_velocity?,
        weight: weight?.unwrap_or(1.0),
        velocity_weight: velocity_weight?,
    })
}

/// A weight: a much smaller one than the others would leave the value undetermined.
fn weight(table: &Table<'_>, key: &'static str) -> Option<Option<f64>> {
    const RANGE: std::ops::RangeInclusive<f64> = 1e-9..=1e9;
    if !table.has(key) {
        return Some(None);
    }
    let found = table.quantity(key, Dimension::NUMBER)?;
    if !RANGE.contains(&found) {
        let expected = "a weight from 1e-9 to 1e9, usually 1";
        let problem = TransientProblem::Range {
            key,
            found,
            expected,
        };
        table.note(key, &problem);
        return None;
    }
    Some(Some(found))
}

/// Notes initial velocities of nodes without `[transient]`, and loads of an equilibrium of the
/// start that does not exist.
pub(in crate::input) fn check(root: &Table<'_>, builder: &ModelBuilder) {
    check_released(root);
    if root.has("transient") || root.has("periodic") {
        return;
    }
    let mut reported = BTreeSet::new();
    for (initial, node, line) in builder.initial() {
        for (key, is_said) in [
            ("velocity", initial.velocity.is_some()),
            ("angular_velocity", initial.angular_velocity.is_some()),
        ] {
            // The nodes of a blade have one card.
            if is_said && reported.insert((line, key)) {
                let node = node.to_owned();
                let problem = TransientProblem::IdleVelocity { node, key };
                root.document().note(line, &problem);
            }
        }
    }
}

fn check_released(root: &Table<'_>) {
    let start = |card: &str| {
        if root.has(card) && root.is_table(card) {
            root.table(card).and_then(|run| {
                if run.is_text("start") {
                    run.text("start")
                } else {
                    None
                }
            })
        } else {
            None
        }
    };
    let mut starts = ["transient", "periodic"].into_iter().filter_map(start);
    if starts.any(|start| start != "given") {
        return;
    }
    for kind in ["load", "distributed_load"] {
        let cards = if root.is_list(kind) {
            root.tables(kind)
        } else {
            Vec::new()
        };
        for load in cards {
            if load.has("release") && load.boolean("release") == Some(true) {
                load.note("release", &LoadProblem::IdleRelease);
            }
        }
    }
}
