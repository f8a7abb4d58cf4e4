//! Curvature of a line: rate of rotation of its section axes.
//!
//! ```text
//! k = axial( Q^T dQ/ds )                                                      (D-230)
//! ```
//!
//! by the rotation vector between positions shortly before and after, which is exact on
//! straight pieces and on arcs, and of second order on splines.

use super::{Curve, Side};
use crate::rotation::vector;
use crate::section::InitialCurvature;

/// Part of an interval between two points of the line over which the axes are compared:
/// on a spline the error is in the order of its square.
const PART: f64 = 1e-4;

impl Curve {
    /// Twist rate about x and curvature about y and z of the line at arc length `s` [m],
    /// in section axes, and its slope, which is (1, 0, 0): the first of the axes is the
    /// tangent. At the joint of two pieces, of the piece on `side`.
    pub fn initial_curvature(&self, s: f64, side: Side) -> InitialCurvature {
        let mut initial = InitialCurvature::STRAIGHT;
        let known = self.arc_lengths();
        let behind = match side {
            Side::Inner => known.partition_point(|position| *position < s),
            Side::Outer => known.partition_point(|position| *position <= s),
        };
        let Some(last) = known.len().checked_sub(2) else {
            return initial;
        };
        let i = behind.saturating_sub(1).min(last);
        let (from, to) = (known[i], known[i + 1]);
        let step = PART * (to - from);
        let position = s.clamp(from, to);
        let [a, b] = [(position - step).max(from), (position + step).min(to)];
        if b > a {
            let relative = self.on(a, Side::Outer).axes.transpose() * self.on(b, Side::Inner).axes;
            initial.curvature = vector::from_rotation(&relative) / (b - a);
        }
        initial
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::line::{Course, LinePoint, ReferenceLine};

    fn point(position: [f64; 3], twist: f64) -> LinePoint {
        let position = Vector3::from(position);
        LinePoint { position, twist }
    }

    // A straight piece has only its twist rate, on each side of a point its own; the axes
    // are compared over 2e-4 m, which leaves 1e-16/1e-4 of a radian.
    #[test]
    fn straight_pieces_have_their_twist_rates() {
        let points = vec![
            point([0.0; 3], 0.2),
            point([1.0, 0.0, 0.0], 0.5),
            point([2.0, 0.5, 0.1], 0.1),
        ];
        let curve = ReferenceLine::through(points, Course::Polyline).curve();
        let outer = (1.0_f64 + 0.25 + 0.01).sqrt();
        for (s, side, rate) in [
            (0.0, Side::Inner, 0.3),
            (0.5, Side::Outer, 0.3),
            (1.0, Side::Inner, 0.3),
            (1.0, Side::Outer, -0.4 / outer),
            (1.0 + outer, Side::Outer, -0.4 / outer),
        ] {
            let found = curve.initial_curvature(s, side).curvature;
            let expected = Vector3::new(rate, 0.0, 0.0);
            assert!((found - expected).amax() < 1e-11, "{s}: {found}");
        }
    }

    // A line of arcs has its given curvature.
    #[test]
    fn arcs_have_the_curvature_that_makes_them() {
        let arcs = [
            (2.0, Vector3::new(0.3, -0.2, 0.1)),
            (1.0, Vector3::new(0.0, 0.4, 0.0)),
        ];
        let curve = ReferenceLine::curved(point([0.0; 3], 0.1), &arcs).curve();
        for (s, side, arc) in [
            (0.0, Side::Outer, 0),
            (1.3, Side::Outer, 0),
            (2.0, Side::Inner, 0),
            (2.0, Side::Outer, 1),
            (3.0, Side::Inner, 1),
        ] {
            let found = curve.initial_curvature(s, side).curvature;
            assert!((found - arcs[arc].1).amax() < 1e-11, "{s}: {found}");
        }
    }

    // The parabola y = a x^2 turns by 2 a / (1 + 4 a^2 x^2)^(3/2) about z. The spline
    // through its points, natural at the ends, follows it in the middle to 1e-4 (its
    // curvature at distance n intervals from an end is off by 0.27^n).
    #[test]
    fn a_spline_has_the_curvature_of_its_curve() {
        let (a, n) = (0.2, 40);
        let x = |i: usize| 2.0 * i as f64 / n as f64 - 1.0;
        let points = (0..=n).map(|i| point([x(i), a * x(i) * x(i), 0.0], 0.0));
        let line = ReferenceLine::through(points.collect(), Course::Spline);
        let curve = line.curve();
        let middle = 0.5 * curve.length();
        let found = curve.initial_curvature(middle, Side::Outer).curvature;
        assert!(
            (found - Vector3::new(0.0, 0.0, 2.0 * a)).amax() < 1e-4 * 2.0 * a,
            "{found}"
        );
    }
}
