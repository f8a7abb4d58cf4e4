//! Elements of section models: four corners, middle nodes of the sides, center.
//!
//! ```text
//!   4 --- 7 --- 3        4 = 0: a triangle with the middle nodes 5, 6, 7
//!   |           |        two equal corners: a triangle too
//!   8     9     6        a middle node is 0 if the side is linear
//!   |           |
//!   1 --- 5 --- 2
//! ```
//!
//! Helicoid's cells are linear or quadratic as a whole. If a file has elements with some of
//! their middle nodes, or linear and quadratic ones, all become quadratic: absent middle
//! nodes are added at the middles of their sides, each for both elements of the side.

use std::collections::HashMap;

use super::parts::{Parts, Shape};
use super::problem::{FileProblem, Problems};
use crate::mesh::CellKind;

/// Nodes and elements of a file.
#[derive(Debug, Default)]
pub(super) struct Elements {
    parts: Parts,
    positions: HashMap<u64, [f64; 3]>,
    elements: Vec<Sides>,
}

/// An element by its sides.
#[derive(Debug)]
struct Sides {
    line: usize,
    tag: u64,
    corners: Vec<u64>,
    /// Middle nodes of the sides, 0 for none.
    middles: Vec<u64>,
    center: u64,
}

impl Sides {
    /// The ends of a side, in ascending order.
    fn ends(&self, side: usize) -> [u64; 2] {
        let corner = |index: usize| self.corners[index % self.corners.len()];
        let [a, b] = [corner(side), corner(side + 1)];
        [a.min(b), a.max(b)]
    }
}

impl Elements {
    /// Adds a node.
    pub(super) fn node(&mut self, tag: u64, [y, z]: [f64; 2]) -> Result<(), FileProblem> {
        self.positions.insert(tag, [y, z, 0.0]);
        self.parts.node(tag, [y, z, 0.0])
    }

    /// Adds an element of a line of the file, with its nodes in the order above, 0 for none.
    pub(super) fn element(
        &mut self,
        (line, tag): (usize, u64),
        nodes: [u64; 9],
    ) -> Result<(), FileProblem> {
        let count = if nodes[3] == 0 { 3 } else { 4 };
        let (mut corners, mut middles) = (Vec::new(), Vec::new());
        for side in 0..count {
            let (corner, next) = (nodes[side], nodes[(side + 1) % count]);
            if corner != next {
                corners.push(corner);
                middles.push(nodes[4 + side]);
            }
        }
        let is_triangle = corners.len() == 3;
        if corners.len() < 3 || corners.contains(&0) {
            return Err(FileProblem::Count {
                what: format!("element {tag}"),
                found: corners.iter().filter(|&&corner| corner != 0).count(),
                expected: "three or four different corners".to_owned(),
            });
        }
        self.elements.push(Sides {
            line,
            tag,
            corners,
            middles,
            center: if is_triangle { 0 } else { nodes[8] },
        });
        Ok(())
    }

    /// The nodes and elements as parts of a mesh; problems are noted with the lines of the
    /// elements, added nodes in `notes`.
    pub(super) fn parts(&mut self, problems: &mut Problems, notes: &mut Vec<String>) -> Parts {
        let sides = || self.elements.iter().flat_map(|element| &element.middles);
        let is_quadratic = sides().any(|&middle| middle != 0);
        let is_linear = sides().any(|&middle| middle == 0);
        if is_quadratic && is_linear {
            let added = self.complete(problems);
            notes.push(format!(
                "elements without some of their middle nodes: {added} nodes were added, and all \
                 elements are quadratic"
            ));
        }
        let mut parts = std::mem::take(&mut self.parts);
        for element in &self.elements {
            let is_quadratic = element.middles.iter().all(|&middle| middle != 0);
            let kind = match (element.corners.len(), is_quadratic, element.center) {
                (3, false, _) => CellKind::Triangle3,
                (3, true, _) => CellKind::Triangle6,
                (_, false, _) => CellKind::Quadrilateral4,
                (_, true, 0) => CellKind::Quadrilateral8,
                (_, true, _) => CellKind::Quadrilateral9,
            };
            let all = element.corners.iter().chain(&element.middles);
            let all = all.copied().chain([element.center]);
            let nodes = all.take(kind.node_count()).collect();
            let at = (element.line, element.tag);
            let added = parts.element(at, Shape::Cell(kind), nodes, None);
            problems.keep(element.line, added);
        }
        parts
    }

    /// Adds the absent middle nodes; returns their number.
    fn complete(&mut self, problems: &mut Problems) -> usize {
        let mut middle_of: HashMap<[u64; 2], u64> = HashMap::new();
        for element in &self.elements {
            for (side, &middle) in element.middles.iter().enumerate() {
                if middle != 0 {
                    middle_of.insert(element.ends(side), middle);
                }
            }
        }
        let mut next = self.positions.keys().copied().max().unwrap_or(0);
        let mut added = 0;
        for element in &mut self.elements {
            for side in 0..element.middles.len() {
                if element.middles[side] != 0 {
                    continue;
                }
                let ends = element.ends(side);
                element.middles[side] = *middle_of.entry(ends).or_insert_with(|| {
                    let at = |tag: u64| self.positions.get(&tag).copied();
                    let [Some(a), Some(b)] = ends.map(at) else {
                        // an unknown corner is reported with its element
                        return ends[1];
                    };
                    next = next.saturating_add(1);
                    added += 1;
                    let middle = [0, 1, 2].map(|axis| 0.5 * (a[axis] + b[axis]));
                    problems.keep(element.line, self.parts.node(next, middle));
                    next
                });
            }
        }
        added
    }
}
