//! Blades, and the attachment of their roots.

use nalgebra::Matrix3;
use shared_geom::document::Table;

use super::ModelBuilder;
use crate::case::BladeNodes;
use crate::input::hub::Hub;

impl ModelBuilder {
    /// Axes of the blade to which a node belongs.
    pub fn blade_axes(&self, node: usize) -> Option<Matrix3<f64>> {
        self.blade_axes[node]
    }

    /// The hub, if it could be read.
    pub fn hub(&self) -> Option<&Hub> {
        self.hub.as_ref()
    }

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

    /// Indices of the beams of a blade, from the root to the tip.
    pub fn beams_of(&self, blade: &BladeNodes) -> Vec<usize> {
        let position = |node: usize| blade.nodes.iter().position(|own| *own == node);
        let mut found: Vec<_> = self.beams.iter().enumerate().collect();
        found.retain(|(_, beam)| beam.nodes.iter().all(|node| position(*node).is_some()));
        found.sort_by_key(|(_, beam)| beam.nodes.map(position).into_iter().min());
        found.into_iter().map(|(index, _)| index).collect()
    }

    /// Notes that the given nodes, from the root to the tip, belong to a blade.
    pub fn add_blade(&mut self, blade: BladeNodes) {
        self.blades.push(blade);
    }

    /// Axes (columns) of the tower: up, from side to side, and along the wind.
    pub fn tower(&self) -> Option<Matrix3<f64>> {
        self.tower
    }

    /// Notes that the model has a tower with these axes.
    pub fn add_tower(&mut self, axes: Matrix3<f64>) {
        self.tower = Some(axes);
    }

    /// Notes that the card called `card` has the blades `blades`.
    pub fn add_blade_card(&mut self, card: String, blades: Vec<String>) {
        self.blade_cards.insert(card, blades);
    }

    /// The blades called `name`: the blade of this name, or else all blades of the card of this
    /// name; empty if neither exists.
    pub fn blades_called(&self, name: &str) -> Vec<&BladeNodes> {
        let of = |name: &str| self.blades.iter().find(|blade| blade.name == name);
        if let Some(blade) = of(name) {
            return vec![blade];
        }
        let names = self.blade_cards.get(name).into_iter().flatten();
        names.filter_map(|name| of(name)).collect()
    }

    /// Names of the nodes meant by `name`: if there is no node `CARD/END`, but a card called
    /// `CARD`, the nodes `END` of all its blades.
    pub fn node_names(&self, name: &str) -> Vec<String> {
        let one = || vec![name.to_owned()];
        if self.names.contains_key(name) {
            return one();
        }
        let blades = name
            .split_once('/')
            .and_then(|(card, end)| Some((self.blade_cards.get(card)?, end)));
        blades.map_or_else(one, |(blades, end)| {
            blades
                .iter()
                .map(|blade| format!("{blade}/{end}"))
                .collect()
        })
    }
}
