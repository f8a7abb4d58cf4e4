//! Positions of the problems of a mesh.

use shared_geom::mesh::Mesh;

use super::problem::MeshProblem;

impl MeshProblem {
    /// Positions of its cells and nodes in the mesh, if it has any [file unit].
    pub(super) fn positions(&self, mesh: &Mesh) -> Vec<[f64; 2]> {
        match self {
            Self::InvertedCell { center: at, .. }
            | Self::TurnedCell { center: at, .. }
            | Self::HangingNode { at, .. }
            | Self::SideMiddle { at, .. } => vec![*at],
            Self::Overlap { nodes, .. } => {
                let all = mesh.nodes.iter().filter(|node| nodes.contains(&node.tag));
                all.map(|node| [node.position.x, node.position.y]).collect()
            }
            Self::DoubleCover(overlap) => overlap.positions.clone(),
            Self::DoubledNodes { seam, .. } => seam.positions.clone(),
            Self::Hanging { node, .. } => vec![node.position],
            _ => Vec::new(),
        }
    }
}
