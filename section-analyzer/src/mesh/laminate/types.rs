//! Laminates as they are asked for, and their cells and faces.

use shared_geom::mesh::Line;

/// A laminate along a physical curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Lamina {
    /// The curve: index in [`Mesh::groups`](shared_geom::mesh::Mesh::groups).
    pub curve: usize,
    /// On which side of the line it lies; `None` for the side without cells, or for the
    /// middle where there are no cells at all.
    pub side: Option<LaminaSide>,
    /// Thicknesses of the plies, from the line outward; for one in the middle from right
    /// to left. All positive [mesh unit].
    pub thicknesses: Vec<f64>,
    /// The physical surface that the cells of each ply get, parallel to `thicknesses`:
    /// indices in [`Mesh::groups`](shared_geom::mesh::Mesh::groups).
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

/// The cells that [`add_laminae`](super::add_laminae) has put behind those of the mesh.
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
