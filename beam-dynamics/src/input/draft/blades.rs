//! Blades, and the attachment of their roots.

use shared_geom::document::Table;

use super::Draft;
use crate::case::BladeNodes;

impl Draft {
    /// The node of the hub if the hub moves; `None` if the frame holds it, so that roots
    /// are clamped.
    pub fn hub_node(&self) -> Option<usize> {
        self.hub_node
    }

    /// Sets the node of a hub that moves.
    pub fn set_hub_node(&mut self, node: usize) {
        self.used.insert(node);
        self.hub_node = Some(node);
    }

    /// Attaches the root of a blade to the hub: to the frame, or to the node of a hub that
    /// moves. A node that is held already is noted under `key`.
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

    /// Notes that the given nodes, from the root to the tip, belong to a blade.
    pub fn add_blade(&mut self, blade: BladeNodes) {
        self.blades.push(blade);
    }
}
