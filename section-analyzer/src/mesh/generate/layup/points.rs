//! The points of a contour: what makes a list one, its corners, and the splines through it.

use shared_geom::spline::Spline;

use super::super::super::distance;
use super::polygon::{crossing, turn};
use super::problem::LayupProblem;

/// Parts of the contour, from its ends, within which and at which distance points are kept.
const ROUNDING: [f64; 2] = [0.01, 1e-3];
/// A turn at a point given twice is a corner above this angle \[rad\]: 10 degrees.
const TURN: f64 = 0.175;
/// Fewest points of a contour.
const LEAST: usize = 9;

/// The length of the polygon and the splines of both coordinates through points, of which
/// `overlap` are repeated at both ends; at the points `sharp` they begin anew.
pub(super) fn splines(
    points: &[[f64; 2]],
    overlap: usize,
    sharp: &[[f64; 2]],
) -> (Vec<f64>, Vec<[Spline; 2]>) {
    let ring = [
        &points[points.len() - overlap..],
        points,
        &points[..overlap],
    ]
    .concat();
    let mut along = vec![0.0];
    for pair in ring.windows(2) {
        along.push(along[along.len() - 1] + distance(pair[0], pair[1]));
    }
    let last = ring.len() - 1;
    let inner = (1..last).filter(|i| sharp.contains(&ring[*i]));
    let ends: Vec<usize> = [0].into_iter().chain(inner).chain([last]).collect();
    let piece = |ends: &[usize]| {
        let range = ends[0]..=ends[1];
        [0, 1].map(|i| {
            let values: Vec<f64> = ring[range.clone()].iter().map(|point| point[i]).collect();
            Spline::new(&along[range.clone()], &values)
        })
    };
    let pieces = ends.windows(2).map(piece).collect();
    (along, pieces)
}

/// Points without those that round the corners of a trailing edge: near both ends only points
/// at some distance from the one before are kept. Walls are mitred at sharp corners.
pub(super) fn without_rounding(points: Vec<[f64; 2]>, length: f64) -> Vec<[f64; 2]> {
    let one_end = |points: Vec<[f64; 2]>| {
        let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
        let (mut along, mut before) = (0.0, points[0]);
        for point in points {
            along += distance(before, point);
            before = point;
            let is_apart = |last: &[f64; 2]| distance(*last, point) > ROUNDING[1] * length;
            if along > ROUNDING[0] * length || kept.last().is_none_or(is_apart) {
                kept.push(point);
            }
        }
        kept.reverse();
        kept
    };
    one_end(one_end(points))
}

/// Largest distance of the ends of a contour, as a part of its length: one side alone has nearly one, and the
/// largest wall that may be left out, of a box twice as high as it is wide, a half.
const LARGEST_BASE: f64 = 0.6;

/// Points without doubled ones, and corners; refuses lists that are no contour.
pub(super) fn checked(points: &[[f64; 2]]) -> Result<[Vec<[f64; 2]>; 2], LayupProblem> {
    let wrong = |why: String| Err(LayupProblem::Contour { why });
    if let Some(index) = points
        .iter()
        .position(|p| !(p[0].is_finite() && p[1].is_finite()))
    {
        return wrong(format!("has no number in row {}", index + 1));
    }
    let mut distinct: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let size: f64 = points
        .windows(2)
        .map(|pair| distance(pair[0], pair[1]))
        .sum();
    let mut doubled = Vec::new();
    for point in points {
        let last = distinct.last().copied();
        match last.filter(|last| distance(*last, *point) <= 1e-9 * size) {
            Some(last) => doubled.push(last),
            None => distinct.push(*point),
        }
    }
    let inner = distinct.windows(3);
    let sharp = inner.filter(|three| doubled.contains(&three[1]) && turn(three) > TURN);
    let sharp = sharp.map(|three| three[1]).collect();
    if distinct.len() < LEAST {
        return wrong(format!(
            "has {} points, expected {LEAST} or more: straight sides have points too, and a point given twice is a \
             corner",
            distinct.len()
        ));
    }
    if let Some([a, b]) = crossing(&distinct) {
        return wrong(format!(
            "crosses itself between rows {} and {}",
            a + 1,
            b + 1
        ));
    }
    let around = || distinct.iter().zip(distinct.iter().cycle().skip(1));
    let area: f64 = around().map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    if area >= 0.0 {
        let why = "runs counterclockwise, expected from the trailing edge over the suction side";
        return wrong(why.into());
    }
    let base = distance(distinct[0], distinct[distinct.len() - 1]);
    if base > LARGEST_BASE * size {
        return wrong(format!(
            "ends at a distance of {:.2} of its length from its start, expected both sides of the section",
            base / size
        ));
    }
    Ok([distinct, sharp])
}
