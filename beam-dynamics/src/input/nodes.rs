//! Explicit nodes.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::draft::Draft;
use super::frames::Frame;
use super::transient::initial_motion;
use crate::case::InitialMotion;
use crate::model::Node;

/// Adds every `[[node]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for table in root.tables("node") {
        let label = table.require_text("name", "the name of the node");
        let frame = draft.frames().of(&table);
        let node = node(&table, label.clone(), frame);
        let initial = initial_motion(&table).zip(frame).map(|(motion, frame)| {
            let turned = |vector: Vector3<f64>| frame.direction(&vector);
            InitialMotion {
                velocity: motion.velocity.map(turned),
                angular_velocity: motion.angular_velocity.map(turned),
                ..motion
            }
        });
        table.finish();
        match (node.zip(initial), label) {
            (Some((node, initial)), _) => {
                if let Some(index) = draft.add_node(node, &table, None) {
                    draft.set_initial(index, initial);
                }
            }
            (None, Some(label)) => drop(draft.name_node(&label, None, &table)),
            (None, None) => draft.note_broken(),
        }
    }
}

/// The node of a card; `None` for the frame if it is wrong.
fn node(table: &Table<'_>, label: Option<String>, frame: Option<Frame>) -> Option<Node> {
    let position = match table.has("position") {
        true => table.vector("position", Dimension::LENGTH),
        // Notes that it is absent.
        false => table
            .require_quantity("position", Dimension::LENGTH)
            .map(|_| Vector3::zeros()),
    };
    let rotation = match table.has("orientation") {
        true => table
            .vector("orientation", Dimension::ANGLE)
            .map(|phi| vector::to_rotation(&phi)),
        false => Some(Matrix3::identity()),
    };
    let frame = frame?;
    Some(Node {
        label: label?,
        position: frame.point(&position?),
        rotation: frame.axes(&rotation?),
    })
}
