//! Connections of the nodes: beams, with the direction in which they lead away, and joints.

use nalgebra::Vector3;

use crate::input::builder::ModelBuilder;

/// A connection of a node with another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Link {
    /// The other node.
    pub to: usize,
    /// Of a beam the direction of the section axis x at the node, toward the other one; `None` of a
    /// joint [-].
    pub span: Option<Vector3<f64>>,
}

/// The connections of all nodes.
#[derive(Debug)]
pub(super) struct Links {
    of: Vec<Vec<Link>>,
    /// Whether a clamp or a support holds a node.
    is_held: Vec<bool>,
}

impl Links {
    /// The connections of the model, of beams between neighbors along them.
    pub fn new(builder: &ModelBuilder) -> Self {
        let mut links = Self::none(builder.nodes().len());
        for beam in builder.beams() {
            let spans = [0, 1, 2].map(|k| {
                let node = &builder.nodes()[beam.nodes[k]];
                let axes = node.rotation * beam.geometry.nodes[k].orientation;
                axes.column(0).into_owned()
            });
            for [a, b] in [[0, 1], [1, 2]] {
                links.add(beam.nodes[a], beam.nodes[b], Some(spans[a]));
                links.add(beam.nodes[b], beam.nodes[a], Some(-spans[b]));
            }
        }
        builder
            .clamped()
            .for_each(|node| links.is_held[node] = true);
        for joint in builder.joints() {
            if let [node] = joint.nodes() {
                links.is_held[*node] = true;
            }
            for pair in joint.nodes().windows(2) {
                links.add(pair[0], pair[1], None);
                links.add(pair[1], pair[0], None);
            }
        }
        links
    }

    /// No connections of so many nodes.
    fn none(nodes: usize) -> Self {
        Self {
            of: vec![Vec::new(); nodes],
            is_held: vec![false; nodes],
        }
    }

    fn add(&mut self, from: usize, to: usize, span: Option<Vector3<f64>>) {
        self.of[from].push(Link { to, span });
    }

    /// The connections of a node.
    pub fn of(&self, node: usize) -> &[Link] {
        &self.of[node]
    }

    /// Which of the nodes `on_axis`, which belong to no blade, are central: all but the ends of single
    /// beams that lead away from the axis, and nodes between such an end and another node on the axis
    /// that only these two joints hold, as with several hinges in one point.
    pub fn central(&self, on_axis: &[bool]) -> Vec<bool> {
        let is_end = |node: usize| {
            let beams = || self.of(node).iter().filter(|link| link.span.is_some());
            let away = beams().filter(|link| !on_axis[link.to]).count();
            away == 1 && beams().count() == 1
        };
        let nodes = 0..on_axis.len();
        let mut central: Vec<_> = nodes.map(|node| on_axis[node] && !is_end(node)).collect();
        let is_between = |node: usize, central: &[bool]| match self.of(node) {
            [a, b] if !self.is_held[node] && a.span.is_none() && b.span.is_none() => {
                let is_arm = |link: &Link| on_axis[link.to] && !central[link.to];
                on_axis[a.to] && on_axis[b.to] && is_arm(a) != is_arm(b)
            }
            _ => false,
        };
        while let Some(node) =
            (0..on_axis.len()).find(|&node| central[node] && is_between(node, &central))
        {
            central[node] = false;
        }
        central
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Links of beams, whose spans do not matter, and joints.
    fn links(count: usize, beams: &[[usize; 2]], joints: &[[usize; 2]]) -> Links {
        let mut links = Links::none(count);
        links.is_held[0] = true;
        for (pairs, span) in [(beams, Some(Vector3::x())), (joints, None)] {
            for [a, b] in pairs {
                links.add(*a, *b, span);
                links.add(*b, *a, span);
            }
        }
        links
    }

    // Nodes on the axis first.
    #[test]
    fn ends_of_single_arms_are_not_central() {
        let central = |on_axis: usize, count: usize, beams: &[_], joints: &[_]| {
            let is_on_axis: Vec<_> = (0..count).map(|node| node < on_axis).collect();
            links(count, beams, joints).central(&is_on_axis)[..on_axis].to_vec()
        };
        // One arm, clamped or free; two arms; an arm on a mast; a body.
        assert_eq!(central(1, 2, &[[0, 1]], &[]), [false]);
        assert_eq!(central(1, 3, &[[0, 1], [0, 2]], &[]), [true]);
        assert_eq!(central(2, 3, &[[0, 1], [1, 2]], &[]), [true; 2]);
        assert_eq!(central(1, 1, &[], &[]), [true]);
        // A clamped hub and the roots of two arms, one with two hinges in one point.
        let joints = [[0, 1], [0, 2], [2, 3]];
        let found = central(4, 6, &[[1, 4], [3, 5]], &joints);
        assert_eq!(found, [true, false, false, false]);
    }
}
