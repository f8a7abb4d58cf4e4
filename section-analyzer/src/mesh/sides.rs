//! The sides of the cells: which cells meet at them, and whether they fit.

use std::collections::HashMap;

use super::plane::PlaneMesh;
use super::problem::{MeshProblem, limited};

/// A side, as the first cell that has it sees it.
#[derive(Debug, Clone, Copy)]
struct Side {
    cell: usize,
    /// First corner, counterclockwise in that cell.
    first: u32,
    middle: Option<u32>,
    /// Whether a second cell has been met.
    met: bool,
}

/// What the sides tell.
#[derive(Debug)]
pub(super) struct Sides {
    /// Pairs of cells (indices) that share a side.
    pub(super) neighbors: Vec<[usize; 2]>,
    /// Overlapping cells and sides that do not fit.
    pub(super) problems: Vec<MeshProblem>,
}

/// Goes through the sides of all cells. `oriented` tells whether all cells are
/// counterclockwise, so that neighbors run through their side in opposite directions.
pub(super) fn sides(mesh: &PlaneMesh, oriented: bool) -> Sides {
    let mut sides: HashMap<[u32; 2], Side> = HashMap::with_capacity(2 * mesh.cells.len());
    let (mut neighbors, mut overlaps, mut gaps) = (Vec::new(), Vec::new(), Vec::new());
    for (number, cell) in mesh.cells.iter().enumerate() {
        for side in 0..cell.kind.corner_count() {
            let (a, b, middle) = cell.kind.side(side);
            let [first, second] = [a, b].map(|local| cell.nodes()[local]);
            let middle = middle.map(|local| cell.nodes()[local]);
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
            // A cell that meets itself lists a node twice: told with the cell.
            if new || side.cell == number {
                continue;
            }
            let cells = [side.cell, number].map(|cell| mesh.cells[cell].tag);
            let nodes = key.map(|node| mesh.node_tags[node as usize]);
            if side.met || (oriented && side.first == first) {
                overlaps.push(MeshProblem::Overlap { cells, nodes });
            } else if side.middle != middle {
                gaps.push(MeshProblem::SideMiddle { cells, nodes });
            }
            side.met = true;
            neighbors.push([side.cell, number]);
        }
    }
    let mut problems = limited(overlaps, "overlapping cells");
    problems.extend(limited(gaps, "sides without a common middle"));
    Sides {
        neighbors,
        problems,
    }
}
