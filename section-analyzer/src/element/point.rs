//! A cell at a point: shape functions, their gradients in section axes, and the area that
//! an integration point represents.

use std::sync::LazyLock;

use shared_geom::lagrange::ShapeValues;
use shared_geom::mesh::CellKind;

/// Shape functions of a cell and their gradients at one point.
#[derive(Debug, Clone, Copy)]
pub struct CellPoint {
    /// Number of nodes; entries of the arrays from there on are zero.
    pub count: usize,
    /// Shape functions \[-\].
    pub n: [f64; 9],
    /// Their derivatives along y \[1/m\].
    pub dy: [f64; 9],
    /// Their derivatives along z \[1/m\].
    pub dz: [f64; 9],
    /// Position of the point: y \[m\].
    pub y: f64,
    /// Position of the point: z \[m\].
    pub z: f64,
    /// Quadrature weight times Jacobian determinant \[m^2\]. Not positive where
    /// the cell is inverted or has no area; the gradients are meaningless there.
    pub area: f64,
}

impl CellPoint {
    /// The cell with `nodes` (y, z), at (r, s) of its reference cell, where the
    /// quadrature weight is `weight`.
    ///
    /// ```text
    /// J = [ y,r  z,r ]     [ N,y ]        [ N,r ]
    ///     [ y,s  z,s ]     [ N,z ] = J^-1 [ N,s ]
    /// ```
    pub fn at(kind: CellKind, nodes: &[[f64; 2]], r: f64, s: f64, weight: f64) -> Self {
        Self::of_shape(&kind.shape(r, s), nodes, weight)
    }

    #[inline(always)]
    fn of_shape(shape: &ShapeValues, nodes: &[[f64; 2]], weight: f64) -> Self {
        let along = |values: &[f64; 9], axis: usize| -> f64 {
            let terms = nodes.iter().zip(values);
            terms.map(|(node, n)| node[axis] * n).sum()
        };
        let (y_r, z_r) = (along(&shape.dr, 0), along(&shape.dr, 1));
        let (y_s, z_s) = (along(&shape.ds, 0), along(&shape.ds, 1));
        let jacobian = y_r * z_s - z_r * y_s;

        let mut point = Self {
            count: shape.count,
            n: shape.n,
            dy: [0.0; 9],
            dz: [0.0; 9],
            y: along(&shape.n, 0),
            z: along(&shape.n, 1),
            area: weight * jacobian,
        };
        for i in 0..shape.count {
            point.dy[i] = (z_s * shape.dr[i] - z_r * shape.ds[i]) / jacobian;
            point.dz[i] = (y_r * shape.ds[i] - y_s * shape.dr[i]) / jacobian;
        }
        point
    }
}

/// Shape functions at a point of the integration rule of a kind of cells, with the
/// weight of the point.
#[derive(Debug, Clone, Copy)]
pub struct RulePoint {
    shape: ShapeValues,
    weight: f64,
}

impl RulePoint {
    /// The cell with `nodes` (y, z) at this point.
    #[inline(always)]
    pub fn of_cell(&self, nodes: &[[f64; 2]]) -> CellPoint {
        CellPoint::of_shape(&self.shape, nodes, self.weight)
    }
}

/// The rules of all kinds, in the order of their numbers.
static RULES: LazyLock<[Vec<RulePoint>; 5]> = LazyLock::new(|| {
    CellKind::ALL.map(|kind| {
        let points = kind.rule().iter();
        let values = points.map(|point| RulePoint {
            shape: kind.shape(point.r, point.s),
            weight: point.weight,
        });
        values.collect()
    })
});

/// The points of the integration rule of a kind of cells.
pub fn rule_points(kind: CellKind) -> &'static [RulePoint] {
    // the kinds are numbered in the order of `CellKind::ALL`
    &RULES[kind as usize]
}

/// The cell at the points of its integration rule.
pub fn cell_points(kind: CellKind, nodes: &[[f64; 2]]) -> impl Iterator<Item = CellPoint> {
    rule_points(kind).iter().map(|point| point.of_cell(nodes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Any affine image of the reference cell has the gradients of a linear
    /// field exact: y itself has gradient (1, 0), z has (0, 1).
    #[test]
    fn gradients_of_the_coordinates_are_the_unit_vectors() {
        for kind in CellKind::ALL {
            let nodes: Vec<[f64; 2]> = kind
                .reference_nodes()
                .iter()
                .map(|&[r, s]| [2.0 + 0.7 * r - 0.3 * s, -1.0 + 0.2 * r + 0.5 * s])
                .collect();
            for point in cell_points(kind, &nodes) {
                let sum = |values: &[f64; 9], axis: usize| -> f64 {
                    nodes.iter().zip(values).map(|(p, v)| p[axis] * v).sum()
                };
                assert_relative_eq!(sum(&point.dy, 0), 1.0, epsilon = 1e-13);
                assert_relative_eq!(sum(&point.dz, 1), 1.0, epsilon = 1e-13);
                assert_relative_eq!(sum(&point.dy, 1), 0.0, epsilon = 1e-13);
                assert_relative_eq!(sum(&point.dz, 0), 0.0, epsilon = 1e-13);
            }
        }
    }

    /// The rules are indexed by the number of the kind.
    #[test]
    fn kinds_are_numbered_in_the_order_of_their_list() {
        for (number, kind) in CellKind::ALL.into_iter().enumerate() {
            assert_eq!(kind as usize, number);
            assert_eq!(rule_points(kind).len(), kind.rule().len());
        }
    }

    /// Area of the affine image: |0.7 * 0.5 + 0.3 * 0.2| = 0.41 times the area of the
    /// reference cell (1/2 or 4).
    #[test]
    fn areas_add_up_to_the_cell() {
        for kind in CellKind::ALL {
            let nodes: Vec<[f64; 2]> = kind
                .reference_nodes()
                .iter()
                .map(|&[r, s]| [0.7 * r - 0.3 * s, 0.2 * r + 0.5 * s])
                .collect();
            let reference = if kind.corner_count() == 3 { 0.5 } else { 4.0 };
            let area: f64 = cell_points(kind, &nodes).map(|p| p.area).sum();
            assert_relative_eq!(area, 0.41 * reference, max_relative = 1e-14);
        }
    }
}
