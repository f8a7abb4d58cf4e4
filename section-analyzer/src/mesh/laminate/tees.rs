//! Walls that end on other walls.
//!
//! The continuous wall is divided at the points where the levels of the other one meet
//! its face, with a row of short lines; the nodes of the row on this face are the nodes
//! at the end of the other wall:
//!
//! ```text
//!            w |  |  |  levels h of the wall that ends
//!              |  |  |
//!     ---------*--*--*---------  face at the level F of the continuous wall
//!        a     |row  |     b
//!     ---------*--*--*---------> t
//!
//! s(h) = (h - F n . m) / (t . m)       position along t of the level h
//! ```
//!
//! This is (S-127), with n the left of t and m the left of the wall that ends.

use shared_geom::mesh::{Mesh, Node};

use super::super::boundary::Curve;
use super::super::plane::distance;
use super::Lamina;
use super::build::plane_of;
use super::joints::{End, Joint, Meeting, away, cross, dot, left_of};
use super::layers::{Ends, Layers};
use super::mitre::View;
use super::problem::{LaminaProblem, limited};
use super::segments::{Segment, label};

/// Least sine of the angle between two walls: 15 degrees.
const LEAST_SINE: f64 = 0.2588;
/// Fraction of a line that another wall may cover at an end.
const MOST: f64 = 0.75;
/// Positions along a row that differ by less, relative to its length, are treated as
/// equal.
const SAME: f64 = 1e-9;

/// A wall that ends on the face of another.
#[derive(Debug)]
pub(super) struct Landing {
    web: End,
    /// For each of its levels an end of a line of the row, and the level there.
    faces: Vec<(End, usize)>,
}

type Problem = (usize, LaminaProblem);

/// Makes the rows: adds their lines to `segments`, and shortens the adjacent ones.
pub(super) fn open(
    mesh: &mut Mesh,
    laminae: &[Lamina],
    segments: &mut Vec<Segment>,
    layers: &[Layers],
    joints: &[Joint],
) -> Result<Vec<Landing>, Vec<Problem>> {
    let mut landings = Vec::new();
    let mut problems = Vec::new();
    for joint in joints {
        if let Meeting::Tee { wall, web } = joint.meeting {
            let tee = Tee::new(mesh, segments, layers, joint.node, wall, web);
            match tee.check(mesh, laminae, segments) {
                Ok(()) => landings.push(tee.open(mesh, segments)),
                Err(problem) => problems.push(problem),
            }
        }
    }
    if problems.is_empty() {
        Ok(landings)
    } else {
        Err(limited(problems, "junctions of laminates"))
    }
}

/// Joins the walls that end to their faces.
pub(super) fn land(landings: &[Landing], ends: &mut [Ends]) {
    for landing in landings {
        let face = |&(end, level): &(End, usize)| ends[end.segment][end.number][level];
        let nodes = landing.faces.iter().map(face).collect();
        ends[landing.web.segment][landing.web.number] = nodes;
    }
}

/// A wall that ends on another.
struct Tee {
    node: u32,
    position: [f64; 2],
    wall: [End; 2],
    web: End,
    /// The lines of the wall before and after the node.
    curves: [Curve; 2],
    /// Whether the line before the node has the direction of the wall.
    along: bool,
    /// Index of the level of the face on which the other wall ends.
    face: usize,
    sine: f64,
    /// Positions along the wall of the levels that end, parallel to them.
    positions: Vec<f64>,
    /// Ends of the lines of the row, ascending; the node is one of them or between them.
    marks: Vec<f64>,
    /// Distance from the node to the face, along the wall that ends.
    depth: f64,
}

impl Tee {
    fn new(
        mesh: &Mesh,
        segments: &[Segment],
        layers: &[Layers],
        node: u32,
        wall: [End; 2],
        web: End,
    ) -> Self {
        let position = mesh.nodes[node as usize].position;
        let before = View::new(segments, layers, wall[0], true);
        let behind = View::new(segments, layers, wall[1], false);
        let t = [0, 1].map(|i| before.tangent[i] + behind.tangent[i]);
        let t = t.map(|x| x / t[0].hypot(t[1]));
        let w = away(segments, web);
        let normal = left_of(t);
        let sine = cross(t, w);
        let levels = before.levels();
        let face = if sine > 0.0 {
            levels.last()
        } else {
            levels.first()
        };
        let (height, face) = face.copied().unwrap_or_default();
        // to the left of the wall that ends, like its levels
        let m = left_of(w).map(|x| if web.number == 0 { x } else { -x });
        let own = &layers[segments[web.segment].lamina].levels;
        let along = |level: &f64| (level - height * dot(normal, m)) / dot(t, m);
        let positions: Vec<f64> = own.iter().map(along).collect();
        let mut tee = Self {
            node,
            position: [position.x, position.y],
            wall,
            web,
            curves: wall.map(|end| segments[end.segment].curve),
            along: before.is_along(),
            face,
            sine: sine.abs(),
            marks: Vec::new(),
            positions,
            depth: height / dot(normal, w),
        };
        tee.mark();
        tee
    }

    /// The ends of the lines of the row: the levels, and the node if it lies beyond.
    fn mark(&mut self) {
        let mut marks = self.positions.clone();
        marks.sort_unstable_by(f64::total_cmp);
        let (low, high) = (marks[0], marks[marks.len() - 1]);
        let tolerance = SAME * (high - low);
        for position in marks.iter_mut().chain(&mut self.positions) {
            if position.abs() <= tolerance {
                *position = 0.0;
            }
        }
        if low > tolerance {
            marks.insert(0, 0.0);
        } else if high < -tolerance {
            marks.push(0.0);
        }
        self.marks = marks;
    }

    /// Covered lengths of the lines before and after, and of the line that ends.
    fn taken(&self) -> [(End, f64); 3] {
        let (low, high) = (self.marks[0], self.marks[self.marks.len() - 1]);
        [
            (self.wall[0], (-low).max(0.0)),
            (self.wall[1], high.max(0.0)),
            (self.web, self.depth),
        ]
    }

    fn check(&self, mesh: &Mesh, laminae: &[Lamina], segments: &[Segment]) -> Result<(), Problem> {
        let of = [self.web, self.wall[0]].map(|end| segments[end.segment].lamina);
        let curves = of.map(|one| label(mesh, laminae, one));
        let node = mesh.nodes[self.node as usize].tag;
        if self.sine.is_nan() || self.sine < LEAST_SINE {
            let problem = LaminaProblem::Branch {
                node,
                position: self.position,
                lines: 3,
                curves: curves.to_vec(),
            };
            return Err((of[0], problem));
        }
        for (end, taken) in self.taken() {
            let line = &segments[end.segment];
            let length = distance(line.curve.first, line.curve.second);
            if taken.is_nan() || taken > MOST * length {
                let problem = LaminaProblem::Crowded {
                    curves,
                    node,
                    position: self.position,
                    line: line.tag,
                    length,
                    taken,
                };
                return Err((of[0], problem));
            }
        }
        Ok(())
    }

    fn open(&self, mesh: &mut Mesh, segments: &mut Vec<Segment>) -> Landing {
        let [before, behind, web] = self.taken();
        let lamina = segments[self.wall[0].segment].clone();
        let z = plane_of(mesh, segments);
        let mut nodes = Vec::with_capacity(self.marks.len());
        for &mark in &self.marks {
            nodes.push(if mark == 0.0 {
                self.node
            } else {
                new_node(mesh, z, self.at(mark))
            });
        }
        for ((end, taken), node) in [(before, nodes[0]), (behind, nodes[nodes.len() - 1])] {
            if taken > 0.0 {
                shorten(mesh, &mut segments[end.segment], end.number, taken, node);
            }
        }
        let own = new_node(mesh, z, self.position);
        let (end, depth) = web;
        shorten(mesh, &mut segments[end.segment], end.number, depth, own);

        let first = segments.len();
        for (marks, nodes) in self.marks.windows(2).zip(nodes.windows(2)) {
            let center = self.at(0.5 * (marks[0] + marks[1]));
            let middle = lamina.middle.map(|_| new_node(mesh, z, center));
            let mut ends = [nodes[0], nodes[1]];
            let mut positions = [self.at(marks[0]), self.at(marks[1])];
            if !self.along {
                ends.reverse();
                positions.reverse();
            }
            segments.push(Segment {
                nodes: ends,
                middle,
                curve: Curve::new(positions[0], positions[1], middle.map(|_| center)),
                ..lamina.clone()
            });
        }
        let face = |position: &f64| (self.end_at(first, *position), self.face);
        Landing {
            web: self.web,
            faces: self.positions.iter().map(face).collect(),
        }
    }

    /// The end of a line of the row at a position; `first` is the first line.
    fn end_at(&self, first: usize, position: f64) -> End {
        let found = self.marks.iter().position(|mark| *mark == position);
        let mark = found.unwrap_or(0);
        let line = mark.min(self.marks.len() - 2);
        End {
            segment: first + line,
            number: usize::from((mark > line) == self.along),
        }
    }

    /// The point on the wall at this distance along it.
    fn at(&self, mark: f64) -> [f64; 2] {
        if mark == 0.0 {
            return self.position;
        }
        let which = usize::from(mark > 0.0);
        let curve = &self.curves[which];
        curve.at(parameter(curve, self.wall[which].number, mark.abs()))
    }
}

/// The parameter of a curve at the distance `way` from one of its ends, along the tangent
/// there.
fn parameter(curve: &Curve, end: usize, way: f64) -> f64 {
    let whole = distance(curve.first, curve.second);
    let inward = |t: f64| if end == 0 { t } else { 1.0 - t };
    let start = curve.at(inward(0.0));
    let direction = match end {
        0 => curve.direction(0.0),
        _ => curve.direction(1.0).map(|x| -x),
    };
    let mut t = way / whole;
    // each step corrects the deviation from a uniform line
    for _ in 0..12 {
        let position = curve.at(inward(t));
        let gone = dot([position[0] - start[0], position[1] - start[1]], direction);
        if gone > 0.0 {
            t = (t * way / gone).min(1.0);
        }
    }
    inward(t)
}

/// Removes the length `taken` of a line at an end, which becomes `node`.
fn shorten(mesh: &mut Mesh, segment: &mut Segment, end: usize, taken: f64, node: u32) {
    let z = mesh.nodes[node as usize].position.z;
    let curve = segment.curve;
    let cut = parameter(&curve, end, taken);
    let (from, to) = if end == 0 { (cut, 1.0) } else { (0.0, cut) };
    let center = curve.at(0.5 * (from + to));
    segment.nodes[end] = node;
    segment.middle = segment.middle.map(|_| new_node(mesh, z, center));
    let middle = segment.middle.map(|_| center);
    segment.curve = Curve::new(curve.at(from), curve.at(to), middle);
}

fn new_node(mesh: &mut Mesh, z: f64, [x, y]: [f64; 2]) -> u32 {
    let tag = mesh.nodes.iter().map(|node| node.tag).max();
    mesh.nodes.push(Node {
        tag: tag.unwrap_or(0).saturating_add(1),
        position: [x, y, z].into(),
    });
    mesh.nodes.len() as u32 - 1
}
