//! The lines of all laminates, the adjacent cells, and the sides of the laminates.

use std::collections::HashMap;

use shared_geom::mesh::{Line, LineKind, Mesh};

use super::super::boundary::Curve;
use super::super::plane::{distance, polygon_area};
use super::problem::LaminaProblem;
use super::segments::{Segment, label, sorted};
use super::{Lamina, LaminaSide, fits};

/// Cells next to a line.
#[derive(Debug, Clone, Copy, Default)]
struct Beside {
    left: usize,
    right: usize,
}

type Problems = Vec<(usize, LaminaProblem)>;

/// The lines of all laminates, and the side of each laminate.
pub(super) fn collect(
    mesh: &Mesh,
    laminae: &[Lamina],
) -> Result<(Vec<Segment>, Vec<LaminaSide>), Problems> {
    let mut segments = Vec::new();
    for (index, lamina) in laminae.iter().enumerate() {
        let lines = mesh.lines.iter();
        let own = lines.filter(|line| line.groups.contains(lamina.curve));
        segments.extend(own.map(|line| segment(mesh, line, index)));
    }
    let mut problems = without_length(mesh, laminae, &segments);
    let beside = beside(mesh, &segments);
    for (segment, beside) in segments.iter_mut().zip(&beside) {
        segment.is_alone = beside.left + beside.right == 0;
    }
    let mut sides = Vec::with_capacity(laminae.len());
    for index in 0..laminae.len() {
        let own = segments.iter().zip(&beside);
        let own: Vec<_> = own.filter(|(segment, _)| segment.lamina == index).collect();
        match side_of(mesh, &laminae[index], &own) {
            Ok(side) => sides.push(side),
            Err(problem) => problems.push((index, problem)),
        }
    }
    problems.extend(fits::misfits(mesh, laminae, &segments));
    if sides.len() == laminae.len() {
        problems.extend(fits::twice(mesh, laminae, &segments, &sides));
    }
    if problems.is_empty() {
        Ok((segments, sides))
    } else {
        Err(problems)
    }
}

fn segment(mesh: &Mesh, line: &Line, lamina: usize) -> Segment {
    let point = |node: u32| {
        let position = mesh.nodes[node as usize].position;
        [position.x, position.y]
    };
    let nodes = line.nodes();
    let middle = (line.kind == LineKind::Line3).then(|| nodes[2]);
    Segment {
        lamina,
        tag: line.tag,
        nodes: [nodes[0], nodes[1]],
        middle,
        is_alone: true,
        curve: Curve::new(point(nodes[0]), point(nodes[1]), middle.map(point)),
    }
}

/// Lines of zero length, which have no direction.
fn without_length(mesh: &Mesh, laminae: &[Lamina], segments: &[Segment]) -> Problems {
    let is_point = |segment: &&Segment| {
        let length = distance(segment.curve.first, segment.curve.second);
        length.is_nan() || length == 0.0
    };
    let problem = |segment: &Segment| {
        let problem = LaminaProblem::NoLength {
            curve: label(mesh, laminae, segment.lamina),
            line: segment.tag,
            position: segment.curve.first,
        };
        (segment.lamina, problem)
    };
    let mut found = segments.iter().filter(is_point).map(problem);
    found.next().into_iter().collect()
}

/// The cells next to each line, relative to its direction.
fn beside(mesh: &Mesh, segments: &[Segment]) -> Vec<Beside> {
    // relative to the direction from the lower to the higher node
    let mut known: HashMap<[u32; 2], Beside> = HashMap::new();
    for segment in segments {
        known.insert(segment.key(), Beside::default());
    }
    for cell in &mesh.cells {
        let corner = |&node: &u32| {
            let position = mesh.nodes[node as usize].position;
            [position.x, position.y]
        };
        let is_counterclockwise = polygon_area(cell.corners().iter().map(corner)) > 0.0;
        for ([a, b], _) in cell.kind.sides(cell.nodes()) {
            if let Some(found) = known.get_mut(&sorted([a, b])) {
                if (a < b) == is_counterclockwise {
                    found.left += 1
                } else {
                    found.right += 1
                }
            }
        }
    }
    let seen = |segment: &Segment| {
        let found = known.get(&segment.key()).copied().unwrap_or_default();
        if segment.nodes[0] < segment.nodes[1] {
            found
        } else {
            Beside {
                left: found.right,
                right: found.left,
            }
        }
    };
    segments.iter().map(seen).collect()
}

/// The side of a laminate, given its lines and the cells next to them.
fn side_of(
    mesh: &Mesh,
    lamina: &Lamina,
    lines: &[(&Segment, &Beside)],
) -> Result<LaminaSide, LaminaProblem> {
    let curve = mesh.groups[lamina.curve].label();
    let first = |wanted: &dyn Fn(&Beside) -> bool| {
        let mut found = lines.iter().filter(|(_, beside)| wanted(beside));
        let first = found.next();
        first.map(|(segment, _)| (segment.tag, segment.position(), 1 + found.count()))
    };
    if let Some((line, position, count)) = first(&|beside| beside.left > 0 && beside.right > 0) {
        return Err(LaminaProblem::Inside {
            curve,
            line,
            position,
            count,
        });
    }
    let left = first(&|beside| beside.left > 0);
    let right = first(&|beside| beside.right > 0);
    let alone = first(&|beside| beside.left + beside.right == 0);
    if let (Some(one), Some(other)) = (left, right) {
        return Err(LaminaProblem::SideChanges {
            curve,
            lines: [one.0, other.0],
            positions: [one.1, other.1],
        });
    }
    // the side without cells, if there are cells
    let free = match (left, right) {
        (Some(_), _) => Some(LaminaSide::Right),
        (_, Some(_)) => Some(LaminaSide::Left),
        _ => None,
    };
    let beside = left.or(right);
    match (lamina.side, free.zip(beside), alone) {
        (None, None, _) => Ok(LaminaSide::Center),
        (Some(side), None, _) => Ok(side),
        (None, Some((free, _)), None) => Ok(free),
        (Some(side), Some((free, _)), _) if side == free => Ok(side),
        (Some(side), Some((free, (line, position, _))), _) => Err(LaminaProblem::IntoCells {
            curve,
            side,
            free,
            line,
            position,
        }),
        (None, Some((free, one)), Some(other)) => Err(LaminaProblem::Mixed {
            curve,
            free,
            lines: [one.0, other.0],
            positions: [one.1, other.1],
        }),
    }
}
