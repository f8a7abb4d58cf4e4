//! The parts of the structure.

use super::domain::Domain;

/// First node of each part of the structure that shares no node with the others; parts of
/// cells with stiffness.
pub fn structural_parts(domain: &Domain) -> Vec<usize> {
    let count = domain.nodes.len();
    let mut parent: Vec<u32> = (0..count as u32).collect();
    fn root(parent: &mut [u32], mut node: u32) -> u32 {
        while parent[node as usize] != node {
            parent[node as usize] = parent[parent[node as usize] as usize];
            node = parent[node as usize];
        }
        node
    }
    for cell in &domain.cells {
        let nodes = cell.nodes();
        if nodes
            .iter()
            .any(|&n| !domain.electric.is_structural(n as usize))
        {
            continue;
        }
        if domain.laws[cell.law as usize].iter().all(|&c| c == 0.0) {
            continue;
        }
        let first = root(&mut parent, nodes[0]);
        for &node in &nodes[1..] {
            let other = root(&mut parent, node);
            parent[other as usize] = first;
        }
    }
    let structural = (0..count).filter(|&node| domain.electric.is_structural(node));
    structural
        .filter(|&node| parent[node] == node as u32)
        .collect()
}
