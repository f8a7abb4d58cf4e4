//! Joints: hinges and rigid connections between two nodes, and joints of every kind.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::draft::Draft;
use super::drives::{self, Catalog};
use super::ends::{label, pair};
use super::hinge_card::HingeCard;
use super::number::not_negative;
use super::problem::InputProblem;
use crate::elements::Signal;
use crate::elements::joints::HingeSpring;
use crate::model::Drive;

mod kinds;
mod problem;

#[cfg(test)]
mod tests;

pub(super) use kinds::read as read_joints;
pub use problem::JointProblem;

/// Largest constant relaxed angle of a hinge \[deg\]: 15 degrees remain beyond the undeformed and
/// the relaxed state before the angle is ambiguous.
const MOST_RELAXED: f64 = 330.0;

/// Adds every `[[hinge]]` to the model.
pub(super) fn read_hinges(root: &Table<'_>, draft: &mut Draft) {
    for (number, table) in root.tables("hinge").iter().enumerate() {
        let label = label(table, "hinge", number);
        let is_new = draft.take_label("joint", &label, table);
        let nodes = pair(table, draft, &format!("hinge \"{label}\""));
        let axis = axis(table);
        let frame = draft.frames().of(table);
        let offset = match table.has("offset") {
            true => table.vector("offset", Dimension::LENGTH),
            false => Some(Vector3::zeros()),
        };
        let spring = spring(table, draft.drives());
        let in_node = match table.has("axis_in") {
            true => table.word("axis_in", &["model", "node"]),
            false => Some(0),
        };
        table.finish();
        match (nodes, axis.zip(frame), offset, spring, in_node) {
            (Some(nodes), Some((axis, frame)), Some(offset), Some(spring), Some(in_node))
                if is_new =>
            {
                let outer = &draft.nodes()[nodes[1]];
                let position = outer.position + outer.rotation * offset;
                let axis = match in_node {
                    0 => frame.direction(&axis),
                    _ => outer.rotation * axis,
                };
                draft.add_hinge(&label, nodes, (position, axis), &spring);
            }
            _ => draft.note_broken(),
        }
    }
}

/// Adds every `[[rigid]]` to the model.
pub(super) fn read_rigid(root: &Table<'_>, draft: &mut Draft) {
    for (number, table) in root.tables("rigid").iter().enumerate() {
        let label = label(table, "rigid connection", number);
        let is_new = draft.take_label("joint", &label, table);
        let nodes = pair(table, draft, &format!("rigid connection \"{label}\""));
        table.finish();
        match nodes {
            Some(nodes) if is_new => draft.add_rigid(&label, nodes),
            _ => draft.note_broken(),
        }
    }
}

/// The axis of a hinge, in the model's frame.
fn axis(table: &Table<'_>) -> Option<Vector3<f64>> {
    if !table.has("axis") {
        let _ = table.require_text("axis", "the direction of the axis");
        return None;
    }
    let axis = table.vector("axis", Dimension::NUMBER)?;
    let largest = axis.amax();
    if largest == 0.0 {
        table.note("axis", &InputProblem::NoAxis);
        return None;
    }
    Some(axis / largest)
}

/// Spring and damper of a hinge: `stiffness`, `damping`, `angle`.
pub(super) fn spring(table: &Table<'_>, drives: &Catalog) -> Option<HingeCard> {
    let number = |key: &str, dimension: Dimension| match table.has(key) {
        true => not_negative(table, key, dimension),
        false => Some(0.0),
    };
    let stiffness = number("stiffness", Dimension::MOMENT);
    let damping = number("damping", Dimension::TURNING_DAMPER);
    let angle = match table.has("angle") {
        true => drives::read_signal(table, "angle", Dimension::ANGLE, drives),
        false => Some(Drive::Constant(0.0).into()),
    };
    let constant = angle.as_ref().and_then(Signal::constant);
    if let Some(found) = constant.map(f64::to_degrees)
        && found.abs() > MOST_RELAXED
    {
        table.note("angle", &InputProblem::FullTurn { found });
        return None;
    }
    if table.has("angle") && stiffness == Some(0.0) {
        table.note("angle", &InputProblem::NoSpring);
        return None;
    }
    let angle = angle?;
    let (angle, relaxed) = match constant {
        Some(constant) => (constant, None),
        None => (0.0, Some(angle)),
    };
    let spring = HingeSpring {
        stiffness: stiffness?,
        damping: damping?,
        angle,
    };
    Some(HingeCard { spring, relaxed })
}
