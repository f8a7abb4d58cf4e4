//! The checks of the cells, in their order.

use super::boundary::Boundary;
use super::coincident::coincident_nodes;
use super::components::{check_connected, part_of_each_cell};
use super::contact::contacts;
use super::findings::{DoubledNodes, HangingNode, NarrowGap, Seam};
use super::orientation::orient;
use super::plane::PlaneMesh;
use super::problem::{MeshProblem, limited_to};
use super::seams::{Groups, doubled_sides, representatives, seams};
use super::sides::sides;

/// Surface pairs reported per kind of problem.
const MOST_REPORTED: usize = 5;

/// Warnings about cells without problems.
#[derive(Debug)]
pub(super) struct CheckedCells {
    /// Number of cells that were reversed to counterclockwise.
    pub(super) reversed: usize,
    /// Nodes at the same position.
    pub(super) coincident: Vec<[u32; 2]>,
    pub(super) seams: Vec<Seam>,
    pub(super) hanging: Vec<HangingNode>,
    pub(super) gaps: Vec<NarrowGap>,
    /// Nodes at which walls touch without a shared side.
    pub(super) pinches: Vec<u32>,
}

/// Makes the cells counterclockwise, and checks that they fit and are connected.
pub(super) fn check_cells(
    plane: &mut PlaneMesh,
    groups: Groups<'_>,
    doubled_nodes: DoubledNodes,
) -> Result<CheckedCells, Vec<MeshProblem>> {
    let (reversed, neighbors, mut problems) = turn_and_fit(plane);
    let boundary = Boundary::of(plane);
    let coincident = coincident_nodes(plane, &boundary);
    let least = representatives(plane.nodes.len(), &coincident);
    let doubled = doubled_sides(&boundary, &least);
    // contacts can be found only if all cells are sound
    let found = || contacts(plane, &boundary, &least, &doubled, groups);
    let contacts = problems.is_empty().then(found).unwrap_or_default();

    let part_of_cell = part_of_each_cell(plane.cells.len(), &neighbors);
    let slits = Slits {
        allowed: doubled_nodes == DoubledNodes::Allow,
        count: part_of_cell.iter().max().map_or(0, |&last| last + 1),
        part_of_cell,
    };
    let seams = seams(plane, &boundary, &doubled, groups, |cells| {
        slits.parts(cells)
    });
    // parts that touch are reported as seams, and not again as parts
    let mut joined = neighbors;
    joined.extend(
        doubled
            .iter()
            .map(|pair| pair.map(|side| boundary.sides[side].cell)),
    );
    joined.extend(contacts.hangs_on.iter().chain(&contacts.overlapping));
    let label = |cell: usize| groups.label(cell);
    let connected = check_connected(plane, &joined, &coincident, &contacts.gaps, label);

    let overlaps = contacts.overlaps.into_iter().map(MeshProblem::DoubleCover);
    problems.extend(limited_to(
        MOST_REPORTED,
        overlaps.collect(),
        "pairs of surfaces that overlap",
    ));
    let (seams, wrong) = slits.of_seams(seams);
    problems.extend(wrong);
    let (hanging, wrong) = slits.of_hanging(contacts.hanging, &contacts.hangs_on);
    problems.extend(wrong);
    problems.extend(connected.err());
    if problems.is_empty() {
        Ok(CheckedCells {
            reversed,
            coincident,
            seams,
            hanging,
            gaps: contacts.gaps,
            pinches: boundary.pinches(plane.nodes.len()),
        })
    } else {
        Err(problems)
    }
}

/// Makes the cells counterclockwise; returns the number of reversed ones, the pairs of
/// cells that share a side, and the problems of cells and sides.
fn turn_and_fit(plane: &mut PlaneMesh) -> (usize, Vec<[usize; 2]>, Vec<MeshProblem>) {
    let oriented = orient(plane);
    let sides = sides(plane, oriented.is_ok());
    let mut problems = Vec::new();
    let reversed = oriented.unwrap_or_else(|inverted| {
        problems.extend(inverted);
        0
    });
    problems.extend(sides.problems);
    (reversed, sides.neighbors, problems)
}

/// Intended slits, and slits that are problems.
#[derive(Debug)]
struct Slits {
    /// Whether the user allows them.
    allowed: bool,
    /// The part of the section that each cell belongs to.
    part_of_cell: Vec<usize>,
    /// Number of parts.
    count: usize,
}

impl Slits {
    /// The number of parts of the section, if the two cells belong to different ones.
    fn parts(&self, [a, b]: [usize; 2]) -> Option<usize> {
        (self.part_of_cell[a] != self.part_of_cell[b]).then_some(self.count)
    }

    /// Seams that are intended, or lie within one region, and seams that are problems.
    fn of_seams(&self, seams: Vec<Seam>) -> (Vec<Seam>, Vec<MeshProblem>) {
        let is_slit = |seam: &Seam| {
            seam.parts.is_none() && (self.allowed || seam.groups[0] == seam.groups[1])
        };
        let (slits, wrong): (Vec<_>, Vec<_>) = seams.into_iter().partition(is_slit);
        let allowed = self.allowed;
        let problem = |seam| MeshProblem::DoubledNodes { seam, allowed };
        let wrong = wrong.into_iter().map(problem).collect();
        (
            slits,
            limited_to(MOST_REPORTED, wrong, "pairs of surfaces that touch"),
        )
    }

    /// Hanging nodes that are intended, and hanging nodes that are problems, by the
    /// surfaces between which they lie; `cells` are the cell with the corner and the cell
    /// with the side of each.
    fn of_hanging(
        &self,
        nodes: Vec<HangingNode>,
        cells: &[[usize; 2]],
    ) -> (Vec<HangingNode>, Vec<MeshProblem>) {
        let mut slits = Vec::new();
        let mut wrong: Vec<(HangingNode, usize)> = Vec::new();
        for (node, &cells) in nodes.into_iter().zip(cells) {
            let [one, other] = &node.groups;
            let is_known = |known: &[String; 2]| known.contains(one) && known.contains(other);
            if self.allowed && self.parts(cells).is_none() {
                slits.push(node);
            } else if let Some(known) = wrong.iter_mut().find(|(n, _)| is_known(&n.groups)) {
                known.1 += 1;
            } else {
                wrong.push((node, 0));
            }
        }
        let allowed = self.allowed;
        let problem = |(node, more)| MeshProblem::Hanging {
            node,
            more,
            allowed,
        };
        let wrong = wrong.into_iter().map(problem).collect();
        (
            slits,
            limited_to(MOST_REPORTED, wrong, "pairs of surfaces with hanging nodes"),
        )
    }
}
