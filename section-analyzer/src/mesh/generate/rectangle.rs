//! Full rectangles.

use shared_geom::mesh::{CellKind, Mesh};

use super::builder::{self, Shape, block, border, build, cells_per_quad};
use super::problem::{self, GenerateProblem};

/// A full rectangle, centered at the origin.
///
/// ```text
///                 top
///        +--+--+--+--+--+--+          z
///   left |  |  |  |  |  |  | right    ^
///        +--+--+--+--+--+--+          |
///               bottom                +--> y
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rectangle {
    /// Size along y [unit of the mesh].
    pub width: f64,
    /// Size along z [unit of the mesh].
    pub height: f64,
    /// Cells along y; triangles come in pairs.
    pub cells_y: usize,
    /// Cells along z; triangles come in pairs.
    pub cells_z: usize,
    /// Kind of the cells.
    pub kind: CellKind,
    /// Name of the physical surface.
    pub name: String,
}

impl Rectangle {
    /// The mesh, with physical curves `bottom`, `right`, `top` and `left`, which
    /// run clockwise.
    ///
    /// # Errors
    /// All invalid dimensions.
    pub fn generate(&self) -> Result<Mesh, Vec<GenerateProblem>> {
        self.check()?;
        let step = builder::step(self.kind);
        let cells = [self.cells_y, self.cells_z];
        let [last_y, last_z] = cells.map(|count| count * step);
        let point = |i: usize, j: usize| j * (last_y + 1) + i;
        // exactly symmetric about the origin
        let position = |size: f64, i: usize, last: usize| size * (i as f64 / last as f64 - 0.5);
        let mut points = Vec::with_capacity((last_y + 1) * (last_z + 1));
        for j in 0..=last_z {
            for i in 0..=last_y {
                points.push([
                    position(self.width, i, last_y),
                    position(self.height, j, last_z),
                ]);
            }
        }
        let borders = vec![
            border("bottom", self.cells_y, step, |i| point(last_y - i, 0)),
            border("right", self.cells_z, step, |i| point(last_y, last_z - i)),
            border("top", self.cells_y, step, |i| point(i, last_z)),
            border("left", self.cells_z, step, |i| point(0, i)),
        ];
        let shape = Shape {
            points,
            quads: block(cells, step, point),
            borders,
            surface: self.name.clone(),
        };
        Ok(build(shape, self.kind, true))
    }

    fn check(&self) -> Result<(), Vec<GenerateProblem>> {
        let mut problems = Vec::new();
        problem::check_length("width", self.width, &mut problems);
        problem::check_length("height", self.height, &mut problems);
        problem::check_cells("cells along y", self.cells_y, 1, &mut problems);
        problem::check_cells("cells along z", self.cells_z, 1, &mut problems);
        let factors = [self.cells_y, self.cells_z, cells_per_quad(self.kind)];
        problem::check_total(&factors, &mut problems);
        problem::outcome(problems)
    }
}
