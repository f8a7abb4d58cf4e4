//! Problems of the cells of laminates, reported as problems of their curves: the cells'
//! tags are in no file.

use std::collections::HashSet;

use shared_geom::mesh::Mesh;

use super::super::findings::CellOverlap;
use super::super::problem::MeshProblem;
use super::problem::{LaminaProblem, limited};
use super::segments::label;
use super::words::Wall;
use super::{Lamina, LaminaCell, Laminated};

type LaminaReport = (usize, LaminaProblem);

/// Splits `problems` of the mesh into problems of the mesh itself and of laminates, the
/// latter with the index of the laminate whose input must change.
pub fn of_laminae(
    mesh: &Mesh,
    laminae: &[Lamina],
    laminated: &Laminated,
    problems: Vec<MeshProblem>,
) -> (Vec<MeshProblem>, Vec<LaminaReport>) {
    if laminated.cells.is_empty() {
        return (problems, Vec::new());
    }
    let cells = Cells::new(mesh, laminae, laminated);
    let mut own = Vec::new();
    let mut misshapen = Vec::new();
    let mut others = Vec::new();
    for problem in problems {
        match cells.reported(&problem) {
            Some((lamina, LaminaProblem::Misshapen { .. })) if counted(&mut misshapen, lamina) => {}
            Some(reported) if matches!(reported.1, LaminaProblem::Misshapen { .. }) => {
                misshapen.push(reported);
            }
            Some(reported) => others.push(reported),
            None => own.push(cells.without_made_nodes(problem)),
        }
    }
    // a count of further problems belongs to the reported ones
    if own
        .iter()
        .all(|problem| matches!(problem, MeshProblem::More { .. }))
    {
        own.clear();
    }
    others.dedup();
    let mut reported = misshapen;
    reported.extend(limited(others, "positions at which laminates do not fit"));
    (own, reported)
}

/// Counts one more cell of a laminate with a reported cell; otherwise false.
fn counted(reported: &mut [LaminaReport], lamina: usize) -> bool {
    let known = reported.iter_mut().find(|(known, _)| *known == lamina);
    match known {
        Some((_, LaminaProblem::Misshapen { count, .. })) => {
            *count += 1;
            true
        }
        _ => false,
    }
}

/// The cells of a mesh by their tags.
struct Cells<'a> {
    mesh: &'a Mesh,
    laminae: &'a [Lamina],
    laminated: &'a Laminated,
    /// Number of cells of the mesh itself.
    solid: usize,
}

impl<'a> Cells<'a> {
    fn new(mesh: &'a Mesh, laminae: &'a [Lamina], laminated: &'a Laminated) -> Self {
        Self {
            solid: mesh.cells.len().saturating_sub(laminated.cells.len()),
            mesh,
            laminae,
            laminated,
        }
    }

    /// The ply of the cell, if it is a cell of a laminate.
    fn of_lamina(&self, tag: u64) -> Option<&LaminaCell> {
        let made = self.mesh.cells.get(self.solid..)?;
        let index = made.iter().position(|cell| cell.tag == tag)?;
        self.laminated.cells.get(index)
    }

    /// The part of a cell: the laminate on a curve, or a surface.
    fn wall(&self, tag: u64) -> Wall {
        if let Some(cell) = self.of_lamina(tag) {
            return Wall::Curve(label(self.mesh, self.laminae, cell.lamina));
        }
        let cell = self.mesh.cells.iter().find(|cell| cell.tag == tag);
        let group = cell.and_then(|cell| self.mesh.groups.get(cell.groups.first()?));
        Wall::Cells(group.map(|group| group.label()))
    }

    fn reported(&self, problem: &MeshProblem) -> Option<LaminaReport> {
        match problem {
            MeshProblem::InvertedCell { cell, center, .. }
            | MeshProblem::TurnedCell { cell, center, .. } => {
                let found = self.of_lamina(*cell)?;
                let lamina = &self.laminae[found.lamina];
                let problem = LaminaProblem::Misshapen {
                    curve: label(self.mesh, self.laminae, found.lamina),
                    line: found.line,
                    position: *center,
                    thickness: lamina.thicknesses.iter().sum(),
                    count: 1,
                };
                Some((found.lamina, problem))
            }
            MeshProblem::Overlap { cells, nodes } => {
                let node = self.mesh.nodes.iter().find(|node| node.tag == nodes[0])?;
                let position = [node.position.x, node.position.y];
                self.pair(*cells, |walls| LaminaProblem::Overlaps {
                    walls,
                    position,
                    count: 1,
                })
            }
            MeshProblem::DoubleCover(CellOverlap {
                cells, positions, ..
            }) => {
                let (pair, position) = (*cells.first()?, *positions.first()?);
                self.pair(pair, |walls| LaminaProblem::Overlaps {
                    walls,
                    position,
                    count: cells.len(),
                })
            }
            MeshProblem::Hanging { node, more, .. } => {
                self.pair([node.corner_of, node.side_of], |walls| {
                    LaminaProblem::Unjoined {
                        walls,
                        position: node.position,
                        count: 1 + more,
                    }
                })
            }
            MeshProblem::HangingNode { cells, at, .. } => {
                let pair = cells.map(|(tag, _)| tag);
                self.pair(pair, |walls| LaminaProblem::Unjoined {
                    walls,
                    position: *at,
                    count: 1,
                })
            }
            _ => None,
        }
    }

    /// A problem between two cells, if one is of a laminate.
    fn pair(
        &self,
        cells: [u64; 2],
        problem: impl FnOnce([Wall; 2]) -> LaminaProblem,
    ) -> Option<LaminaReport> {
        let mut found = cells.iter().filter_map(|&cell| self.of_lamina(cell));
        let lamina = found.next().map(|cell| cell.lamina)?;
        let lamina = found.fold(lamina, |last, cell| last.max(cell.lamina));
        let mut walls = cells.map(|cell| self.wall(cell));
        if matches!(walls[0], Wall::Cells(_)) {
            walls.reverse();
        }
        Some((lamina, problem(walls)))
    }

    /// The problem without pairs of nodes that the file does not have.
    fn without_made_nodes(&self, mut problem: MeshProblem) -> MeshProblem {
        if let MeshProblem::Disconnected { coincident, .. } = &mut problem {
            let made = self.mesh.nodes.get(self.laminated.first_node..);
            let made = made.unwrap_or_default().iter().map(|node| node.tag);
            let made: HashSet<u64> = made.collect();
            coincident.retain(|pair| !pair.iter().any(|tag| made.contains(tag)));
        }
        problem
    }
}
