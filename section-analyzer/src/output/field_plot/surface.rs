//! The cells of a section in triangles small enough to be plane, each with its
//! values.

use std::collections::HashMap;

use shared_geom::figure::ValueTriangle;
use shared_geom::mesh::CellKind;

use super::field::Field;
use super::sample::Sample;
use crate::mesh::polygon_area;
use crate::output::outline::{Side, SideRole, cell_points, length, side_points};
use crate::output::plane::Plane;
use crate::section::Section;

/// Size of the triangles [figure pixels].
pub(super) const PIECE: f64 = 9.0;
/// Triangles along the side of a cell at most: those of one as wide as the figure.
const PIECES: usize = 200;

/// What is drawn of the cells.
#[derive(Debug, Default)]
pub(super) struct Surface {
    pub triangles: Vec<ValueTriangle>,
    /// Places where an arrow may stand.
    pub samples: Vec<Sample>,
}

/// A reference cell in pieces: shape functions at their corners.
struct Pattern {
    shapes: Vec<[f64; 9]>,
    triangles: Vec<[usize; 3]>,
}

impl Surface {
    pub fn new(section: &Section, plane: &Plane, field: &Field) -> Self {
        let mut patterns: HashMap<(CellKind, usize), Pattern> = HashMap::new();
        let mut surface = Self::default();
        for (index, cell) in section.mesh.cells.iter().enumerate() {
            let mut places = [[0.0; 2]; 9];
            for (place, of_node) in places.iter_mut().zip(section.mesh.places(cell)) {
                *place = plane.place(of_node);
            }
            let count = pieces(cell.kind, &places[..cell.kind.node_count()]);
            let pattern = patterns
                .entry((cell.kind, count))
                .or_insert_with(|| Pattern::new(cell.kind, count));
            let vectors = field.vectors.as_ref().map(|vectors| &vectors[index]);
            surface.add(pattern, &places, &field.values[index], vectors);
        }
        surface
    }

    fn add(
        &mut self,
        pattern: &Pattern,
        places: &[[f64; 2]; 9],
        values: &[f64; 9],
        vectors: Option<&[[f64; 2]; 9]>,
    ) {
        let places: Vec<_> = pattern.at(places);
        let scalars = values.map(|value| [value, 0.0]);
        let values: Vec<_> = pattern.at(&scalars);
        for &triangle in &pattern.triangles {
            self.triangles.push(ValueTriangle {
                corners: triangle.map(|corner| places[corner]),
                values: triangle.map(|corner| values[corner][0]),
            });
        }
        // a cell without a value has no arrows, and takes their place from none
        let Some(vectors) = vectors.filter(|_| !values[0][0].is_nan()) else {
            return;
        };
        let vectors = pattern.at(vectors);
        for triangle in &pattern.triangles {
            let places = triangle.map(|corner| places[corner]);
            let vectors = triangle.map(|corner| vectors[corner]);
            self.samples.push(Sample::of(places, vectors));
        }
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
                shapes.push(match is_triangle {
                    true => kind.shape(a, b).n,
                    false => kind.shape(2.0 * a - 1.0, 2.0 * b - 1.0).n,
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
        // the map has no order of its own
        triangles.sort_unstable();
        Self { shapes, triangles }
    }

    /// Two values at all points, from those at the nodes.
    fn at(&self, nodes: &[[f64; 2]; 9]) -> Vec<[f64; 2]> {
        let point = |shape: &[f64; 9]| {
            let mut sum = [0.0; 2];
            for (n, value) in shape.iter().zip(nodes) {
                sum[0] += n * value[0];
                sum[1] += n * value[1];
            }
            sum
        };
        self.shapes.iter().map(point).collect()
    }
}

/// Pieces along a side of a cell.
fn pieces(kind: CellKind, places: &[[f64; 2]]) -> usize {
    let size = |axis: usize| {
        let along = places.iter().map(|place| place[axis]);
        let low = along.clone().fold(f64::INFINITY, f64::min);
        along.fold(f64::NEG_INFINITY, f64::max) - low
    };
    let least = if kind.is_quadratic() { 2 } else { 1 };
    ((size(0).max(size(1)) / PIECE).ceil() as usize).clamp(least, PIECES)
}

/// Mean width of each region: its area over half of its border [m].
pub(super) fn region_widths(section: &Section, sides: &[Side]) -> Vec<f64> {
    let mesh = &section.mesh;
    let place = |node: u32| mesh.nodes[node as usize];
    let mut area = vec![0.0; mesh.groups.len()];
    for cell in &mesh.cells {
        area[cell.group] += polygon_area(cell_points(cell, &place));
    }
    let mut border = vec![0.0; mesh.groups.len()];
    for side in sides
        .iter()
        .filter(|side| !matches!(side.role, SideRole::Inner(_)))
    {
        let points = side_points(side.ends, side.middle, &place);
        for cell in [Some(side.cell), side.other].into_iter().flatten() {
            border[mesh.cells[cell].group] += length(&points);
        }
    }
    let width = |(area, border): (&f64, &f64)| 2.0 * area / border;
    area.iter().zip(&border).map(width).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pieces of a reference cell, placed on itself, have its area.
    #[test]
    fn patterns_cover_the_cell() {
        for kind in CellKind::ALL {
            let mut nodes = [[0.0; 2]; 9];
            nodes[..kind.node_count()].copy_from_slice(kind.reference_nodes());
            for count in 1..5 {
                let pattern = Pattern::new(kind, count);
                let places = pattern.at(&nodes);
                let area: f64 = pattern
                    .triangles
                    .iter()
                    .map(|corners| polygon_area(corners.map(|corner| places[corner])))
                    .sum();
                let expected = if kind.corner_count() == 3 { 0.5 } else { 4.0 };
                assert!((area - expected).abs() < 1e-12, "{kind:?} {count} {area}");
            }
        }
    }
}
