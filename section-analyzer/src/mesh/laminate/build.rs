//! Nodes and cells of laminates.

use std::collections::HashMap;

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, CellKind, Mesh, Node};

use super::super::plane::distance;
use super::joints::{cross, dot, left_of};
use super::layers::{Ends, Layers};
use super::problem::{LaminaProblem, limited};
use super::segments::{Segment, label};
use super::{Lamina, LaminaCell, LaminaFace, faces};

/// Makes nodes and cells of laminates in a mesh.
pub(super) struct Builder<'a> {
    pub mesh: &'a mut Mesh,
    pub laminae: &'a [Lamina],
    pub segments: &'a [Segment],
    /// The layers of each laminate.
    pub layers: &'a [Layers],
    /// The faces of the cells made.
    pub faces: Vec<LaminaFace>,
    next_node: u64,
    next_cell: u64,
    /// Surface entity of the first laminate: not used in the mesh.
    entity: i32,
    /// The nodes in the middle of sides, by the ends.
    middles: HashMap<[u32; 2], u32>,
}

impl<'a> Builder<'a> {
    pub fn new(
        mesh: &'a mut Mesh,
        laminae: &'a [Lamina],
        segments: &'a [Segment],
        layers: &'a [Layers],
    ) -> Self {
        let nodes = mesh.nodes.iter().map(|node| node.tag);
        let cells = mesh.cells.iter().map(|cell| cell.tag);
        let lines = mesh.lines.iter().map(|line| line.tag);
        let points = mesh.points.iter().map(|point| point.tag);
        let elements = cells.chain(lines).chain(points);
        let entities = mesh.cells.iter().map(|cell| cell.entity);
        Self {
            next_node: nodes.max().unwrap_or(0).saturating_add(1),
            next_cell: elements.max().unwrap_or(0).saturating_add(1),
            entity: entities.max().unwrap_or(0).max(0).saturating_add(1),
            middles: HashMap::new(),
            faces: Vec::new(),
            mesh,
            laminae,
            segments,
            layers,
        }
    }

    /// Tag and position of a node.
    pub fn named(&self, node: u32) -> (u64, [f64; 2]) {
        (self.mesh.nodes[node as usize].tag, self.position(node))
    }

    fn position(&self, node: u32) -> [f64; 2] {
        let position = self.mesh.nodes[node as usize].position;
        [position.x, position.y]
    }

    /// Nodes at these offsets from a node; without offset it is the node itself.
    pub fn nodes_at(&mut self, node: u32, offsets: &[[f64; 2]]) -> Vec<u32> {
        let position = self.position(node);
        let mut made = Vec::with_capacity(offsets.len());
        for offset in offsets {
            made.push(if offset[0] == 0.0 && offset[1] == 0.0 {
                node
            } else {
                self.node([0, 1].map(|i| position[i] + offset[i]))
            });
        }
        made
    }

    fn node(&mut self, [x, y]: [f64; 2]) -> u32 {
        let z = plane_of(self.mesh, self.segments);
        self.mesh.nodes.push(Node {
            tag: self.next_node,
            position: Vector3::new(x, y, z),
        });
        self.next_node = self.next_node.saturating_add(1);
        self.mesh.nodes.len() as u32 - 1
    }

    /// Makes the cells, given the nodes at the ends of their lines.
    pub fn cells(&mut self, ends: &[Ends]) -> Result<Vec<LaminaCell>, Vec<(usize, LaminaProblem)>> {
        let mut cells = Vec::new();
        let mut problems = Vec::new();
        for (segment, ends) in self.segments.iter().zip(ends) {
            let layers = &self.layers[segment.lamina];
            let positions = self.halfway(segment, layers, ends);
            if self.folds(segment, ends, &positions) {
                problems.push(self.folded(segment, layers));
                continue;
            }
            let middles = self.middles_of(segment, layers, ends, &positions);
            self.faces
                .extend(faces::of_line(segment, layers, ends, &middles));
            let chord = segment.curve.chord();
            for (layer, &ply) in layers.plies.iter().enumerate() {
                self.cell(segment, ends, &middles, [layer, ply]);
                cells.push(LaminaCell {
                    lamina: segment.lamina,
                    ply,
                    direction: chord[1].atan2(chord[0]),
                    line: segment.tag,
                });
            }
        }
        if problems.is_empty() {
            Ok(cells)
        } else {
            Err(limited(problems, "lines whose laminates fold"))
        }
    }

    /// The positions of the levels halfway between their ends, on the normals of the
    /// line.
    ///
    /// ```text
    /// x_k = x(u) + h_k n(u) ,     u = 1/2 + (d_0 + d_1) / (2 length)
    /// ```
    /// where d_0 and d_1 are the shifts of the two ends along the line due to corners.
    fn halfway(&self, segment: &Segment, layers: &Layers, ends: &Ends) -> Vec<[f64; 2]> {
        let curve = &segment.curve;
        let length = distance(curve.first, curve.second);
        let position = |(index, &level): (usize, &f64)| {
            let moved = |end: usize| {
                let position = self.position(ends[end][index]);
                let (from, tangent) = match end {
                    0 => (curve.first, curve.direction(0.0)),
                    _ => (curve.second, curve.direction(1.0)),
                };
                dot([0, 1].map(|i| position[i] - from[i]), tangent)
            };
            let u = 0.5 + 0.5 * (moved(0) + moved(1)) / length;
            let (x, n) = (curve.at(u), left_of(curve.direction(u)));
            [0, 1].map(|i| x[i] + level * n[i])
        };
        layers.levels.iter().enumerate().map(position).collect()
    }

    /// The nodes halfway along the line, one per level; none on lines with two nodes.
    fn middles_of(
        &mut self,
        segment: &Segment,
        layers: &Layers,
        ends: &Ends,
        positions: &[[f64; 2]],
    ) -> Vec<u32> {
        let Some(own) = segment.middle else {
            return Vec::new();
        };
        let mut middles = Vec::with_capacity(positions.len());
        for (index, &position) in positions.iter().enumerate() {
            let key = sorted(ends[0][index], ends[1][index]);
            let known = self.middles.get(&key).copied();
            let node = known.unwrap_or_else(|| {
                if layers.levels[index] == 0.0 {
                    own
                } else {
                    self.node(position)
                }
            });
            self.middles.insert(key, node);
            middles.push(node);
        }
        middles
    }

    /// The node halfway through a layer.
    fn between(&mut self, a: u32, b: u32) -> u32 {
        let key = sorted(a, b);
        if let Some(&known) = self.middles.get(&key) {
            return known;
        }
        let node = self.node(mean(self.position(a), self.position(b)));
        self.middles.insert(key, node);
        node
    }

    fn cell(&mut self, segment: &Segment, ends: &Ends, middles: &[u32], [layer, ply]: [usize; 2]) {
        let [first, second] = ends;
        let mut nodes = vec![
            first[layer],
            second[layer],
            second[layer + 1],
            first[layer + 1],
        ];
        let kind = if middles.is_empty() {
            CellKind::Quadrilateral4
        } else {
            let (below, above) = (middles[layer], middles[layer + 1]);
            let ends = [
                self.between(nodes[1], nodes[2]),
                self.between(nodes[3], nodes[0]),
            ];
            let center = self.node(mean(self.position(below), self.position(above)));
            nodes.extend([below, ends[0], above, ends[1], center]);
            CellKind::Quadrilateral9
        };
        let lamina = &self.laminae[segment.lamina];
        let entity = self.entity.saturating_add(segment.lamina as i32);
        let mut cell = Cell::new(self.next_cell, kind, entity, |i| nodes[i]);
        cell.groups = lamina.groups[ply].into();
        self.mesh.cells.push(cell);
        self.next_cell = self.next_cell.saturating_add(1);
    }

    /// Whether some level has the opposite direction to the line: at its ends or, on
    /// lines with three nodes, in its middle.
    fn folds(&self, segment: &Segment, ends: &Ends, positions: &[[f64; 2]]) -> bool {
        let curve = &segment.curve;
        (0..positions.len()).any(|level| {
            let [a, b] = [ends[0][level], ends[1][level]].map(|node| self.position(node));
            let along = |weights: [f64; 3]| {
                let [u, v, w] = weights;
                [0, 1].map(|i| u * a[i] + v * positions[level][i] + w * b[i])
            };
            let tangents = match segment.middle {
                None => vec![([-1.0, 0.0, 1.0], 0.5)],
                Some(_) => vec![
                    ([-3.0, 4.0, -1.0], 0.0),
                    ([-1.0, 0.0, 1.0], 0.5),
                    ([1.0, -4.0, 3.0], 1.0),
                ],
            };
            let mut tangents = tangents.into_iter();
            tangents.any(|(weights, t)| {
                let forward = dot(along(weights), curve.direction(t));
                forward.is_nan() || forward <= 0.0
            })
        })
    }

    fn folded(&self, segment: &Segment, layers: &Layers) -> (usize, LaminaProblem) {
        let curve = &segment.curve;
        // a parabola in its middle: x' = b - a, x'' = 4 (a + b - 2 m), 0 <= t <= 1
        let (a, b, m) = (curve.first, curve.second, curve.at(0.5));
        let chord = curve.chord();
        let second = [0, 1].map(|i| 4.0 * (a[i] + b[i] - 2.0 * m[i]));
        let length = distance(a, b);
        let bend = cross(chord, second).abs();
        let problem = LaminaProblem::Folded {
            curve: label(self.mesh, self.laminae, segment.lamina),
            line: segment.tag,
            position: segment.position(),
            reach: layers.reach(),
            length,
            radius: (!curve.is_straight()).then(|| length * length * length / bend),
        };
        (segment.lamina, problem)
    }
}

/// The z of the mesh, equal to the z of its lines.
pub(super) fn plane_of(mesh: &Mesh, segments: &[Segment]) -> f64 {
    let node = segments.first().map_or(0, |segment| segment.nodes[0]);
    mesh.nodes
        .get(node as usize)
        .map_or(0.0, |node| node.position.z)
}

fn sorted(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

fn mean(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| 0.5 * (a[i] + b[i]))
}
