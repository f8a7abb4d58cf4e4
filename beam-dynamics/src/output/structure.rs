//! Drawn parts of a model: its nodes, its beams, and their lines.

use nalgebra::Vector3;

use crate::case::BladeNodes;
use crate::elements::SectionState;
use crate::model::Node;

/// Points of a beam that a plot joins by straight lines, both ends included.
const POINTS_A_BEAM: usize = 9;

/// Nodes, beams and lines of beams of a model, undeformed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Structure {
    /// Name of each node.
    pub labels: Vec<String>,
    /// Undeformed positions of the nodes \[m\].
    pub positions: Vec<Vector3<f64>>,
    /// Nodes of each beam.
    pub beams: Vec<[usize; 3]>,
    /// Every beam is in one of them.
    pub members: Vec<Member>,
}

/// Beams that follow each other: the beams of a blade, or beams that join end to end.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Member {
    /// Name of the blade, or names of the nodes at both ends.
    pub name: String,
    /// Indices of the beams, from the root to the tip.
    pub beams: Vec<usize>,
    /// Arc position of the first node of each beam, from the first node of the member
    /// along the undeformed line \[m\].
    pub starts: Vec<f64>,
    /// Length of the undeformed line \[m\].
    pub length: f64,
}

impl Structure {
    /// The structure of these nodes and beams. Beams between the nodes of a blade form the member
    /// of this name, the others are joined end to end.
    pub fn new(nodes: &[Node], beams: &[[usize; 3]], blades: &[BladeNodes]) -> Self {
        let mut structure = Self {
            labels: nodes.iter().map(|node| node.label.clone()).collect(),
            positions: nodes.iter().map(|node| node.position).collect(),
            beams: beams.to_vec(),
            members: Vec::new(),
        };
        let mut free: Vec<usize> = (0..beams.len()).collect();
        for blade in blades {
            let index = |node: usize| blade.nodes.iter().position(|other| *other == node);
            let is_own = |beam: &usize| beams[*beam].iter().all(|node| index(*node).is_some());
            let mut own: Vec<_> = free.iter().copied().filter(is_own).collect();
            own.sort_by_key(|beam| index(beams[*beam][0]));
            free.retain(|beam| !own.contains(beam));
            structure.add_member(blade.name.clone(), own);
        }
        while !free.is_empty() {
            let chain = take_chain(beams, &mut free);
            let ends = [chain.first(), chain.last()].map(|beam| beam.map_or([0; 3], |b| beams[*b]));
            let label = |node: usize| structure.labels[node].clone();
            let name = format!("{} to {}", label(ends[0][0]), label(ends[1][2]));
            structure.add_member(name, chain);
        }
        structure
    }

    /// Beams with a gap between them are joined by a straight line.
    fn add_member(&mut self, name: String, beams: Vec<usize>) {
        if beams.is_empty() {
            return;
        }
        let mut starts = Vec::with_capacity(beams.len());
        let mut length = 0.0;
        let mut end: Option<Vector3<f64>> = None;
        for &beam in &beams {
            let nodes = self.beams[beam].map(|node| self.positions[node]);
            length += end.map_or(0.0, |end| (nodes[0] - end).norm());
            starts.push(length);
            length += arc_length(&nodes, 1.0);
            end = Some(nodes[2]);
        }
        self.members.push(Member {
            name,
            beams,
            starts,
            length,
        });
    }

    /// Arc position in its member of the position xi on beam `index` of the member \[m\].
    pub fn arc_position(&self, member: &Member, index: usize, xi: f64) -> f64 {
        let nodes = self.beams[member.beams[index]].map(|node| self.positions[node]);
        member.starts[index] + arc_length(&nodes, xi)
    }

    /// Member and index in it of each beam.
    pub fn indices(&self) -> Vec<(usize, usize)> {
        let mut indices = vec![(0, 0); self.beams.len()];
        for (number, member) in self.members.iter().enumerate() {
            for (index, &beam) in member.beams.iter().enumerate() {
                indices[beam] = (number, index);
            }
        }
        indices
    }

    /// Member and arc position \[m\] of each evaluation point; `sections` contains them in the
    /// order of the beams, two per beam.
    pub fn along(&self, sections: &[SectionState]) -> Vec<(usize, f64)> {
        let positions = self.indices();
        let along = |(k, section): (usize, &SectionState)| {
            let (number, position) = positions[k / 2];
            let member = &self.members[number];
            (number, self.arc_position(member, position, section.xi))
        };
        // Only sections of three-node beams have an index here.
        let known = sections.iter().take(2 * positions.len());
        known.enumerate().map(along).collect()
    }

    /// Arc positions and indices of the nodes of a member, from the root to the tip.
    pub fn stations(&self, member: &Member) -> Vec<(f64, usize)> {
        let mut stations: Vec<(f64, usize)> = Vec::new();
        for (index, &beam) in member.beams.iter().enumerate() {
            for (node, xi) in self.beams[beam].into_iter().zip([-1.0, 0.0, 1.0]) {
                if stations.last().is_none_or(|last| last.1 != node) {
                    stations.push((self.arc_position(member, index, xi), node));
                }
            }
        }
        stations
    }

    /// The line of each beam, smooth, with its nodes at `positions`.
    pub fn curves(&self, positions: &[Vector3<f64>]) -> Vec<Vec<Vector3<f64>>> {
        let curve = |beam: &[usize; 3]| {
            let nodes = beam.map(|node| positions[node]);
            let xi = |k: usize| 2.0 * k as f64 / (POINTS_A_BEAM - 1) as f64 - 1.0;
            let shape = |xi: f64| [0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)];
            let point = |k| {
                let [a, b, c] = shape(xi(k));
                a * nodes[0] + b * nodes[1] + c * nodes[2]
            };
            (0..POINTS_A_BEAM).map(point).collect()
        };
        self.beams.iter().map(curve).collect()
    }

    /// Nodes to which no beam is attached.
    pub fn loose_nodes(&self) -> Vec<usize> {
        let is_loose = |node: &usize| !self.beams.iter().flatten().any(|other| other == node);
        (0..self.positions.len()).filter(is_loose).collect()
    }

    /// Extent of the undeformed nodes along an axis of the model \[m\].
    pub fn length(&self, axis: usize) -> f64 {
        let positions = || self.positions.iter().map(|position| position[axis]);
        let [low, high] = [
            positions().fold(f64::INFINITY, f64::min),
            positions().fold(f64::NEG_INFINITY, f64::max),
        ];
        (high - low).max(0.0)
    }

    /// Diagonal of the box around the undeformed nodes \[m\]; one if all are at one position.
    pub fn size(&self) -> f64 {
        match Vector3::from_fn(|axis, _| self.length(axis)).norm() {
            0.0 => 1.0,
            size => size,
        }
    }
}

/// Removes the first of `free`, with all beams joined to it end to end.
fn take_chain(beams: &[[usize; 3]], free: &mut Vec<usize>) -> Vec<usize> {
    let mut chain = vec![free.remove(0)];
    // Backward first: the list may begin in the middle of a line.
    while let Some(k) = free.iter().position(|b| beams[*b][2] == beams[chain[0]][0]) {
        chain.insert(0, free.remove(k));
    }
    let last = |chain: &[usize]| beams[chain[chain.len() - 1]][2];
    while let Some(k) = free.iter().position(|b| beams[*b][0] == last(&chain)) {
        chain.push(free.remove(k));
    }
    chain
}

/// Length of the parabola through three nodes from its beginning to xi:
/// `int_-1^xi |N'_j x_j| d xi`.
fn arc_length(nodes: &[Vector3<f64>; 3], xi: f64) -> f64 {
    let half = 0.5 * (xi + 1.0);
    let speed = |u: f64| {
        let xi = -1.0 + half * (u + 1.0);
        ((xi - 0.5) * nodes[0] - 2.0 * xi * nodes[1] + (xi + 0.5) * nodes[2]).norm()
    };
    let rule = shared_geom::quadrature::line(5);
    rule.iter()
        .map(|(u, weight)| half * weight * speed(*u))
        .sum()
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use super::*;
    use crate::output::samples::nodes_at;

    #[test]
    fn beams_that_join_are_one_member_and_blades_have_their_names() {
        // Nodes 0 to 4 are two beams of a mast, 5 to 7 a blade after a gap of 1 m.
        let nodes = nodes_at(&[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [5.0, 0.0, 0.0],
            [6.0, 0.0, 0.0],
            [7.0, 0.0, 0.0],
        ]);
        let blade = BladeNodes {
            name: "red".to_owned(),
            azimuth: 0.0,
            nodes: vec![5, 6, 7],
            axes: Matrix3::identity(),
            file: None,
        };
        let beams = [[2, 3, 4], [5, 6, 7], [0, 1, 2]];
        let structure = Structure::new(&nodes, &beams, &[blade]);
        let members: Vec<_> = structure
            .members
            .iter()
            .map(|member| {
                (
                    member.name.as_str(),
                    member.beams.clone(),
                    member.length.round(),
                )
            })
            .collect();
        assert_eq!(
            members,
            [("red", vec![1], 2.0), ("n0 to n4", vec![2, 0], 4.0)]
        );
        assert_eq!(structure.indices(), [(1, 1), (0, 0), (1, 0)]);
        let found = structure.arc_position(&structure.members[1], 1, 0.5);
        assert!((found - 3.5).abs() < 1e-14, "{found}");
        let stations = structure.stations(&structure.members[1]);
        assert_eq!(
            stations.iter().map(|s| s.1).collect::<Vec<_>>(),
            [0, 1, 2, 3, 4]
        );
    }

    // The parabola y = x^2 from -1 to 1 is sqrt 5 + asinh(2) / 2 long; five Gauss points
    // miss that by 3e-4.
    #[test]
    fn arc_lengths_are_those_of_the_parabola() {
        let nodes = [[-1.0, 1.0], [0.0, 0.0], [1.0, 1.0]].map(|[x, y]| Vector3::new(x, y, 0.0));
        let exact = 5.0_f64.sqrt() + 0.5 * 2.0_f64.asinh();
        assert!((arc_length(&nodes, 1.0) - exact).abs() < 1e-3 * exact);
        assert!((arc_length(&nodes, 0.0) - 0.5 * exact).abs() < 1e-3 * exact);
    }

    #[test]
    fn curves_pass_through_the_nodes() {
        let nodes = nodes_at(&[[0.0, 0.0, 0.0], [1.0, 0.3, 0.0], [2.0, 0.0, 1.0], [9.0; 3]]);
        let structure = Structure::new(&nodes, &[[0, 1, 2]], &[]);
        let curve = &structure.curves(&structure.positions)[0];
        for (k, node) in [(0, 0), (4, 1), (8, 2)] {
            assert_eq!(curve[k], structure.positions[node]);
        }
        assert_eq!(structure.loose_nodes(), [3]);
    }
}
