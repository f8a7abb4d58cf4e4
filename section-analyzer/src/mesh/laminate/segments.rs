//! Lines of laminates.

use shared_geom::mesh::Mesh;

use super::super::boundary::Curve;
use super::Lamina;

/// A line with its laminate.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// Index of the laminate.
    pub lamina: usize,
    /// Tag of the line.
    pub tag: u64,
    /// Its ends.
    pub nodes: [u32; 2],
    /// The node at its middle.
    pub middle: Option<u32>,
    /// Whether no cell of the mesh is next to it.
    pub is_alone: bool,
    pub curve: Curve,
}

impl Segment {
    /// Key of the line, independent of its direction.
    pub fn key(&self) -> [u32; 2] {
        sorted(self.nodes)
    }

    /// Its midpoint [mesh unit].
    pub fn position(&self) -> [f64; 2] {
        self.curve.at(0.5)
    }
}

/// The ends of a line, ascending.
pub(super) fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// The name of the curve of a laminate.
pub(super) fn label(mesh: &Mesh, laminae: &[Lamina], lamina: usize) -> String {
    mesh.groups[laminae[lamina].curve].label()
}
