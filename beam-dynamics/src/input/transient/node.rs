//! Initial motion of a node.

use std::collections::BTreeSet;

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::TransientProblem;
use crate::case::InitialMotion;
use crate::input::draft::Draft;
use crate::input::loads::LoadProblem;

/// Reads `velocity`, `angular_velocity`, `initial_weight` and `velocity_weight` of a node.
pub(in crate::input) fn initial_motion(table: &Table<'_>) -> Option<InitialMotion> {
    let vector = |key: &str, dimension: Dimension| match table.has(key) {
        true => table.vector(key, dimension).map(Some),
        false => Some(None),
    };
    let velocity = vector("velocity", Dimension::VELOCITY);
    let angular_velocity = vector("angular_velocity", Dimension::ROTATION_SPEED);
    let (weight, velocity_weight) = (
        weight(table, "initial_weight"),
        weight(table, "velocity_weight"),
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
pub(in crate::input) fn check(root: &Table<'_>, draft: &Draft) {
    check_released(root);
    if root.has("transient") {
        return;
    }
    let mut told = BTreeSet::new();
    for (initial, node, line) in draft.initial() {
        for (key, is_said) in [
            ("velocity", initial.velocity.is_some()),
            ("angular_velocity", initial.angular_velocity.is_some()),
        ] {
            // The nodes of a blade have one card.
            if is_said && told.insert((line, key)) {
                let node = node.to_owned();
                let problem = TransientProblem::IdleVelocity { node, key };
                root.document().note(line, &problem);
            }
        }
    }
}

fn check_released(root: &Table<'_>) {
    let start = match root.has("transient") && root.is_table("transient") {
        true => root
            .table("transient")
            .and_then(|run| match run.is_text("start") {
                true => run.text("start"),
                false => None,
            }),
        false => None,
    };
    if start.is_some_and(|start| start != "given") {
        return;
    }
    for kind in ["load", "distributed_load"] {
        let cards = match root.is_list(kind) {
            true => root.tables(kind),
            false => Vec::new(),
        };
        for load in cards {
            if load.has("release") && load.boolean("release") == Some(true) {
                load.note("release", &LoadProblem::IdleRelease);
            }
        }
    }
}
