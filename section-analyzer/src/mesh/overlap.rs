//! Whether a side of one cell runs through the inside of another.

use shared_geom::mesh::Cell;

use super::boundary::{Curve, curves};
use super::plane::{PlaneMesh, distance};

/// Part of the tolerance that the straight pieces of curved sides may use up.
const PIECES: f64 = 0.25;

/// A place of `side` that lies inside of `cell`, farther than `tolerance` from all
/// of its sides; `None` if there is none.
pub(super) fn place_inside(
    mesh: &PlaneMesh,
    cell: &Cell,
    side: &Curve,
    tolerance: f64,
) -> Option<[f64; 2]> {
    if is_apart(mesh, cell, side, tolerance) {
        return None;
    }
    let (mut polygon, mut line) = (Vec::new(), Vec::new());
    let mut left = side.pieces(PIECES * tolerance, &mut line);
    line.push(side.second);
    for curve in curves(mesh, cell) {
        left = left.max(curve.pieces(PIECES * tolerance, &mut polygon));
    }
    let tolerance = tolerance + 2.0 * left;
    line.windows(2)
        .find_map(|piece| piece_inside(&polygon, [piece[0], piece[1]], tolerance))
}

/// Whether some straight line parts the side from the cell, up to the tolerance:
/// the normals of the cell's chords and of the side's are tried.
fn is_apart(mesh: &PlaneMesh, cell: &Cell, side: &Curve, tolerance: f64) -> bool {
    let mut hull = [[0.0; 2]; 12];
    let mut count = 0;
    for curve in curves(mesh, cell) {
        for point in curve.hull() {
            hull[count] = point;
            count += 1;
        }
    }
    let hull = &hull[..count];
    let chord = |points: &[[f64; 2]]| {
        let [a, b] = [points[0], points[2]];
        let length = distance(a, b);
        [(b[1] - a[1]) / length, (a[0] - b[0]) / length]
    };
    let parts = |normal: [f64; 2]| {
        let height = |p: &[f64; 2]| p[0] * normal[0] + p[1] * normal[1];
        let highest = hull.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
        let lowest = side.hull().iter().map(height).fold(f64::INFINITY, f64::min);
        lowest >= highest - tolerance
    };
    let own = chord(&side.hull());
    hull.chunks(3).map(chord).any(parts) || parts(own) || parts(own.map(|x| -x))
}

/// The middle of a part of the piece that lies inside of the polygon.
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
        let is_deep = || edges(polygon).all(|(a, b)| from_edge(middle, a, b) > tolerance);
        (is_within(polygon, middle) && is_deep()).then_some(middle)
    })
}

fn edges(polygon: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// Where on the way from p to q, from 0 to 1, the line from a to b is crossed.
fn crossing(p: [f64; 2], q: [f64; 2], a: [f64; 2], b: [f64; 2]) -> Option<f64> {
    let (d, e) = ([q[0] - p[0], q[1] - p[1]], [b[0] - a[0], b[1] - a[1]]);
    let way = [a[0] - p[0], a[1] - p[1]];
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let (t, u) = (cross(way, e) / cross(d, e), cross(way, d) / cross(d, e));
    // no numbers for parallel lines, which fail the comparisons
    (t > 0.0 && t < 1.0 && (0.0..=1.0).contains(&u)).then_some(t)
}

/// Whether a ray from the point crosses the polygon an odd number of times.
fn is_within(polygon: &[[f64; 2]], [y, z]: [f64; 2]) -> bool {
    let crossed = edges(polygon).filter(|(a, b)| {
        (a[1] > z) != (b[1] > z) && y < a[0] + (z - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

fn from_edge(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let line = Curve::new(a, b, None);
    distance(p, line.at(line.nearest(p)))
}
