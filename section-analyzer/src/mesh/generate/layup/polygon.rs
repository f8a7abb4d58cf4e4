//! Turns and crossings of polygons.

use super::super::super::distance;

/// Two lines of a polygon that cross: the numbers of their first points. The first and the last
/// line may share a point.
pub(super) fn crossing(points: &[[f64; 2]]) -> Option<[usize; 2]> {
    let side = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let last = points.len() - 2;
    for (i, one) in points.windows(2).enumerate() {
        for (j, other) in points.windows(2).enumerate().skip(i + 2) {
            let crosses = side(one[0], one[1], other[0]) * side(one[0], one[1], other[1]) < 0.0
                && side(other[0], other[1], one[0]) * side(other[0], other[1], one[1]) < 0.0;
            let is_end =
                i == 0 && j == last && distance(one[0], other[1]) < 1e-3 * distance(one[0], one[1]);
            if crosses && !is_end {
                return Some([i, j]);
            }
        }
    }
    None
}

/// The turn of a polygon at the middle one of three points \[rad\].
pub(super) fn turn(points: &[[f64; 2]]) -> f64 {
    let [a, b] = [0, 1].map(|k| [0, 1].map(|i| points[k + 1][i] - points[k][i]));
    let (sine, cosine) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    sine.atan2(cosine).abs()
}
