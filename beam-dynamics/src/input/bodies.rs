//! Bodies: concentrated masses.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::draft::Draft;
use super::moments::moments;
use crate::elements::bodies::RigidInertia;

/// Adds every `[[body]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for (number, table) in root.tables("body").iter().enumerate() {
        let label = table
            .text("name")
            .unwrap_or_else(|| format!("body {}", number + 1));
        let is_new = draft.take_label("body", &label, table);
        let words = format!("body \"{label}\"");
        let name = table.require_text("node", "the name of a node");
        let node = name.and_then(|name| draft.find_node(&name, table, "node", &words));
        let lump = lump(table, &label);
        table.finish();
        match (node, lump) {
            (Some(node), Some(lump)) if is_new => {
                draft.add_body(label, node, lump.inertia(&Vector3::zeros()));
            }
            _ => draft.note_broken(),
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
    /// The inertia about a node, if the carrying part is at `place` relative to the node
    /// \[m\].
    pub fn inertia(&self, place: &Vector3<f64>) -> RigidInertia {
        RigidInertia::about_node(self.mass, &(place + self.offset), &self.central)
    }
}

/// Reads `mass`, `offset` and `inertia`.
pub(super) fn lump(table: &Table<'_>, label: &str) -> Option<Lump> {
    let mass = table.require_positive("mass", Dimension::MASS);
    let offset = match table.has("offset") {
        true => table.vector("offset", Dimension::LENGTH),
        false => Some(Vector3::zeros()),
    };
    let moments = moments(table, label);
    Some(Lump {
        mass: mass?,
        offset: offset?,
        central: Matrix3::from_diagonal(&moments?),
    })
}
