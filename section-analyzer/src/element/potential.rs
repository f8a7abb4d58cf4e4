//! The gradient of a potential at a section point, from the nodes of its cell.
//!
//! ```text
//! g = grad V = (V,y  V,z  (V' - a V,y - b V,z)/J)                                 (S-163)
//! ```
//!
//! # References
//! - \[Masarati\], appendix G: the potential of piezoelectric beams.

use super::line::Line;
use super::point::CellPoint;
use nalgebra::{Matrix3x6, RowVector6};

/// Six columns of a potential at the nodes of a cell; entries after its node count are not
/// read.
pub type NodalPotential = [RowVector6<f64>; 9];

/// The gradient at `point` of a beam along `line` of a `potential` that changes along the
/// beam by `rate`, six columns at once: rows y z x.
///
/// As in [`super::strain_at`], derivatives are taken of differences from the first node.
pub fn gradient_at(
    line: &Line,
    point: &CellPoint,
    rate: Option<&NodalPotential>,
    potential: &NodalPotential,
) -> Matrix3x6<f64> {
    let (mut along_y, mut along_z) = (RowVector6::zeros(), RowVector6::zeros());
    for i in 1..point.count {
        let difference = potential[i] - potential[0];
        along_y += point.dy[i] * difference;
        along_z += point.dz[i] * difference;
    }
    let mut along = RowVector6::zeros();
    if let Some(rate) = rate {
        let nodes = rate.iter().zip(&point.n).take(point.count);
        along += nodes.map(|(value, n)| *n * value).sum::<RowVector6<f64>>();
    }
    if !line.is_straight() {
        let metric = line.metric(point.y, point.z);
        along -= metric.tilt[0] * along_y + metric.tilt[1] * along_z;
        along /= metric.volume;
    }
    Matrix3x6::from_rows(&[along_y, along_z, along])
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;
    use shared_geom::mesh::CellKind;
    use shared_geom::rotation::skew;
    use shared_geom::section::InitialCurvature;

    /// A potential `V(s, y, z) = f . X` of the positions X in space of a turning section,
    /// with X = X0 + t, X' = l + k x t in section axes: at the section its gradient in
    /// space is f, with the same components along the axes y z x of the section. Round-off
    /// of numbers of order one.
    #[test]
    fn linear_potentials_of_space_have_their_gradient_on_curved_beams() {
        let initial = InitialCurvature {
            curvature: Vector3::new(0.4, -0.2, 0.3),
            slope: Vector3::new(0.9, 0.1, -0.2),
        };
        let line = Line::through(&initial, [0.0; 2], 1.0);
        let f = Vector3::new(0.7, -1.1, 0.4);
        let kind = CellKind::Quadrilateral9;
        let nodes: Vec<_> = kind
            .reference_nodes()
            .iter()
            .map(|&[r, s]| [0.3 + 0.2 * r - 0.1 * s, 0.1 * r + 0.2 * s + 0.03 * r * s])
            .collect();
        let (mut rate, mut potential) = ([RowVector6::zeros(); 9], [RowVector6::zeros(); 9]);
        for (i, [y, z]) in nodes.iter().enumerate() {
            let t = Vector3::new(0.0, *y, *z);
            potential[i][2] = f.dot(&t) + 1e3;
            rate[i][2] = f.dot(&(initial.slope + skew(&initial.curvature) * t));
        }
        let point = CellPoint::at(kind, &nodes, 0.3, -0.6, 1.0);
        let found = gradient_at(&line, &point, Some(&rate), &potential);
        let expected = Vector3::new(f.y, f.z, f.x);
        assert!((found.column(2) - expected).amax() < 1e-11);
        assert_eq!(found.column(0).amax(), 0.0);
    }
}
