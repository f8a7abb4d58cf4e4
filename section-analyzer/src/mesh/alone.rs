//! Linear cells that are alone between both faces of a wall: with the sides ab and cd on the outline,
//! or with the side ab and the node c.
//!
//! ```text
//!   d ---- c              c
//!   |      |            /   \
//!   a ---- b          a ----- b
//! ```

use std::collections::{HashMap, HashSet};

use super::plane::polygon_area;
use super::section_mesh::{SectionCell, SectionMesh};

/// Part of the area in linear cells that reach from one face of a wall to the other: quadrilaterals
/// with two opposite sides on the outline, and triangles with one side and the node across from it.
pub fn alone_in_walls(mesh: &SectionMesh) -> f64 {
    let mut count: HashMap<[u32; 2], usize> = HashMap::new();
    for cell in &mesh.cells {
        for side in sides(cell) {
            *count.entry(side).or_default() += 1;
        }
    }
    let outer = count.into_iter().filter(|side| side.1 == 1);
    let outer: HashSet<[u32; 2]> = outer.map(|side| side.0).collect();
    let nodes: HashSet<u32> = outer.iter().flatten().copied().collect();
    let is_alone = |cell: &SectionCell| {
        if cell.kind.is_quadratic() {
            return false;
        }
        let is_outer: Vec<bool> = sides(cell).map(|side| outer.contains(&side)).collect();
        match is_outer[..] {
            [a, b, c, d] => (a && c) || (b && d),
            _ => {
                let sides = is_outer.iter().filter(|is_outer| **is_outer).count();
                sides == 1 && cell.nodes().iter().all(|node| nodes.contains(node))
            }
        }
    };
    let (mut alone, mut whole) = (0.0, 0.0);
    for cell in &mesh.cells {
        let corners = cell.corners().iter();
        let area = polygon_area(corners.map(|node| mesh.nodes[*node as usize])).abs();
        whole += area;
        alone += if is_alone(cell) { area } else { 0.0 };
    }
    alone / whole
}

/// The sides of a cell by the nodes at their ends, the smaller first.
fn sides(cell: &SectionCell) -> impl Iterator<Item = [u32; 2]> + '_ {
    let sides = cell.kind.sides(cell.nodes());
    sides.map(|([a, b], _)| [a.min(b), a.max(b)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::Rectangle;
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;

    /// All linear cells of a strip one cell high, but for triangles at its corners; none of a strip
    /// two cells high, or of quadratic cells.
    #[test]
    fn cells_that_are_alone_in_a_strip() {
        let part = |kind: CellKind, cells_z: usize| {
            let mesh = Rectangle {
                width: 2.0,
                height: 0.1,
                cells_y: 10,
                cells_z,
                kind,
                name: "strip".into(),
            };
            let mesh = mesh.generate().expect("sound measures");
            let place = SourceLocation::file("test");
            let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &place).expect("sound mesh");
            alone_in_walls(&mesh)
        };
        assert!((part(CellKind::Quadrilateral4, 1) - 1.0).abs() < 1e-12);
        assert!(part(CellKind::Triangle3, 1) > 0.8);
        for (kind, cells) in [
            (CellKind::Quadrilateral4, 2),
            (CellKind::Triangle3, 2),
            (CellKind::Quadrilateral8, 1),
            (CellKind::Triangle6, 1),
        ] {
            assert_eq!(part(kind, cells), 0.0, "{kind:?}");
        }
    }
}
