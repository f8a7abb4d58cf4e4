//! Explicit nodes.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Text, Vector};
use shared_geom::keys;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::frames::{Frame, IN};
use super::misplaced_keys::OF_NODE;
use super::transient::{
    ANGULAR_VELOCITY, INITIAL_WEIGHT, VELOCITY, VELOCITY_WEIGHT, initial_motion,
};
use crate::case::InitialMotion;
use crate::model::Node;

keys! {
    /// A point with axes, to which beams, bodies, joints and loads refer by its name.
    pub(super) CARD = "[[node]]";
    /// The name of the node.
    NAME: String = "name", [Text], required, "\"tip\"";
    /// Position in the undeformed model.
    POSITION: Vector3<f64> = "position", [Vector(3, Dimension::LENGTH)], required, "[1, 0, 0]";
    /// Rotation vector of the axes of the node.
    ORIENTATION: Vector3<f64> = "orientation", [Vector(3, Dimension::ANGLE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, -90, 0]";
    with VELOCITY.schema, ANGULAR_VELOCITY.schema, INITIAL_WEIGHT.schema, VELOCITY_WEIGHT.schema,
        IN.schema;
}

/// Adds every `[[node]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for table in root.tables("node") {
        let label = table.get(&NAME);
        let frame = builder.frames().of(&table);
        let node = node(&table, label.clone(), frame);
        let initial = initial_motion(&table).zip(frame).map(|(motion, frame)| {
            let turned = |vector: Vector3<f64>| frame.direction(&vector);
            InitialMotion {
                velocity: motion.velocity.map(turned),
                angular_velocity: motion.angular_velocity.map(turned),
                ..motion
            }
        });
        table.finish_beside(&OF_NODE);
        match (node.zip(initial), label) {
            (Some((node, initial)), _) => {
                if let Some(index) = builder.add_node(node, &table, None) {
                    builder.set_initial(index, initial);
                }
            }
            (None, Some(label)) => drop(builder.name_node(&label, None, &table)),
            (None, None) => builder.note_broken(),
        }
    }
}

/// The node of a card; `None` for the frame if it is wrong.
fn node(table: &Table<'_>, label: Option<String>, frame: Option<Frame>) -> Option<Node> {
    let position = table.get(&POSITION);
    let rotation = table.get(&ORIENTATION).map(|phi| vector::to_rotation(&phi));
    let frame = frame?;
    Some(Node {
        label: label?,
        position: frame.point(&position?),
        rotation: frame.axes(&rotation?),
    })
}
