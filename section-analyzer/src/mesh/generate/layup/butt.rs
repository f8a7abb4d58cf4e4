//! A web at the trailing edge, on which the layers of both sides end.
//!
//! ```text
//!   suction side ----------.--.
//!           layers         |  |
//!              ------------|  |
//!                          |  |  plies of the web, along the whole base
//!              ------------|  |
//!           layers         |  |
//!   pressure side ---------'--'
//! ```
//!
//! The end columns of both sides lie on the base, so that their nodes are nodes of the web, whose
//! plies lie behind it, the first one on the base.

use super::super::super::distance;
use super::super::grid::Grid;
use super::types::Web;

/// Least number of cells between the layers of both sides.
const LEAST: f64 = 2.0;
/// Largest number of cells between them.
const MOST: f64 = 2000.0;

/// Nodes and cells of a web behind the end columns of both sides, suction and pressure, whose nodes
/// are given from the outside in; cells are at most `size` long.
pub(super) fn add_butt(web: &Web, ends: [&[u32]; 2], size: f64, grid: &mut Grid) {
    let fore = along_base(ends, size, grid);
    let base: Vec<[f64; 2]> = fore.iter().map(|node| grid.position(*node)).collect();
    let [from, to] = [base[0], base[base.len() - 1]];
    let length = distance(from, to);
    let behind = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    let (mut depth, mut last) = (0.0, fore.clone());
    for ply in &web.plies {
        let names = [ply.name.clone(), format!("{}@{}", ply.name, web.name)];
        let cells = (ply.thickness / (2.0 * size)).ceil().clamp(1.0, 50.0);
        for _ in 0..cells as usize {
            depth += ply.thickness / cells;
            let at = |p: &[f64; 2]| [0, 1].map(|i| p[i] + depth * behind[i]);
            let next: Vec<u32> = base.iter().map(|p| grid.node(at(p))).collect();
            grid.strip([&next, &last], &names);
            last = next;
        }
    }
    let upward: Vec<u32> = fore.into_iter().rev().collect();
    grid.curve(&upward, std::slice::from_ref(&web.name));
}

/// The nodes on the base from the suction to the pressure side: the ones of the end columns, and new
/// ones between them.
fn along_base([suction, pressure]: [&[u32]; 2], size: f64, grid: &mut Grid) -> Vec<u32> {
    let ends = [suction, pressure].map(|end| end[end.len() - 1]);
    let [from, to] = ends.map(|node| grid.position(node));
    let cells = (distance(from, to) / size).ceil().clamp(LEAST, MOST);
    let mut nodes = suction.to_vec();
    nodes.extend(grid.divided(ends, cells as usize));
    nodes.extend(pressure.iter().rev());
    // layers that are absent have no nodes of their own
    nodes.dedup();
    nodes
}
