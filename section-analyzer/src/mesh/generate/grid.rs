//! Nodes, cells and lines of a blade during generation.
//!
//! Cells contain their corners; the middle node of a side belongs to the two corners at
//! its ends, so that cells on both sides share it. It lies at their midpoint unless a
//! wall has moved it onto its curve.

use std::collections::{BTreeSet, HashMap};

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, CellKind, GroupSet, Line, Mesh, Node, PhysicalGroup};

use super::super::jacobian::Jacobian;

const CURVE: u8 = 1;
const SURFACE: u8 = 2;

/// A blade during generation.
#[derive(Debug, Default)]
pub(super) struct Grid {
    positions: Vec<[f64; 2]>,
    cells: Vec<(Vec<u32>, GroupSet)>,
    lines: Vec<([u32; 2], GroupSet)>,
    middles: HashMap<[u32; 2], [f64; 2]>,
    groups: Vec<(u8, String)>,
}

impl Grid {
    /// A new node.
    pub fn node(&mut self, position: [f64; 2]) -> u32 {
        self.positions.push(position);
        self.positions.len() as u32 - 1
    }

    /// The position of a node.
    pub fn position(&self, node: u32) -> [f64; 2] {
        self.positions[node as usize]
    }

    /// Sets the position of the middle node between two nodes, unless it is already set.
    pub fn middle(&mut self, a: u32, b: u32, position: [f64; 2]) {
        if a != b {
            self.middles.entry(key(a, b)).or_insert(position);
        }
    }

    /// A cell with these corners, counterclockwise; two of them may be equal.
    pub fn cell(&mut self, corners: [u32; 4], names: &[String]) {
        let mut distinct: Vec<u32> = Vec::with_capacity(4);
        for corner in corners {
            if !distinct.contains(&corner) {
                distinct.push(corner);
            }
        }
        if distinct.len() >= 3 {
            let groups = self.set(SURFACE, names);
            self.cells.push((distinct, groups));
        }
    }

    /// A line of named curves.
    pub fn line(&mut self, ends: [u32; 2], names: &[String]) {
        if ends[0] != ends[1] {
            let groups = self.set(CURVE, names);
            self.lines.push((ends, groups));
        }
    }

    /// Nodes of a number of cells on the straight line from one node to another.
    pub fn divided(&mut self, [a, b]: [u32; 2], count: usize) -> Vec<u32> {
        let [from, to] = [a, b].map(|node| self.position(node));
        let mut nodes = vec![a];
        for i in 1..count {
            let part = i as f64 / count as f64;
            nodes.push(self.node([0, 1].map(|k| from[k] + part * (to[k] - from[k]))));
        }
        nodes.push(b);
        nodes
    }

    /// Cells between two lines of nodes, the second one left of the first.
    pub fn strip(&mut self, [right, left]: [&[u32]; 2], names: &[String]) {
        for (a, b) in right.windows(2).zip(left.windows(2)) {
            self.cell([a[0], a[1], b[1], b[0]], names);
        }
    }

    /// Lines of named curves through nodes.
    pub fn curve(&mut self, nodes: &[u32], names: &[String]) {
        for side in nodes.windows(2).filter(|_| !names.is_empty()) {
            self.line([side[0], side[1]], names);
        }
    }

    fn set(&mut self, dimension: u8, names: &[String]) -> GroupSet {
        let mut indices = Vec::with_capacity(names.len());
        for name in names {
            let is_it = |group: &(u8, String)| group.0 == dimension && group.1 == *name;
            let known = self.groups.iter().position(is_it);
            indices.push(known.unwrap_or_else(|| {
                self.groups.push((dimension, name.clone()));
                self.groups.len() - 1
            }));
        }
        indices.into_iter().collect()
    }

    /// The holes of the cells and of `lines` between them: closed chains of corners, counterclockwise.
    pub fn holes(&self, lines: &[Vec<u32>]) -> Vec<Vec<u32>> {
        let sides = self.cells.iter().flat_map(|(corners, _)| {
            let next = corners.iter().cycle().skip(1);
            corners.iter().copied().zip(next.copied())
        });
        let sides: BTreeSet<(u32, u32)> = sides.collect();
        // a cell is to the left of a side, a hole or the outside to the right
        let is_free = |(a, b): &&(u32, u32)| !sides.contains(&(*b, *a));
        let mut free: BTreeSet<(u32, u32)> = sides.iter().filter(is_free).copied().collect();
        for pair in lines.iter().flat_map(|line| line.windows(2)) {
            free.extend([(pair[0], pair[1]), (pair[1], pair[0])]);
        }
        let mut holes = Vec::new();
        while let Some(first) = free.pop_first() {
            let (mut chain, mut at) = (vec![first.0], first);
            while at.1 != first.0 {
                chain.push(at.1);
                // of several sides the sharpest turn to the right is of this hole
                let next = free.range((at.1, 0)..=(at.1, u32::MAX)).copied();
                let next = next.filter(|side| side.1 != at.0);
                let turn = |side: &(u32, u32)| self.turn(at, *side);
                let Some(next) = next.min_by(|a, b| turn(a).total_cmp(&turn(b))) else {
                    break;
                };
                free.remove(&next);
                at = next;
            }
            if self.area(&chain) < 0.0 {
                chain.reverse();
                holes.push(chain);
            }
        }
        holes
    }

    /// The turn from a side to the next one, positive to the left \[rad\].
    fn turn(&self, (a, b): (u32, u32), (_, c): (u32, u32)) -> f64 {
        let [a, b, c] = [a, b, c].map(|node| self.position(node));
        let [u, v] = [[b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]];
        (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
    }

    /// The area in a closed chain of nodes, positive if it is counterclockwise.
    pub fn area(&self, chain: &[u32]) -> f64 {
        let next = chain.iter().cycle().skip(1);
        let parts = chain.iter().zip(next).map(|(a, b)| {
            let [a, b] = [a, b].map(|node| self.position(*node));
            0.5 * (a[0] * b[1] - a[1] * b[0])
        });
        parts.sum()
    }

    /// The mesh, of quadrilaterals of this kind and triangles of the same order.
    pub fn mesh(mut self, kind: CellKind) -> Mesh {
        let triangle = if kind.is_quadratic() {
            CellKind::Triangle6
        } else {
            CellKind::Triangle3
        };
        let mut middle_nodes = HashMap::new();
        let lines = std::mem::take(&mut self.lines);
        let cells = std::mem::take(&mut self.cells);
        let mut tags = 1..;
        let mut next = || tags.next().unwrap_or(0);
        let mut mesh = Mesh::default();
        let owner = |groups: &GroupSet| groups.first().map_or(0, |first| first as i32 + 1);
        for (ends, groups) in lines {
            let middle = if kind.is_quadratic() {
                self.middle_node(ends, &mut middle_nodes)
            } else {
                0
            };
            let nodes = [ends[0], ends[1], middle];
            let mut line = Line::new(next(), kind.side_kind(), owner(&groups), |i| nodes[i]);
            line.groups = groups;
            mesh.lines.push(line);
        }
        for (corners, groups) in cells {
            let kind = if corners.len() == 3 { triangle } else { kind };
            let nodes = self.nodes_of(kind, corners, &mut middle_nodes);
            let mut cell = Cell::new(next(), kind, owner(&groups), |i| nodes[i]);
            cell.groups = groups;
            mesh.cells.push(cell);
        }
        mesh.groups = self.numbered_groups();
        let node = |(index, point): (usize, &[f64; 2])| Node {
            tag: index as u64 + 1,
            position: Vector3::new(point[0], point[1], 0.0),
        };
        mesh.nodes = self.positions.iter().enumerate().map(node).collect();
        without_unused(mesh)
    }

    fn nodes_of(
        &mut self,
        kind: CellKind,
        corners: Vec<u32>,
        middles: &mut HashMap<[u32; 2], u32>,
    ) -> Vec<u32> {
        let mut nodes = corners;
        let count = nodes.len();
        if !kind.is_quadratic() {
            return nodes;
        }
        for side in 0..count {
            let ends = [nodes[side], nodes[(side + 1) % count]];
            nodes.push(self.middle_node(ends, middles));
        }
        if kind == CellKind::Quadrilateral9 {
            let sum = |nodes: &[u32], i: usize| -> f64 {
                nodes.iter().map(|node| self.position(*node)[i]).sum()
            };
            // the center of the corresponding cell with 8 nodes
            let center = [0, 1].map(|i| 0.5 * sum(&nodes[4..], i) - 0.25 * sum(&nodes[..4], i));
            nodes.push(self.node(center));
        }
        nodes
    }

    fn middle_node(&mut self, [a, b]: [u32; 2], known: &mut HashMap<[u32; 2], u32>) -> u32 {
        if let Some(&node) = known.get(&key(a, b)) {
            return node;
        }
        let position = self.middles.get(&key(a, b)).copied().unwrap_or_else(|| {
            let (a, b) = (self.position(a), self.position(b));
            [0, 1].map(|i| 0.5 * (a[i] + b[i]))
        });
        let node = self.node(position);
        known.insert(key(a, b), node);
        node
    }

    fn numbered_groups(&self) -> Vec<PhysicalGroup> {
        let group = |(index, (dimension, name)): (usize, &(u8, String))| PhysicalGroup {
            dimension: *dimension,
            tag: index as i32 + 1,
            name: Some(name.clone()),
        };
        self.groups.iter().enumerate().map(group).collect()
    }
}

fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// The mesh with only the nodes that belong to cells.
fn without_unused(mut mesh: Mesh) -> Mesh {
    let mut new = vec![None; mesh.nodes.len()];
    for cell in &mesh.cells {
        for node in cell.nodes() {
            new[*node as usize] = Some(0);
        }
    }
    let mut nodes = Vec::with_capacity(mesh.nodes.len());
    for (index, node) in mesh.nodes.iter().enumerate() {
        if new[index].is_some() {
            new[index] = Some(nodes.len() as u32);
            nodes.push(Node {
                tag: nodes.len() as u64 + 1,
                ..*node
            });
        }
    }
    let at = |node: u32| new[node as usize].unwrap_or(0);
    for cell in &mut mesh.cells {
        let mut moved = Cell::new(cell.tag, cell.kind, cell.entity, |i| at(cell.nodes()[i]));
        moved.groups = cell.groups.clone();
        *cell = moved;
    }
    for line in &mut mesh.lines {
        let mut moved = Line::new(line.tag, line.kind, line.entity, |i| at(line.nodes()[i]));
        moved.groups = line.groups.clone();
        *line = moved;
    }
    mesh.nodes = nodes;
    mesh
}

/// Cells whose Jacobian is not positive everywhere.
pub(super) struct Folded {
    /// The center of each.
    pub centers: Vec<[f64; 2]>,
    /// Center of the one with the least part of its largest Jacobian.
    pub position: [f64; 2],
    /// Physical surfaces of this one.
    pub groups: GroupSet,
}

/// The cells that fold, if any.
pub(super) fn folded(mesh: &Mesh) -> Option<Folded> {
    let jacobian = Jacobian::new();
    let position = |node: &u32| {
        let position = mesh.nodes[*node as usize].position;
        [position.x, position.y]
    };
    let mut centers = Vec::new();
    let mut worst: Option<(f64, [f64; 2], &GroupSet)> = None;
    for cell in &mesh.cells {
        let positions: Vec<[f64; 2]> = cell.nodes().iter().map(position).collect();
        let [least, largest] = jacobian.extremes(cell.kind, &positions);
        if least > 0.0 {
            continue;
        }
        let corners = &positions[..cell.kind.corner_count()];
        let mean = |i: usize| corners.iter().map(|corner| corner[i]).sum::<f64>();
        let center = [0, 1].map(|i| mean(i) / corners.len() as f64);
        centers.push(center);
        let part = least / largest.abs().max(f64::MIN_POSITIVE);
        if worst.is_none_or(|(known, ..)| part < known) {
            worst = Some((part, center, &cell.groups));
        }
    }
    worst.map(|(_, position, groups)| Folded {
        centers,
        position,
        groups: groups.clone(),
    })
}
