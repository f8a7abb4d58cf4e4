//! Nodes at the same position, within a millionth of the size of their cells.
//!
//! Only nodes of the boundary are compared: an inner node can coincide with another only
//! if cells overlap.

use super::boundary::Boundary;
use super::plane::{PlaneMesh, distance};

/// Distance, relative to the shortest side of a cell, within which nodes coincide.
const NEARNESS: f64 = 1e-6;

/// Pairs of nodes (indices, the smaller first) at the same position, sorted; for more
/// than two at one position, pairs that connect them.
pub(super) fn coincident_nodes(mesh: &PlaneMesh, boundary: &Boundary) -> Vec<[u32; 2]> {
    let reach = reaches(mesh, boundary);
    let nodes: Vec<u32> = (0..mesh.nodes.len() as u32)
        .filter(|&node| reach[node as usize].is_finite())
        .collect();
    let known = nodes.iter().map(|&node| reach[node as usize]);
    let widest = known.fold(0.0, f64::max);
    if !(widest > 0.0 && widest.is_finite()) {
        return Vec::new();
    }
    let mut pairs = Vec::new();
    // strips of twice the reach, then the same ones shifted by half their width: two
    // coincident nodes share a strip at least once
    for shift in [0.0, 0.5] {
        let strip = |node: u32| (mesh.nodes[node as usize][0] / (2.0 * widest) + shift).floor();
        let height = |node: u32| mesh.nodes[node as usize][1];
        let mut order: Vec<(f64, f64, u32)> = nodes
            .iter()
            .map(|&node| (strip(node), height(node), node))
            .collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        for (i, &(strip, height, a)) in order.iter().enumerate() {
            let near = order[i + 1..]
                .iter()
                .take_while(|other| other.0 == strip && other.1 - height <= widest);
            for &(_, _, b) in near {
                let [p, q] = [a, b].map(|node| mesh.nodes[node as usize]);
                let reach = reach[a as usize].min(reach[b as usize]);
                if distance(p, q) <= reach {
                    // further nodes at this position follow from this one
                    pairs.push([a.min(b), a.max(b)]);
                    break;
                }
            }
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// For each node of the boundary the distance within which another node coincides with
/// it; infinite for all other nodes.
fn reaches(mesh: &PlaneMesh, boundary: &Boundary) -> Vec<f64> {
    let mut reach = vec![f64::INFINITY; mesh.nodes.len()];
    for side in &boundary.sides {
        let cell = &mesh.cells[side.cell];
        let size = NEARNESS * mesh.sides(cell).fold(f64::INFINITY, f64::min);
        for &node in side.ends.iter().chain(&side.middle) {
            let reach = &mut reach[node as usize];
            *reach = reach.min(size);
        }
    }
    reach
}
