//! The nodes across the laminates at the ends of their lines.
//!
//! Between two lines with unit normals n1, n2 the node of a level h lies at the offset o
//! from the node of the lines, which has the distance h from both:
//!
//! ```text
//! n1 . o = h1 ,   n2 . o = h2 ;      o = h (n1 + n2) / (1 + n1 . n2)   if h1 = h2 = h
//! ```
//!
//! This is (S-126). With the same levels on both sides it is the mitre of a corner and
//! the mean normal of a smooth wall.

use super::build::Builder;
use super::joints::{End, Joint, Meeting, SMOOTH, away, cross, dot, leading, left_of, turn};
use super::layers::{Bank, Ends, Layers};
use super::problem::{LaminaProblem, limited};
use super::segments::{Segment, label};

/// Largest change of direction that is mitred \[rad\]: 135 degrees; then the outer edge
/// of a layer is 2.6 times as far from the corner as from the line.
const SHARPEST: f64 = 135.0 * std::f64::consts::PI / 180.0;

/// Error of an angle due to the digits of coordinates \[rad\].
const ROUND_OFF: f64 = 1e-6;

type Nodes = Vec<(End, Vec<u32>)>;
type Problem = (usize, LaminaProblem);

/// A laminate at a node, relative to the path through the node.
pub(super) struct View<'a> {
    end: End,
    /// Whether the line has the direction of the path.
    along: bool,
    /// Unit tangent of the path.
    pub tangent: [f64; 2],
    layers: &'a Layers,
}

impl<'a> View<'a> {
    /// View of the line before the node (`is_first`), or of the line after it.
    pub fn new(segments: &[Segment], layers: &'a [Layers], end: End, is_first: bool) -> Self {
        Self {
            end,
            along: (end.number == 1) == is_first,
            tangent: if is_first {
                leading(segments, end)
            } else {
                away(segments, end)
            },
            layers: &layers[segments[end.segment].lamina],
        }
    }

    pub fn is_along(&self) -> bool {
        self.along
    }

    pub fn bank(&self) -> Bank {
        self.layers.bank.seen(self.along)
    }

    /// A level of the laminate relative to the path, or the inverse.
    pub fn turned(&self, level: f64) -> f64 {
        if self.along { level } else { 0.0 - level }
    }

    /// The levels, ascending to the left of the path, each with its index.
    pub fn levels(&self) -> Vec<(f64, usize)> {
        let levels = self.layers.levels.iter().enumerate();
        let mut seen: Vec<_> = levels
            .map(|(index, &level)| (self.turned(level), index))
            .collect();
        if !self.along {
            seen.reverse();
        }
        seen
    }

    /// Whether two levels are equal.
    fn is_same(&self, other: &Self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.layers.tolerance().max(other.layers.tolerance())
    }

    /// Whether both have the same levels.
    pub fn equals(&self, other: &Self) -> bool {
        let (own, others) = (self.levels(), other.levels());
        let mut pairs = own.iter().zip(&others);
        own.len() == others.len() && pairs.all(|(a, b)| self.is_same(other, a.0, b.0))
    }
}

/// Makes the nodes at the ends of all lines: for each line the nodes of its levels.
pub(super) fn join(builder: &mut Builder<'_>, joints: &[Joint]) -> Result<Vec<Ends>, Vec<Problem>> {
    let mut ends = vec![Ends::default(); builder.segments.len()];
    let mut problems = Vec::new();
    for joint in joints {
        let found = match &joint.meeting {
            Meeting::Free(of) => Ok(all_single(builder, joint.node, of)),
            // its row has been made before
            Meeting::Tee { wall: [a, b], web } => {
                Ok(all_single(builder, joint.node, &[*a, *b, *web]))
            }
            Meeting::Through(lines) => through(builder, joint.node, lines),
        };
        match found {
            Ok(found) => {
                for (end, nodes) in found {
                    ends[end.segment][end.number] = nodes;
                }
            }
            Err(problem) => problems.push(problem),
        }
    }
    if problems.is_empty() {
        Ok(ends)
    } else {
        Err(limited(problems, "joints of laminates"))
    }
}

fn all_single(builder: &mut Builder<'_>, node: u32, ends: &[End]) -> Nodes {
    let single = |&end: &End| (end, single(builder, node, end));
    ends.iter().map(single).collect()
}

/// The nodes of a laminate that is joined to no other: along the normal of its line.
fn single(builder: &mut Builder<'_>, node: u32, end: End) -> Vec<u32> {
    let view = View::new(builder.segments, builder.layers, end, end.number == 1);
    let normal = left_of(view.tangent);
    let levels = &view.layers.levels;
    let offsets = levels.iter().map(|&level| normal.map(|x| level * x));
    let offsets: Vec<_> = offsets.collect();
    builder.nodes_at(node, &offsets)
}

/// The nodes of the laminates of two lines.
fn through(builder: &mut Builder<'_>, node: u32, lines: &[Vec<End>; 2]) -> Result<Nodes, Problem> {
    let (segments, layers) = (builder.segments, builder.layers);
    let view = |end: &End, is_first| View::new(segments, layers, *end, is_first);
    let before: Vec<_> = lines[0].iter().map(|end| view(end, true)).collect();
    let mut behind: Vec<_> = lines[1].iter().map(|end| view(end, false)).collect();
    let mut nodes = Vec::new();
    // cells next to both lines connect the ends
    let mut is_joined = lines.iter().flatten().all(|end| !is_alone(builder, *end));
    for one in &before {
        let same = behind.iter().position(|other| other.bank() == one.bank());
        match same.map(|other| behind.swap_remove(other)) {
            Some(other) => {
                nodes.extend(pair(builder, node, one, &other)?);
                is_joined = true;
            }
            None => {
                let other = behind
                    .iter()
                    .find(|other| other.bank() == Bank::Middle || one.bank() == Bank::Middle);
                if let Some(other) = other {
                    return Err(unlike(builder, node, [one, other]));
                }
                nodes.push((one.end, single(builder, node, one.end)));
            }
        }
    }
    for other in &behind {
        if let Some(one) = before
            .iter()
            .find(|one| lamina(builder, one) == lamina(builder, other))
        {
            return Err(unlike(builder, node, [one, other]));
        }
        nodes.push((other.end, single(builder, node, other.end)));
    }
    match (is_joined, before.first(), behind.first()) {
        (false, Some(one), Some(other)) => Err(unlike(builder, node, [one, other])),
        _ => Ok(nodes),
    }
}

/// Whether no cell of the mesh is next to the line of an end.
fn is_alone(builder: &Builder<'_>, end: End) -> bool {
    builder.segments[end.segment].is_alone
}

fn lamina(builder: &Builder<'_>, view: &View<'_>) -> usize {
    builder.segments[view.end.segment].lamina
}

/// The problem of laminates that cannot be joined as they are on different sides of their
/// lines.
fn unlike(builder: &Builder<'_>, node: u32, views: [&View<'_>; 2]) -> Problem {
    let of = views.map(|view| lamina(builder, view));
    let curves = of.map(|one| label(builder.mesh, builder.laminae, one));
    let (tag, position) = builder.named(node);
    let problem = match of[0] == of[1] {
        true => LaminaProblem::AgainstEachOther {
            curve: curves[0].clone(),
            lines: views.map(|view| builder.segments[view.end.segment].tag),
            node: tag,
            position,
        },
        false if views.iter().any(|view| view.bank() == Bank::Middle) => LaminaProblem::OffCenter {
            curves,
            node: tag,
            position,
        },
        false => LaminaProblem::OtherSide {
            curves,
            node: tag,
            position,
        },
    };
    (of[1], problem)
}

/// The nodes of two laminates on the same side.
fn pair(
    builder: &mut Builder<'_>,
    node: u32,
    one: &View<'_>,
    other: &View<'_>,
) -> Result<Nodes, Problem> {
    if lamina(builder, one) == lamina(builder, other) && one.along != other.along {
        return Err(unlike(builder, node, [one, other]));
    }
    let angle = turn(one.tangent, other.tangent);
    let equal = one.equals(other);
    if angle.abs() > SHARPEST + ROUND_OFF {
        // both fit if the corner opens away from the laminates, and cells between them
        // connect them
        let opens = match one.bank() {
            Bank::Left => angle < 0.0,
            Bank::Right => angle > 0.0,
            Bank::Middle => false,
        };
        let is_held = ![one, other].iter().any(|view| is_alone(builder, view.end));
        if opens && is_held {
            return Ok(all_single(builder, node, &[one.end, other.end]));
        }
        return Err(sharp(builder, node, other, angle));
    }
    if equal || angle.abs() <= SMOOTH {
        return Ok(stepped(builder, node, one, other));
    }
    if one.layers.levels.len() != other.layers.levels.len() {
        return Err(differ(builder, node, [one, other]));
    }
    let normals = [one, other].map(|view| left_of(view.tangent));
    let determinant = cross(normals[0], normals[1]);
    let (levels, others) = (one.levels(), other.levels());
    let offset = |(&(h1, _), &(h2, _)): (&(f64, usize), &(f64, usize))| {
        [
            (h1 * normals[1][1] - h2 * normals[0][1]) / determinant,
            (h2 * normals[0][0] - h1 * normals[1][0]) / determinant,
        ]
    };
    let offsets: Vec<_> = levels.iter().zip(&others).map(offset).collect();
    let made = builder.nodes_at(node, &offsets);
    Ok(vec![
        (one.end, in_order(&levels, &made)),
        (other.end, in_order(&others, &made)),
    ])
}

/// The nodes, parallel to the levels of the laminate.
fn in_order(levels: &[(f64, usize)], made: &[u32]) -> Vec<u32> {
    let mut nodes = vec![0; levels.len()];
    for (&(_, index), &node) in levels.iter().zip(made) {
        nodes[index] = node;
    }
    nodes
}

/// The nodes of two laminates with the mean normal: common levels share nodes.
fn stepped(builder: &mut Builder<'_>, node: u32, one: &View<'_>, other: &View<'_>) -> Nodes {
    let [n1, n2] = [one, other].map(|view| left_of(view.tangent));
    let mean = [0, 1].map(|i| (n1[i] + n2[i]) / (1.0 + dot(n1, n2)));
    let offset = |&(level, _): &(f64, usize)| mean.map(|x| level * x);
    let levels = one.levels();
    let offsets: Vec<_> = levels.iter().map(offset).collect();
    let made = builder.nodes_at(node, &offsets);
    let others = other.levels();
    let shared = |&(level, _): &(f64, usize)| {
        let same = |(own, _): &(f64, usize)| one.is_same(other, *own, level);
        levels.iter().position(same).map(|index| made[index])
    };
    let mut of_other = Vec::with_capacity(others.len());
    for level in &others {
        of_other.push(match shared(level) {
            Some(node) => node,
            None => builder.nodes_at(node, &[offset(level)])[0],
        });
    }
    vec![
        (one.end, in_order(&levels, &made)),
        (other.end, in_order(&others, &of_other)),
    ]
}

fn sharp(builder: &Builder<'_>, node: u32, view: &View<'_>, angle: f64) -> Problem {
    let lamina = lamina(builder, view);
    let (node, position) = builder.named(node);
    let problem = LaminaProblem::Sharp {
        curve: label(builder.mesh, builder.laminae, lamina),
        node,
        position,
        turn: angle.abs(),
        limit: SHARPEST,
    };
    (lamina, problem)
}

fn differ(builder: &Builder<'_>, node: u32, views: [&View<'_>; 2]) -> Problem {
    let of = views.map(|view| lamina(builder, view));
    let (node, position) = builder.named(node);
    let problem = LaminaProblem::Differ {
        curves: of.map(|one| label(builder.mesh, builder.laminae, one)),
        layers: views.map(|view| view.layers.plies.len()),
        node,
        position,
    };
    (of[1], problem)
}
