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

use shared_geom::error::SourceLocation;
use shared_geom::mesh::{CellKind, Mesh};

use super::super::SectionMesh;

pub(super) mod area;
mod bend;
mod build;
mod butt;
pub(super) mod cells;
mod column;
mod feet;
mod fill;
mod front;
mod kinks;
pub(super) mod line;
mod mitre;
mod outline;
mod pairs;
mod points;
mod polygon;
mod problem;
pub(super) mod spar;
pub(super) mod spar_web;
pub(super) mod stack;
pub(super) mod stations;
mod triangles;
mod types;
pub(super) mod wall;
mod webs;

pub use outline::Outline;
pub use problem::{LayupProblem, Upright};
pub use types::{
    Bound, Fill, Layer, LayerArea, LayupSection, MeshedLayup, Spar, SparWeb, Web, WebPly,
};

use wall::{Reach, Wall};

/// Attempts to mesh a section: factors of the reach of contacts and of the size of cells.
const ATTEMPTS: [(f64, f64); 4] = [(1.0, 1.0), (2.0, 1.0), (1.0, 0.5), (2.0, 0.5)];
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
        let mut tight = None;
        for (reach, part) in ATTEMPTS {
            let wall = Wall::new(self, &outline, part * size, Reach(reach));
            if let Ok(wall) = &wall {
                tight = wall.tight.clone();
            }
            let made = wall.and_then(|wall| build::mesh(self, &wall).map(|mesh| (mesh, wall)));
            let problem = match made {
                Ok((mesh, wall)) => match sound(&mesh) {
                    Ok(()) => {
                        let areas = area::areas(self, &wall, &mesh);
                        area::check(&areas[..areas.len() - self.fills.len()])?;
                        return Ok(MeshedLayup { mesh, areas });
                    }
                    Err(problem) => problem,
                },
                Err(problem) => problem,
            };
            let is_final = !problem.is_of_cells();
            let problem = first.get_or_insert(problem).clone();
            if is_final {
                return Err(problem);
            }
        }
        // a section whose layers meet ahead
        Err(tight.or(first).unwrap_or(LayupProblem::NoLayers))
    }
}

/// Checks cells and mesh as any input is checked.
fn sound(mesh: &Mesh) -> Result<(), LayupProblem> {
    let label = |groups: &shared_geom::mesh::GroupSet| {
        let first = groups.first().and_then(|first| mesh.groups.get(first));
        first.map_or_else(String::new, shared_geom::mesh::PhysicalGroup::label)
    };
    if let Some(folded) = super::grid::folded(mesh) {
        return Err(LayupProblem::Folded {
            layer: label(&folded.groups),
            count: folded.count,
            position: folded.position,
        });
    }
    let place = SourceLocation::file("mesh of the layup");
    match SectionMesh::from_mesh(mesh, 1.0, &place) {
        Ok(_) => Ok(()),
        Err(problems) => Err(LayupProblem::Unsound {
            text: problems.to_string(),
        }),
    }
}

/// Kind of the quadrilaterals.
const KIND: CellKind = CellKind::Quadrilateral8;

#[cfg(test)]
mod tests;
