//! Makes meshes from blocks of a lattice.
//!
//! A shape provides the points of a lattice, the quadrilaterals between them and the
//! lines of its boundaries. For linear cells the lattice has only the corners of the
//! cells; for quadratic ones it is twice as fine, so that middles of sides and cells are
//! lattice points, mapped like the corners:
//!
//! ```text
//!  j                3 --- 6 --- 2
//!  ^                |           |
//!  |     step = 2:  7     8     5
//!  +--> i           |           |
//!                   0 --- 4 --- 1
//! ```

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, CellKind, GroupSet, Line, Mesh, Node, PhysicalGroup};

/// A quadrilateral of the lattice.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quad {
    /// Lattice points in the order of a quadrilateral with 9 nodes, counterclockwise; the
    /// points after the corners are for quadratic cells only.
    points: [u32; 9],
    /// Diagonal that splits it into triangles: from corner 1 to 3 instead of 0 to 2.
    backward: bool,
}

/// A named part of the boundary.
#[derive(Debug)]
pub(super) struct Border {
    pub(super) name: &'static str,
    /// Lattice points of each line: ends, then the middle (for quadratic cells).
    pub(super) lines: Vec<[u32; 3]>,
}

/// Data of a shape.
#[derive(Debug)]
pub(super) struct Shape {
    /// Positions of the lattice points, in the unit of the mesh.
    pub(super) points: Vec<[f64; 2]>,
    pub(super) quads: Vec<Quad>,
    pub(super) borders: Vec<Border>,
    /// Name of the physical surface.
    pub(super) surface: String,
}

/// Lattice steps along one cell.
pub(super) fn step(kind: CellKind) -> usize {
    if kind.is_quadratic() { 2 } else { 1 }
}

/// Number of cells made of one quadrilateral.
pub(super) fn cells_per_quad(kind: CellKind) -> usize {
    if kind.corner_count() == 3 { 2 } else { 1 }
}

/// Positions of the nine points of a quadrilateral, in half cells.
const HALVES: [[usize; 2]; 9] = [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
    [1, 0],
    [2, 1],
    [1, 2],
    [0, 1],
    [1, 1],
];

/// The quadrilaterals of a block with `cells` in its two directions, where the second
/// direction lies left of the first; `point(i, j)` is the index of the lattice point. The
/// diagonals alternate, so that triangles have no preferred direction.
pub(super) fn block(
    cells: [usize; 2],
    step: usize,
    point: impl Fn(usize, usize) -> usize,
) -> Vec<Quad> {
    let mut quads = Vec::with_capacity(cells[0] * cells[1]);
    for j in 0..cells[1] {
        for i in 0..cells[0] {
            quads.push(Quad {
                points: HALVES
                    .map(|[a, b]| point(i * step + a * step / 2, j * step + b * step / 2) as u32),
                backward: (i + j) % 2 == 1,
            });
        }
    }
    quads
}

/// The lines of a border of `cells` cells; `point(i)` is the index of the lattice point.
pub(super) fn border(
    name: &'static str,
    cells: usize,
    step: usize,
    point: impl Fn(usize) -> usize,
) -> Border {
    let line = |i| [0, 2, 1].map(|half| point(i * step + half * step / 2) as u32);
    Border {
        name,
        lines: (0..cells).map(line).collect(),
    }
}

/// The mesh of a shape. Quadratic cells keep the middle points of the mapping if
/// `curved`, otherwise their sides are straight.
pub(super) fn build(shape: Shape, kind: CellKind, curved: bool) -> Mesh {
    let mut points = shape.points;
    let cells: Vec<[u32; 9]> = shape
        .quads
        .iter()
        .flat_map(|quad| split(quad, kind))
        .collect();
    if !curved {
        straighten(&mut points, &cells, kind);
    }
    let (nodes, node_of_point) = number_nodes(&points, &cells, kind);
    let node = |point: u32| node_of_point[point as usize];

    let mut groups = Vec::new();
    let mut lines = Vec::new();
    let mut tags = 1..;
    for (border, entity) in shape.borders.iter().zip(1..) {
        for points in &border.lines {
            let tag = tags.next().unwrap_or(0);
            let mut line = Line::new(tag, kind.side_kind(), entity, |i| node(points[i]));
            line.groups = groups.len().into();
            lines.push(line);
        }
        groups.push(named(1, entity, border.name.into()));
    }
    let surface = GroupSet::from(groups.len());
    groups.push(named(2, 1, shape.surface));
    let cells = cells.iter().zip(tags).map(|(points, tag)| {
        let mut cell = Cell::new(tag, kind, 1, |i| node(points[i]));
        cell.groups = surface.clone();
        cell
    });
    Mesh {
        cells: cells.collect(),
        nodes,
        lines,
        groups,
        ..Mesh::default()
    }
}

fn named(dimension: u8, tag: i32, name: String) -> PhysicalGroup {
    PhysicalGroup {
        dimension,
        tag,
        name: Some(name),
    }
}

/// Corners and side middles of the two triangles on each side of a diagonal, as indices
/// of the points of the quadrilateral.
const FORWARD: [[usize; 6]; 2] = [[0, 1, 2, 4, 5, 8], [0, 2, 3, 8, 6, 7]];
const BACKWARD: [[usize; 6]; 2] = [[0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 6, 8]];

/// Lattice points of the cells that a quadrilateral is made into.
fn split(quad: &Quad, kind: CellKind) -> impl Iterator<Item = [u32; 9]> {
    let halves = if quad.backward { &BACKWARD } else { &FORWARD };
    let triangle =
        |half: &[usize; 6]| -> [u32; 9] { std::array::from_fn(|i| quad.points[half[i.min(5)]]) };
    let cells = match kind {
        CellKind::Triangle3 | CellKind::Triangle6 => halves.map(|half| Some(triangle(&half))),
        _ => [Some(quad.points), None],
    };
    cells.into_iter().flatten()
}

/// Moves the middle points of sides to the midpoint of their ends, and of cells to the
/// center of the corners.
fn straighten(points: &mut [[f64; 2]], cells: &[[u32; 9]], kind: CellKind) {
    let mean = |points: &[[f64; 2]], of: &[u32]| -> [f64; 2] {
        let sum = |axis: usize| -> f64 { of.iter().map(|&p| points[p as usize][axis]).sum() };
        [0, 1].map(|axis| sum(axis) / of.len() as f64)
    };
    for cell in cells {
        for side in 0..kind.corner_count() {
            if let (a, b, Some(middle)) = kind.side(side) {
                points[cell[middle] as usize] = mean(points, &[cell[a], cell[b]]);
            }
        }
        if kind == CellKind::Quadrilateral9 {
            points[cell[8] as usize] = mean(points, &cell[..4]);
        }
    }
}

/// The nodes at the used points, in the order of the lattice, and the node of each point.
fn number_nodes(points: &[[f64; 2]], cells: &[[u32; 9]], kind: CellKind) -> (Vec<Node>, Vec<u32>) {
    let mut used = vec![false; points.len()];
    for cell in cells {
        for &point in &cell[..kind.node_count()] {
            used[point as usize] = true;
        }
    }
    let mut nodes = Vec::new();
    let mut node_of_point = vec![0; points.len()];
    for (point, &[x, y]) in points.iter().enumerate().filter(|&(point, _)| used[point]) {
        node_of_point[point] = nodes.len() as u32;
        nodes.push(Node {
            tag: nodes.len() as u64 + 1,
            position: Vector3::new(x, y, 0.0),
        });
    }
    (nodes, node_of_point)
}
