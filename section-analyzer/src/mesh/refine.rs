//! A mesh whose cells have more shapes of displacement on the same geometry: linear cells
//! become quadratic, quadratic cells are cut into four like them.
//!
//! New nodes are positions of the cell's own map, so that curved sides stay as they are and
//! every displacement of the cells is one of the new cells too:
//!
//! ```text
//! triangle3 -> triangle6        quadrilateral4 -> quadrilateral9
//!
//! triangle6 -> 4 triangle6      quadrilateral8, 9 -> 4 of their kind
//!   2                             3-----+-----2
//!   | \                           |     |     |
//!   +---+                         +-----+-----+
//!   | \ | \                       |     |     |
//!   0---+---1                     0-----+-----1
//! ```

use std::collections::HashMap;

use shared_geom::mesh::CellKind;

use super::section_mesh::{SectionCell, SectionMesh};

/// Steps along a side of the lattice on which the nodes of the new cells lie.
const STEPS: usize = 4;

/// The nodes at the points of a cell's lattice, as far as they exist.
type Lattice = [[Option<u32>; STEPS + 1]; STEPS + 1];

/// A refined mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The mesh, without curves; new nodes follow the nodes of the original.
    pub mesh: SectionMesh,
    /// For each cell the index of its original.
    pub originals: Vec<usize>,
}

/// `mesh` with linear cells made quadratic, and quadratic cells cut into four.
pub fn refined(mesh: &SectionMesh) -> Refined {
    let mut nodes = Nodes {
        positions: mesh.nodes.clone(),
        between: HashMap::new(),
    };
    let mut cells = Vec::new();
    let mut originals = Vec::new();
    for (index, cell) in mesh.cells.iter().enumerate() {
        let mut lattice = nodes.on_sides(mesh, cell);
        let (kind, parts) = parts(cell.kind);
        for corners in parts {
            let node = |&at: &[f64; 2]| {
                let [i, j] = inside(corners, at);
                *lattice[i][j].get_or_insert_with(|| nodes.add(mesh, cell, [i, j]))
            };
            let found: Vec<u32> = kind.reference_nodes().iter().map(node).collect();
            cells.push(SectionCell::new(cell.tag, kind, cell.group, |i| found[i]));
            originals.push(index);
        }
    }
    let last = mesh.node_tags.iter().max().copied().unwrap_or(0);
    let tags = (1..).map(|k| last + k);
    let node_tags = mesh.node_tags.iter().copied().chain(tags);
    Refined {
        mesh: SectionMesh {
            node_tags: node_tags.take(nodes.positions.len()).collect(),
            nodes: nodes.positions,
            cells,
            groups: mesh.groups.clone(),
            curves: Vec::new(),
        },
        originals,
    }
}

/// Kind of the new cells, and the lattice points of the corners of each.
fn parts(kind: CellKind) -> (CellKind, &'static [&'static [[usize; 2]]]) {
    match kind {
        CellKind::Triangle3 => (CellKind::Triangle6, &[&[[0, 0], [4, 0], [0, 4]]]),
        CellKind::Quadrilateral4 => (
            CellKind::Quadrilateral9,
            &[&[[0, 0], [4, 0], [4, 4], [0, 4]]],
        ),
        CellKind::Triangle6 => (
            kind,
            &[
                &[[0, 0], [2, 0], [0, 2]],
                &[[2, 0], [4, 0], [2, 2]],
                &[[0, 2], [2, 2], [0, 4]],
                &[[2, 0], [2, 2], [0, 2]],
            ],
        ),
        CellKind::Quadrilateral8 | CellKind::Quadrilateral9 => (
            kind,
            &[
                &[[0, 0], [2, 0], [2, 2], [0, 2]],
                &[[2, 0], [4, 0], [4, 2], [2, 2]],
                &[[2, 2], [4, 2], [4, 4], [2, 4]],
                &[[0, 2], [2, 2], [2, 4], [0, 4]],
            ],
        ),
    }
}

/// The lattice point at reference coordinates of the part with these corners.
fn inside(corners: &[[usize; 2]], [r, s]: [f64; 2]) -> [usize; 2] {
    let straight = match corners.len() {
        3 => CellKind::Triangle3,
        _ => CellKind::Quadrilateral4,
    };
    let shape = straight.shape(r, s);
    [0, 1].map(|axis| {
        let parts = corners.iter().zip(shape.n);
        let position: f64 = parts.map(|(corner, n)| n * corner[axis] as f64).sum();
        position.round() as usize
    })
}

/// The lattice point of reference coordinates of `kind`.
fn point(kind: CellKind, at: [f64; 2]) -> [usize; 2] {
    let steps = STEPS as f64;
    at.map(|x| match kind.corner_count() {
        3 => (steps * x).round() as usize,
        _ => (0.5 * steps * (x + 1.0)).round() as usize,
    })
}

/// Reference coordinates of a lattice point of `kind`.
fn reference(kind: CellKind, point: [usize; 2]) -> [f64; 2] {
    let steps = STEPS as f64;
    point.map(|i| match kind.corner_count() {
        3 => i as f64 / steps,
        _ => 2.0 * i as f64 / steps - 1.0,
    })
}

/// The nodes of the refined mesh so far.
#[derive(Debug)]
struct Nodes {
    positions: Vec<[f64; 2]>,
    /// New nodes on sides, by their two neighbors in the original.
    between: HashMap<[u32; 2], u32>,
}

impl Nodes {
    /// The nodes of a cell, and new ones between neighbors on its sides.
    fn on_sides(&mut self, mesh: &SectionMesh, cell: &SectionCell) -> Lattice {
        let mut lattice = Lattice::default();
        let kind = cell.kind;
        let points: Vec<_> = kind
            .reference_nodes()
            .iter()
            .map(|&at| point(kind, at))
            .collect();
        for (&node, &[i, j]) in cell.nodes().iter().zip(&points) {
            lattice[i][j] = Some(node);
        }
        for side in 0..kind.corner_count() {
            let (first, second, middle) = kind.side(side);
            let local: Vec<usize> = [Some(first), middle, Some(second)]
                .into_iter()
                .flatten()
                .collect();
            for pair in local.windows(2) {
                let [i, j] = [0, 1].map(|axis| (points[pair[0]][axis] + points[pair[1]][axis]) / 2);
                let mut key = [pair[0], pair[1]].map(|k| cell.nodes()[k]);
                key.sort_unstable();
                let known = self.between.get(&key).copied();
                let node = known.unwrap_or_else(|| self.add(mesh, cell, [i, j]));
                self.between.insert(key, node);
                lattice[i][j] = Some(node);
            }
        }
        lattice
    }

    /// A new node at a lattice point of a cell.
    fn add(&mut self, mesh: &SectionMesh, cell: &SectionCell, point: [usize; 2]) -> u32 {
        let [r, s] = reference(cell.kind, point);
        let shape = cell.kind.shape(r, s);
        let mut position = [0.0; 2];
        for (at, n) in mesh.positions(cell).zip(shape.n) {
            position = [0, 1].map(|axis| position[axis] + n * at[axis]);
        }
        self.positions.push(position);
        self.positions.len() as u32 - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::Ellipse;
    use shared_geom::error::SourceLocation;

    fn ellipse(kind: CellKind) -> SectionMesh {
        let mesh = Ellipse {
            semi_y: 0.3,
            semi_z: 0.1,
            cells: 3,
            kind,
            curved: true,
        };
        let mesh = mesh.generate().expect("sound measures");
        let (mesh, _) =
            SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test")).expect("sound mesh");
        mesh
    }

    fn area(mesh: &SectionMesh, cell: &SectionCell) -> f64 {
        let positions: Vec<_> = mesh.positions(cell).collect();
        let points = cell.kind.rule().iter().map(|point| {
            let shape = cell.kind.shape(point.r, point.s);
            let sum = |by: &[f64; 9], axis: usize| -> f64 {
                positions.iter().zip(by).map(|(at, n)| n * at[axis]).sum()
            };
            let [yr, zr] = [0, 1].map(|axis| sum(&shape.dr, axis));
            let [ys, zs] = [0, 1].map(|axis| sum(&shape.ds, axis));
            point.weight * (yr * zs - ys * zr)
        });
        points.sum()
    }

    /// Parts have positive areas that add up to the area of their cell, curved sides
    /// included; nodes on common sides exist once (Euler's number of a disc). Round-off.
    #[test]
    fn parts_fill_their_cells_and_share_their_nodes() {
        for kind in CellKind::ALL {
            let mesh = ellipse(kind);
            let Refined {
                mesh: fine,
                originals,
            } = refined(&mesh);
            let mut areas = vec![0.0; mesh.cells.len()];
            for (cell, &original) in fine.cells.iter().zip(&originals) {
                let part = area(&fine, cell);
                assert!(part > 0.0, "{kind:?}");
                areas[original] += part;
            }
            for (cell, found) in mesh.cells.iter().zip(areas) {
                let expected = area(&mesh, cell);
                assert!((found / expected - 1.0).abs() < 1e-12, "{kind:?}");
            }
            let sides: std::collections::HashSet<_> = fine
                .cells
                .iter()
                .flat_map(|cell| cell.kind.sides(cell.nodes()))
                .map(|([a, b], _)| [a.min(b), a.max(b)])
                .collect();
            let corners: std::collections::HashSet<_> =
                fine.cells.iter().flat_map(|cell| cell.corners()).collect();
            let euler = corners.len() + fine.cells.len() - sides.len();
            assert_eq!(euler, 1, "{kind:?}");
            let used: std::collections::HashSet<_> =
                fine.cells.iter().flat_map(|cell| cell.nodes()).collect();
            assert_eq!(used.len(), fine.nodes.len(), "{kind:?}");
            assert_eq!(fine.node_tags.len(), fine.nodes.len());
            assert_eq!(fine.nodes[..mesh.nodes.len()], mesh.nodes);
        }
    }

    /// Every function of a cell is one of its parts: shape functions of the cell at the
    /// parts' nodes, interpolated by a part, give the cell's own values inside of it.
    #[test]
    fn functions_of_a_cell_are_functions_of_its_parts() {
        for kind in CellKind::ALL {
            let (part, all) = parts(kind);
            for corners in all {
                let at = part.reference_nodes().iter();
                let nodes = at.map(|&at| reference(kind, inside(corners, at)));
                let nodes: Vec<_> = nodes.collect();
                let (r, s) = (0.21, 0.34);
                let own = part.shape(r, s);
                let mean = |axis: usize| -> f64 {
                    nodes.iter().zip(own.n).map(|(at, n)| n * at[axis]).sum()
                };
                let expected = kind.shape(mean(0), mean(1));
                for k in 0..kind.node_count() {
                    let values = nodes.iter().map(|&[r, s]| kind.shape(r, s).n[k]);
                    let found: f64 = values.zip(own.n).map(|(value, n)| n * value).sum();
                    assert!((found - expected.n[k]).abs() < 1e-14, "{kind:?}, {k}");
                }
            }
        }
    }
}
