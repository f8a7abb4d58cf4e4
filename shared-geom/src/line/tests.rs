use std::f64::consts::{FRAC_PI_2, PI};

use super::*;
use crate::rotation::is_rotation;

fn point(x: f64, y: f64, z: f64, twist: f64) -> LinePoint {
    LinePoint {
        position: Vector3::new(x, y, z),
        twist,
    }
}

/// A swept and prebent line with twist.
fn bent(course: Course) -> ReferenceLine {
    let points = vec![
        point(0.0, 0.0, 0.0, 0.3),
        point(4.0, 0.2, -0.1, 0.2),
        point(7.0, 0.1, -0.8, 0.1),
        point(10.0, -1.5, -2.0, -0.05),
    ];
    ReferenceLine::through(points, course)
}

// The curvature of a natural spline is zero at its ends and it passes through its points;
// through points of a straight line it is the line.
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

// Through (0, 0), (1, h), (2, 0) the natural spline has the second derivative -3 h in the
// middle: y = h (3 x - x^3)/2 up to there, and its mirror image beyond. The length by
// Simpson's rule with 2000 intervals, whose error is below 1e-13.
#[test]
fn a_spline_of_three_points_has_the_known_shape_and_length() {
    let h = 0.8;
    let points = [(0.0, 0.0), (1.0, h), (2.0, 0.0)];
    let points = points.map(|(x, y)| point(x, y, 0.0, 0.1 * y));
    let line = ReferenceLine::through(points.to_vec(), Course::Spline);
    let speed = |x: f64| (1.5 * h * (1.0 - x * x)).hypot(1.0);
    let n = 2000;
    let simpson = (0..=n).map(|i| {
        let weight = match i {
            0 => 1.0,
            _ if i == n => 1.0,
            _ if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        weight * speed(f64::from(i) / f64::from(n))
    });
    let half = simpson.sum::<f64>() / (3.0 * f64::from(n));
    let arc_lengths = line.arc_lengths();
    assert!(
        (arc_lengths[1] - half).abs() < 1e-12,
        "{arc_lengths:?} {half}"
    );
    assert!((arc_lengths[2] - 2.0 * half).abs() < 1e-12);
    for s in [0.2, 0.7, 1.2, 1.9, 2.3] {
        let at = line.at(s);
        let x = if s < half {
            at.position.x
        } else {
            2.0 - at.position.x
        };
        let y = 0.5 * h * (3.0 * x - x * x * x);
        assert!((at.position.y - y).abs() < 1e-14, "{s}");
        assert!((at.twist - 0.1 * y).abs() < 1e-14, "{s}");
    }
}

// Arc length is the parameter: differences over 2e-4 m have errors of third order,
// below 1e-8, and round-off of 1e-11.
#[test]
fn positions_are_requested_by_arc_length_and_axes_follow_the_line() {
    let arcs = [
        (3.0, Vector3::new(0.1, -0.05, 0.2)),
        (5.0, Vector3::new(-0.2, 0.1, 0.0)),
    ];
    let curved = ReferenceLine::curved(point(1.0, 2.0, 3.0, 0.2), &arcs);
    for line in [bent(Course::Polyline), bent(Course::Spline), curved] {
        let curve = line.curve();
        for part in [0.0, 0.1, 0.35, 0.5, 0.77, 0.93, 1.0] {
            let s = part * curve.length();
            let at = curve.at(s);
            let d = 1e-4;
            let slope = (curve.at(s + d).position - curve.at(s - d).position) / (2.0 * d);
            assert!((slope - at.tangent).amax() < 1e-7, "{line:?} {s} {slope}");
            assert_eq!(at.tangent, at.axes.column(0).into_owned());
            assert!(is_rotation(&at.axes, 1e-14));
        }
        let ends = curve.at(curve.length()).position;
        let last = line.points.last().unwrap().position;
        assert!((ends - last).amax() < 1e-13, "{ends} {last}");
    }
}

// Before twist the chord is level; twist turns the leading edge up.
#[test]
fn chords_are_level_before_twist_and_twist_is_nose_up() {
    for course in [Course::Polyline, Course::Spline] {
        let line = bent(course);
        for s in [0.0, 2.0, 6.0, 10.0] {
            let at = line.at(s);
            let level = at.axes * about_x(-at.twist);
            assert!(level[(2, 1)].abs() < 1e-15 && level[(1, 1)] > 0.0);
            assert_eq!(at.axes[(2, 1)] > 0.0, at.twist > 0.0);
        }
    }
}

// In the piece from (4, 0.2, -0.1) to (7, 0.1, -0.8) the line points along their
// difference; at its ends it depends on the side.
#[test]
fn at_a_kink_each_side_has_its_own_axes() {
    let line = bent(Course::Polyline);
    let curve = line.curve();
    let kink = curve.arc_lengths()[1];
    let piece = |a: usize| (line.points[a + 1].position - line.points[a].position).normalize();
    for (side, along) in [(Side::Inner, piece(0)), (Side::Outer, piece(1))] {
        let at = curve.on(kink, side);
        assert!((at.tangent - along).amax() < 1e-15);
        assert!((at.position - line.points[1].position).amax() < 1e-15);
        assert!((at.twist - 0.2).abs() < 1e-15);
    }
}

// A quarter of a circle of radius 2 to the left, in one arc: it ends at (2, 2, 0), and
// leads along y there, with the leading edge toward -x.
#[test]
fn an_arc_is_a_circle() {
    let quarter = (2.0 * FRAC_PI_2, Vector3::new(0.0, 0.0, 0.5));
    let line = ReferenceLine::curved(point(0.0, 0.0, 0.0, 0.0), &[quarter]);
    assert!((line.length() - PI).abs() < 1e-15);
    let tip = line.at(line.length());
    assert!((tip.position - Vector3::new(2.0, 2.0, 0.0)).amax() < 1e-15);
    assert!((tip.axes.column(1) + Vector3::x()).amax() < 1e-15);
    assert!(line.problems().is_empty() && line.points[1].twist.abs() < 1e-15);
}

// Curvature k about z and twist rate t make a helix of radius k/(k^2 + t^2) and advance
// t/sqrt(k^2 + t^2): chord^2 = (2 r sin(w s/2))^2 + (h s)^2. Cut in two it is the same.
#[test]
fn an_arc_with_twist_is_a_helix() {
    let (k, t, length) = (0.4, 0.3, 6.0);
    let rate = Vector3::new(t, 0.0, k);
    let root = point(1.0, -1.0, 0.5, 0.7);
    let whole = ReferenceLine::curved(root, &[(length, rate)]);
    let halves = ReferenceLine::curved(root, &[(2.0, rate), (4.0, rate)]);
    let omega = f64::hypot(k, t);
    for s in [0.5, 2.0, 3.3, 6.0] {
        let chord = (whole.at(s).position - root.position).norm();
        let across = 2.0 * k / (omega * omega) * (0.5 * omega * s).sin();
        assert!((chord - across.hypot(t / omega * s)).abs() < 1e-14, "{s}");
        let other = halves.at(s);
        assert!((other.axes - whole.at(s).axes).amax() < 1e-14);
        assert!((other.position - whole.at(s).position).amax() < 1e-14);
    }
    // Twist without curvature is counted beyond a turn.
    let twisted = ReferenceLine::curved(root, &[(40.0, Vector3::new(t, 0.0, 0.0)); 3]);
    let twists: Vec<_> = twisted.points.iter().map(|point| point.twist).collect();
    for (arc, twist) in twists.iter().enumerate() {
        assert!(
            (twist - (0.7 + 12.0 * arc as f64)).abs() < 1e-13,
            "{twists:?}"
        );
    }
    assert!((twisted.at(50.0).twist - 15.7).abs() < 1e-13);
}

// The sections of a turned line are the turned sections of the line.
#[test]
fn a_twisted_line_has_turned_sections() {
    let angle = 0.37;
    let arc = (9.0, Vector3::new(0.1, -0.05, 0.2));
    let curved = ReferenceLine::curved(point(0.0, 0.0, 0.0, 0.2), &[arc]);
    for line in [bent(Course::Polyline), bent(Course::Spline), curved] {
        let turned = line.twisted(angle);
        for s in [0.0, 1.3, 5.5, 9.0] {
            let (before, after) = (line.at(s), turned.at(s));
            assert!((before.axes * about_x(angle) - after.axes).amax() < 1e-14);
            assert!((before.position - after.position).amax() < 1e-13);
        }
    }
}

#[test]
fn what_cannot_be_followed_is_reported() {
    let reported = |points: &[LinePoint], course| {
        let line = ReferenceLine::through(points.to_vec(), course);
        let shown: Vec<_> = line.problems().iter().map(ToString::to_string).collect();
        shown.join("\n")
    };
    let origin = point(0.0, 0.0, 0.0, 0.0);
    let tip = point(1.0, 0.0, 0.0, 0.0);
    let cases = [
        (reported(&[origin], Course::Spline), "has 1 points"),
        (
            reported(&[origin, origin, tip], Course::Polyline),
            "point 2 of the line lies where point 1",
        ),
        (
            reported(&[tip, origin], Course::Spline),
            "point 2 of the line lies at x = 0 m",
        ),
        (
            reported(&[origin, point(0.0, 0.0, 3.0, 0.0)], Course::Polyline),
            "leads along z from point 1 to point 2",
        ),
        (
            reported(&[origin, point(1.0, f64::NAN, 0.0, 0.0)], Course::Spline),
            "point 2 of the line holds a number that is not finite",
        ),
        (
            reported(&[origin, tip], Course::Arcs),
            "has 2 points, 0 curvatures and 0 lengths",
        ),
        (
            reported(&[origin, point(1e10, 0.0, 0.0, 0.0)], Course::Polyline),
            "the line is 1.000e10 m long, expected at most 1e9 m",
        ),
        // The squares of these overflow.
        (
            reported(
                &[origin, tip, point(1e200, 1e200, 0.0, 0.0)],
                Course::Spline,
            ),
            "m long, expected at most",
        ),
        (
            reported(&[origin, tip, point(2.0, 1e300, 0.0, 0.0)], Course::Spline),
            "m long, expected at most",
        ),
    ];
    for (shown, expected) in cases {
        assert!(shown.contains(expected), "{expected}: {shown}");
    }
    let arc = ReferenceLine::curved(origin, &[(-1.0, Vector3::zeros())]);
    assert!(
        arc.problems()[0]
            .to_string()
            .contains("arc 1 of the line is -1 m long")
    );
}

// A line that was not checked gives meaningless numbers, but no panic.
#[test]
fn no_line_panics() {
    let numbers = [0.0, 1.0, -3.0, f64::NAN, f64::INFINITY, 1e300];
    for (i, course) in [Course::Polyline, Course::Spline, Course::Arcs]
        .into_iter()
        .cycle()
        .take(60)
        .enumerate()
    {
        let pick = |k: usize| numbers[(i * 7 + k * 5 + k * k) % numbers.len()];
        let points = (0..i % 5).map(|k| point(pick(k), pick(k + 1), pick(k + 2), pick(k + 3)));
        let mut line = ReferenceLine::through(points.collect(), course);
        line.arc_length = (0..i % 4).map(pick).collect();
        line.curvature = (0..i % 3).map(|k| Vector3::repeat(pick(k))).collect();
        let _ = (line.at(0.5), line.length(), line.problems());
        let _ = line.curve().on(pick(1), Side::Inner);
    }
}
