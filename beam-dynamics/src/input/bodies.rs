//! Bodies: concentrated masses.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Positive, Text, Vector};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::ends::label;
use super::moments::{INERTIA, moments};
use crate::elements::bodies::RigidInertia;

keys! {
    /// A concentrated mass on a node.
    pub(super) CARD = "[[body]]";
    /// Its name, for messages.
    NAME: Option<String> = "name", [Text], or "`body` and its number", "\"counterweight\"";
    /// The name of a node.
    NODE: String = "node", [Text], required, "\"tip\"";
    with MASS.schema, OFFSET.schema, INERTIA.schema;
}

keys! {
    /// Mass.
    pub(super) MASS: f64 = "mass", [Positive(Dimension::MASS)], required, "12";
    /// Position of its center relative to the node, in the node's axes; on a blade relative to
    /// the line.
    pub(super) OFFSET: Vector3<f64> = "offset", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0.2, 0]";
}

/// Adds every `[[body]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("body").iter().enumerate() {
        let label = label(table, &NAME, "body", number);
        let is_new = builder.take_label("body", &label, table);
        let words = format!("body \"{label}\"");
        let name = table.get(&NODE);
        let node = name.and_then(|name| builder.find_node(&name, table, NODE.name(), &words));
        let lump = lump(table, &label);
        table.finish();
        match (node, lump) {
            (Some(node), Some(lump)) if is_new => {
                builder.add_body(label, node, lump.inertia(&Vector3::zeros()));
            }
            _ => builder.note_broken(),
        }
    }
}

/// A concentrated mass with its center, in the axes of the carrying part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lump {
    /// Mass \[kg\].
    mass: f64,
    /// Position of its center \[m\].
    offset: Vector3<f64>,
    /// Inertia about the center \[kg m^2\].
    central: Matrix3<f64>,
}

impl Lump {
    /// The inertia about a node, if the carrying part is at `position` relative to the node
    /// \[m\].
    pub fn inertia(&self, position: &Vector3<f64>) -> RigidInertia {
        RigidInertia::about_node(self.mass, &(position + self.offset), &self.central)
    }
}

/// Reads `mass`, `offset` and `inertia`.
pub(super) fn lump(table: &Table<'_>, label: &str) -> Option<Lump> {
    let (mass, offset) = (table.get(&MASS), table.get(&OFFSET));
    let moments = moments(table, label);
    Some(Lump {
        mass: mass?,
        offset: offset?,
        central: Matrix3::from_diagonal(&moments?),
    })
}
