//! Explicit nodes.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::draft::Draft;
use super::transient::initial_motion;
use crate::model::Node;

/// Adds every `[[node]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for table in root.tables("node") {
        let label = table.require_text("name", "the name of the node");
        let node = node(&table, label.clone());
        let initial = initial_motion(&table);
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

fn node(table: &Table<'_>, label: Option<String>) -> Option<Node> {
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
    Some(Node {
        label: label?,
        position: position?,
        rotation: rotation?,
    })
}
