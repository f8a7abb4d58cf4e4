//! Orientation of the cells: all of them counterclockwise, none inverted.
//!
//! The Jacobian determinant `J = y,r z,s - y,s z,r` of the mapping from the
//! reference cell must have one sign in the whole cell: in corners and integration
//! points and between them.

use std::collections::HashMap;

use shared_geom::mesh::{Cell, CellKind};

use super::jacobian::Jacobian;
use super::plane::{PlaneMesh, distance};
use super::problem::{Inversion, MeshProblem, limited};

/// Smallest Jacobian relative to the largest of the cell, below which the cell is treated
/// as inverted: far above rounding, far below any useful cell.
const LEAST_RATIO: f64 = 1e-10;
/// Largest Jacobian relative to the square of the longest side, below which the
/// cell has no area.
const LEAST_AREA: f64 = 1e-13;

/// Direction of the nodes of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Turn {
    Counterclockwise,
    Clockwise,
}

/// Reverses the cells of clockwise surfaces; returns their number, or the cells that are
/// inverted or whose direction differs from the others of their surface.
pub(super) fn orient(mesh: &mut PlaneMesh) -> Result<usize, Vec<MeshProblem>> {
    let jacobian = Jacobian::new();
    let mut problems = Vec::new();
    let mut turns = Vec::with_capacity(mesh.cells.len());
    let mut counts: HashMap<i32, [usize; 2]> = HashMap::new();
    for cell in &mesh.cells {
        let mut positions = [[0.0; 2]; 9];
        for (position, &node) in positions.iter_mut().zip(cell.nodes()) {
            *position = mesh.nodes[node as usize];
        }
        let extremes = jacobian.extremes(cell.kind, &positions[..cell.nodes().len()]);
        let turn = turn(extremes, mesh.longest_side(cell));
        turns.push(turn);
        match turn {
            Some(turn) => counts.entry(cell.entity).or_default()[turn as usize] += 1,
            None => problems.push(MeshProblem::InvertedCell {
                cell: cell.tag,
                center: mesh.center(cell),
                reason: reason(mesh, cell),
            }),
        }
    }
    let mut problems = limited(problems, "inverted cells");
    problems.extend(limited(
        disagreeing(mesh, &turns, &counts),
        "inverted cells",
    ));
    if !problems.is_empty() {
        return Err(problems);
    }
    let mut reversed = 0;
    for (cell, turn) in mesh.cells.iter_mut().zip(turns) {
        if turn == Some(Turn::Clockwise) {
            *cell = cell.reversed();
            reversed += 1;
        }
    }
    Ok(reversed)
}

/// The direction of a cell; `None` if its Jacobian changes sign or vanishes.
fn turn([low, high]: [f64; 2], side: f64) -> Option<Turn> {
    let least = LEAST_AREA * side * side;
    if high > least && low > LEAST_RATIO * high {
        Some(Turn::Counterclockwise)
    } else if low < -least && high < LEAST_RATIO * low {
        Some(Turn::Clockwise)
    } else {
        None
    }
}

/// The cells whose direction is opposite to most cells of their surface.
fn disagreeing(
    mesh: &PlaneMesh,
    turns: &[Option<Turn>],
    counts: &HashMap<i32, [usize; 2]>,
) -> Vec<MeshProblem> {
    let mut problems = Vec::new();
    for (cell, turn) in mesh.cells.iter().zip(turns) {
        let Some(turn) = turn else { continue };
        let Some(&[counterclockwise, clockwise]) = counts.get(&cell.entity) else {
            continue;
        };
        let usual = if clockwise > counterclockwise {
            Turn::Clockwise
        } else {
            Turn::Counterclockwise
        };
        if *turn != usual {
            problems.push(MeshProblem::TurnedCell {
                cell: cell.tag,
                center: mesh.center(cell),
                entity: cell.entity,
                others: counterclockwise.max(clockwise),
            });
        }
    }
    problems
}

/// The likely reason why a cell is inverted.
fn reason(mesh: &PlaneMesh, cell: &Cell) -> Inversion {
    if let Some(node) = repeated(cell) {
        let node = mesh.node_tags[node as usize];
        return Inversion::Repeated { node };
    }
    let corners: Vec<[f64; 2]> = mesh.corners(cell).collect();
    let count = corners.len();
    let cross = |i: usize| {
        let (a, b, c) = (
            corners[(i + count - 1) % count],
            corners[i],
            corners[(i + 1) % count],
        );
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    let crosses: Vec<f64> = (0..count).map(cross).collect();
    let longest = mesh.longest_side(cell);
    let least = LEAST_AREA * longest * longest;
    if crosses.iter().all(|cross| cross.abs() <= least) {
        return Inversion::NoArea;
    }
    // the corners whose sign differs from the sign of the sum
    let sum: f64 = crosses.iter().sum();
    let worst = (0..count).min_by(|&a, &b| (crosses[a] * sum).total_cmp(&(crosses[b] * sum)));
    if let Some(worst) = worst
        && crosses[worst] * sum.signum() <= least
    {
        let node = mesh.node_tags[cell.corners()[worst] as usize];
        return Inversion::Corner { node };
    }
    farthest_middle(mesh, cell, longest).unwrap_or(Inversion::NoArea)
}

/// A node that the cell lists more than once.
fn repeated(cell: &Cell) -> Option<u32> {
    let nodes = cell.nodes();
    let mut numbered = nodes.iter().enumerate();
    numbered.find_map(|(i, node)| nodes[..i].contains(node).then_some(*node))
}

/// The node farthest from the middle of its side or of the cell.
fn farthest_middle(mesh: &PlaneMesh, cell: &Cell, longest: f64) -> Option<Inversion> {
    let position = |local: usize| mesh.nodes[cell.nodes()[local] as usize];
    let sides = (0..cell.kind.corner_count()).filter_map(|side| {
        let (a, b, middle) = cell.kind.side(side);
        let (a, b) = (position(a), position(b));
        let mean = [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]));
        Some((middle?, distance(position(middle?), mean) / distance(a, b)))
    });
    let center = (cell.kind == CellKind::Quadrilateral9)
        .then(|| (8, distance(position(8), mesh.center(cell)) / longest));
    let (local, distance) = sides.chain(center).max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(Inversion::Middle {
        node: mesh.node_tags[cell.nodes()[local] as usize],
        distance,
    })
}
