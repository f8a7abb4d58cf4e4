//! Laminates along lines: each line of a physical curve becomes, layer by layer, a
//! quadrilateral as thick as a ply.
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
//! displacements of ply and cell agree all along it, on quadratic sides too. A line
//! with two nodes becomes quadrilaterals with four, one with three nodes with nine.
//!
//! The levels are (S-125). At a node between two lines a corner is mitred (S-126), and a
//! smooth wall gets the mean normal. Where the laminates of the two differ, a smooth wall
//! steps (the levels of both are cut through all their plies, the nodes of those that
//! both have are shared), and a corner with as many layers on both sides is mitred layer
//! by layer.

use shared_geom::mesh::{Line, Mesh};

use super::plane::check_references;

mod build;
mod faces;
mod fits;
mod joints;
mod layers;
mod mitre;
mod problem;
mod segments;
mod steps;
mod tees;
mod told;
mod words;

pub use problem::LaminaProblem;
pub use told::of_laminae;
pub use words::Wall;

use build::Builder;
use layers::Layers;

/// A laminate along a physical curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Lamina {
    /// The curve: index in [`Mesh::groups`].
    pub curve: usize,
    /// On which side of the line it lies; `None` for the side without cells, or for the
    /// middle where there are no cells at all.
    pub side: Option<LaminaSide>,
    /// Thicknesses of the plies, from the line outward; for one in the middle from right
    /// to left. All positive [mesh unit].
    pub thicknesses: Vec<f64>,
    /// The physical surface that the cells of each ply get, parallel to `thicknesses`:
    /// indices in [`Mesh::groups`].
    pub groups: Vec<usize>,
}

/// Side of a line, seen along it with x, the beam axis, towards the reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LaminaSide {
    /// From the line to its left.
    Left,
    /// From the line to its right.
    Right,
    /// Half of the thickness on either side.
    Center,
}

impl LaminaSide {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Center => "center",
        }
    }
}

/// What a cell of a laminate is a part of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaminaCell {
    /// The laminate: index in the list that was given.
    pub lamina: usize,
    /// The ply: index in [`Lamina::thicknesses`].
    pub ply: usize,
    /// Direction of the line halfway along the cell, from +y \[rad\].
    pub direction: f64,
    /// Tag of its line in the mesh file.
    pub line: u64,
}

/// A line of a face of a laminate: a side of one of its cells, on the surface of the
/// section.
#[derive(Debug, Clone, PartialEq)]
pub struct LaminaFace {
    /// The laminate: index in the list that was given.
    pub lamina: usize,
    /// Left or right of the laminate, seen along its line.
    pub side: LaminaSide,
    /// In the direction of the laminate's line, with the tag of that; in no group.
    pub line: Line,
}

/// The cells that [`add_laminae`] has put behind those of the mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Laminated {
    /// What they are a part of, in their order.
    pub cells: Vec<LaminaCell>,
    /// Their faces away from the line, on both sides of one in the middle.
    pub faces: Vec<LaminaFace>,
    /// Index of the first node that was made for them.
    pub first_node: usize,
    /// Number of nodes of their lines that no cell has: those of lines that run inside
    /// of a ply.
    pub bare_nodes: usize,
}

/// Adds the cells of `laminae` to `mesh`.
///
/// # Errors
/// All problems, each with the index of the laminate whose input has to change; the mesh
/// is then of no use.
pub fn add_laminae(
    mesh: &mut Mesh,
    laminae: &[Lamina],
) -> Result<Laminated, Vec<(usize, LaminaProblem)>> {
    // a mesh that refers to nodes which are not there is told by its own check
    if laminae.is_empty() || check_references(mesh).is_err() {
        return Ok(Laminated::default());
    }
    let bare = Bare::of(mesh, laminae);
    let (mut segments, sides) = segments::collect(mesh, laminae)?;
    let mut layers: Vec<Layers> = laminae
        .iter()
        .zip(sides)
        .map(|(lamina, side)| Layers::new(&lamina.thicknesses, side))
        .collect();
    let found = joints::joints(mesh, laminae, &segments)?;
    steps::cut(&found, &segments, &mut layers);
    let landings = tees::open(mesh, laminae, &mut segments, &layers, &found)?;

    // the nodes of walls that others end on are new
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

    /// How many of them, and of those made since, no cell has.
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
