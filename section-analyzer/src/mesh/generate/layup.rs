//! Sections of blades from their layup: layers along arcs of a contour, and webs.
//!
//! The wall is made of columns of cells through all layers. A column begins at a point of
//! the contour and runs inward; depth is measured normal to the surface,
//!
//! ```text
//! x(s, d) = p(s) + d v(s),    v . n = 1,    0 <= d <= sum of the thicknesses at s
//! ```
//!
//! so that layers have their given thickness for any direction v. Where the layers of
//! both sides meet, the columns of both sides end in one common node: outer layers are
//! complete there, inner ones are cut. Nodes of the inner faces are the nodes of webs, and of the
//! triangles of fills.

use shared_geom::mesh::{Cell, CellKind, GroupSet, Mesh, PhysicalGroup};

use super::super::{DoubledNodes, SectionMesh, distance};

pub(super) mod area;
mod bend;
mod build;
mod butt;
pub(super) mod cells;
mod column;
mod failures;
mod fan;
mod feet;
mod fill;
mod front;
mod hole;
mod kinks;
pub(super) mod line;
mod mitre;
mod outline;
mod pairs;
mod points;
mod polygon;
mod problem;
mod remedies;
mod space;
pub(super) mod spar;
pub(super) mod spar_web;
pub(super) mod stack;
pub(super) mod stations;
mod triangles;
mod types;
pub(super) mod wall;
mod webs;

pub use outline::Outline;
pub use problem::{Hole, LayupProblem, Upright};
pub use types::{
    Bound, Fill, Layer, LayerArea, LayupSection, MeshedLayup, Spar, SparWeb, Web, WebPly,
};

use remedies::Remedies;
use wall::Wall;

/// Largest number of attempts to mesh a section with cells of a size.
const ATTEMPTS: usize = 12;
/// Factors of the size of all cells, if nothing else helps.
const PARTS: [f64; 2] = [1.0, 0.5];
/// Number of cells around a contour if no size is given.
pub const AROUND: f64 = 120.0;

impl LayupSection {
    /// The mesh, of quadrilaterals with 8 nodes and triangles with 6. Physical surfaces:
    /// the name of each layer, web ply and fill; for layers also their parts `NAME@suction` and
    /// `NAME@pressure`, and `NAME@WEB` along the web of a spar. Physical curves: `contour`, the outer surface, clockwise, and its
    /// parts `contour@suction` and `contour@pressure`; the name of each web, from the
    /// pressure to the suction side.
    ///
    /// # Errors
    /// The problem that prevents a mesh; it names the layer or the web.
    pub fn generate(&self) -> Result<MeshedLayup, LayupProblem> {
        types::check(self)?;
        let outline = Outline::new(&self.contour)?;
        let size = self.size.unwrap_or(outline.perimeter() / AROUND);
        let least = 1e-4 * outline.perimeter();
        if size.is_nan() || size <= least {
            return Err(LayupProblem::Size { size, least });
        }
        let mut first = None;
        for part in PARTS {
            if let Some(made) = self.meshed(&outline, part * size, &mut first)? {
                return Ok(made);
            }
        }
        Err(first.unwrap_or(LayupProblem::NoLayers))
    }

    /// The mesh with cells of a size; `None` if cells fail with all remedies: `first` is the first
    /// problem of cells.
    fn meshed(
        &self,
        outline: &Outline,
        size: f64,
        first: &mut Option<LayupProblem>,
    ) -> Result<Option<MeshedLayup>, LayupProblem> {
        let mut remedies = Remedies::default();
        for _ in 0..ATTEMPTS {
            let wall = match Wall::new(self, outline, size, &remedies) {
                Ok(wall) => wall,
                Err(problem) => return Err(first.take().unwrap_or(problem)),
            };
            let failed = match build::mesh(self, &wall) {
                Ok(mesh) => match sound(&mesh) {
                    Ok(()) => {
                        let areas = area::areas(self, &wall, &mesh);
                        area::check(&areas[..areas.len() - self.fills.len()])?;
                        return Ok(Some(MeshedLayup { mesh, areas }));
                    }
                    Err(failed) => failed,
                },
                Err(problem) => {
                    let positions = problem.position().into_iter().collect();
                    Failed {
                        problem: Box::new(problem),
                        positions,
                    }
                }
            };
            let is_of_cells = failed.problem.is_of_cells();
            let is_left = is_of_cells && failures::add(&mut remedies, &wall, &failed.positions);
            let problem = first.get_or_insert_with(|| with_space(*failed.problem, wall.tight));
            if !is_of_cells {
                return Err(problem.clone());
            }
            if !is_left {
                return Ok(None);
            }
        }
        Ok(None)
    }
}

/// A mesh that failed, and the positions of its wrong cells.
struct Failed {
    problem: Box<LayupProblem>,
    positions: Vec<[f64; 2]>,
}

/// The problem of cells of a section whose layers have too little space ahead, if they have.
fn with_space(cells: LayupProblem, space: Option<LayupProblem>) -> LayupProblem {
    match space.filter(|_| cells.is_of_cells()) {
        Some(space) => LayupProblem::Crowded {
            space: Box::new(space),
            cells: Box::new(cells),
        },
        None => cells,
    }
}

/// Checks cells and mesh as any input is checked.
fn sound(mesh: &Mesh) -> Result<(), Failed> {
    if let Some(folded) = super::grid::folded(mesh) {
        let problem = LayupProblem::Folded {
            layer: label(mesh, &folded.groups),
            count: folded.centers.len(),
            position: folded.position,
        };
        let positions = folded.centers;
        return Err(Failed {
            problem: Box::new(problem),
            positions,
        });
    }
    SectionMesh::checked(mesh, 1.0, DoubledNodes::Error)
        .map(|_| ())
        .map_err(|problems| {
            let texts: Vec<String> = problems.iter().map(ToString::to_string).collect();
            let text = texts.join("; ");
            let positions = problems.iter().flat_map(|one| one.positions(mesh));
            let positions: Vec<[f64; 2]> = positions.collect();
            let layer = positions.first().map(|at| layer_at(mesh, *at));
            Failed {
                positions,
                problem: Box::new(LayupProblem::Unsound { layer, text }),
            }
        })
}

/// The label of the layer of cells.
fn label(mesh: &Mesh, groups: &GroupSet) -> String {
    let first = groups.first().and_then(|first| mesh.groups.get(first));
    first.map_or_else(String::new, PhysicalGroup::label)
}

/// The label of the layer whose cell is nearest to a position.
fn layer_at(mesh: &Mesh, position: [f64; 2]) -> String {
    let off = |cell: &&Cell| {
        let corners = cell.corners();
        let nodes = corners
            .iter()
            .map(|node| mesh.nodes[*node as usize].position);
        let sum = nodes.fold([0.0; 2], |sum, at| [sum[0] + at.x, sum[1] + at.y]);
        let count = corners.len() as f64;
        distance(sum.map(|sum| sum / count), position)
    };
    let nearest = mesh.cells.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.map_or_else(String::new, |cell| label(mesh, &cell.groups))
}

/// Kind of the quadrilaterals.
const KIND: CellKind = CellKind::Quadrilateral8;

#[cfg(test)]
mod tests;
