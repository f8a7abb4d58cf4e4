//! Ends and joints of laminates.

use std::collections::BTreeMap;

use shared_geom::mesh::Mesh;

use super::Lamina;
use super::problem::{LaminaProblem, limited};
use super::segments::{Segment, label};

/// Change of direction up to which a wall continues smoothly \[rad\]: 15 degrees.
pub(super) const SMOOTH: f64 = 15.0 * std::f64::consts::PI / 180.0;
/// An end of a line with a laminate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct End {
    pub segment: usize,
    /// 0 for its first node, 1 for its second.
    pub number: usize,
}

/// Laminates that meet at a node.
#[derive(Debug)]
pub(super) enum Meeting {
    /// The laminates of one line end.
    Free(Vec<End>),
    /// The laminates of two lines.
    Through([Vec<End>; 2]),
    /// One that continues through the node, and one that ends on it.
    Tee { wall: [End; 2], web: End },
}

/// A node at the end of lines with laminates.
#[derive(Debug)]
pub(super) struct Joint {
    pub node: u32,
    pub meeting: Meeting,
}

type Problems = Vec<(usize, LaminaProblem)>;

/// The nodes at which the lines end, in the order of the mesh.
pub(super) fn joints(
    mesh: &Mesh,
    laminae: &[Lamina],
    segments: &[Segment],
) -> Result<Vec<Joint>, Problems> {
    let mut ends: BTreeMap<u32, BTreeMap<[u32; 2], Vec<End>>> = BTreeMap::new();
    for (index, segment) in segments.iter().enumerate() {
        for (number, node) in segment.nodes.into_iter().enumerate() {
            let lines = ends.entry(node).or_default();
            lines.entry(segment.key()).or_default().push(End {
                segment: index,
                number,
            });
        }
    }
    let mut problems = Vec::new();
    let mut joints = Vec::with_capacity(ends.len());
    for (node, lines) in ends {
        let mut lines: Vec<_> = lines.into_values().collect();
        let meeting = match lines.len() {
            1 => Meeting::Free(lines.swap_remove(0)),
            2 => Meeting::Through([lines.swap_remove(0), lines.swap_remove(0)]),
            _ => match tee(segments, &lines) {
                Some(tee) => tee,
                None => {
                    problems.push(branch(mesh, laminae, segments, node, &lines));
                    continue;
                }
            },
        };
        joints.push(Joint { node, meeting });
    }
    if problems.is_empty() {
        Ok(joints)
    } else {
        Err(limited(problems, "junctions of laminates"))
    }
}

/// One wall that continues smoothly and one that ends on it, if the three lines have this
/// form.
fn tee(segments: &[Segment], lines: &[Vec<End>]) -> Option<Meeting> {
    let alone = |line: &Vec<End>| match line[..] {
        [end] => segments[end.segment].is_alone.then_some(end),
        _ => None,
    };
    let ends: Option<Vec<End>> = lines.iter().map(alone).collect();
    let [a, b, c] = ends?[..] else {
        return None;
    };
    let ways = [[a, b, c], [b, c, a], [c, a, b]];
    let smoothness = |[a, b, _]: &[End; 3]| turn(leading(segments, *a), away(segments, *b)).abs();
    let best = ways
        .into_iter()
        .min_by(|a, b| smoothness(a).total_cmp(&smoothness(b)))?;
    let [a, b, web] = best;
    (smoothness(&best) <= SMOOTH).then_some(Meeting::Tee { wall: [a, b], web })
}

fn branch(
    mesh: &Mesh,
    laminae: &[Lamina],
    segments: &[Segment],
    node: u32,
    lines: &[Vec<End>],
) -> (usize, LaminaProblem) {
    let mut of: Vec<usize> = lines
        .iter()
        .flatten()
        .map(|end| segments[end.segment].lamina)
        .collect();
    of.sort_unstable();
    of.dedup();
    let position = mesh.nodes[node as usize].position;
    let problem = LaminaProblem::Branch {
        node: mesh.nodes[node as usize].tag,
        position: [position.x, position.y],
        lines: lines.len(),
        curves: of.iter().map(|&one| label(mesh, laminae, one)).collect(),
    };
    (of[0], problem)
}

/// Unit tangent of a line at its end, from the end into the line.
pub(super) fn away(segments: &[Segment], end: End) -> [f64; 2] {
    let curve = &segments[end.segment].curve;
    match end.number {
        0 => curve.direction(0.0),
        _ => curve.direction(1.0).map(|x| -x),
    }
}

/// Unit tangent of a line at its end, from the line into the end.
pub(super) fn leading(segments: &[Segment], end: End) -> [f64; 2] {
    away(segments, end).map(|x| -x)
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// `n = x cross t`: to the left of a direction.
pub(super) fn left_of(t: [f64; 2]) -> [f64; 2] {
    [-t[1], t[0]]
}

/// Angle from a direction to another, positive to the left \[rad\].
pub(super) fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    cross(from, to).atan2(dot(from, to))
}
