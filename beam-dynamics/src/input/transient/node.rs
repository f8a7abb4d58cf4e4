//! Initial motion of a node.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::TransientProblem;
use crate::case::InitialMotion;
use crate::input::draft::Draft;

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

/// Notes initial velocities of nodes without `[transient]`.
pub(in crate::input) fn check(root: &Table<'_>, draft: &Draft) {
    if root.has("transient") {
        return;
    }
    for (initial, node, line) in draft.initial() {
        for (key, is_said) in [
            ("velocity", initial.velocity.is_some()),
            ("angular_velocity", initial.angular_velocity.is_some()),
        ] {
            if is_said {
                let node = node.to_owned();
                let problem = TransientProblem::IdleVelocity { node, key };
                root.document().note(line, &problem);
            }
        }
    }
}
