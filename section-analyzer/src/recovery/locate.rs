//! Search for the cell that contains a point.

use crate::element::CellPoint;
use crate::mesh::SectionMesh;
use shared_geom::mesh::CellKind;

/// Distance outside the reference cell up to which a point is treated as inside: round-off
/// of points on a side.
const MARGIN: f64 = 1e-9;

/// Maximum number of Newton steps of the inverse map; valid cells need three to five.
const STEPS: usize = 30;

/// Part of a cell's bounding box by which curved sides may extend beyond its nodes.
const BULGE: f64 = 0.3;

/// A point within a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Located {
    /// Cell: index in the mesh.
    pub cell: usize,
    /// First reference coordinate \[-\].
    pub r: f64,
    /// Second reference coordinate \[-\].
    pub s: f64,
}

/// The cell that contains `position` (y, z); the first of several on a common side.
pub(super) fn locate(mesh: &SectionMesh, position: [f64; 2]) -> Option<Located> {
    mesh.cells.iter().enumerate().find_map(|(index, cell)| {
        let nodes: Vec<_> = mesh.positions(cell).collect();
        if !near_box(&nodes, position) {
            return None;
        }
        let (r, s) = inverted(cell.kind, &nodes, position)?;
        let cell = index;
        (outside(mesh.cells[index].kind, r, s) <= MARGIN).then_some(Located { cell, r, s })
    })
}

fn near_box(nodes: &[[f64; 2]], position: [f64; 2]) -> bool {
    let bounds = |axis: usize| {
        let values = nodes.iter().map(|node| node[axis]);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        })
    };
    let (y, z) = (bounds(0), bounds(1));
    let margin = BULGE * (y.1 - y.0).max(z.1 - z.0);
    let within = |(low, high): (f64, f64), x: f64| low - margin <= x && x <= high + margin;
    within(y, position[0]) && within(z, position[1])
}

/// Reference coordinates of `position` by Newton's method from the middle.
///
/// ```text
/// r <- r + J^-T (position - sum N_i(r) x_i)
/// ```
fn inverted(kind: CellKind, nodes: &[[f64; 2]], position: [f64; 2]) -> Option<(f64, f64)> {
    let (mut r, mut s) = match kind.corner_count() {
        3 => (1.0 / 3.0, 1.0 / 3.0),
        _ => (0.0, 0.0),
    };
    for _ in 0..STEPS {
        let at = CellPoint::at(kind, nodes, r, s, 1.0);
        let (dy, dz) = (position[0] - at.y, position[1] - at.z);
        // r as a function of the position has the gradient of its own interpolation
        let (mut step_r, mut step_s) = (0.0, 0.0);
        for (i, [node_r, node_s]) in kind.reference_nodes().iter().enumerate() {
            let slope = at.dy[i] * dy + at.dz[i] * dz;
            step_r += node_r * slope;
            step_s += node_s * slope;
        }
        if !(step_r.is_finite() && step_s.is_finite()) {
            return None;
        }
        r += step_r;
        s += step_s;
        if step_r.abs().max(step_s.abs()) < 1e-3 * MARGIN {
            return Some((r, s));
        }
    }
    None
}

/// Distance of (r, s) outside the reference cell; negative inside.
fn outside(kind: CellKind, r: f64, s: f64) -> f64 {
    match kind.corner_count() {
        3 => (-r).max(-s).max(r + s - 1.0),
        _ => (r.abs() - 1.0).max(s.abs() - 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::coupled_rectangle;

    /// The integration points of curved cells are located, to round-off over the size of a
    /// cell (1e-15 / 0.5) and Newton's last step.
    #[test]
    fn points_of_curved_cells_are_found() {
        for kind in CellKind::ALL {
            let mesh = coupled_rectangle(kind).mesh;
            for (index, cell) in mesh.cells.iter().enumerate() {
                for point in kind.rule() {
                    let at = CellPoint::at(
                        kind,
                        &mesh.positions(cell).collect::<Vec<_>>(),
                        point.r,
                        point.s,
                        point.weight,
                    );
                    let found = locate(&mesh, [at.y, at.z]).unwrap();
                    assert_eq!(found.cell, index);
                    assert!((found.r - point.r).abs() < 1e-11, "{kind:?}");
                    assert!((found.s - point.s).abs() < 1e-11, "{kind:?}");
                }
            }
        }
    }

    #[test]
    fn nodes_are_found_and_positions_outside_are_not() {
        let mesh = coupled_rectangle(CellKind::Quadrilateral9).mesh;
        assert!(mesh.nodes.iter().all(|&node| locate(&mesh, node).is_some()));
        assert_eq!(locate(&mesh, [10.0, 0.0]), None);
        let corner = mesh.nodes[mesh.cells[0].nodes()[0] as usize];
        assert_eq!(locate(&mesh, [corner[0] - 1e-3, corner[1] - 1e-3]), None);
    }
}
