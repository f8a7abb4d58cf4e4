//! Collects the content of the sections of a file.
//!
//! Elements keep the tags of their nodes and of their physical groups until the
//! whole file has been read; only then are tags turned into indices.

use std::collections::{BTreeMap, HashMap};

use super::element::ElementShape;
use super::problem::ReadProblem;
use super::tags::TagTable;
use crate::mesh::{Mesh, Node, PhysicalGroup};

/// Assignment of physical groups to an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Membership {
    /// By this physical tag, 0 for none (MSH 2.2); elements of reversed groups are
    /// reversed in the file, elements of several groups are repeated.
    Tag(i32),
    /// By its entity (MSH 4.1).
    Entity,
}

/// Kind of an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct ElementKind {
    pub(super) shape: ElementShape,
    pub(super) entity: i32,
    pub(super) membership: Membership,
}

/// An element as the file lists it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    /// Line or byte.
    pub(super) at: usize,
    pub(super) tag: u64,
    pub(super) kind: ElementKind,
    /// Index of its first node tag in [`MeshBuilder::references`].
    pub(super) first: usize,
}

/// Elements of a type that is not read.
#[derive(Debug)]
pub(super) struct Unsupported {
    pub(super) count: u64,
    /// Line or byte of the first.
    pub(super) at: usize,
}

/// Content read so far.
#[derive(Debug, Default)]
pub(super) struct MeshBuilder {
    pub(super) mesh: Mesh,
    pub(super) node_index: TagTable,
    /// Whether some node could not be read, so that missing references are not reported
    /// again.
    pub(super) nodes_lost: bool,
    pub(super) elements: Vec<Element>,
    pub(super) references: Vec<u64>,
    /// By the number of the type.
    pub(super) unsupported: BTreeMap<u64, Unsupported>,
    pub(super) group_index: HashMap<(u8, i32), usize>,
    /// Physical tags of each entity, by (dimension, tag); 4.1 only.
    pub(super) entities: HashMap<(u8, i32), Vec<i32>>,
    /// Whether all entities have been read, so that other ones may not be used.
    pub(super) entities_known: bool,
}

impl MeshBuilder {
    /// Reserves space for `count` nodes.
    pub(super) fn reserve_nodes(&mut self, count: usize) {
        self.mesh.nodes.reserve(count);
        self.node_index.reserve(count);
    }

    /// Adds a node.
    pub(super) fn node(&mut self, tag: u64, position: [f64; 3]) -> Result<(), ReadProblem> {
        let index = u32::try_from(self.mesh.nodes.len()).ok();
        let index = index.filter(|&index| index < u32::MAX);
        let index = index.ok_or(ReadProblem::TooManyNodes)?;
        if !self.node_index.insert(tag, index) {
            return Err(ReadProblem::RepeatedNode(tag));
        }
        let position = position.into();
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

    /// Notes that some entity could not be read, so that unknown ones are not reported
    /// again.
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

    /// Adds the element of a line or byte, whose node tags are `nodes`.
    pub(super) fn element(&mut self, at: usize, tag: u64, kind: ElementKind, nodes: &[u64]) {
        let first = self.references.len();
        self.references.extend_from_slice(nodes);
        self.elements.push(Element {
            at,
            tag,
            kind,
            first,
        });
    }

    /// Counts elements of a type that is not read.
    pub(super) fn unsupported(&mut self, at: usize, number: u64, count: u64) {
        let none = Unsupported { count: 0, at };
        let known = self.unsupported.entry(number).or_insert(none);
        known.count = known.count.saturating_add(count);
    }
}
