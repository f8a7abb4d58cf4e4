//! A cell in the solver's form.

use shared_geom::mesh::CellKind;

/// A cell of the domain.
#[derive(Debug, Clone, Copy)]
pub struct DomainCell {
    /// Number of the cell in its file.
    pub tag: u64,
    /// Index of the cell in the mesh of the section.
    pub mesh_cell: u32,
    /// Shape.
    pub kind: CellKind,
    /// Index into [`Domain::laws`](super::Domain::laws).
    pub law: u32,
    /// Index into the laws of [`Electric`](super::Electric); `None` for a cell without potential.
    pub coupled: Option<u32>,
    /// Density \[kg/m^3\].
    pub density: f64,
    pub(super) nodes: [u32; 9],
}

impl DomainCell {
    /// Nodes: indices into [`Domain::nodes`](super::Domain::nodes), in the order of the cell.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.kind.node_count()]
    }
}
