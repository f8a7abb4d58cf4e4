//! Points of airfoils that are off the line of their neighbors: likely a wrong number.
//!
//! A corner is none: without its point, the contour has two corners of half the angle in its place.

use super::shape::Points;

/// Least distance of a wrong point from the line between its neighbors [chords]; roughness of measured
/// airfoils is below 0.001.
const LEAST: f64 = 4e-3;
/// Its distance over the largest one of the points near it, without it. A corner has 1.5 with points at
/// equal distances, and at most 2.
const FACTOR: f64 = 5.0;
/// Points on each side that are near.
const NEAR: usize = 3;

/// The point of an airfoil that is farthest off the line of its neighbors, if it is wrong, and its
/// distance [chords].
pub(super) fn outlier(points: &Points) -> Option<([f64; 2], f64)> {
    let mut points = points.clone();
    points.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
    let wrong = |i: usize| {
        let near = &points[i - NEAR..=i + NEAR];
        let found = off(&near[NEAR - 1..=NEAR + 1]);
        let without = [&near[..NEAR], &near[NEAR + 1..]].concat();
        let others = without.windows(3).map(off).fold(0.0, f64::max);
        (found > LEAST && found > FACTOR * others).then_some((near[NEAR], found))
    };
    let inner = NEAR..points.len().saturating_sub(NEAR);
    inner.filter_map(wrong).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Distance of the second of three points from the line between the others.
fn off(three: &[[f64; 2]]) -> f64 {
    let side = |to: usize| [0, 1].map(|k| three[to][k] - three[0][k]);
    let (point, line) = (side(1), side(2));
    (point[0] * line[1] - point[1] * line[0]).abs() / line[0].hypot(line[1]).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::outlier;
    use crate::mesh::generate::blade::naca;

    /// A point that is moved by 3 % of the chord is found with its distance, at any place of the contour but
    /// its ends; the other points are none, and neither is a moved point that is within the bound.
    #[test]
    fn one_wrong_point_is_found() {
        let right = naca("4415", false).expect("an airfoil");
        assert_eq!(outlier(&right), None);
        for number in (8..right.len() - 8).step_by(5) {
            let mut points = right.clone();
            points[number][1] += 0.03;
            // near the nose the contour itself is upright, and the point moves along it
            if (points[number][0]) < 0.02 {
                continue;
            }
            let (point, distance) = outlier(&points).expect("a point");
            assert_eq!(point, points[number], "{number}");
            // the curvature and the slope of the contour change the distance a little
            assert!((0.02..0.04).contains(&distance), "{number}: {distance}");
            points[number][1] -= 0.029;
            assert_eq!(outlier(&points), None, "{number}");
        }
    }

    /// Corners of boxes and wedges, with points at equal and at unequal distances.
    #[test]
    fn corners_are_none() {
        for step in [0.01, 0.05, 0.1] {
            let count = (1.0_f64 / step).round() as usize;
            let along = |i: usize| (i as f64 / count as f64).powf(1.3);
            for depth in [0.02, 0.2, 0.5] {
                let upper = (0..count).map(|i| [1.0 - along(i), depth]);
                let front = (0..count).map(|i| [0.0, depth * (1.0 - 2.0 * along(i))]);
                let lower = (0..=count).map(|i| [along(i), -depth]);
                let contour: Vec<[f64; 2]> = upper.chain(front).chain(lower).collect();
                assert_eq!(outlier(&contour), None, "{step} {depth}");
                let wedge = (0..=count).map(|i| [1.0 - along(i), depth * along(i)]);
                let wedge = wedge.chain((1..=count).map(|i| [along(i), -depth * (1.0 - along(i))]));
                assert_eq!(outlier(&wedge.collect()), None, "{step} {depth}");
            }
        }
    }
}
