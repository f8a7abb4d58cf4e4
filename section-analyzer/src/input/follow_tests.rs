use super::*;
use crate::section::samples::Random;
use std::f64::consts::{FRAC_PI_2, PI};

#[test]
fn straight_line_points_from_its_first_to_its_second_end() {
    let up = [Parabola::new([2.0, -1.0], [2.0, 3.0], None)];
    for p in [[0.0, 0.0], [5.0, 9.0], [2.0, -4.0], [2.0, 1.0]] {
        assert_eq!(direction(&up, p), Some(FRAC_PI_2));
    }
    let back = Parabola::new([3.0, 0.0], [-3.0, 0.0], None);
    assert_eq!(direction(&[back], [0.0, 1.0]), Some(PI));
}

/// Of a square run counterclockwise, a point inside follows the nearest side.
#[test]
fn nearest_side_of_a_polygon_counts() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let square: Vec<_> = (0..4)
        .map(|i| Parabola::new(corners[i], corners[(i + 1) % 4], None))
        .collect();
    for (p, expected) in [
        ([0.3, -0.9], 0.0),
        ([0.9, -0.3], FRAC_PI_2),
        ([-0.2, 0.7], PI),
        ([-0.8, 0.1], -FRAC_PI_2),
    ] {
        assert_eq!(direction(&square, p), Some(expected));
    }
}

/// Outside of a corner both sides are equally near: the one that passes abreast is used,
/// in either order.
#[test]
fn at_a_corner_the_side_abreast_of_the_point_counts() {
    let flat = Parabola::new([0.0, 0.0], [1.0, 0.0], None);
    let steep = Parabola::new([1.0, 0.0], [1.0, 1.0], None);
    let p = [1.1, -0.7];
    for curve in [[flat.clone(), steep.clone()], [steep, flat]] {
        assert_eq!(direction(&curve, p), Some(0.0));
    }
}

/// Brute force over 20001 positions: none is nearer than the one found, for random
/// parabolas (including sharply bent ones) and random points.
#[test]
fn nearest_position_on_a_parabola_beats_a_fine_scan() {
    let mut random = Random(3);
    for _ in 0..300 {
        let line = Parabola::new(random.point(), random.point(), Some(random.point()));
        let p = Vector2::from(random.point()) * 2.0;
        let found = line.nearest(&p);
        let scanned = (0..=5_000)
            .map(|k| (p - line.position(f64::from(k) * 4e-4 - 1.0)).norm_squared())
            .fold(f64::INFINITY, f64::min);
        // round-off of the squared distance
        assert!(found.squared_distance <= scanned + 1e-14);
        // a true point of the line: no nearer than the scan by its resolution
        assert!(found.squared_distance.sqrt() > scanned.sqrt() - 1e-3);
        assert!(line.squared_bound(&p) <= found.squared_distance + 1e-14);
    }
}

/// y = x^2: the point (0, 5) is equally near to two points, whose tangent is (1, 2 x)
/// with x^2 = 5 - 1/2 (stationary distance: x + 2 x (x^2 - 5) = 0).
#[test]
fn parabola_has_its_closed_form() {
    let parabola = [Parabola::new([-3.0, 9.0], [3.0, 9.0], Some([0.0, 0.0]))];
    let x = 4.5_f64.sqrt();
    // A little to the right, the right one is used.
    let found = direction(&parabola, [1e-9, 5.0]).unwrap();
    assert!((found - (2.0 * x).atan()).abs() < 1e-8);
    // Below the apex the nearest point is the apex.
    assert!(direction(&parabola, [0.0, -1.0]).unwrap().abs() < 1e-15);
}

#[test]
fn a_curve_without_extent_has_no_direction() {
    assert_eq!(direction(&[], [0.0, 0.0]), None);
    let point = Parabola::new([1.0, 1.0], [1.0, 1.0], None);
    assert_eq!(direction(&[point], [0.0, 0.0]), None);
}
