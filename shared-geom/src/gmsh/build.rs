//! Collects what the sections of a file tell and makes the mesh of it.
//!
//! Elements keep the tags of their nodes and of their physical group until the
//! whole file has been read; only then are tags turned into indices.

use std::collections::{HashMap, HashSet};

use nalgebra::Vector3;

use super::element::{ElementShape, other_type};
use super::problem::{Problems, ReadProblem};
use crate::mesh::{Cell, Line, Mesh, Node, PhysicalGroup, Point};

/// How an element is given its physical group.
#[derive(Debug, Clone, Copy)]
pub(super) enum Membership {
    /// By this physical tag, 0 for none (MSH 2.2); elements of reversed groups
    /// stand reversed in the file.
    Tag(i32),
    /// By its entity (MSH 4.1).
    Entity,
}

/// An element as the file lists it.
#[derive(Debug, Clone, Copy)]
struct Element {
    line: usize,
    tag: u64,
    shape: ElementShape,
    entity: i32,
    membership: Membership,
    /// Where its node tags begin in [`MeshBuilder::references`].
    first: usize,
}

/// Elements of a type that is not read.
#[derive(Debug)]
struct Unsupported {
    number: u32,
    count: u64,
    line: usize,
}

/// What has been read so far.
#[derive(Debug, Default)]
pub(super) struct MeshBuilder {
    mesh: Mesh,
    node_index: HashMap<u64, u32>,
    /// Whether some node could not be read, so that references to it are no news.
    nodes_lost: bool,
    elements: Vec<Element>,
    references: Vec<u64>,
    unsupported: Vec<Unsupported>,
    group_index: HashMap<(u8, i32), usize>,
    /// Physical tags of each entity, by (dimension, tag); 4.1 only.
    entities: HashMap<(u8, i32), Vec<i32>>,
    /// Whether all entities have been read, so that no others may be used.
    entities_known: bool,
}

impl MeshBuilder {
    /// Makes room for as many nodes.
    pub(super) fn reserve_nodes(&mut self, count: usize) {
        self.mesh.nodes.reserve(count);
        self.node_index.reserve(count);
    }

    /// Adds a node.
    pub(super) fn node(&mut self, tag: u64, position: Vector3<f64>) -> Result<(), ReadProblem> {
        let index = u32::try_from(self.mesh.nodes.len()).map_err(|_| ReadProblem::TooManyNodes)?;
        if self.node_index.insert(tag, index).is_some() {
            return Err(ReadProblem::RepeatedNode(tag));
        }
        self.mesh.nodes.push(Node { tag, position });
        Ok(())
    }

    /// Notes that a node could not be read.
    pub(super) fn lose_nodes(&mut self) {
        self.nodes_lost = true;
    }

    /// Adds a physical group with its name.
    pub(super) fn named_group(&mut self, group: PhysicalGroup) -> Result<(), ReadProblem> {
        let (dimension, tag) = (group.dimension, group.tag);
        let index = self.mesh.groups.len();
        if self.group_index.insert((dimension, tag), index).is_some() {
            return Err(ReadProblem::GroupNamedTwice { dimension, tag });
        }
        self.mesh.groups.push(group);
        Ok(())
    }

    /// Notes that the file lists its entities.
    pub(super) fn begin_entities(&mut self) {
        self.entities_known = true;
    }

    /// Notes that some entity could not be read, so that unknown ones are no news.
    pub(super) fn lose_entities(&mut self) {
        self.entities_known = false;
    }

    /// Adds an entity with the signed tags of its physical groups.
    pub(super) fn entity(
        &mut self,
        dimension: u8,
        tag: i32,
        physical: Vec<i32>,
    ) -> Result<(), ReadProblem> {
        match self.entities.insert((dimension, tag), physical) {
            None => Ok(()),
            Some(_) => Err(ReadProblem::RepeatedEntity { dimension, tag }),
        }
    }

    /// Adds the element of line `line`, whose node tags are `nodes`.
    pub(super) fn element(
        &mut self,
        line: usize,
        tag: u64,
        (shape, entity, membership): (ElementShape, i32, Membership),
        nodes: &[u64],
    ) {
        let first = self.references.len();
        self.references.extend_from_slice(nodes);
        self.elements.push(Element {
            line,
            tag,
            shape,
            entity,
            membership,
            first,
        });
    }

    /// Counts elements of a type that is not read.
    pub(super) fn unsupported(&mut self, line: usize, number: u32, count: u64) {
        let known = self.unsupported.iter_mut().find(|u| u.number == number);
        match known {
            Some(known) => known.count = known.count.saturating_add(count),
            None => self.unsupported.push(Unsupported {
                number,
                count,
                line,
            }),
        }
    }

    /// Turns tags into indices: the mesh, if no problem is found here or before.
    pub(super) fn finish(mut self, problems: &mut Problems) -> Mesh {
        self.tell_unsupported(problems);
        let elements = std::mem::take(&mut self.elements);
        let mut tags = HashSet::with_capacity(elements.len());
        let mut told = HashSet::new();
        let mut cell_lines = Vec::new();
        for element in &elements {
            if !tags.insert(element.tag) {
                problems.push(element.line, ReadProblem::RepeatedElement(element.tag));
            }
            let Some(nodes) = self.resolve(element, problems) else {
                continue;
            };
            let (group, reversed) = self.membership(element, &mut told, problems);
            if matches!(element.shape, ElementShape::Cell(_)) {
                cell_lines.push(element.line);
            }
            self.place(element, nodes, group, reversed);
        }
        self.check_repeated_cells(&cell_lines, problems);
        self.mesh
    }

    fn tell_unsupported(&self, problems: &mut Problems) {
        for unsupported in &self.unsupported {
            let (name, volume) = other_type(unsupported.number);
            problems.push(
                unsupported.line,
                ReadProblem::UnsupportedElements {
                    name,
                    count: unsupported.count,
                    volume,
                },
            );
        }
    }

    /// Node indices of an element; entries behind its node count are zero.
    fn resolve(&self, element: &Element, problems: &mut Problems) -> Option<[u32; 9]> {
        let mut nodes = [0; 9];
        let mut known = true;
        let end = element.first + element.shape.node_count();
        let tags = &self.references[element.first..end];
        for (node, tag) in nodes.iter_mut().zip(tags) {
            match self.node_index.get(tag) {
                Some(&index) => *node = index,
                None => {
                    known = false;
                    if !self.nodes_lost {
                        let problem = ReadProblem::UnknownNode {
                            element: element.tag,
                            node: *tag,
                        };
                        problems.push(element.line, problem);
                    }
                }
            }
        }
        known.then_some(nodes)
    }

    /// The group of an element, and whether the element is reversed in it. An
    /// entity with a problem is told once: it is then in `told`.
    fn membership(
        &mut self,
        element: &Element,
        told: &mut HashSet<(u8, i32)>,
        problems: &mut Problems,
    ) -> (Option<usize>, bool) {
        let tag = match element.membership {
            Membership::Tag(tag) => tag.saturating_abs(),
            Membership::Entity => self.tag_by_entity(element, told, problems),
        };
        let dimension = element.shape.dimension();
        (self.group(dimension, tag.saturating_abs()), tag < 0)
    }

    /// The signed physical tag of an element's entity: the first of several.
    fn tag_by_entity(
        &self,
        element: &Element,
        told: &mut HashSet<(u8, i32)>,
        problems: &mut Problems,
    ) -> i32 {
        let (dimension, tag) = (element.shape.dimension(), element.entity);
        let Some(physical) = self.entities.get(&(dimension, tag)) else {
            if self.entities_known && told.insert((dimension, tag)) {
                problems.push(element.line, ReadProblem::UnknownEntity { dimension, tag });
            }
            return 0;
        };
        let mut tags = physical.iter().copied().filter(|&tag| tag != 0);
        let first = tags.next().unwrap_or(0);
        let second = tags.find(|tag| tag.saturating_abs() != first.saturating_abs());
        if let Some(second) = second
            && dimension == 2
            && told.insert((dimension, tag))
        {
            let problem = self.two_groups(element.tag, [first, second]);
            problems.push(element.line, problem);
        }
        first
    }

    fn two_groups(&self, cell: u64, tags: [i32; 2]) -> ReadProblem {
        let [first, second] = tags.map(|tag| {
            let tag = tag.saturating_abs();
            match self.group_index.get(&(2, tag)) {
                Some(&index) => self.mesh.groups[index].label(),
                None => tag.to_string(),
            }
        });
        ReadProblem::CellInTwoGroups {
            cell,
            first,
            second,
        }
    }

    /// Index of a group, which is made if it has no name; `None` for tag 0.
    fn group(&mut self, dimension: u8, tag: i32) -> Option<usize> {
        if tag == 0 {
            return None;
        }
        let groups = &mut self.mesh.groups;
        let index = *self.group_index.entry((dimension, tag)).or_insert_with(|| {
            groups.push(PhysicalGroup {
                dimension,
                tag,
                name: None,
            });
            groups.len() - 1
        });
        Some(index)
    }

    /// Adds an element to the mesh.
    fn place(&mut self, element: &Element, nodes: [u32; 9], group: Option<usize>, reversed: bool) {
        let (tag, entity) = (element.tag, element.entity);
        match element.shape {
            ElementShape::Point => self.mesh.points.push(Point {
                tag,
                node: nodes[0],
                entity,
                group,
            }),
            ElementShape::Line(kind) => {
                let line = Line::new(tag, kind, entity, |i| nodes[i]);
                let mut line = if reversed { line.reversed() } else { line };
                line.group = group;
                self.mesh.lines.push(line);
            }
            ElementShape::Cell(kind) => {
                let cell = Cell::new(tag, kind, entity, |i| nodes[i]);
                let mut cell = if reversed { cell.reversed() } else { cell };
                cell.group = group;
                self.mesh.cells.push(cell);
            }
        }
    }

    /// Tells cells on the same corners: MSH 2.2 repeats a cell for each of its groups.
    fn check_repeated_cells(&self, lines: &[usize], problems: &mut Problems) {
        let mut seen: HashMap<[u32; 4], usize> = HashMap::with_capacity(lines.len());
        for (i, cell) in self.mesh.cells.iter().enumerate() {
            let mut key = [u32::MAX; 4];
            key[..cell.corners().len()].copy_from_slice(cell.corners());
            key.sort_unstable();
            let Some(first) = seen.insert(key, i) else {
                continue;
            };
            let other = &self.mesh.cells[first];
            let label = |group: Option<usize>| group.map(|g| self.mesh.groups[g].label());
            let problem = match (label(other.group), label(cell.group)) {
                (Some(first), Some(second)) if first != second => ReadProblem::CellInTwoGroups {
                    cell: cell.tag,
                    first,
                    second,
                },
                _ => ReadProblem::RepeatedCell {
                    cell: cell.tag,
                    first: other.tag,
                },
            };
            problems.push(lines[i], problem);
        }
    }
}
