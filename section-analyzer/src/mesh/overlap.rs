//! Detects sides of one cell inside of another.

use shared_geom::mesh::Cell;

use super::boundary::{Curve, curves};
use super::plane::{PlaneMesh, distance};

/// Fraction of the tolerance available for the straight pieces of curved sides.
const PIECES: f64 = 0.25;

/// A point of `side` that lies inside of `cell`, farther than `tolerance` from all of its
/// sides; `None` if there is none.
pub(super) fn position_inside(
    mesh: &PlaneMesh,
    cell: &Cell,
    side: &Curve,
    tolerance: f64,
) -> Option<[f64; 2]> {
    if is_apart(mesh, cell, side, tolerance) {
        return None;
    }
    let (polygon, left) = polygon_of(mesh, cell, tolerance);
    let mut line = Vec::new();
    let left = left.max(side.pieces(PIECES * tolerance, &mut line));
    line.push(side.second);
    let tolerance = tolerance + 2.0 * left;
    line.windows(2)
        .find_map(|piece| piece_inside(&polygon, [piece[0], piece[1]], tolerance))
}

/// Whether a point lies inside of `cell`, farther than `tolerance` from all of its sides.
pub(super) fn is_inside(mesh: &PlaneMesh, cell: &Cell, position: [f64; 2], tolerance: f64) -> bool {
    let (polygon, left) = polygon_of(mesh, cell, tolerance);
    is_deep(&polygon, position, tolerance + left)
}

/// The polygon that represents a cell, and its distance from the cell's sides.
fn polygon_of(mesh: &PlaneMesh, cell: &Cell, tolerance: f64) -> (Vec<[f64; 2]>, f64) {
    let mut polygon = Vec::new();
    let pieces = curves(mesh, cell).map(|curve| curve.pieces(PIECES * tolerance, &mut polygon));
    let left = pieces.fold(0.0, f64::max);
    (polygon, left)
}

/// Whether a straight line separates the side from the cell, up to the tolerance: the
/// normals of the cell's chords and of the side's chord are tried.
fn is_apart(mesh: &PlaneMesh, cell: &Cell, side: &Curve, tolerance: f64) -> bool {
    let mut hull = [[0.0; 2]; 8];
    let mut chords = [[0.0; 2]; 6];
    let (mut points, mut count) = (0, 0);
    for curve in curves(mesh, cell) {
        chords[count] = curve.chord();
        count += 1;
        hull[points] = curve.first;
        points += 1;
        if !curve.is_straight() {
            hull[points] = curve.control();
            points += 1;
        }
    }
    let own = side.chord();
    chords[count] = own;
    chords[count + 1] = own.map(|x| -x);
    let (hull, side) = (&hull[..points], side.hull());
    chords[..count + 2].iter().any(|chord| {
        // to the right of the chord, outside of the cell
        let height = |p: &[f64; 2]| p[0] * chord[1] - p[1] * chord[0];
        let highest = hull.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
        let lowest = side.iter().map(height).fold(f64::INFINITY, f64::min);
        lowest >= highest - tolerance * (chord[0] * chord[0] + chord[1] * chord[1]).sqrt()
    })
}

/// The midpoint of a part of the piece inside of the polygon.
fn piece_inside(polygon: &[[f64; 2]], piece: [[f64; 2]; 2], tolerance: f64) -> Option<[f64; 2]> {
    let [p, q] = piece;
    let mut cuts = vec![0.0, 1.0];
    for (a, b) in edges(polygon) {
        cuts.extend(crossing(p, q, a, b));
    }
    cuts.sort_unstable_by(f64::total_cmp);
    cuts.windows(2).find_map(|ends| {
        let t = 0.5 * (ends[0] + ends[1]);
        let middle = [0, 1].map(|i| p[i] + t * (q[i] - p[i]));
        is_deep(polygon, middle, tolerance).then_some(middle)
    })
}

fn is_deep(polygon: &[[f64; 2]], position: [f64; 2], tolerance: f64) -> bool {
    is_within(polygon, position)
        && edges(polygon).all(|(a, b)| from_edge(position, a, b) > tolerance)
}

fn edges(polygon: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// Position from p to q, from 0 to 1, at which the line from a to b is crossed.
fn crossing(p: [f64; 2], q: [f64; 2], a: [f64; 2], b: [f64; 2]) -> Option<f64> {
    let (d, e) = ([q[0] - p[0], q[1] - p[1]], [b[0] - a[0], b[1] - a[1]]);
    let way = [a[0] - p[0], a[1] - p[1]];
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let (t, u) = (cross(way, e) / cross(d, e), cross(way, d) / cross(d, e));
    // not finite for parallel lines, which fail the comparisons
    (t > 0.0 && t < 1.0 && (0.0..=1.0).contains(&u)).then_some(t)
}

/// Whether a ray from the point crosses the polygon an odd number of times.
pub(crate) fn is_within(polygon: &[[f64; 2]], [y, z]: [f64; 2]) -> bool {
    let crossed = edges(polygon).filter(|(a, b)| {
        (a[1] > z) != (b[1] > z) && y < a[0] + (z - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

fn from_edge(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let line = Curve::new(a, b, None);
    distance(p, line.at(line.nearest(p)))
}
