use super::*;
use std::f64::consts::FRAC_PI_2;

fn point(x: f64, y: f64, z: f64, twist: f64) -> LinePoint {
    LinePoint {
        position: Vector3::new(x, y, z),
        twist,
    }
}

// The curvature of a natural spline is zero at its ends and its points are met; through
// points of a straight line it is the line.
#[test]
fn a_spline_through_a_straight_line_is_the_line() {
    let points = [0.0, 1.0, 1.5, 4.0].map(|x| point(x, 2.0 * x, -2.0 * x, 0.1 * x));
    let line = ReferenceLine::through(points.to_vec(), Course::Spline);
    assert!((line.length() - 12.0).abs() < 1e-14);
    let at = line.at(7.5);
    // A few roundings of numbers up to 10.
    assert!((at.position - Vector3::new(2.5, 5.0, -5.0)).amax() < 1e-14);
    assert!((at.twist - 0.25).abs() < 1e-15);
}

// A quarter of a circle of radius 2 to the left, in one arc: it ends at (2, 2, 0), and
// leads along y there, with the leading edge toward -x.
#[test]
fn an_arc_is_a_circle() {
    let quarter = (2.0 * FRAC_PI_2, Vector3::new(0.0, 0.0, 0.5));
    let line = ReferenceLine::curved(point(0.0, 0.0, 0.0, 0.0), &[quarter]);
    assert!((line.length() - std::f64::consts::PI).abs() < 1e-15);
    let tip = line.at(line.length());
    assert!((tip.position - Vector3::new(2.0, 2.0, 0.0)).amax() < 1e-15);
    assert!((tip.axes.column(1) + Vector3::x()).amax() < 1e-15);
    assert!(line.problems().is_empty() && line.points[1].twist.abs() < 1e-15);
}
