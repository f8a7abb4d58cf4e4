//! Turns and crossings of polygons.

use super::super::super::distance;

/// A turn at the trailing edge is no corner below the first of these \[rad\], and below the second
/// \[rad\] or the third times the turns beside it [-].
const SMOOTH: [f64; 3] = [0.7, 0.035, 3.0];
/// The turns at both ends of a base are no corners if their sum is smaller \[rad\]: 10 degrees.
const ROUND: f64 = 0.175;

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

/// Whether the ends of the points are no corners: the direction changes there about as much as
/// beside them, where it turns in the same sense, or little on both sides of a base.
pub(super) fn is_smooth(points: &[[f64; 2]], is_closed: bool) -> bool {
    let last = points.len() - 1;
    let line = |a: usize, b: usize| [0, 1].map(|i| points[b][i] - points[a][i]);
    // positive if the section is convex
    let angle = |a: [f64; 2], b: [f64; 2]| {
        let (sine, cosine) = (b[0] * a[1] - b[1] * a[0], a[0] * b[0] + a[1] * b[1]);
        sine.atan2(cosine)
    };
    let [first, end] = [line(0, 1), line(last - 1, last)];
    let base = line(last, 0);
    let turns = if is_closed {
        [angle(end, first).abs(), f64::INFINITY]
    } else {
        [angle(end, base).abs(), angle(base, first).abs()]
    };
    let turn = if is_closed {
        turns[0]
    } else {
        turns[0].max(turns[1])
    };
    let beside = angle(first, line(1, 2)).max(angle(line(last - 2, last - 1), end));
    let is_as_beside = turn < SMOOTH[1].max(SMOOTH[2] * beside);
    turn < SMOOTH[0] && (is_as_beside || turns[0] + turns[1] < ROUND)
}
