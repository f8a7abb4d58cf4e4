//! Division of cells into triangles small enough to be drawn as plane.

use std::collections::HashMap;

use shared_geom::mesh::CellKind;

/// Size of triangles with a value at each corner [figure pixels].
pub(super) const PIECE: f64 = 9.0;
/// Largest number of triangles along the side of a cell: enough for a cell as wide as the
/// figure.
const PIECES: usize = 200;

/// A reference cell divided into triangles: shape functions at their corners.
#[derive(Debug)]
pub(super) struct Pattern {
    shapes: Vec<[f64; 9]>,
    /// The three points of each triangle.
    pub triangles: Vec<[usize; 3]>,
}

/// The patterns made so far.
#[derive(Debug)]
pub(super) struct Patterns {
    /// Size of the triangles [figure pixels].
    size: f64,
    known: HashMap<(CellKind, usize), Pattern>,
}

impl Patterns {
    /// Patterns of triangles of about `size` \[figure pixels\].
    pub fn new(size: f64) -> Self {
        Self {
            size,
            known: HashMap::new(),
        }
    }

    /// The triangles of a cell with these nodes \[figure pixels\] by its corners, if it is
    /// so small that its pattern has one piece along a side.
    pub fn of_corners<const N: usize>(
        &self,
        kind: CellKind,
        nodes: &[[f64; N]; 9],
    ) -> Option<&'static [[usize; 3]]> {
        let nodes = &nodes[..kind.node_count()];
        let is_small = extent(nodes, 0).max(extent(nodes, 1)) <= self.size;
        is_small.then_some(match kind.corner_count() {
            3 => &[[0, 1, 2]],
            _ => &[[0, 1, 3], [1, 2, 3]],
        })
    }

    /// The pattern of a cell whose nodes are at the first two values of `nodes`
    /// \[figure pixels\], with at least `least` pieces along a side.
    pub fn of<const N: usize>(
        &mut self,
        kind: CellKind,
        nodes: &[[f64; N]; 9],
        least: usize,
    ) -> &Pattern {
        let nodes = &nodes[..kind.node_count()];
        let size = extent(nodes, 0).max(extent(nodes, 1));
        let count = ((size / self.size).ceil() as usize).clamp(least, PIECES);
        let known = self.known.entry((kind, count));
        known.or_insert_with(|| Pattern::new(kind, count))
    }
}

impl Pattern {
    fn new(kind: CellKind, count: usize) -> Self {
        let is_triangle = kind.corner_count() == 3;
        let step = 1.0 / count as f64;
        let mut number = HashMap::new();
        let mut shapes = Vec::new();
        for i in 0..=count {
            for j in 0..=count {
                if is_triangle && i + j > count {
                    continue;
                }
                number.insert((i, j), shapes.len());
                let (a, b) = (i as f64 * step, j as f64 * step);
                shapes.push(if is_triangle {
                    kind.shape(a, b).n
                } else {
                    kind.shape(2.0 * a - 1.0, 2.0 * b - 1.0).n
                });
            }
        }
        let mut triangles = Vec::new();
        for &(i, j) in number.keys() {
            for corners in [
                [(i, j), (i + 1, j), (i, j + 1)],
                [(i + 1, j), (i + 1, j + 1), (i, j + 1)],
            ] {
                let corners = corners.map(|corner| number.get(&corner).copied());
                if let [Some(a), Some(b), Some(c)] = corners {
                    triangles.push([a, b, c]);
                }
            }
        }
        // the order of the map is arbitrary
        triangles.sort_unstable();
        Self { shapes, triangles }
    }

    /// Values at all points, from those at the nodes.
    pub fn at<const N: usize>(&self, nodes: &[[f64; N]; 9]) -> impl Iterator<Item = [f64; N]> {
        self.shapes.iter().map(move |shape| {
            let mut sum = [0.0; N];
            for (n, values) in shape.iter().zip(nodes) {
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum += n * value;
                }
            }
            sum
        })
    }
}

/// Extent of the nodes along an axis.
fn extent<const N: usize>(nodes: &[[f64; N]], axis: usize) -> f64 {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for node in nodes {
        (low, high) = (low.min(node[axis]), high.max(node[axis]));
    }
    high - low
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::polygon_area;

    /// Corners of small cells are the points of their patterns.
    #[test]
    fn small_cells_have_the_triangles_of_their_pattern() {
        for kind in CellKind::ALL {
            let mut nodes = [[0.0; 2]; 9];
            nodes[..kind.node_count()].copy_from_slice(kind.reference_nodes());
            let pattern = Pattern::new(kind, 1);
            let positions: Vec<_> = pattern.at(&nodes).collect();
            let found = pattern
                .triangles
                .iter()
                .map(|t| t.map(|point| positions[point]));
            let found: Vec<_> = found.collect();
            let by_corners = Patterns::new(2.0).of_corners(kind, &nodes).unwrap();
            let expected = by_corners.iter().map(|t| t.map(|corner| nodes[corner]));
            assert_eq!(found, expected.collect::<Vec<_>>(), "{kind:?}");
            assert!(Patterns::new(0.9).of_corners(kind, &nodes).is_none());
        }
    }

    /// The pieces of a reference cell, placed on itself, have its area.
    #[test]
    fn patterns_cover_the_cell() {
        for kind in CellKind::ALL {
            let mut nodes = [[0.0; 2]; 9];
            nodes[..kind.node_count()].copy_from_slice(kind.reference_nodes());
            for count in 1..5 {
                let pattern = Pattern::new(kind, count);
                let positions: Vec<_> = pattern.at(&nodes).collect();
                let area: f64 = pattern
                    .triangles
                    .iter()
                    .map(|corners| polygon_area(corners.map(|corner| positions[corner])))
                    .sum();
                let expected = if kind.corner_count() == 3 { 0.5 } else { 4.0 };
                assert!((area - expected).abs() < 1e-12, "{kind:?} {count} {area}");
            }
        }
    }
}
