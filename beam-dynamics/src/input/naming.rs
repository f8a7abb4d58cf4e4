//! Axes used to name the motion of each node.
//!
//! A node of a blade takes the axes of the blade's root, and so does every node connected
//! with it by beams and joints. If no blade is connected, the span is the section axis x at
//! the clamped node of the connected beams, or else at their first node.
//!
//! A node on the axis of rotation that belongs to no blade, and to no beam across the axis, is
//! central, as the nodes of shafts and hubs: x of its axes is the axis of rotation.

use std::collections::BTreeMap;

use nalgebra::Matrix3;

use super::builder::ModelBuilder;
use crate::model::NamingAxes;

/// Part of the size of the model up to which a node is on the axis of rotation.
const ON_AXIS: f64 = 1e-9;

impl ModelBuilder {
    /// Axes for naming, one per node; `None` without a hub.
    pub fn naming(&self) -> Option<Vec<NamingAxes>> {
        let groups = self.connected();
        let sections = self.sections();
        let group_axes = self.group_axes(&groups, &sections)?;
        let central = self.central()?;
        let along = self.hub()?.shaft_axes();
        let axes = |node: usize| {
            if central[node] {
                NamingAxes {
                    blade: along,
                    section: along,
                    is_central: true,
                }
            } else {
                NamingAxes {
                    blade: self.blade_axes(node).unwrap_or(group_axes[&groups[node]]),
                    section: sections[node],
                    is_central: false,
                }
            }
        };
        Some((0..groups.len()).map(axes).collect())
    }

    /// Whether each node is on the axis of rotation and belongs neither to a blade nor to a beam
    /// across the axis; `None` without a hub.
    fn central(&self) -> Option<Vec<bool>> {
        let hub = self.hub()?;
        let size = self.nodes().iter().map(|node| node.position.norm());
        let near = ON_AXIS * size.fold(0.0, f64::max);
        let is_free = |node: usize| self.blade_axes(node).is_none();
        let nodes = self.nodes().iter().enumerate();
        let mut central: Vec<_> = nodes
            .map(|(k, node)| is_free(k) && hub.distance(&node.position) <= near)
            .collect();
        for beam in self.beams() {
            let is_along = beam
                .nodes
                .iter()
                .all(|&node| hub.distance(&self.nodes()[node].position) <= near);
            if !is_along {
                beam.nodes.iter().for_each(|&node| central[node] = false);
            }
        }
        Some(central)
    }

    /// Blade axes of each group of connected nodes, by its first node.
    fn group_axes(
        &self,
        groups: &[usize],
        sections: &[Matrix3<f64>],
    ) -> Option<BTreeMap<usize, Matrix3<f64>>> {
        let hub = self.hub()?;
        let mut roots = BTreeMap::new();
        for node in self.clamped() {
            roots.entry(groups[node]).or_insert(node);
        }
        let mut axes = BTreeMap::new();
        for (node, &group) in groups.iter().enumerate() {
            if let Some(of_blade) = self.blade_axes(node) {
                axes.entry(group).or_insert(of_blade);
            }
        }
        for &group in groups {
            let root = roots.get(&group).copied().unwrap_or(group);
            let span = sections[root].column(0).into_owned();
            axes.entry(group).or_insert_with(|| hub.naming_axes(&span));
        }
        Some(axes)
    }

    /// For each node the first node that is connected with it by beams and joints.
    fn connected(&self) -> Vec<usize> {
        let mut group: Vec<usize> = (0..self.nodes().len()).collect();
        let of_beams = self.beams().iter().map(|beam| beam.nodes.to_vec());
        let of_joints = self.joints().map(|joint| joint.nodes().to_vec());
        let links: Vec<_> = of_beams.chain(of_joints).collect();
        let mut spread = |links: &mut dyn Iterator<Item = &Vec<usize>>| {
            let mut changed = false;
            for nodes in links {
                let least = nodes.iter().map(|&node| group[node]).min().unwrap_or(0);
                for &node in nodes {
                    changed |= group[node] != least;
                    group[node] = least;
                }
            }
            changed
        };
        // Forward and back, so that a chain in either order takes one pass.
        while spread(&mut links.iter()) | spread(&mut links.iter().rev()) {}
        group
    }

    /// Section axes at each node: the axes of the first beam on it, or its own.
    fn sections(&self) -> Vec<Matrix3<f64>> {
        let mut sections: Vec<_> = self.nodes().iter().map(|node| node.rotation).collect();
        for beam in self.beams().iter().rev() {
            for (node, end) in beam.nodes.into_iter().zip(&beam.geometry.nodes) {
                sections[node] = self.nodes()[node].rotation * end.orientation;
            }
        }
        sections
    }
}
