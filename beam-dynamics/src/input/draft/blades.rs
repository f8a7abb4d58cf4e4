//! Blades, and what holds their roots.

use shared_geom::document::Table;

use super::Draft;
use crate::case::BladeNodes;

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

    /// Blades so far.
    pub fn blades(&self) -> &[BladeNodes] {
        &self.blades
    }

    /// Whether a blade of this name could not be read.
    pub fn is_broken_blade(&self, blade: &str) -> bool {
        self.broken_blades.contains(blade)
    }

    /// Notes that the given nodes, from the root to the tip, are those of a blade.
    pub fn add_blade(&mut self, blade: BladeNodes) {
        self.blades.push(blade);
    }
}
