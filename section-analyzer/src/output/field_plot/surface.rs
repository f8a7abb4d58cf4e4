//! The cells of a section in triangles small enough to be plane, each with its
//! values.

use shared_geom::figure::ValueTriangle;

use super::field::Field;
use super::sample::Sample;
use crate::mesh::polygon_area;
use crate::output::cell_pieces::{PIECE, Pattern, Patterns};
use crate::output::outline::{Side, SideRole, cell_points, length, side_points};
use crate::output::plane::Plane;
use crate::section::Section;

/// The drawn parts of the cells.
#[derive(Debug, Default)]
pub(super) struct Surface {
    pub triangles: Vec<ValueTriangle>,
    /// Possible positions of arrows.
    pub samples: Vec<Sample>,
}

impl Surface {
    pub fn new(section: &Section, plane: &Plane, field: &Field) -> Self {
        let mut patterns = Patterns::new(PIECE);
        let mut surface = Self::default();
        for (index, cell) in section.mesh.cells.iter().enumerate() {
            let mut positions = [[0.0; 2]; 9];
            for (position, of_node) in positions.iter_mut().zip(section.mesh.positions(cell)) {
                *position = plane.position(of_node);
            }
            // because a quadratic one is curved even if it is small
            let least = if cell.kind.is_quadratic() { 2 } else { 1 };
            let pattern = patterns.of(cell.kind, &positions, least);
            let vectors = field.vectors.as_ref().map(|vectors| &vectors[index]);
            surface.add(pattern, &positions, &field.values[index], vectors);
        }
        surface
    }

    fn add(
        &mut self,
        pattern: &Pattern,
        positions: &[[f64; 2]; 9],
        values: &[f64; 9],
        vectors: Option<&[[f64; 2]; 9]>,
    ) {
        let positions: Vec<_> = pattern.at(positions).collect();
        let scalars = values.map(|value| [value, 0.0]);
        let values: Vec<_> = pattern.at(&scalars).collect();
        for &triangle in &pattern.triangles {
            self.triangles.push(ValueTriangle {
                corners: triangle.map(|corner| positions[corner]),
                values: triangle.map(|corner| values[corner][0]),
            });
        }
        // a cell without a value has no arrows, and blocks no other arrow
        let Some(vectors) = vectors.filter(|_| !values[0][0].is_nan()) else {
            return;
        };
        let vectors: Vec<_> = pattern.at(vectors).collect();
        for triangle in &pattern.triangles {
            let positions = triangle.map(|corner| positions[corner]);
            let vectors = triangle.map(|corner| vectors[corner]);
            self.samples.push(Sample::of(positions, vectors));
        }
    }
}

/// Mean width of each region: its area over half of its border [m].
pub(super) fn region_widths(section: &Section, sides: &[Side]) -> Vec<f64> {
    let mesh = &section.mesh;
    let position = |node: u32| mesh.nodes[node as usize];
    let mut area = vec![0.0; mesh.groups.len()];
    for cell in &mesh.cells {
        area[cell.group] += polygon_area(cell_points(cell, &position));
    }
    let mut border = vec![0.0; mesh.groups.len()];
    for side in sides
        .iter()
        .filter(|side| !matches!(side.role, SideRole::Inner(_)))
    {
        let points = side_points(side.ends, side.middle, &position);
        for cell in [Some(side.cell), side.other].into_iter().flatten() {
            border[mesh.cells[cell].group] += length(&points);
        }
    }
    let width = |(area, border): (&f64, &f64)| 2.0 * area / border;
    area.iter().zip(&border).map(width).collect()
}
