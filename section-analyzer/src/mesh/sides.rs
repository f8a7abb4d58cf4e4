//! The sides of the cells: finds the cells that meet at them, and checks that they fit.
//!
//! Two cells fit at a side if they share its nodes, including the middle node. If only
//! one of them has a middle node, or a middle node is a corner of another cell, the
//! displacements on the two sides differ between the nodes: the node is a hanging node.

use std::collections::HashMap;

use super::plane::PlaneMesh;
use super::problem::{MeshProblem, limited};

/// A side, in the direction of its first cell.
#[derive(Debug, Clone, Copy)]
struct Side {
    cell: usize,
    /// First corner, counterclockwise in that cell.
    first: u32,
    middle: Option<u32>,
    /// Whether a second cell has been found.
    met: bool,
}

/// Results of the check of sides.
#[derive(Debug)]
pub(super) struct Sides {
    /// Pairs of cells (indices) that share a side.
    pub(super) neighbors: Vec<[usize; 2]>,
    /// Overlapping cells and sides that do not fit.
    pub(super) problems: Vec<MeshProblem>,
}

/// Goes through the sides of all cells. `oriented` is true if all cells are
/// counterclockwise, so that neighbors pass their side in opposite directions.
pub(super) fn sides(mesh: &PlaneMesh, oriented: bool) -> Sides {
    let mut sides: HashMap<[u32; 2], Side> = HashMap::with_capacity(2 * mesh.cells.len());
    let (mut neighbors, mut overlaps, mut gaps) = (Vec::new(), Vec::new(), Vec::new());
    for (number, cell) in mesh.cells.iter().enumerate() {
        for ([first, second], middle) in cell.kind.sides(cell.nodes()) {
            let key = [first.min(second), first.max(second)];
            let mut new = false;
            let side = sides.entry(key).or_insert_with(|| {
                new = true;
                Side {
                    cell: number,
                    first,
                    middle,
                    met: false,
                }
            });
            // A cell that meets itself lists a node twice, which is reported with the
            // cell.
            if new || side.cell == number {
                continue;
            }
            if side.met || (oriented && side.first == first) {
                overlaps.push(MeshProblem::Overlap {
                    cells: [side.cell, number].map(|cell| mesh.cells[cell].tag),
                    nodes: key.map(|node| mesh.node_tags[node as usize]),
                });
            } else if side.middle != middle {
                let middles = [(side.cell, side.middle), (number, middle)];
                gaps.push(no_common_middle(mesh, key, middles));
            }
            side.met = true;
            neighbors.push([side.cell, number]);
        }
    }
    for (with, without, problem) in middles_at_corners(mesh) {
        gaps.push(problem);
        neighbors.push([with, without]);
    }
    let mut problems = limited(overlaps, "overlapping cells");
    problems.extend(limited(gaps, "sides without a common middle"));
    Sides {
        neighbors,
        problems,
    }
}

/// The problem of a side whose cells have different middle nodes.
fn no_common_middle(
    mesh: &PlaneMesh,
    side: [u32; 2],
    middles: [(usize, Option<u32>); 2],
) -> MeshProblem {
    match middles {
        [(with, Some(middle)), (without, None)] | [(without, None), (with, Some(middle))] => {
            hanging(mesh, side, middle, [with, without], false)
        }
        [(first, _), (second, _)] => {
            let ends = side.map(|node| mesh.nodes[node as usize]);
            MeshProblem::SideMiddle {
                cells: [first, second].map(|cell| mesh.cells[cell].tag),
                nodes: side.map(|node| mesh.node_tags[node as usize]),
                at: [0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis])),
            }
        }
    }
}

/// The node `middle` of `side` that is in the side of the first cell only, or a corner of
/// the second.
fn hanging(
    mesh: &PlaneMesh,
    side: [u32; 2],
    middle: u32,
    cells: [usize; 2],
    corner: bool,
) -> MeshProblem {
    MeshProblem::HangingNode {
        node: mesh.node_tags[middle as usize],
        at: mesh.nodes[middle as usize],
        side: side.map(|node| mesh.node_tags[node as usize]),
        cells: cells.map(|cell| (mesh.cells[cell].tag, mesh.cells[cell].kind)),
        corner,
    }
}

/// The middle nodes of sides that are corners of other cells: the cell of the side, the
/// other cell, and the problem.
fn middles_at_corners(mesh: &PlaneMesh) -> Vec<(usize, usize, MeshProblem)> {
    let mut cell_at_corner = vec![None; mesh.nodes.len()];
    for (number, cell) in mesh.cells.iter().enumerate() {
        for &corner in cell.corners() {
            cell_at_corner[corner as usize] = Some(number);
        }
    }
    let mut found = Vec::new();
    for (number, cell) in mesh.cells.iter().enumerate() {
        for (ends, middle) in cell.kind.sides(cell.nodes()) {
            let Some(middle) = middle else {
                continue;
            };
            match cell_at_corner[middle as usize] {
                // a cell that lists a node twice is reported by another check
                Some(other) if other != number => {
                    let problem = hanging(mesh, ends, middle, [number, other], true);
                    found.push((number, other, problem));
                }
                _ => {}
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use shared_geom::mesh::{Cell, CellKind, Mesh, Node};

    use super::*;

    /// The messages for cells on these nodes, all tags from one.
    fn messages(positions: &[[f64; 2]], cells: &[(CellKind, &[u32])]) -> Vec<String> {
        let node = |(&[x, y], tag): (&[f64; 2], u64)| Node {
            tag,
            position: [x, y, 0.0].into(),
        };
        let cell = |(&(kind, nodes), tag): (&(CellKind, &[u32]), u64)| {
            Cell::new(tag, kind, 1, |i| nodes[i] - 1)
        };
        let mesh = Mesh {
            nodes: positions.iter().zip(1..).map(node).collect(),
            cells: cells.iter().zip(1..).map(cell).collect(),
            ..Mesh::default()
        };
        let found = sides(&PlaneMesh::new(&mesh), true);
        found.problems.iter().map(MeshProblem::to_string).collect()
    }

    /// ```text
    ///   4---7---3--10---9        tags; 8 is in the middle of 4 1, 6 of 2 3
    ///   |       |       |
    ///   8       6      11
    ///   |       |       |
    ///   1---5---2--12--13
    /// ```
    const POSITIONS: [[f64; 2]; 13] = [
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 2.0],
        [0.0, 2.0],
        [1.0, 0.0],
        [2.0, 1.0],
        [1.0, 2.0],
        [0.0, 1.0],
        [4.0, 2.0],
        [3.0, 2.0],
        [4.0, 1.0],
        [3.0, 0.0],
        [4.0, 0.0],
    ];
    const LEFT: (CellKind, &[u32]) = (CellKind::Quadrilateral8, &[1, 2, 3, 4, 5, 6, 7, 8]);

    #[test]
    fn a_linear_cell_beside_a_quadratic_one_lets_the_middle_hang() {
        let quadratic: &[u32] = &[2, 13, 9, 3, 12, 11, 10, 6];
        let fits = [LEFT, (CellKind::Quadrilateral8, quadratic)];
        assert!(messages(&POSITIONS, &fits).is_empty());
        for cells in [
            [LEFT, (CellKind::Quadrilateral4, &quadratic[..4])],
            [(CellKind::Quadrilateral4, &LEFT.1[..4]), fits[1]],
        ] {
            let [with, without] = match cells[0].0 {
                CellKind::Quadrilateral8 => [1, 2],
                _ => [2, 1],
            };
            let expected = format!(
                "node 6 at (2, 1) hangs in the middle of the side from node 2 to node 3: cell \
                 {with} (quadrilateral with 8 nodes) has it there, cell {without} \
                 (quadrilateral with 4 nodes) does not"
            );
            assert_eq!(messages(&POSITIONS, &cells), [expected]);
        }
    }

    #[test]
    fn a_middle_at_a_corner_hangs() {
        let right: &[u32] = &[6, 9, 3];
        assert_eq!(
            messages(&POSITIONS, &[LEFT, (CellKind::Triangle3, right)]),
            [
                "node 6 at (2, 1) hangs in the middle of the side from node 2 to node 3: cell 1 \
                 (quadrilateral with 8 nodes) has it there, cell 2 (triangle with 3 nodes) has \
                 a corner there"
            ]
        );
    }

    #[test]
    fn doubled_middles_are_reported() {
        let positions = [POSITIONS.as_slice(), &[[2.0, 1.0]]].concat();
        let right: &[u32] = &[2, 13, 9, 3, 12, 11, 10, 14];
        assert_eq!(
            messages(&positions, &[LEFT, (CellKind::Quadrilateral8, right)]),
            [
                "cells 1 and 2 share the side from node 2 to node 3 at (2, 1), but not the node \
                 in its middle"
            ]
        );
    }
}
