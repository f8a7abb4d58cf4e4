//! Least and largest Jacobian determinant of a whole cell, not only at sample points.
//!
//! ```text
//! J(r, s) = y,r z,s - y,s z,r = sum_i c_i B_i(r, s),      min c_i <= J <= max c_i
//! ```
//!
//! `J` is a polynomial; its coefficients `c_i` in the basis of Bernstein polynomials
//! follow from its values at one point per term. The basis functions are positive and sum
//! to one, so that the coefficients bound it. If the bound is not sharp, the cell is
//! divided into quarters, each with its own coefficients.
//!
//! # References
//! - [Johnen2013], sections 3 and 4.

use shared_geom::lagrange::ShapeValues;
use shared_geom::mesh::CellKind;

/// Bounds are refined until they agree within this fraction of the largest `|J|`.
const SHARPNESS: f64 = 1e-3;
/// Largest number of subdivisions; each reduces the distance of the bounds by a factor of
/// four.
const DIVISIONS: usize = 6;
/// Number of points along each side at which a polynomial of degree three is evaluated.
const POINTS: usize = 4;

/// Finds extremes of Jacobian determinants.
#[derive(Debug)]
pub(super) struct Jacobian {
    /// Shape functions in the points of the whole cell, by kind.
    whole: Vec<(CellKind, Vec<ShapeValues>)>,
}

/// A part of the reference cell: `origin + a first + b second`, with `a` and `b`
/// from 0 to 1, for triangles `a + b <= 1`.
#[derive(Debug, Clone, Copy)]
struct Piece {
    origin: [f64; 2],
    first: [f64; 2],
    second: [f64; 2],
}

/// A cell whose extremes are searched; `sign` is -1 for the largest.
#[derive(Debug, Clone, Copy)]
struct Search<'a> {
    kind: CellKind,
    positions: &'a [[f64; 2]],
    sign: f64,
    tolerance: f64,
}

impl Jacobian {
    /// For all kinds of cells.
    pub(super) fn new() -> Self {
        let shapes = |kind: CellKind| {
            let points = points(kind, &Piece::whole(kind));
            let shapes = points.into_iter().map(|[r, s]| kind.shape(r, s));
            (kind, shapes.collect())
        };
        Self {
            whole: CellKind::ALL.map(shapes).to_vec(),
        }
    }

    /// Least and largest Jacobian determinant of the cell with nodes at `positions`
    /// [square of their unit].
    pub(super) fn extremes(&self, kind: CellKind, positions: &[[f64; 2]]) -> [f64; 2] {
        let kind = straight_kind(kind, positions);
        let positions = &positions[..kind.node_count()];
        let mut values = [0.0; POINTS * POINTS];
        let mut count = 0;
        let shapes = self.whole.iter().filter(|(known, _)| *known == kind);
        for shape in shapes.flat_map(|(_, shapes)| shapes) {
            values[count] = determinant(shape, positions);
            count += 1;
        }
        let values = &mut values[..count];
        let [low, high] = range(values);
        to_bernstein(kind, values);
        let [bound_low, bound_high] = range(values);
        let tolerance = SHARPNESS * bound_low.abs().max(bound_high.abs());
        let search = |sign| Search {
            kind,
            positions,
            sign,
            tolerance,
        };
        let (mut least, mut largest) = (low, high);
        if bound_low < low - tolerance {
            least = search(1.0).least_of_quarters(&Piece::whole(kind), low, DIVISIONS);
        }
        if bound_high > high + tolerance {
            largest = -search(-1.0).least_of_quarters(&Piece::whole(kind), -high, DIVISIONS);
        }
        [least, largest]
    }
}

/// The linear kind of a quadratic cell whose middle nodes are all at the midpoints, up to
/// rounding: its mapping is the mapping of the linear cell.
fn straight_kind(kind: CellKind, positions: &[[f64; 2]]) -> CellKind {
    /// Square of the distance from the midpoint, relative to the square of the chord.
    const ROUNDING: f64 = 1e-26;
    let square = |p: [f64; 2]| p[0] * p[0] + p[1] * p[1];
    let is_middle = |node: usize, of: &[usize]| {
        let mean = |i: usize| of.iter().map(|&n| positions[n][i]).sum::<f64>() / of.len() as f64;
        let chord = [0, 1].map(|i| positions[of[1]][i] - positions[of[0]][i]);
        square([0, 1].map(|i| positions[node][i] - mean(i))) <= ROUNDING * square(chord)
    };
    let is_straight = (0..kind.corner_count()).all(|side| match kind.side(side) {
        (a, b, Some(middle)) => is_middle(middle, &[a, b]),
        _ => false,
    });
    match kind {
        CellKind::Triangle6 if is_straight => CellKind::Triangle3,
        CellKind::Quadrilateral8 if is_straight => CellKind::Quadrilateral4,
        CellKind::Quadrilateral9 if is_straight && is_middle(8, &[0, 1, 2, 3]) => {
            CellKind::Quadrilateral4
        }
        other => other,
    }
}

impl Search<'_> {
    /// The least of `sign J` in the quarters of `piece`, or `known` if that is less.
    fn least_of_quarters(&self, piece: &Piece, known: f64, divisions: usize) -> f64 {
        let mut least = known;
        for quarter in piece.quarters(self.kind) {
            let points = points(self.kind, &quarter);
            let value =
                |[r, s]: [f64; 2]| self.sign * determinant(&self.kind.shape(r, s), self.positions);
            let mut values: Vec<f64> = points.into_iter().map(value).collect();
            least = least.min(range(&values)[0]);
            to_bernstein(self.kind, &mut values);
            if range(&values)[0] < least - self.tolerance && divisions > 1 {
                least = self.least_of_quarters(&quarter, least, divisions - 1);
            }
        }
        least
    }
}

impl Piece {
    fn whole(kind: CellKind) -> Self {
        match kind.corner_count() {
            3 => Self {
                origin: [0.0, 0.0],
                first: [1.0, 0.0],
                second: [0.0, 1.0],
            },
            _ => Self {
                origin: [-1.0, -1.0],
                first: [2.0, 0.0],
                second: [0.0, 2.0],
            },
        }
    }

    fn at(&self, a: f64, b: f64) -> [f64; 2] {
        [0, 1].map(|i| self.origin[i] + a * self.first[i] + b * self.second[i])
    }

    fn quarters(&self, kind: CellKind) -> [Self; 4] {
        let [first, second] = [self.first, self.second].map(|side| side.map(|x| 0.5 * x));
        let quarter = |a: f64, b: f64| Self {
            origin: self.at(a, b),
            first,
            second,
        };
        let last = quarter(0.5, 0.5);
        let last = match kind.corner_count() {
            // the middle triangle, upside down
            3 => Self {
                first: first.map(|x| -x),
                second: second.map(|x| -x),
                ..last
            },
            _ => last,
        };
        [
            quarter(0.0, 0.0),
            quarter(0.5, 0.0),
            quarter(0.0, 0.5),
            last,
        ]
    }
}

/// The points of `piece` at which `J` is evaluated, one per term. `J` is constant in
/// linear triangles, linear in `r` and in `s` in straight quadrilaterals, and in
/// quadratic cells of degree 2 (triangles) or of degree 3 in each of `r` and `s`.
fn points(kind: CellKind, piece: &Piece) -> Vec<[f64; 2]> {
    let at = |&[a, b]: &[f64; 2]| piece.at(a, b);
    match kind {
        CellKind::Triangle3 => vec![piece.at(0.0, 0.0)],
        CellKind::Triangle6 => kind.reference_nodes().iter().map(at).collect(),
        CellKind::Quadrilateral4 => grid(2).iter().map(at).collect(),
        CellKind::Quadrilateral8 | CellKind::Quadrilateral9 => {
            grid(POINTS).iter().map(at).collect()
        }
    }
}

/// `n` by `n` points of the unit square, row by row.
fn grid(n: usize) -> Vec<[f64; 2]> {
    let part = |i: usize| i as f64 / (n - 1) as f64;
    let rows = (0..n).flat_map(|j| (0..n).map(move |i| (i, j)));
    rows.map(|(i, j)| [part(i), part(j)]).collect()
}

/// Converts the values at [`points`] to the coefficients.
///
/// ```text
/// degree 2, on a side of a triangle:  c_m = 2 f_m - (f_a + f_b) / 2
/// degree 3, along a line:  c_1 = (-5 f_0 + 18 f_1 - 9 f_2 + 2 f_3) / 6, c_2 mirrored
/// ```
/// Values at corners are unchanged.
fn to_bernstein(kind: CellKind, values: &mut [f64]) {
    match kind {
        CellKind::Triangle3 | CellKind::Quadrilateral4 => {}
        CellKind::Triangle6 => {
            for side in 0..3 {
                let (a, b) = (values[side], values[(side + 1) % 3]);
                values[3 + side] = 2.0 * values[3 + side] - 0.5 * (a + b);
            }
        }
        CellKind::Quadrilateral8 | CellKind::Quadrilateral9 => {
            for line in 0..POINTS {
                cubic(values, POINTS * line, 1);
            }
            for line in 0..POINTS {
                cubic(values, line, POINTS);
            }
        }
    }
}

/// The four values from `start`, `step` apart.
fn cubic(values: &mut [f64], start: usize, step: usize) {
    let at = |i: usize| start + i * step;
    let f = [0, 1, 2, 3].map(|i| values[at(i)]);
    values[at(1)] = (-5.0 * f[0] + 18.0 * f[1] - 9.0 * f[2] + 2.0 * f[3]) / 6.0;
    values[at(2)] = (2.0 * f[0] - 9.0 * f[1] + 18.0 * f[2] - 5.0 * f[3]) / 6.0;
}

/// `J = y,r z,s - y,s z,r`.
fn determinant(shape: &ShapeValues, positions: &[[f64; 2]]) -> f64 {
    let (mut dr, mut ds) = ([0.0; 2], [0.0; 2]);
    for (i, position) in positions.iter().enumerate() {
        for axis in 0..2 {
            dr[axis] += shape.dr[i] * position[axis];
            ds[axis] += shape.ds[i] * position[axis];
        }
    }
    dr[0] * ds[1] - dr[1] * ds[0]
}

fn range(values: &[f64]) -> [f64; 2] {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], &value: &f64| [low.min(value), high.max(value)];
    values.iter().fold(ends, wider)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodes of the reference cell, moved by a few tenths from a fixed sequence.
    fn shaken(kind: CellKind, seed: u64) -> Vec<[f64; 2]> {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state % 2001) as f64 / 1000.0 - 1.0
        };
        let nodes = kind.reference_nodes().iter();
        nodes.map(|p| p.map(|x| x + 0.15 * next())).collect()
    }

    /// Compares with a search in 81 x 81 points, whose error at a smooth extreme is
    /// quadratic in its step 1/80: (1/80)^2 / 8 of the second derivative, some 1e-3 of
    /// the largest J here. No value of the search may be outside of the result.
    #[test]
    fn extremes_are_those_of_a_fine_search() {
        let finder = Jacobian::new();
        for kind in CellKind::ALL {
            for seed in 0..40 {
                let positions = shaken(kind, seed);
                let [low, high] = finder.extremes(kind, &positions);
                let whole = Piece::whole(kind);
                let inside = grid(81)
                    .into_iter()
                    .filter(|[a, b]| kind.corner_count() == 4 || a + b <= 1.0);
                let values: Vec<f64> = inside
                    .map(|[a, b]| whole.at(a, b))
                    .map(|[r, s]| determinant(&kind.shape(r, s), &positions))
                    .collect();
                let [seen_low, seen_high] = range(&values);
                let size = low.abs().max(high.abs());
                let slack = 2.0 * SHARPNESS * size;
                assert!(
                    low <= seen_low + slack && high >= seen_high - slack,
                    "{kind:?} {seed}"
                );
                let missed = 4e-3 * size;
                assert!(
                    low >= seen_low - missed && high <= seen_high + missed,
                    "{kind:?} {seed}"
                );
            }
        }
    }

    /// Straight-sided quadratic cells have the Jacobian of the linear cell, computed on
    /// its own path. If their nodes are moved by far less than their width, the path of
    /// curved cells is used, with the same result.
    #[test]
    fn straight_cells_are_as_linear_ones() {
        let finder = Jacobian::new();
        for kind in CellKind::ALL.into_iter().filter(|kind| kind.is_quadratic()) {
            let linear = match kind.corner_count() {
                3 => CellKind::Triangle3,
                _ => CellKind::Quadrilateral4,
            };
            let corners = shaken(linear, 5);
            let position = |&[r, s]: &[f64; 2]| {
                let shape = linear.shape(r, s);
                [0, 1].map(|i| (0..corners.len()).map(|n| shape.n[n] * corners[n][i]).sum())
            };
            let mut positions: Vec<[f64; 2]> =
                kind.reference_nodes().iter().map(position).collect();
            assert_eq!(straight_kind(kind, &positions), linear);
            let straight = finder.extremes(kind, &positions);
            positions[kind.corner_count()][0] += 1e-9;
            assert_eq!(straight_kind(kind, &positions), kind);
            let curved = finder.extremes(kind, &positions);
            for (a, b) in straight.into_iter().zip(curved) {
                assert!((a - b).abs() < 1e-7, "{kind:?} {a} {b}");
            }
        }
    }

    /// Some strongly distorted cells have a Jacobian that is positive at all nodes and
    /// integration points, and negative between them.
    #[test]
    fn a_fold_between_nodes_and_points_is_found() {
        let kind = CellKind::Quadrilateral9;
        let finder = Jacobian::new();
        let mut found = 0;
        for seed in 0..4000 {
            let positions: Vec<[f64; 2]> = kind
                .reference_nodes()
                .iter()
                .zip(shaken(kind, seed))
                .map(|(node, moved)| [0, 1].map(|i| node[i] + 2.6 * (moved[i] - node[i])))
                .collect();
            let at = |r: f64, s: f64| determinant(&kind.shape(r, s), &positions);
            let nodes = kind.reference_nodes().iter().map(|&[r, s]| at(r, s));
            let points = kind.rule().iter().map(|point| at(point.r, point.s));
            let seen = nodes.chain(points).fold(f64::INFINITY, f64::min);
            let [low, _] = finder.extremes(kind, &positions);
            found += usize::from(seen > 0.02 && low < -0.02);
        }
        assert!(found > 0, "no such cell among the samples");
    }
}
