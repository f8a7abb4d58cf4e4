//! Clamps.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::Text;
use shared_geom::keys;

use super::builder::ModelBuilder;

keys! {
    /// A node that the frame of the model holds, or the hub if it has a support.
    pub(super) CARD = "[[clamp]]";
    /// The name of a node.
    NODE: String = "node", [Text], required, "\"root\"";
}

/// Adds every `[[clamp]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("clamp").iter().enumerate() {
        let words = format!("clamp {}", number + 1);
        let name = table.get(&NODE);
        table.finish();
        let node = name.and_then(|name| builder.find_node(&name, table, "node", &words));
        match node {
            Some(node) => builder.add_clamp(node, table, "node"),
            None => builder.note_broken(),
        }
    }
}
