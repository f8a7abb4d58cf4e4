//! The sides of cells on a physical curve.
//!
//! A line of the curve and a side of a cell match if their ends are at the same
//! positions. The shape of the side follows the cell, with or without a middle node of
//! the line.

use std::collections::HashMap;

use super::section_mesh::{Curve, CurveLine, SectionMesh};

/// Position of the cells relative to a line, seen along it with y to the right and z up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bank {
    /// One cell, on the left: the outer surface is on the right.
    Left,
    /// One cell, on the right: the outer surface is on the left.
    Right,
    /// Cells on both sides: the line lies inside the section.
    Both,
}

/// A side of a cell on a curve, in the direction of the curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CurveSide {
    /// Tag of the line in the mesh file.
    pub tag: u64,
    /// Position of the cells.
    pub bank: Bank,
    nodes: [u32; 3],
    count: usize,
}

impl CurveSide {
    /// The nodes: first end, second end, and the middle one of quadratic cells; indices
    /// in [`SectionMesh::nodes`].
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..self.count]
    }
}

/// A side of the mesh, from its end with the smaller number.
#[derive(Debug, Clone, Copy)]
struct Side {
    middle: Option<u32>,
    /// Number of cells that pass the side counterclockwise in the direction of rising
    /// indices, and in the opposite direction.
    cells: [usize; 2],
}

impl SectionMesh {
    /// The sides of cells on `curve`, parallel to its lines.
    ///
    /// # Errors
    /// The first line that is not a side of a cell.
    pub fn sides_of_curve<'a>(&self, curve: &'a Curve) -> Result<Vec<CurveSide>, &'a CurveLine> {
        let sides = self.sides_by_ends();
        let nodes_at = self.nodes_by_position();
        let found = curve.lines.iter().map(|line| {
            let [first, second] = [line.first, line.second].map(|end| at(&nodes_at, &end));
            side_between(&sides, line.tag, first, second).ok_or(line)
        });
        found.collect()
    }

    /// The nodes of the sides of cells on `curve`, each once and ascending, including the
    /// middle nodes of quadratic sides; along a slit, the nodes of both sides.
    ///
    /// # Errors
    /// The first line that is not a side of a cell.
    pub fn nodes_of_curve<'a>(&self, curve: &'a Curve) -> Result<Vec<u32>, &'a CurveLine> {
        let sides = self.sides_by_ends();
        let nodes_at = self.nodes_by_position();
        let mut nodes = Vec::new();
        for line in &curve.lines {
            let [first, second] = [line.first, line.second].map(|end| at(&nodes_at, &end));
            let before = nodes.len();
            for [a, b] in pairs(first, second) {
                if let Some(side) = sides.get(&[a.min(b), a.max(b)]) {
                    nodes.extend([a, b].into_iter().chain(side.middle));
                }
            }
            if nodes.len() == before {
                return Err(line);
            }
        }
        nodes.sort_unstable();
        nodes.dedup();
        Ok(nodes)
    }

    fn nodes_by_position(&self) -> HashMap<[u64; 2], Vec<u32>> {
        let mut nodes_at: HashMap<[u64; 2], Vec<u32>> = HashMap::new();
        for (node, position) in self.nodes.iter().enumerate() {
            nodes_at.entry(key(position)).or_default().push(node as u32);
        }
        nodes_at
    }

    fn sides_by_ends(&self) -> HashMap<[u32; 2], Side> {
        let mut sides = HashMap::with_capacity(2 * self.cells.len());
        for cell in &self.cells {
            for ([first, second], middle) in cell.kind.sides(cell.nodes()) {
                let side = sides
                    .entry([first.min(second), first.max(second)])
                    .or_insert(Side {
                        middle,
                        cells: [0; 2],
                    });
                side.cells[usize::from(first > second)] += 1;
            }
        }
        sides
    }
}

/// A position as a key; both zeros are equal.
fn key(position: &[f64; 2]) -> [u64; 2] {
    position.map(|x| (x + 0.0).to_bits())
}

/// The nodes at a position.
fn at<'a>(nodes_at: &'a HashMap<[u64; 2], Vec<u32>>, position: &[f64; 2]) -> &'a [u32] {
    nodes_at.get(&key(position)).map_or(&[], Vec::as_slice)
}

/// All pairs of a node of `first` and a node of `second`.
fn pairs<'a>(first: &'a [u32], second: &'a [u32]) -> impl Iterator<Item = [u32; 2]> + 'a {
    first
        .iter()
        .flat_map(move |a| second.iter().map(move |b| [*a, *b]))
}

/// The side from a node of `first` to one of `second`. If nodes are doubled along a slit,
/// the sides on both of its faces are found, and combined as the two sides of one line.
fn side_between(
    sides: &HashMap<[u32; 2], Side>,
    tag: u64,
    first: &[u32],
    second: &[u32],
) -> Option<CurveSide> {
    let mut found: Option<CurveSide> = None;
    for [a, b] in pairs(first, second) {
        let Some(side) = sides.get(&[a.min(b), a.max(b)]) else {
            continue;
        };
        let [along, against] = if a < b {
            side.cells
        } else {
            [side.cells[1], side.cells[0]]
        };
        let bank = match (along > 0, against > 0) {
            (true, false) => Bank::Left,
            (false, true) => Bank::Right,
            _ => Bank::Both,
        };
        match &mut found {
            Some(known) => known.bank = Bank::Both,
            None => {
                found = Some(CurveSide {
                    tag,
                    bank,
                    nodes: [a, b, side.middle.unwrap_or(0)],
                    count: 2 + usize::from(side.middle.is_some()),
                });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::Rectangle;
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;

    fn rectangle(kind: CellKind) -> SectionMesh {
        let mesh = Rectangle {
            width: 3.0,
            height: 1.0,
            cells_y: 3,
            cells_z: 2,
            kind,
            name: "bar".into(),
        };
        let mesh = mesh.generate().expect("sound measures");
        let (mesh, _) =
            SectionMesh::from_mesh(&mesh, 1e-3, &SourceLocation::file("test")).expect("sound");
        mesh
    }

    fn line([first, second]: [[f64; 2]; 2]) -> Curve {
        let line = CurveLine {
            tag: 7,
            first,
            second,
            middle: None,
        };
        Curve {
            label: "line".into(),
            lines: vec![line],
        }
    }

    /// The borders of the generator run clockwise: cells on the right, nodes as in the
    /// lines.
    #[test]
    fn borders_have_cells_at_one_side() {
        for kind in CellKind::ALL {
            let mesh = rectangle(kind);
            for curve in &mesh.curves {
                let sides = mesh.sides_of_curve(curve).expect("sides of cells");
                assert_eq!(sides.len(), curve.lines.len());
                for (side, line) in sides.iter().zip(&curve.lines) {
                    assert_eq!(side.bank, Bank::Right, "{kind:?}");
                    let positions = [line.first, line.second].into_iter().chain(line.middle);
                    let nodes = side.nodes().iter().map(|&node| mesh.nodes[node as usize]);
                    assert!(nodes.eq(positions), "{kind:?}");
                }
                let mut all: Vec<u32> = sides.iter().flat_map(|s| s.nodes().to_vec()).collect();
                all.sort_unstable();
                all.dedup();
                assert_eq!(mesh.nodes_of_curve(curve), Ok(all), "{kind:?}");
            }
        }
    }

    #[test]
    fn lines_inside_and_lines_of_no_cell_are_reported() {
        let mesh = rectangle(CellKind::Quadrilateral8);
        let inside = [mesh.nodes[0], mesh.nodes[0]];
        assert!(mesh.sides_of_curve(&line(inside)).is_err());
        // the two corners on z = 0 of the first cell of the lower row
        let cell = &mesh.cells[0];
        let [_, _, c, d] = cell.corners() else {
            panic!("four corners")
        };
        let ends = [*d, *c].map(|node| mesh.nodes[node as usize]);
        let forward = line(ends);
        let backward = line([ends[1], ends[0]]);
        let side = mesh.sides_of_curve(&forward).expect("a side")[0];
        assert_eq!((side.bank, side.nodes().len()), (Bank::Both, 3));
        assert_eq!(side.tag, 7);
        let back = mesh.sides_of_curve(&backward).expect("a side")[0];
        assert_eq!(back.nodes()[0], side.nodes()[1]);
    }
}
