//! Laminates as requested, and their cells and faces.

use shared_geom::mesh::Line;

/// A laminate along a physical curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Lamina {
    /// The curve: index in [`Mesh::groups`](shared_geom::mesh::Mesh::groups).
    pub curve: usize,
    /// Side of the line; `None` for the side without cells, or centered if there are no
    /// cells at all.
    pub side: Option<LaminaSide>,
    /// Thicknesses of the plies, from the line outward; from right to left for a centered
    /// laminate. All positive [mesh unit].
    pub thicknesses: Vec<f64>,
    /// The physical surface of the cells of each ply, parallel to `thicknesses`:
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
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Center => "center",
        }
    }
}

/// The ply of a cell of a laminate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaminaCell {
    /// The laminate: index in the given list.
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
    /// The laminate: index in the given list.
    pub lamina: usize,
    /// Left or right of the laminate, seen along its line.
    pub side: LaminaSide,
    /// In the direction of the laminate's line, with the tag of this line; in no group.
    pub line: Line,
}

/// The cells that [`add_laminae`](super::add_laminae) has added after the cells of the
/// mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Laminated {
    /// Their plies, in their order.
    pub cells: Vec<LaminaCell>,
    /// Their faces away from the line, on both sides of a centered laminate.
    pub faces: Vec<LaminaFace>,
    /// Index of the first node that was made for them.
    pub first_node: usize,
    /// Number of nodes of their lines that belong to no cell: nodes of lines inside of a
    /// ply.
    pub bare_nodes: usize,
}
