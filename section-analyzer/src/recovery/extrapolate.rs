//! From the integration points of a cell to its nodes.
//!
//! A polynomial of one degree less than the warping is fitted to the values at the
//! integration points, weighted with their areas, and evaluated at the nodes:
//!
//! ```text
//! min_c sum_p A_p (b_p' c - f_p)^2        f_i = b_i' c = sum_p W_ip f_p           (S-51)
//! b = (1, a, b)  or, in quadrilaterals of 8 and 9 nodes,  (1, a, b, r s)
//! (a, b) = J0^-1 (y - y0, z - z0)         J0: Jacobian in the middle of the cell
//! ```
//!
//! Strains of a displacement of degree p are more accurate by an order at the points of the
//! rule of one point less in each direction (2 x 2 in quadrilaterals of 8 and 9 nodes) than
//! elsewhere. The fit passes through the values there: on a parallelogram it drops the
//! second Legendre polynomial, which is zero at exactly these points. The strain evaluated
//! at the nodes, where that polynomial is largest, would contain it in full. `a` and `b`
//! are linear in the position on curved cells too, so that stresses linear over the section
//! are reproduced exactly on any cell.
//!
//! # References
//! - \[HintonCampbell1974\]: local least-squares smoothing, and its equality to
//!   extrapolation from the reduced rule.
//! - \[Barlow1976\]: points of highest accuracy of the stresses in a cell.

use crate::element::CellPoint;
use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};
use shared_geom::mesh::CellKind;

/// W of a cell: row node, column integration point \[-\].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Extrapolation {
    weights: Vec<f64>,
    points: usize,
}

impl Extrapolation {
    /// The weights of the cell with `nodes` (y, z) and the points of its rule.
    pub fn new(kind: CellKind, nodes: &[[f64; 2]], points: &[CellPoint]) -> Self {
        let basis = Basis::new(kind, nodes);
        let area: f64 = points.iter().map(|point| point.area).sum();
        let at_points: Vec<(Vector4<f64>, f64)> = kind
            .rule()
            .iter()
            .zip(points)
            .map(|(at, point)| (basis.at(at.r, at.s, [point.y, point.z]), point.area / area))
            .collect();
        // with three functions the fourth is zero: a one keeps the matrix regular
        let mut normal = Matrix4::zeros();
        normal[(3, 3)] = if basis.has_twist { 0.0 } else { 1.0 };
        for (b, weight) in &at_points {
            normal += *weight * b * b.transpose();
        }
        // a cell too distorted for a fit has its mean at all nodes
        let fit = normal.cholesky().map(|factor| factor.inverse());
        let weight = |at_node: &Vector4<f64>, (b, weight): &(Vector4<f64>, f64)| match &fit {
            Some(fit) => weight * at_node.dot(&(fit * b)),
            None => *weight,
        };
        let at_nodes = kind
            .reference_nodes()
            .iter()
            .zip(nodes)
            .map(|(&[r, s], &position)| basis.at(r, s, position));
        Self {
            weights: at_nodes
                .flat_map(|node| at_points.iter().map(move |point| (node, point)))
                .map(|(node, point)| weight(&node, point))
                .collect(),
            points: points.len(),
        }
    }

    /// The weights of the points for each node.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.weights.chunks_exact(self.points)
    }
}

/// The functions of the fit.
struct Basis {
    center: [f64; 2],
    to_affine: Matrix2<f64>,
    has_twist: bool,
}

impl Basis {
    fn new(kind: CellKind, nodes: &[[f64; 2]]) -> Self {
        let (r, s) = match kind.corner_count() {
            3 => (1.0 / 3.0, 1.0 / 3.0),
            _ => (0.0, 0.0),
        };
        let shape = kind.shape(r, s);
        let along = |values: &[f64; 9], axis: usize| -> f64 {
            let terms = nodes.iter().zip(values).map(|(node, n)| node[axis] * n);
            terms.sum()
        };
        let jacobian = Matrix2::new(
            along(&shape.dr, 0),
            along(&shape.ds, 0),
            along(&shape.dr, 1),
            along(&shape.ds, 1),
        );
        Self {
            center: [along(&shape.n, 0), along(&shape.n, 1)],
            to_affine: jacobian.try_inverse().unwrap_or_else(Matrix2::zeros),
            has_twist: kind.corner_count() == 4 && kind.is_quadratic(),
        }
    }

    fn at(&self, r: f64, s: f64, [y, z]: [f64; 2]) -> Vector4<f64> {
        let affine = self.to_affine * Vector2::new(y - self.center[0], z - self.center[1]);
        let twist = if self.has_twist { r * s } else { 0.0 };
        Vector4::new(1.0, affine.x, affine.y, twist)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell_points;

    /// A cell of moderate shape; of quadratic kinds, curved.
    fn curved(kind: CellKind) -> Vec<[f64; 2]> {
        let position = |&[r, s]: &[f64; 2]| {
            let bend = if kind.is_quadratic() { 0.1 } else { 0.0 };
            [
                2.0 + 0.7 * r - 0.3 * s + bend * s * s,
                -1.0 + 0.2 * r + 0.5 * s - bend * r * s,
            ]
        };
        kind.reference_nodes().iter().map(position).collect()
    }

    fn extrapolated(
        kind: CellKind,
        nodes: &[[f64; 2]],
        field: impl Fn(f64, f64) -> f64,
    ) -> Vec<f64> {
        let points: Vec<_> = cell_points(kind, nodes).collect();
        let values: Vec<_> = points.iter().map(|p| field(p.y, p.z)).collect();
        let fit = Extrapolation::new(kind, nodes, &points);
        let at = |row: &[f64]| row.iter().zip(&values).map(|(w, f)| w * f).sum();
        fit.rows().map(at).collect()
    }

    /// Linear fields are reproduced to round-off on curved cells of every kind.
    #[test]
    fn linear_fields_are_kept() {
        let field = |y: f64, z: f64| 3.0 - 2.0 * y + 5.0 * z;
        for kind in CellKind::ALL {
            let nodes = curved(kind);
            let found = extrapolated(kind, &nodes, field);
            assert_eq!(found.len(), kind.node_count());
            for (value, [y, z]) in found.iter().zip(&nodes) {
                assert!((value - field(*y, *z)).abs() < 1e-12, "{kind:?} {value}");
            }
        }
    }

    /// On a square of side 2 the fit to z^2 passes through its values at z = +-1/sqrt 3:
    /// 1/3 everywhere. Extrapolation in the cell's own functions would give 1 and 0.
    #[test]
    fn fit_goes_through_the_values_at_the_reduced_rule() {
        for kind in [CellKind::Quadrilateral8, CellKind::Quadrilateral9] {
            for value in extrapolated(kind, kind.reference_nodes(), |_, z| z * z) {
                assert!((value - 1.0 / 3.0).abs() < 1e-14, "{kind:?} {value}");
            }
        }
    }
}
