//! A side of a cell, and its surface along the beam.
//!
//! With the tangent g1 = (J, a, b) of a material line (S-71) and s = (0, dy, dz) along
//! the side, a piece of the surface has per length of the line
//!
//! ```text
//! n dS = s x g1 = (b dy - a dz, J dz, -J dy)      dS = |s x g1|                   (S-102)
//! ```
//!
//! where n points to the right of the side: outward, if the cell lies at the left. On a
//! straight beam dS is the length of the side.

use super::line::Line;
use nalgebra::Vector3;
use shared_geom::lagrange::{LineValues, line2, line3};
use shared_geom::quadrature;

/// Gauss points on a side: exact for polynomials of degree seven, and so for pressure on
/// quadratic sides of beams of any curvature.
const POINTS: usize = 4;

/// A side at a point of its rule.
#[derive(Debug, Clone, Copy)]
pub struct SidePoint {
    /// Shape functions of its nodes \[-\].
    pub n: [f64; 3],
    /// Surface per length of the line, with the weight of the point, along its normal
    /// to the right of the side \[m\].
    pub surface: Vector3<f64>,
    /// Unit vector along the side \[-\].
    pub tangent: Vector3<f64>,
}

/// The side through `nodes` (y, z), first end, second end, middle, at the points of its
/// rule, of a beam along `line`.
pub fn side_points<'a>(
    line: &'a Line,
    nodes: &'a [[f64; 2]],
) -> impl Iterator<Item = SidePoint> + 'a {
    let rule = quadrature::line(POINTS).iter();
    rule.map(move |&(xi, weight)| side_point(line, nodes, xi, weight))
}

fn side_point(line: &Line, nodes: &[[f64; 2]], xi: f64, weight: f64) -> SidePoint {
    let shape: LineValues = match nodes.len() {
        2 => line2(xi),
        _ => line3(xi),
    };
    let sum = |values: &[f64; 3], axis: usize| -> f64 {
        nodes.iter().zip(values).map(|(p, n)| p[axis] * n).sum()
    };
    let along = Vector3::new(0.0, sum(&shape.d, 0), sum(&shape.d, 1));
    let metric = line.metric(sum(&shape.n, 0), sum(&shape.n, 1));
    let material = Vector3::new(metric.volume, metric.tilt[0], metric.tilt[1]);
    let length = along.norm();
    SidePoint {
        n: shape.n,
        surface: weight * along.cross(&material),
        tangent: if length > 0.0 { along / length } else { along },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The surface of a piece of a helicoidal beam by its parts: two triangles of its four
    /// corners in space, for a decreasing side and length; the difference decreases with
    /// the size.
    #[test]
    fn surface_is_that_of_the_beam_in_space() {
        let line = Line {
            curvature: Vector3::new(0.4, -0.3, 0.7),
            slope: Vector3::new(0.9, 0.2, -0.1),
        };
        let (start, way) = ([0.3, -0.2], [0.6, 0.35]);
        let position = |x: f64, t: f64| {
            let frame = nalgebra::Rotation3::new(x * line.curvature);
            let p = Vector3::new(0.0, start[0] + t * way[0], start[1] + t * way[1]);
            x * line.slope + frame * p
        };
        let h = 1e-5;
        let (o, along, side) = (position(0.0, 0.0), position(h, 0.0), position(0.0, h));
        let opposite = position(h, h);
        let piece = 0.5 * (side - o).cross(&(along - o))
            + 0.5 * (along - opposite).cross(&(side - opposite));
        let end = [start[0] + way[0], start[1] + way[1]];
        let point = side_point(&line, &[start, end], -1.0, 2.0);
        // the weight of the whole reference line, of length 2, for the whole side
        assert_relative_eq!(point.surface, piece / (h * h), epsilon = 1e-4);
        assert_relative_eq!(point.tangent.norm(), 1.0, epsilon = 1e-15);
    }

    /// A quarter of a circle by one parabola: its chord, and a resultant of pressure equal
    /// to the resultant on the chord, for any shape.
    #[test]
    fn pressure_on_a_curved_side_is_that_on_its_chord() {
        let h = std::f64::consts::FRAC_1_SQRT_2;
        let nodes = [[1.0, 0.0], [0.0, 1.0], [h, h]];
        let line = Line::STRAIGHT;
        let sum: Vector3<f64> = side_points(&line, &nodes).map(|p| p.surface).sum();
        // counterclockwise: outward
        assert_relative_eq!(sum, Vector3::new(0.0, 1.0, 1.0), epsilon = 1e-15);
        let length: f64 = side_points(&line, &nodes).map(|p| p.surface.norm()).sum();
        // the length of the parabola, by its closed form: dy/dt = -1/2 - t c, with
        // c = 2 h - 1 the rise of the middle in each axis over the chord
        let rise = 2.0 * (h - 0.5);
        let speed = |t: f64| ((0.5 + rise * t).powi(2) + (0.5 - rise * t).powi(2)).sqrt();
        let steps = 2000;
        let simpson: f64 = (0..=steps)
            .map(|i| {
                let factor = match i {
                    0 => 1.0,
                    i if i == steps => 1.0,
                    i if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                factor * speed(-1.0 + 2.0 * f64::from(i) / f64::from(steps))
            })
            .sum::<f64>()
            * 2.0
            / f64::from(steps)
            / 3.0;
        // four points on the root of a parabola that varies by a factor 1.3
        assert_relative_eq!(length, simpson, max_relative = 1e-4);
    }
}
