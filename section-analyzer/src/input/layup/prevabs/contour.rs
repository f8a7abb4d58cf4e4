//! The contour: the segments that close a loop, run clockwise from the trailing edge.

use super::Points;
use super::components::{Segment, Side};
use super::files::Notes;
use super::geometry::{Kind, extent};
use crate::mesh::distance;
use crate::mesh::generate::layup::Outline;

/// Part of the size of the section within which ends of segments are one.
const JOINED: f64 = 1e-5;
/// A turn that is a corner \[rad\]: 40 degrees.
const CORNER: f64 = 0.7;
/// Straight lines are divided into parts of which the whole contour has this number.
const PARTS: f64 = 240.0;
/// Numbers of parts from which on straight lines, and lines of curves, are divided.
const LONG: [f64; 2] = [4.0, 24.0];

/// A segment of the loop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    /// Its number in the list of segments.
    pub segment: usize,
    /// Whether its line runs clockwise.
    pub is_along: bool,
    /// Parts of the contour at which it starts and ends; the end of a segment through the
    /// trailing edge is before its start.
    pub arcs: [f64; 2],
}

/// The contour of a section with its segments, clockwise.
pub(super) struct Contour {
    /// Points from the trailing edge; a corner elsewhere is given twice.
    pub points: Points,
    pub outline: Outline,
    pub pieces: Vec<Piece>,
}

/// Segments one after the other: their numbers, and whether they run backward.
pub(super) type Chain = Vec<(usize, bool)>;

/// A closed chain of segments, with the number of its first point of each.
struct Loop {
    points: Points,
    pieces: Vec<(usize, bool, usize)>,
}

/// Segments that close a loop.
pub(super) fn chained(segments: &[&Segment<'_>]) -> Option<Chain> {
    let ended = (0..segments.len()).filter(|i| segments[*i].kind != Kind::Endless);
    let points = ended
        .clone()
        .flat_map(|i| segments[i].points.iter().copied());
    let near = JOINED * extent(&points.collect::<Points>());
    let mut starts = ended;
    starts.find_map(|first| chained_from(segments, first, near))
}

/// The closed chain that begins with a segment.
fn chained_from(segments: &[&Segment<'_>], first: usize, near: f64) -> Option<Chain> {
    let ends = |i: usize| {
        let points = &segments[i].points;
        [points[0], points[points.len() - 1]]
    };
    let mut chain = vec![(first, false)];
    let [start, mut end] = ends(first);
    while distance(start, end) > near {
        let is_free = |i: &usize| {
            segments[*i].kind != Kind::Endless && chain.iter().all(|known| known.0 != *i)
        };
        let mut free = (0..segments.len()).filter(is_free);
        let next = free.find_map(|i| {
            let [from, to] = ends(i);
            let forward = (distance(from, end) <= near).then_some((i, false, to));
            forward.or((distance(to, end) <= near).then_some((i, true, from)))
        });
        let (i, is_back, to) = next?;
        chain.push((i, is_back));
        end = to;
    }
    Some(chain)
}

/// The area within a closed chain, positive if it runs counterclockwise.
pub(super) fn area(segments: &[&Segment<'_>], chain: &[(usize, bool)]) -> f64 {
    let points = looped(segments, chain, false).points;
    let around = points.iter().zip(points.iter().cycle().skip(1));
    0.5 * around.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

/// The points of a chain without the last one; long straight lines are divided if `is_divided`.
fn looped(segments: &[&Segment<'_>], chain: &[(usize, bool)], is_divided: bool) -> Loop {
    let length = |i: usize| {
        segments[i]
            .points
            .windows(2)
            .map(|p| distance(p[0], p[1]))
            .sum::<f64>()
    };
    let part = chain.iter().map(|one| length(one.0)).sum::<f64>() / PARTS;
    let (mut points, mut pieces) = (Points::new(), Vec::new());
    for (i, is_back) in chain {
        let mut own = segments[*i].points.clone();
        let long = LONG[usize::from(segments[*i].kind == Kind::Curve)];
        if *is_back {
            own.reverse();
        }
        pieces.push((*i, *is_back, points.len()));
        for pair in own.windows(2) {
            let length = distance(pair[0], pair[1]);
            let count = if is_divided && length > long * part {
                (length / part).ceil()
            } else {
                1.0
            };
            points.extend((0..count as usize).map(|k| {
                let at = k as f64 / count;
                [0, 1].map(|i| pair[0][i] + at * (pair[1][i] - pair[0][i]))
            }));
        }
    }
    Loop { points, pieces }
}

/// The contour of a closed chain; notes problems.
pub(super) fn contour(
    segments: &[&Segment<'_>],
    mut chain: Chain,
    notes: &mut Notes,
) -> Option<Contour> {
    if area(segments, &chain) > 0.0 {
        chain.reverse();
        chain.iter_mut().for_each(|one| one.1 = !one.1);
    }
    inward(segments, &chain, notes)?;
    let whole = looped(segments, &chain, true);
    let points = &whole.points;
    let count = points.len();
    let corners = corners(points);
    let (start, end) = edge(points, &corners);
    let steps = (end + count - start - 1) % count + 1;
    let mut made = Points::with_capacity(steps + 9);
    for k in 0..=steps {
        let i = (start + k) % count;
        made.push(points[i]);
        if k > 0 && k < steps && corners.contains(&i) {
            made.push(points[i]);
        }
    }
    let outline = match Outline::new(&made) {
        Ok(outline) => outline,
        Err(problem) => {
            let element = segments[chain[0].0].element;
            let help = "compare the base lines of the segments";
            let found = problem.to_string();
            notes.wrong(element, ["the contour", &found, "a closed contour", help]);
            return None;
        }
    };
    let starts = Starts::new(points, (start, end), &outline);
    let arcs: Vec<f64> = whole
        .pieces
        .iter()
        .map(|piece| starts.arc(piece.2))
        .collect();
    let of = |k: usize| Piece {
        segment: whole.pieces[k].0,
        is_along: !whole.pieces[k].1,
        arcs: [arcs[k], arcs[(k + 1) % arcs.len()]],
    };
    let pieces = (0..arcs.len()).map(of).collect();
    Some(Contour {
        points: made,
        outline,
        pieces,
    })
}

/// Notes layups that do not lie inward from the base line.
fn inward(segments: &[&Segment<'_>], chain: &[(usize, bool)], notes: &mut Notes) -> Option<()> {
    let mut is_fine = true;
    for (i, is_back) in chain {
        let segment = segments[*i];
        let (inner, word) = if *is_back {
            (Side::Left, "left")
        } else {
            (Side::Right, "right")
        };
        let what = format!("the layup of {}", segment.element.shown());
        if segment.side != inner {
            let found = format!("direction {:?}", segment.side).to_lowercase();
            let expected = format!("{word}, into the section");
            let help = "let the base line be the outer surface, and the layup lie inward of it";
            notes.wrong(segment.element, [&what, &found, &expected, help]);
            is_fine = false;
        }
        if segment.position != 0.0 && segment.side != Side::Both {
            let found = format!("the base line at the part {} of it", segment.position);
            let help = "base lines of the contour are the outer surface";
            notes.wrong(segment.element, [&what, &found, "position begin", help]);
            is_fine = false;
        }
    }
    is_fine.then_some(())
}

/// The numbers of the points at which a loop turns by more than a corner.
fn corners(points: &[[f64; 2]]) -> Vec<usize> {
    let count = points.len();
    let is_corner = |i: &usize| turn(points, *i).abs() > CORNER;
    (0..count).filter(is_corner).collect()
}

/// The turn of a loop at a point \[rad\].
fn turn(points: &[[f64; 2]], i: usize) -> f64 {
    let count = points.len();
    let [before, here, after] = [i + count - 1, i, i + 1].map(|k| points[k % count]);
    let a = [here[0] - before[0], here[1] - before[1]];
    let b = [after[0] - here[0], after[1] - here[1]];
    (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1])
}

/// First and last point of the contour. Two corners with a straight line between them are a base;
/// of several the one with the smallest x2. Else it is the only corner, or the first point.
fn edge(points: &[[f64; 2]], corners: &[usize]) -> (usize, usize) {
    let count = points.len();
    let base = |k: usize| {
        let (from, to) = (corners[k], corners[(k + 1) % corners.len()]);
        let steps = (to + count - from) % count;
        let line = [0, 1].map(|i| points[to][i] - points[from][i]);
        let length = line[0].hypot(line[1]);
        let off = |i: usize| {
            let d = [0, 1].map(|k| points[i % count][k] - points[from][k]);
            (d[0] * line[1] - d[1] * line[0]).abs() / length
        };
        let is_straight = (1..steps).all(|k| off(from + k) < 1e-6 * length);
        is_straight.then_some((from, to))
    };
    let middle = |base: &(usize, usize)| points[base.0][0] + points[base.1][0];
    let bases = (0..corners.len())
        .filter(|_| corners.len() > 1)
        .filter_map(base);
    match bases.min_by(|a, b| middle(a).total_cmp(&middle(b))) {
        Some((from, to)) => (to, from),
        None => {
            let first = corners.first().copied().unwrap_or(0);
            (first, first)
        }
    }
}

/// The places of points of a loop on its outline.
struct Starts<'a> {
    points: &'a [[f64; 2]],
    start: usize,
    /// Number of points on the contour, without the base.
    steps: usize,
    /// Length of the polygon at each of them.
    sums: Vec<f64>,
    outline: &'a Outline,
}

impl<'a> Starts<'a> {
    fn new(points: &'a [[f64; 2]], (start, end): (usize, usize), outline: &'a Outline) -> Self {
        let count = points.len();
        let steps = (end + count - start - 1) % count + 1;
        let mut sums = vec![0.0];
        for k in 0..steps {
            let [a, b] = [start + k, start + k + 1].map(|i| points[i % count]);
            sums.push(sums[k] + distance(a, b));
        }
        Self {
            points,
            start,
            steps,
            sums,
            outline,
        }
    }

    /// The part of the contour at a point of the loop.
    fn arc(&self, index: usize) -> f64 {
        let count = self.points.len();
        let perimeter = self.outline.perimeter();
        let [from, to] = self.outline.corners();
        let k = (index + count - self.start) % count;
        if k == 0 {
            return from / perimeter;
        }
        if k >= self.steps {
            // on the base, behind the last corner
            let last = self.points[(self.start + self.steps) % count];
            let s = to + distance(last, self.points[index]);
            return (s / perimeter).rem_euclid(1.0);
        }
        let near = from + (to - from) * self.sums[k] / self.sums[self.steps];
        self.outline.nearest(self.points[index], near) / perimeter
    }
}
