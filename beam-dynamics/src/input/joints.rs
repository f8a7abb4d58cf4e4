//! Joints: hinges and rigid connections between two nodes, and joints of every kind.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    Drive as OneDrive, NotNegative, Text, Texts, Vector, Word,
};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::drives::{self, Catalog};
use super::ends::{label, pair};
use super::frames::IN;
use super::hinge_card::HingeCard;
use super::problem::InputProblem;
use super::too_stiff;
use crate::elements::Signal;
use crate::elements::joints::HingeSpring;
use crate::model::Drive;

mod keys;
mod kinds;
mod problem;

#[cfg(test)]
mod tests;

pub(super) use keys::JOINT;
pub(super) use kinds::read as read_joints;
pub use problem::JointProblem;

keys! {
    /// A revolute joint with a spring and a damper.
    pub(super) HINGE = "[[hinge]]";
    /// Its name, for messages and output.
    NAME: Option<String> = "name", [Text], or "`hinge` and its number", "\"flap\"";
    /// The names of two nodes; the second turns relative to the first.
    NODES: Vec<String> = "nodes", [Texts], required, "[\"hub\", \"root\"]";
    /// The direction of the axis, of any length.
    AXIS: Vector3<f64> = "axis", [Vector(3, Dimension::NUMBER)], required, "[0, 1, 0]";
    /// Axes of `axis`: the model, or the last node.
    AXIS_IN: usize = "axis_in", [Word(&["model", "node"])], or "\"model\"" = 0, "\"node\"";
    /// Position of the hinge relative to the second node, in its axes.
    OFFSET: Vector3<f64> = "offset", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[-0.1, 0, 0]";
    with STIFFNESS.schema, DAMPING.schema, ANGLE.schema, IN.schema;
}

keys! {
    /// Stiffness of the spring, moment per radian.
    pub(super) STIFFNESS: f64 = "stiffness", [NotNegative(Dimension::MOMENT)], or "0" = 0.0,
        "\"40 kN*m\"";
    /// Damper, moment per angular velocity in radians per time.
    pub(super) DAMPING: f64 = "damping", [NotNegative(Dimension::TURNING_DAMPER)], or "0" = 0.0,
        "\"900 N*m*s\"";
    /// Angle at which the spring is relaxed; zero is the undeformed model.
    pub(super) ANGLE: ByHand = "angle", [OneDrive(Dimension::ANGLE)], or "0", "4";
}

keys! {
    /// Two nodes that move as one body.
    pub(super) RIGID = "[[rigid]]";
    /// Its name, for messages and output.
    RIGID_NAME: Option<String> = "name", [Text], or "`rigid connection` and its number", "\"bracket\"";
    /// The names of two nodes, at any distance.
    RIGID_NODES: Vec<String> = "nodes", [Texts], required, "[\"mast\", \"hub\"]";
}
/// Largest constant relaxed angle of a hinge \[deg\]: 15 degrees remain beyond the undeformed and
/// the relaxed state before the angle is ambiguous.
const MOST_RELAXED: f64 = 330.0;

/// Adds every `[[hinge]]` to the model.
pub(super) fn read_hinges(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("hinge").iter().enumerate() {
        let label = label(table, &NAME, "hinge", number);
        let is_new = builder.take_label("joint", &label, table);
        let nodes = pair((table, &NODES), builder, &format!("hinge \"{label}\""));
        let axis = axis(table);
        let frame = builder.frames().of(table);
        let offset = table.get(&OFFSET);
        let spring = spring(table, builder.drives());
        let in_node = table.get(&AXIS_IN);
        table.finish();
        match (nodes, axis.zip(frame), offset, spring, in_node) {
            (Some(nodes), Some((axis, frame)), Some(offset), Some(spring), Some(in_node))
                if is_new =>
            {
                let outer = &builder.nodes()[nodes[1]];
                let position = outer.position + outer.rotation * offset;
                let axis = match in_node {
                    0 => frame.direction(&axis),
                    _ => outer.rotation * axis,
                };
                builder.add_hinge(&label, nodes, (position, axis), &spring);
            }
            _ => builder.note_broken(),
        }
    }
}

/// Adds every `[[rigid]]` to the model.
pub(super) fn read_rigid(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("rigid").iter().enumerate() {
        let label = label(table, &RIGID_NAME, "rigid connection", number);
        let is_new = builder.take_label("joint", &label, table);
        let nodes = pair(
            (table, &RIGID_NODES),
            builder,
            &format!("rigid connection \"{label}\""),
        );
        table.finish();
        match nodes {
            Some(nodes) if is_new => builder.add_rigid(&label, nodes),
            _ => builder.note_broken(),
        }
    }
}

/// The axis of a hinge, in the model's frame.
fn axis(table: &Table<'_>) -> Option<Vector3<f64>> {
    let axis = table.get(&AXIS)?;
    let largest = axis.amax();
    if largest == 0.0 {
        table.note(&AXIS, &InputProblem::NoAxis);
        return None;
    }
    Some(axis / largest)
}

/// Spring and damper of a hinge: `stiffness`, `damping`, `angle`.
pub(super) fn spring(table: &Table<'_>, drives: &Catalog) -> Option<HingeCard> {
    let resolved = |key: &Key<f64>| {
        let found = table.get(key)?;
        too_stiff::is_resolved(table, key.name(), [found]).then_some(found)
    };
    let (stiffness, damping) = (resolved(&STIFFNESS), resolved(&DAMPING));
    let angle = if table.has(&ANGLE) {
        drives::read_signal(table, &ANGLE.schema, drives)
    } else {
        Some(Drive::Constant(0.0).into())
    };
    let constant = angle.as_ref().and_then(Signal::constant);
    if let Some(found) = constant.map(f64::to_degrees)
        && found.abs() > MOST_RELAXED
    {
        table.note(&ANGLE, &InputProblem::FullTurn { found });
        return None;
    }
    if table.has(&ANGLE) && stiffness == Some(0.0) {
        table.note(&ANGLE, &InputProblem::NoSpring);
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
