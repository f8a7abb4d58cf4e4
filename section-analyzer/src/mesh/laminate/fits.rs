//! Checks whether lines fit each other and the adjacent cells.

use std::collections::HashMap;

use shared_geom::mesh::Mesh;

use super::super::boundary::Curve;
use super::super::plane::distance;
use super::problem::LaminaProblem;
use super::segments::{Segment, label};
use super::{Lamina, LaminaSide};

/// Distance from the border within which a line is on it, relative to its length.
const ALONG: f64 = 0.01;

type Problems = Vec<(usize, LaminaProblem)>;

/// A side of cells of the mesh.
#[derive(Debug, Clone, Copy)]
struct Side {
    nodes: [u32; 2],
    middle: Option<u32>,
    /// Number of cells with this side.
    cells: usize,
}

/// Lines on the border of cells that are not their sides, or have another number of
/// nodes.
pub(super) fn misfits(mesh: &Mesh, laminae: &[Lamina], segments: &[Segment]) -> Problems {
    if mesh.cells.is_empty() || segments.is_empty() {
        return Vec::new();
    }
    let mut sides: HashMap<[u32; 2], Side> = HashMap::new();
    for cell in &mesh.cells {
        for ([a, b], middle) in cell.kind.sides(cell.nodes()) {
            let side = sides.entry([a.min(b), a.max(b)]).or_insert(Side {
                nodes: [a, b],
                middle,
                cells: 0,
            });
            side.cells += 1;
        }
    }
    let mut problems = other_orders(mesh, laminae, segments, &sides);
    problems.extend(along_borders(mesh, laminae, segments, &sides));
    problems
}

/// For each laminate the first line whose nodes differ from the side of the cells.
fn other_orders(
    mesh: &Mesh,
    laminae: &[Lamina],
    segments: &[Segment],
    sides: &HashMap<[u32; 2], Side>,
) -> Problems {
    let is_other = |segment: &&Segment| {
        let [a, b] = segment.nodes;
        let side = sides.get(&[a.min(b), a.max(b)]);
        side.is_some_and(|side| side.middle != segment.middle)
    };
    let mut problems = Vec::new();
    for lamina in 0..laminae.len() {
        let own = segments.iter().filter(|segment| segment.lamina == lamina);
        let mut own = own.filter(is_other);
        if let Some(segment) = own.next() {
            let problem = LaminaProblem::OtherOrder {
                curve: label(mesh, laminae, lamina),
                line: segment.tag,
                position: segment.position(),
                has_middle: segment.middle.is_some(),
                count: 1 + own.count(),
            };
            problems.push((lamina, problem));
        }
    }
    problems
}

/// For each laminate the first line that is not a side of a cell, although it is on the
/// border of cells.
fn along_borders(
    mesh: &Mesh,
    laminae: &[Lamina],
    segments: &[Segment],
    sides: &HashMap<[u32; 2], Side>,
) -> Problems {
    let border: Vec<Curve> = sides
        .values()
        .filter(|side| side.cells == 1)
        .map(|side| {
            let [a, b] = side.nodes.map(|node| position(mesh, node));
            Curve::new(a, b, side.middle.map(|node| position(mesh, node)))
        })
        .collect();
    let mut problems = Vec::new();
    for lamina in 0..laminae.len() {
        let own = segments.iter().filter(|segment| segment.lamina == lamina);
        let mut own = own.filter(|line| line.is_alone && runs_along(&line.curve, &border));
        if let Some(segment) = own.next() {
            let problem = LaminaProblem::NoSide {
                curve: label(mesh, laminae, lamina),
                line: segment.tag,
                position: segment.position(),
                count: 1 + own.count(),
            };
            problems.push((lamina, problem));
        }
    }
    problems
}

fn position(mesh: &Mesh, node: u32) -> [f64; 2] {
    let position = mesh.nodes[node as usize].position;
    [position.x, position.y]
}

/// Whether a curve lies on the border, checked at three of its points.
fn runs_along(curve: &Curve, border: &[Curve]) -> bool {
    let tolerance = ALONG * distance(curve.first, curve.second);
    [0.25, 0.5, 0.75].iter().all(|&t| {
        let position = curve.at(t);
        border.iter().any(|side| {
            let hull = side.hull();
            let is_near = (0..2).all(|axis| {
                let [a, b, c] = hull.map(|point| point[axis]);
                let (low, high) = (a.min(b).min(c), a.max(b).max(c));
                low - tolerance <= position[axis] && position[axis] <= high + tolerance
            });
            is_near && distance(side.at(side.nearest(position)), position) <= tolerance
        })
    })
}

/// Lines with two laminates on one side, and lines that share both ends.
pub(super) fn twice(
    mesh: &Mesh,
    laminae: &[Lamina],
    segments: &[Segment],
    sides: &[LaminaSide],
) -> Problems {
    // used sides, relative to the direction from the lower to the higher node
    let mut taken: HashMap<[u32; 2], Vec<(LaminaSide, &Segment)>> = HashMap::new();
    let mut reported = Vec::new();
    let mut problems = Vec::new();
    for segment in segments {
        let forward = segment.nodes[0] < segment.nodes[1];
        let side = match (sides[segment.lamina], forward) {
            (LaminaSide::Left, false) => LaminaSide::Right,
            (LaminaSide::Right, false) => LaminaSide::Left,
            (side, _) => side,
        };
        let others = taken.entry(segment.key()).or_default();
        let meets = |(other, line): &&(LaminaSide, &Segment)| {
            line.middle != segment.middle
                || *other == side
                || [*other, side].contains(&LaminaSide::Center)
        };
        if let Some((_, other)) = others.iter().find(meets) {
            let pair = [other.lamina, segment.lamina];
            if !reported.contains(&pair) {
                reported.push(pair);
                let curves = pair.map(|lamina| label(mesh, laminae, lamina));
                let position = segment.position();
                let problem = if other.middle == segment.middle {
                    LaminaProblem::Twice {
                        curves,
                        line: segment.tag,
                        position,
                    }
                } else {
                    LaminaProblem::SameEnds {
                        curves,
                        lines: [other.tag, segment.tag],
                        position,
                    }
                };
                problems.push((segment.lamina, problem));
            }
        }
        others.push((side, segment));
    }
    problems
}
