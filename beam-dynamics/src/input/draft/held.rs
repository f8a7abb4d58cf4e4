//! What holds the roots of blades.

use shared_geom::document::Table;

use super::Draft;

impl Draft {
    /// The node of the hub when the hub moves; `None` when the frame holds it, so that
    /// roots are clamped.
    pub fn hub_node(&self) -> Option<usize> {
        self.hub_node
    }

    /// Says which node is that of a hub that moves.
    pub fn set_hub_node(&mut self, node: usize) {
        self.used.insert(node);
        self.hub_node = Some(node);
    }

    /// Holds the root of a blade by the hub: by the frame, or by the node of a hub that
    /// moves. What holds the node already is noted under `key`.
    pub fn hold_root(&mut self, node: usize, table: &Table<'_>, key: &str) {
        match self.hub_node() {
            None => self.add_clamp(node, table, key),
            Some(hub) => {
                let label = format!("hub to {}", self.nodes[node].label);
                self.add_rigid(&label, [hub, node]);
            }
        }
    }
}
