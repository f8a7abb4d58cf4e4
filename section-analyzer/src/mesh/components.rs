//! The parts of a section: one is expected, connected through sides of cells.

use super::findings::NarrowGap;
use super::plane::{PlaneMesh, polygon_area};
use super::problem::{MeshProblem, Part};

/// Checks that all cells are connected through sides. `neighbors` are the pairs of cells
/// that share one, `coincident` the pairs of nodes at the same position, `gaps` possible
/// explanations, and `label(cell)` is the physical surface of a cell.
pub(super) fn check_connected(
    mesh: &PlaneMesh,
    neighbors: &[[usize; 2]],
    coincident: &[[u32; 2]],
    gaps: &[NarrowGap],
    label: impl Fn(usize) -> String,
) -> Result<(), MeshProblem> {
    let part_of_cell = part_of_each_cell(mesh.cells.len(), neighbors);
    let count = part_of_cell.iter().max().map_or(0, |&last| last + 1);
    if count <= 1 {
        return Ok(());
    }
    let mut parts = describe(mesh, &part_of_cell, count, label);
    parts.sort_by_key(|part| std::cmp::Reverse(part.cells));
    let (part_of_node, touching) = parts_at_nodes(mesh, &part_of_cell);
    let tag = |node: u32| mesh.node_tags[node as usize];
    let part = |node: u32| part_of_node[node as usize];
    let apart = coincident.iter().filter(|[a, b]| part(*a) != part(*b));
    Err(MeshProblem::Disconnected {
        parts,
        touching: touching.into_iter().map(tag).collect(),
        coincident: apart.map(|pair| pair.map(tag)).collect(),
        gaps: gaps.to_vec(),
    })
}

/// The index of the part of each cell, in the order of the first cells of the parts.
pub(super) fn part_of_each_cell(cells: usize, neighbors: &[[usize; 2]]) -> Vec<usize> {
    // union-find; the smallest cell of a part represents it
    let mut parent: Vec<usize> = (0..cells).collect();
    for &[a, b] in neighbors {
        let (a, b) = (root(&mut parent, a), root(&mut parent, b));
        parent[a.max(b)] = a.min(b);
    }
    let mut number = vec![0; cells];
    let mut count = 0;
    for cell in 0..cells {
        let root = root(&mut parent, cell);
        if root == cell {
            number[cell] = count;
            count += 1;
        } else {
            number[cell] = number[root];
        }
    }
    number
}

/// The representative of the set of `cell` in a union-find.
pub(super) fn root(parent: &mut [usize], mut cell: usize) -> usize {
    while parent[cell] != cell {
        parent[cell] = parent[parent[cell]];
        cell = parent[cell];
    }
    cell
}

/// The first part that uses each node, and the nodes that several parts use.
fn parts_at_nodes(mesh: &PlaneMesh, part_of_cell: &[usize]) -> (Vec<Option<usize>>, Vec<u32>) {
    let mut parts = vec![None; mesh.nodes.len()];
    let mut touching = Vec::new();
    for (cell, &part) in mesh.cells.iter().zip(part_of_cell) {
        for &node in cell.nodes() {
            match parts[node as usize] {
                None => parts[node as usize] = Some(part),
                Some(first) if first != part => touching.push(node),
                Some(_) => {}
            }
        }
    }
    touching.sort_unstable();
    touching.dedup();
    (parts, touching)
}

fn describe(
    mesh: &PlaneMesh,
    part_of_cell: &[usize],
    count: usize,
    label: impl Fn(usize) -> String,
) -> Vec<Part> {
    let empty = Part {
        cells: 0,
        centroid: [0.0; 2],
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
        groups: Vec::new(),
    };
    let mut parts = vec![empty; count];
    let mut areas = vec![0.0; count];
    for ((number, cell), &of) in mesh.cells.iter().enumerate().zip(part_of_cell) {
        let part = &mut parts[of];
        let weight = polygon_area(mesh.corners(cell)).abs();
        let center = mesh.center(cell);
        part.cells += 1;
        areas[of] += weight;
        for axis in 0..2 {
            // running mean, which is safe for cells without area
            if weight > 0.0 || areas[of] == 0.0 {
                let share = if weight > 0.0 {
                    weight / areas[of]
                } else {
                    1.0
                };
                part.centroid[axis] += share * (center[axis] - part.centroid[axis]);
            }
            for corner in mesh.corners(cell) {
                part.low[axis] = part.low[axis].min(corner[axis]);
                part.high[axis] = part.high[axis].max(corner[axis]);
            }
        }
        let label = label(number);
        if !part.groups.contains(&label) {
            part.groups.push(label);
        }
    }
    parts
}
