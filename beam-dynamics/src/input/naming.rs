//! Axes used to name the motion of each node.
//!
//! A node of a blade takes the axes of the blade's root, and so does every node connected with it, of
//! several blades with the nearest. A node on the axis of rotation is central, as the nodes of shafts
//! and hubs, unless it is the end of a single beam that leads away from the axis: x of its axes is the
//! axis of rotation. Central nodes separate the parts that they connect.
//!
//! Other nodes take the axes of the chain of beams that they lie on: its span is the section axis x at
//! its first node, which is the one at a central node, or else the clamped one, or else the one
//! nearest to the axis.

use std::collections::VecDeque;

use nalgebra::{Matrix3, Vector3};

use super::builder::ModelBuilder;
use crate::model::NamingAxes;
use chains::Chains;
use links::Links;

mod chains;
mod links;

/// Part of the size of the model up to which a node is on the axis of rotation.
const ON_AXIS: f64 = 1e-9;

impl ModelBuilder {
    /// Axes for naming, one per node; `None` without a hub.
    pub fn naming(&self) -> Option<Vec<NamingAxes>> {
        let hub = self.hub()?;
        let links = Links::new(self);
        let on_axis = self.on_axis()?;
        let central = links.central(&on_axis);
        let of_blades = self.axes_of_blades(&links, &central);
        let outside: Vec<_> = central
            .iter()
            .zip(&of_blades)
            .map(|(central, of_blade)| *central || of_blade.is_some())
            .collect();
        let axes_of =
            |span: &Vector3<f64>, node: usize| hub.naming_axes(span, &self.nodes()[node].position);
        let mut chains = Chains::new(&links, &outside, &axes_of);
        let is_at_center = |node: usize| {
            let mut links = links.of(node).iter();
            on_axis[node] || links.any(|link| central[link.to])
        };
        let nodes = 0..self.nodes().len();
        chains.follow(&nodes.filter(|node| is_at_center(*node)).collect::<Vec<_>>());
        for node in self.clamped() {
            chains.follow(&[node]);
        }
        for node in self.outward() {
            chains.follow(&[node]);
        }
        let sections = self.sections();
        let along = hub.shaft_axes();
        let tower = self.tower_axes();
        let axes = |node: usize| {
            let own = || axes_of(&sections[node].column(0).into_owned(), node);
            let blade = of_blades[node].or_else(|| chains.axes(node));
            match central[node] {
                true => NamingAxes {
                    blade: along,
                    section: along,
                    is_central: true,
                    tower: tower[node],
                },
                false => NamingAxes {
                    blade: blade.unwrap_or_else(own),
                    section: sections[node],
                    is_central: false,
                    tower: tower[node],
                },
            }
        };
        Some((0..self.nodes().len()).map(axes).collect())
    }

    /// Axes of the tower for nodes that belong to no blade; all `None` without a tower.
    fn tower_axes(&self) -> Vec<Option<Matrix3<f64>>> {
        let is_of_blade = |node: usize| {
            let mut blades = self.blades().iter();
            blades.any(|blade| blade.nodes.contains(&node))
        };
        let nodes = 0..self.nodes().len();
        let axes = |node: usize| self.tower().filter(|_| !is_of_blade(node));
        nodes.map(axes).collect()
    }

    /// Whether each node is on the axis of rotation and belongs to no blade; `None` without a hub.
    fn on_axis(&self) -> Option<Vec<bool>> {
        let hub = self.hub()?;
        let size = self.nodes().iter().map(|node| node.position.norm());
        let near = ON_AXIS * size.fold(0.0, f64::max);
        let is_on_axis = |node: usize| {
            self.blade_axes(node).is_none() && hub.distance(&self.nodes()[node].position) <= near
        };
        Some((0..self.nodes().len()).map(is_on_axis).collect())
    }

    /// Axes of the nodes of blades, and of the nodes that are connected with them by others than
    /// `central` ones.
    fn axes_of_blades(&self, links: &Links, central: &[bool]) -> Vec<Option<Matrix3<f64>>> {
        let nodes = 0..self.nodes().len();
        let mut axes: Vec<_> = nodes.map(|node| self.blade_axes(node)).collect();
        let known = |(node, axes): (usize, &Option<Matrix3<f64>>)| axes.map(|_| node);
        let mut queue: VecDeque<_> = axes.iter().enumerate().filter_map(known).collect();
        while let Some(node) = queue.pop_front() {
            for link in links.of(node) {
                if axes[link.to].is_none() && !central[link.to] {
                    axes[link.to] = axes[node];
                    queue.push_back(link.to);
                }
            }
        }
        axes
    }

    /// All nodes, the nearest to the axis first.
    fn outward(&self) -> Vec<usize> {
        let distance = |node: &usize| {
            let hub = self.hub();
            hub.map_or(0.0, |hub| hub.distance(&self.nodes()[*node].position))
        };
        let mut nodes: Vec<_> = (0..self.nodes().len()).collect();
        nodes.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        nodes
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
