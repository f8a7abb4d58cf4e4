//! The parts of a mesh as a file lists them: numbers become indices when all are known.

use std::collections::HashMap;

use super::problem::{FileProblem, Problems};
use crate::mesh::{Cell, CellKind, GroupSet, Line, LineKind, Mesh, Node, PhysicalGroup};

/// Shape of an element that is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// A plane cell.
    Cell(CellKind),
    /// A line.
    Line(LineKind),
}

impl Shape {
    /// Number of nodes.
    pub(super) fn node_count(self) -> usize {
        match self {
            Self::Cell(kind) => kind.node_count(),
            Self::Line(kind) => kind.node_count(),
        }
    }

    /// Dimension of its groups.
    fn dimension(self) -> u8 {
        match self {
            Self::Cell(_) => 2,
            Self::Line(_) => 1,
        }
    }
}

/// An element.
#[derive(Debug)]
struct Element {
    line: usize,
    tag: u64,
    shape: Shape,
    nodes: Vec<u64>,
    /// Its sets: indices in [`Parts::sets`].
    sets: Vec<usize>,
}

/// A set of elements: a group of its cells, and one of its lines.
#[derive(Debug)]
struct Set {
    name: Option<String>,
    tag: Option<i32>,
}

/// Content of a file so far.
#[derive(Debug, Default)]
pub(super) struct Parts {
    nodes: Vec<Node>,
    node_index: HashMap<u64, u32>,
    elements: Vec<Element>,
    element_index: HashMap<u64, usize>,
    sets: Vec<Set>,
}

impl Parts {
    /// Adds a node.
    pub(super) fn node(&mut self, tag: u64, position: [f64; 3]) -> Result<(), FileProblem> {
        let index = u32::try_from(self.nodes.len()).ok();
        let index = index.filter(|&index| index < u32::MAX);
        let index = index.ok_or(FileProblem::TooManyNodes)?;
        if self.node_index.contains_key(&tag) {
            return Err(FileProblem::RepeatedNode(tag));
        }
        self.node_index.insert(tag, index);
        let position = position.into();
        self.nodes.push(Node { tag, position });
        Ok(())
    }

    /// Number of nodes.
    pub(super) fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// Adds an element of a line of the file, in the set `set` if there is one.
    pub(super) fn element(
        &mut self,
        (line, tag): (usize, u64),
        shape: Shape,
        nodes: Vec<u64>,
        set: Option<usize>,
    ) -> Result<(), FileProblem> {
        let index = self.elements.len();
        if self.element_index.contains_key(&tag) {
            return Err(FileProblem::RepeatedElement(tag));
        }
        self.element_index.insert(tag, index);
        self.elements.push(Element {
            line,
            tag,
            shape,
            nodes,
            sets: set.into_iter().collect(),
        });
        Ok(())
    }

    /// Adds a set; a set without `tag` is numbered.
    pub(super) fn set(&mut self, name: Option<String>, tag: Option<i32>) -> usize {
        self.sets.push(Set { name, tag });
        self.sets.len() - 1
    }

    /// The elements of a set, in their order.
    pub(super) fn members(&self, set: usize) -> Vec<u64> {
        let elements = self.elements.iter();
        let members = elements.filter(|element| element.sets.contains(&set));
        members.map(|element| element.tag).collect()
    }

    /// Adds an element to a set; returns whether the element exists.
    pub(super) fn assign(&mut self, tag: u64, set: usize) -> bool {
        let element = self.element_index.get(&tag);
        let element = element.and_then(|&index| self.elements.get_mut(index));
        match element {
            Some(element) => {
                element.sets.push(set);
                true
            }
            None => false,
        }
    }

    /// Adds the elements from `first` to `last` in steps of `step` to a set, as far as they
    /// exist.
    pub(super) fn assign_range(&mut self, (first, last, step): (u64, u64, u64), set: usize) {
        for element in &mut self.elements {
            let tag = element.tag;
            if (first..=last).contains(&tag) && (tag - first) % step == 0 {
                element.sets.push(set);
            }
        }
    }

    /// The mesh; unknown nodes are noted.
    pub(super) fn finish(self, problems: &mut Problems) -> Mesh {
        let mut mesh = Mesh {
            nodes: self.nodes,
            ..Mesh::default()
        };
        let mut groups = Groups::default();
        for element in &self.elements {
            let find = |tag: &u64| self.node_index.get(tag).copied();
            let mut nodes: Vec<_> = element.nodes.iter().filter_map(find).collect();
            if nodes.len() < element.nodes.len() {
                let lost = element.nodes.iter().filter(|tag| find(tag).is_none());
                for &node in lost {
                    let element_tag = element.tag;
                    let problem = FileProblem::UnknownNode {
                        element: element_tag,
                        node,
                    };
                    problems.push(element.line, problem);
                }
                continue;
            }
            let dimension = element.shape.dimension();
            let of_sets = element.sets.iter();
            let of_sets =
                of_sets.map(|&set| groups.of((dimension, set), &self.sets, &mut mesh.groups));
            let of_sets: GroupSet = of_sets.collect();
            match element.shape {
                Shape::Cell(kind) => {
                    let mut cell = Cell::new(element.tag, kind, 0, |i| nodes[i]);
                    cell.groups = of_sets;
                    mesh.cells.push(cell);
                }
                Shape::Line(kind) => {
                    middle_last(&mut nodes, &mesh.nodes);
                    let mut line = Line::new(element.tag, kind, 0, |i| nodes[i]);
                    line.groups = of_sets;
                    mesh.lines.push(line);
                }
            }
        }
        mesh
    }
}

/// The groups of the mesh so far, by dimension and set.
#[derive(Debug, Default)]
struct Groups(HashMap<(u8, usize), usize>);

impl Groups {
    /// Index of the group of a set, which is made if it does not exist; groups without a
    /// number are numbered from one within their dimension.
    fn of(&mut self, key: (u8, usize), sets: &[Set], groups: &mut Vec<PhysicalGroup>) -> usize {
        let (dimension, set) = key;
        *self.0.entry(key).or_insert_with(|| {
            let same = groups.iter().filter(|group| group.dimension == dimension);
            let next = i32::try_from(same.count() + 1).unwrap_or(i32::MAX);
            let known = sets.get(set);
            groups.push(PhysicalGroup {
                dimension,
                tag: known.and_then(|set| set.tag).unwrap_or(next),
                name: known.and_then(|set| set.name.clone()),
            });
            groups.len() - 1
        })
    }
}

/// The nodes of a quadratic line with its middle node last: the middle node is the one
/// nearer to the middle of the two others, as programs list it second or last.
fn middle_last(line: &mut [u32], nodes: &[Node]) {
    let [a, b, c] = line else {
        return;
    };
    let position = |index: u32| nodes[index as usize].position;
    let off = |one: u32, first: u32, second: u32| {
        (position(one) - 0.5 * (position(first) + position(second))).norm()
    };
    if off(*b, *a, *c) < off(*c, *a, *b) {
        std::mem::swap(b, c);
    }
}
