//! A mesh of straight quadratic triangles, each cut into r x r like it.

use std::collections::HashMap;

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, CellKind, Mesh, Node};

/// Corners with integer weights, which determine the position of a node; sorted by corner.
type Weights = Vec<(u32, usize)>;

/// `mesh` with each of its triangles cut into `r * r`; lines and points are left out.
pub fn refined(mesh: &Mesh, r: usize) -> Mesh {
    let mut nodes = Nodes {
        corners: mesh,
        parts: 2 * r,
        index: HashMap::new(),
        nodes: Vec::new(),
    };
    let mut cells: Vec<Cell> = Vec::new();
    for cell in &mesh.cells {
        for [a, b, c] in triangles(r) {
            let middle = |p: [usize; 2], q: [usize; 2]| [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
            let positions = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
            let found = positions.map(|position| nodes.at(cell.corners(), position));
            let tag = cells.len() as u64 + 1;
            let mut small = Cell::new(tag, CellKind::Triangle6, cell.entity, |i| found[i]);
            small.groups = cell.groups.clone();
            cells.push(small);
        }
    }
    Mesh {
        nodes: nodes.nodes,
        cells,
        groups: mesh.groups.clone(),
        ..Mesh::default()
    }
}

/// Corners of the small triangles on the lattice of half sides: steps of two along
/// the first and the second side.
fn triangles(r: usize) -> Vec<[[usize; 2]; 3]> {
    let mut triangles = Vec::new();
    for i in 0..r {
        for j in 0..r - i {
            let [i, j] = [2 * i, 2 * j];
            triangles.push([[i, j], [i + 2, j], [i, j + 2]]);
            if i + j + 2 < 2 * r {
                triangles.push([[i + 2, j], [i + 2, j + 2], [i, j + 2]]);
            }
        }
    }
    triangles
}

/// The nodes of the refined mesh.
struct Nodes<'a> {
    corners: &'a Mesh,
    parts: usize,
    index: HashMap<Weights, u32>,
    nodes: Vec<Node>,
}

impl Nodes<'_> {
    /// The node at a lattice point of the triangle with these corners.
    fn at(&mut self, corners: &[u32], [i, j]: [usize; 2]) -> u32 {
        let weights = [self.parts - i - j, i, j];
        let mut key: Weights = corners.iter().copied().zip(weights).collect();
        key.retain(|&(_, weight)| weight > 0);
        key.sort_unstable();
        let (parts, mesh, nodes) = (self.parts as f64, self.corners, &mut self.nodes);
        *self.index.entry(key).or_insert_with_key(|key| {
            let part = |&(corner, weight): &(u32, usize)| {
                mesh.nodes[corner as usize].position * (weight as f64 / parts)
            };
            nodes.push(Node {
                tag: nodes.len() as u64 + 1,
                position: key.iter().map(part).sum::<Vector3<f64>>(),
            });
            nodes.len() as u32 - 1
        })
    }
}
