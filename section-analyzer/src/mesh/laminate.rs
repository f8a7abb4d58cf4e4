//! Laminates along lines: each line of a physical curve becomes, layer by layer, a
//! quadrilateral with the thickness of a ply.
//!
//! ```text
//!        hi *-------*-------*        t  direction of the line
//!           |  ply 2        |        n  its left: n = x cross t
//!           *-------*-------*        levels: distances from the line along n
//!           |  ply 1        |        [mesh unit], lo to hi
//!        lo *-------*-------*
//!         node           next node
//! ```
//!
//! On the border of cells the level 0 has the nodes of the line itself, so that the
//! displacements of ply and cell are equal along it, also on quadratic sides. A line with
//! two nodes becomes quadrilaterals with four, one with three nodes with nine.
//!
//! The levels are (S-125). At a node between two lines a corner is mitred (S-126), and a
//! smooth wall has the mean normal. If the laminates of the two lines differ, a smooth
//! wall has a step (the levels of both divide all their plies, and the nodes of common
//! levels are shared), and a corner with equal numbers of layers on both sides is mitred
//! layer by layer.

use shared_geom::mesh::{Line, Mesh};

use super::plane::check_references;

mod attribution;
mod build;
mod faces;
mod fits;
mod joints;
mod layers;
mod mitre;
mod problem;
mod segments;
mod sides;
mod steps;
mod tees;
mod types;
mod words;

pub use attribution::of_laminae;
pub use problem::LaminaProblem;
pub use types::{Lamina, LaminaCell, LaminaFace, LaminaSide, Laminated};
pub use words::Wall;

use build::Builder;
use layers::Layers;

/// Adds the cells of `laminae` to `mesh`.
///
/// # Errors
/// All problems, each with the index of the laminate whose input must change; the mesh is
/// then not usable.
pub fn add_laminae(
    mesh: &mut Mesh,
    laminae: &[Lamina],
) -> Result<Laminated, Vec<(usize, LaminaProblem)>> {
    // a mesh that refers to missing nodes is reported by another check
    if laminae.is_empty() || check_references(mesh).is_err() {
        return Ok(Laminated::default());
    }
    let bare = Bare::of(mesh, laminae);
    let (mut segments, sides) = sides::collect(mesh, laminae)?;
    let mut layers: Vec<Layers> = laminae
        .iter()
        .zip(sides)
        .map(|(lamina, side)| Layers::new(&lamina.thicknesses, side))
        .collect();
    let found = joints::joints(mesh, laminae, &segments)?;
    steps::cut(&found, &segments, &mut layers);
    let landings = tees::open(mesh, laminae, &mut segments, &layers, &found)?;

    // the nodes of walls on which other laminates end are new
    let found = joints::joints(mesh, laminae, &segments)?;
    let mut builder = Builder::new(mesh, laminae, &segments, &layers);
    let mut ends = mitre::join(&mut builder, &found)?;
    tees::land(&landings, &mut ends);
    let cells = builder.cells(&ends)?;
    let mut faces = builder.faces;
    faces::keep_free(mesh, &mut faces);
    let bare_nodes = bare.count(mesh);
    Ok(Laminated {
        cells,
        faces,
        first_node: bare.count,
        bare_nodes,
    })
}

/// The nodes of the lines before any cell was made.
struct Bare {
    nodes: Vec<u32>,
    /// Number of all nodes.
    count: usize,
}

impl Bare {
    fn of(mesh: &Mesh, laminae: &[Lamina]) -> Self {
        let has_lamina = |line: &&Line| laminae.iter().any(|one| line.groups.contains(one.curve));
        let lines = mesh.lines.iter().filter(has_lamina);
        let mut nodes: Vec<u32> = lines.flat_map(|line| line.nodes().to_vec()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let count = mesh.nodes.len();
        Self { nodes, count }
    }

    /// The number of unused nodes among them, and among the nodes made since.
    fn count(&self, mesh: &Mesh) -> usize {
        let mut used = vec![false; mesh.nodes.len()];
        for node in mesh.cells.iter().flat_map(|cell| cell.nodes()) {
            used[*node as usize] = true;
        }
        let old = self.nodes.iter().map(|&node| node as usize);
        let all = old.chain(self.count..mesh.nodes.len());
        all.filter(|&node| !used[node]).count()
    }
}

#[cfg(test)]
mod tests;
