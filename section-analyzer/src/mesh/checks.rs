//! The checks of the cells, in their order.

use super::boundary::Boundary;
use super::coincident::coincident_nodes;
use super::components::{check_connected, part_of_each_cell};
use super::contact::{Contacts, contacts};
use super::findings::{DoubledNodes, HangingNode, NarrowGap, Seam};
use super::orientation::orient;
use super::plane::PlaneMesh;
use super::problem::{MeshProblem, limited};
use super::seams::{Groups, doubled_sides, representatives, seams};
use super::sides::sides;

/// What is odd about cells without problems.
#[derive(Debug)]
pub(super) struct CheckedCells {
    /// Number of cells that were turned counterclockwise.
    pub(super) reversed: usize,
    /// Nodes at the same place.
    pub(super) coincident: Vec<[u32; 2]>,
    pub(super) seams: Vec<Seam>,
    pub(super) hanging: Vec<HangingNode>,
    pub(super) gaps: Vec<NarrowGap>,
}

/// Turns the cells counterclockwise and states that they fit and hold together.
pub(super) fn check_cells(
    plane: &mut PlaneMesh,
    groups: Groups<'_>,
    doubled_nodes: DoubledNodes,
) -> Result<CheckedCells, Vec<MeshProblem>> {
    let oriented = orient(plane);
    let sides = sides(plane, oriented.is_ok());
    let is_sound = oriented.is_ok() && sides.problems.is_empty();
    let mut problems = Vec::new();
    let reversed = oriented.unwrap_or_else(|inverted| {
        problems.extend(inverted);
        0
    });
    problems.extend(sides.problems);

    let boundary = Boundary::of(plane);
    let coincident = coincident_nodes(plane, &boundary);
    let least = representatives(plane.nodes.len(), &coincident);
    let doubled = doubled_sides(&boundary, &least);
    // what touches can be told only of cells that are all sound
    let contacts = match is_sound {
        true => contacts(plane, &boundary, &least, &doubled, groups),
        false => Contacts::default(),
    };

    let parts = part_of_each_cell(plane.cells.len(), &sides.neighbors);
    let count = parts.iter().max().map_or(0, |&last| last + 1);
    let apart = |[a, b]: [usize; 2]| (parts[a] != parts[b]).then_some(count);
    let seams = seams(plane, &boundary, &doubled, groups, apart);
    let touching = doubled
        .iter()
        .map(|pair| pair.map(|side| boundary.sides[side].cell));
    let mut joined = sides.neighbors;
    joined.extend(touching);
    joined.extend(&contacts.hangs_on);
    joined.extend(&contacts.overlapping);

    let overlaps = contacts.overlaps.into_iter().map(MeshProblem::DoubleCover);
    problems.extend(limited(overlaps.collect(), "overlapping cells"));
    let is_slit = |cells: [usize; 2]| apart(cells).is_none();
    let allowed = doubled_nodes == DoubledNodes::Allow;
    let (meant, wrong) = parted(seams, |seam| {
        seam.parts.is_none() && (allowed || seam.groups[0] == seam.groups[1])
    });
    let doubled = |seam| MeshProblem::DoubledNodes { seam, allowed };
    problems.extend(limited(wrong.into_iter().map(doubled).collect(), "seams"));
    let hanging = contacts.hanging.into_iter().zip(contacts.hangs_on);
    let (slit, wrong) = parted(hanging, |(_, cells)| allowed && is_slit(*cells));
    let hangs = |(node, _)| MeshProblem::Hanging { node, allowed };
    problems.extend(limited(
        wrong.into_iter().map(hangs).collect(),
        "hanging nodes",
    ));
    let label = |cell: usize| groups.label(cell);
    let connected = check_connected(plane, &joined, &coincident, &contacts.gaps, label);
    problems.extend(connected.err());
    match problems.is_empty() {
        true => Ok(CheckedCells {
            reversed,
            coincident,
            seams: meant,
            hanging: slit.into_iter().map(|(node, _)| node).collect(),
            gaps: contacts.gaps,
        }),
        false => Err(problems),
    }
}

/// Those that `takes` takes, and the others.
fn parted<T>(all: impl IntoIterator<Item = T>, takes: impl Fn(&T) -> bool) -> (Vec<T>, Vec<T>) {
    all.into_iter().partition(takes)
}
