//! Meshes made of quadrilaterals: lattices with fields left out, rings, stars.

use std::collections::HashMap;

use nalgebra::Vector3;
use shared_geom::mesh::{Cell, CellKind, Mesh, Node, PhysicalGroup};

/// Distance, relative to the size of the section, below which points are merged.
const SAME: f64 = 1e-9;

/// A shape as quadrilaterals, counterclockwise, each in a group.
#[derive(Debug, Clone, Default)]
pub struct Quads {
    pub points: Vec<[f64; 2]>,
    pub quads: Vec<([usize; 4], usize)>,
}

/// `cells` equal steps from `from` to `to`, the last point included.
pub fn steps(from: f64, to: f64, cells: usize) -> Vec<f64> {
    let position = |i: usize| from + (to - from) * i as f64 / cells as f64;
    (0..=cells).map(position).collect()
}

/// Steps that shrink towards both ends, by the cosine.
pub fn graded(from: f64, to: f64, cells: usize) -> Vec<f64> {
    let part = |i: usize| 0.5 - 0.5 * (std::f64::consts::PI * i as f64 / cells as f64).cos();
    (0..=cells).map(|i| from + (to - from) * part(i)).collect()
}

/// Connected pieces of a line; each begins at the end of the previous one.
pub fn joined(pieces: &[Vec<f64>]) -> Vec<f64> {
    let mut line = pieces[0].clone();
    for piece in &pieces[1..] {
        line.extend(&piece[1..]);
    }
    line
}

impl Quads {
    /// The fields between the lines y and z of a lattice for whose center `group` returns a
    /// number.
    pub fn lattice(y: &[f64], z: &[f64], group: impl Fn([f64; 2]) -> Option<usize>) -> Self {
        let mut shape = Self::default();
        for &z in z {
            shape.points.extend(y.iter().map(|&y| [y, z]));
        }
        let point = |i: usize, j: usize| j * y.len() + i;
        for j in 0..z.len() - 1 {
            for i in 0..y.len() - 1 {
                let center = [0.5 * (y[i] + y[i + 1]), 0.5 * (z[j] + z[j + 1])];
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
                if let Some(group) = group(center) {
                    let quad = corners.map(|(a, b)| point(i + a, j + b));
                    shape.quads.push((quad, group));
                }
            }
        }
        shape
    }

    /// Walls around a rectangle: `halves` are half sizes (y, z), outermost first, and
    /// `cells` the numbers of cells along y and z. Between lines k and k + 1 the top is
    /// group 4 k, then left, bottom and right; corners are mitred and the cells graded
    /// towards them.
    pub fn rings(halves: &[[f64; 2]], cells: [usize; 2]) -> Self {
        let mut shape = Self::default();
        let around = 2 * (cells[0] + cells[1]);
        for &[y, z] in halves {
            let corners = [[y, z], [-y, z], [-y, -z], [y, -z]];
            for wall in 0..4 {
                let count = cells[wall % 2];
                let (from, to) = (corners[wall], corners[(wall + 1) % 4]);
                let parts = graded(0.0, 1.0, count);
                let position = |part: &f64| [0, 1].map(|i| from[i] + (to[i] - from[i]) * part);
                shape.points.extend(parts[..count].iter().map(position));
            }
        }
        for ring in 0..halves.len() - 1 {
            let point = |line: usize, i: usize| (ring + line) * around + i % around;
            let mut i = 0;
            for wall in 0..4 {
                for _ in 0..cells[wall % 2] {
                    let quad = [point(0, i), point(0, i + 1), point(1, i + 1), point(1, i)];
                    shape.quads.push((quad, 4 * ring + wall));
                    i += 1;
                }
            }
        }
        shape
    }

    /// A star-shaped polygon about the origin, given by its corners counterclockwise: each
    /// triangle between origin and side becomes three quadrilaterals, each of them `cells`
    /// by `cells`; all in group 0.
    pub fn star(corners: &[[f64; 2]], cells: usize) -> Self {
        let mut shape = Self::default();
        for (i, &a) in corners.iter().enumerate() {
            let triangle = [[0.0, 0.0], a, corners[(i + 1) % corners.len()]];
            let middle = |i: usize, j: usize| mean(&[triangle[i % 3], triangle[j % 3]]);
            for corner in 0..3 {
                let quad = [
                    triangle[corner],
                    middle(corner, corner + 1),
                    mean(&triangle),
                    middle(corner + 2, corner),
                ];
                shape.add_patch(&quad, cells);
            }
        }
        shape.merged()
    }

    /// Adds a quadrilateral as `cells` by `cells`.
    fn add_patch(&mut self, corners: &[[f64; 2]; 4], cells: usize) {
        let first = self.points.len();
        let line = steps(0.0, 1.0, cells);
        let field = Self::lattice(&line, &line, |_| Some(0));
        self.points.extend(field.points.iter().map(|&[r, s]| {
            let weights = [(1.0 - r) * (1.0 - s), r * (1.0 - s), r * s, (1.0 - r) * s];
            let sum = |axis: usize| {
                let terms = corners.iter().zip(weights);
                terms.map(|(corner, weight)| corner[axis] * weight).sum()
            };
            [sum(0), sum(1)]
        }));
        let quads = field.quads.iter();
        self.quads
            .extend(quads.map(|(quad, group)| (quad.map(|point| first + point), *group)));
    }

    /// The same with coincident points merged.
    fn merged(self) -> Self {
        let size = self
            .points
            .iter()
            .flatten()
            .fold(0.0_f64, |m, x| m.max(x.abs()));
        let key = |p: [f64; 2]| p.map(|x| (x / (SAME * size)).round() as i64);
        let mut number = HashMap::new();
        let mut points = Vec::new();
        let of_point: Vec<usize> = self
            .points
            .iter()
            .map(|&position| {
                *number.entry(key(position)).or_insert_with(|| {
                    points.push(position);
                    points.len() - 1
                })
            })
            .collect();
        let quads = self.quads.iter();
        let quads = quads.map(|(quad, group)| (quad.map(|point| of_point[point]), *group));
        Self {
            quads: quads.collect(),
            points,
        }
    }

    /// The mesh with straight sides. `kind` gives the kind of the cells of each
    /// quadrilateral, all linear or all quadratic; triangles come in pairs. Group g is the
    /// physical surface `g`.
    pub fn mesh(&self, kind: impl Fn(usize) -> CellKind) -> Mesh {
        let mut nodes = self.points.clone();
        let mut middles = HashMap::new();
        let mut middle_of = |corners: &[usize]| {
            let mut key = corners.to_vec();
            key.sort_unstable();
            let positions: Vec<_> = corners.iter().map(|&point| self.points[point]).collect();
            *middles.entry(key).or_insert_with(|| {
                nodes.push(mean(&positions));
                nodes.len() - 1
            })
        };
        let mut cells = Vec::new();
        for (index, (quad, group)) in self.quads.iter().enumerate() {
            let kind = kind(index);
            let mut add = |corners: &[usize]| {
                let mut all = corners.to_vec();
                if kind.is_quadratic() {
                    let next = |i: usize| corners[(i + 1) % corners.len()];
                    all.extend((0..corners.len()).map(|i| middle_of(&[corners[i], next(i)])));
                }
                if kind == CellKind::Quadrilateral9 {
                    all.push(middle_of(corners));
                }
                let tag = cells.len() as u64 + 1;
                let mut cell = Cell::new(tag, kind, 1, |i| all[i] as u32);
                cell.groups = (*group).into();
                cells.push(cell);
            };
            let [a, b, c, d] = *quad;
            match kind.corner_count() {
                3 if index % 2 == 0 => [[a, b, c], [a, c, d]].iter().for_each(|t| add(t)),
                3 => [[a, b, d], [b, c, d]].iter().for_each(|t| add(t)),
                _ => add(quad),
            }
        }
        let groups = 1 + self
            .quads
            .iter()
            .map(|(_, group)| *group)
            .max()
            .unwrap_or(0);
        mesh_of(&nodes, cells, groups)
    }
}

fn mesh_of(nodes: &[[f64; 2]], cells: Vec<Cell>, groups: usize) -> Mesh {
    let node = |(index, &[y, z]): (usize, &[f64; 2])| Node {
        tag: index as u64 + 1,
        position: Vector3::new(y, z, 0.0),
    };
    let group = |index: usize| PhysicalGroup {
        dimension: 2,
        tag: index as i32 + 1,
        name: Some(index.to_string()),
    };
    Mesh {
        nodes: nodes.iter().enumerate().map(node).collect(),
        cells,
        groups: (0..groups).map(group).collect(),
        ..Mesh::default()
    }
}

fn mean(positions: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let sum: f64 = positions.iter().map(|position| position[axis]).sum();
        sum / positions.len() as f64
    })
}
