//! Makes the mesh of the collected data: tags become indices.

use std::collections::HashMap;

use super::build::{Element, Membership, MeshBuilder};
use super::element::{ElementShape, other_type};
use super::merge;
use super::problem::{Problems, ReadProblem};
use super::tags::TagTable;
use crate::mesh::{Cell, GroupSet, Line, Mesh, PhysicalGroup, Point};

/// The groups of the elements of an entity.
#[derive(Debug, Clone, Default)]
struct ElementGroups {
    groups: GroupSet,
    /// Whether these elements run against the direction of the entity.
    reversed: bool,
    /// Groups in which lines run the other way than in `groups`.
    against: GroupSet,
}

/// Common data of the elements of one entity, found once.
#[derive(Debug, Default)]
struct EntityGroups {
    of_entity: HashMap<(u8, i32), ElementGroups>,
    of_tag: HashMap<(u8, i32), GroupSet>,
}

impl MeshBuilder {
    /// Replaces tags by indices: the mesh, if no problem is found here or earlier.
    pub(super) fn finish(mut self, problems: &mut Problems) -> Mesh {
        self.report_unsupported(problems);
        let elements = std::mem::take(&mut self.elements);
        let mut tags = TagTable::default();
        tags.reserve(elements.len());
        let mut entity_groups = EntityGroups::default();
        let mut cell_locations = Vec::new();
        for element in &elements {
            if !tags.insert(element.tag, 0) {
                problems.push(element.at, ReadProblem::RepeatedElement(element.tag));
            }
            let Some(nodes) = self.resolve(element, problems) else {
                continue;
            };
            let element_groups = self.element_groups(element, &mut entity_groups, problems);
            if matches!(element.kind.shape, ElementShape::Cell(_)) {
                cell_locations.push(element.at);
            }
            self.add_element(element, nodes, element_groups);
        }
        let repeats = elements
            .iter()
            .any(|element| element.kind.membership != Membership::Entity);
        if repeats {
            merge::points(&mut self.mesh.points);
            merge::lines(&mut self.mesh.lines);
        }
        merge::cells(&mut self.mesh.cells, &cell_locations, repeats, problems);
        self.mesh
    }

    fn report_unsupported(&self, problems: &mut Problems) {
        for (&number, unsupported) in &self.unsupported {
            let (name, volume) = other_type(number);
            problems.push(
                unsupported.at,
                ReadProblem::UnsupportedElements {
                    name,
                    count: unsupported.count,
                    volume,
                },
            );
        }
    }

    /// Node indices of an element; entries after its node count are zero.
    fn resolve(&self, element: &Element, problems: &mut Problems) -> Option<[u32; 9]> {
        let mut nodes = [0; 9];
        let mut known = true;
        let end = element.first + element.kind.shape.node_count();
        let tags = &self.references[element.first..end];
        for (node, tag) in nodes.iter_mut().zip(tags) {
            match self.node_index.get(*tag) {
                Some(index) => *node = index,
                None => {
                    known = false;
                    if !self.nodes_lost {
                        let problem = ReadProblem::UnknownNode {
                            element: element.tag,
                            node: *tag,
                        };
                        problems.push(element.at, problem);
                    }
                }
            }
        }
        known.then_some(nodes)
    }

    /// The groups of an element; a problem of an entity is reported once.
    fn element_groups(
        &mut self,
        element: &Element,
        known: &mut EntityGroups,
        problems: &mut Problems,
    ) -> ElementGroups {
        let dimension = element.kind.shape.dimension();
        if let Membership::Tag(tag) = element.kind.membership {
            let key = (dimension, tag.saturating_abs());
            let group = || self.group(dimension, tag).into_iter().collect();
            return ElementGroups {
                groups: known.of_tag.entry(key).or_insert_with(group).clone(),
                ..ElementGroups::default()
            };
        }
        let key = (dimension, element.kind.entity);
        if let Some(element_groups) = known.of_entity.get(&key) {
            return element_groups.clone();
        }
        let element_groups = match self.entities.remove(&key) {
            Some(physical) => self.element_groups_of(dimension, &physical),
            None => {
                if self.entities_known {
                    let (dimension, tag) = key;
                    problems.push(element.at, ReadProblem::UnknownEntity { dimension, tag });
                }
                ElementGroups::default()
            }
        };
        known.of_entity.insert(key, element_groups.clone());
        element_groups
    }

    /// The groups of an entity with these signed physical tags: the sign of the first one
    /// applies to its elements.
    fn element_groups_of(&mut self, dimension: u8, physical: &[i32]) -> ElementGroups {
        let reversed = physical
            .iter()
            .find(|&&tag| tag != 0)
            .is_some_and(|&tag| tag < 0);
        let (mut with, mut against) = (Vec::new(), Vec::new());
        for &tag in physical {
            let Some(group) = self.group(dimension, tag) else {
                continue;
            };
            // only lines have a direction that matters
            if dimension == 1 && (tag < 0) != reversed {
                against.push(group)
            } else {
                with.push(group)
            }
        }
        ElementGroups {
            groups: with.into_iter().collect(),
            reversed,
            against: against.into_iter().collect(),
        }
    }

    /// Index of the group with this tag or its negative, which is made if it has no name;
    /// `None` for tag 0.
    fn group(&mut self, dimension: u8, tag: i32) -> Option<usize> {
        let tag = tag.saturating_abs();
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

    /// Adds an element to the mesh; a line with groups of both directions twice.
    fn add_element(&mut self, element: &Element, nodes: [u32; 9], element_groups: ElementGroups) {
        let (tag, entity) = (element.tag, element.kind.entity);
        let ElementGroups {
            groups,
            reversed,
            against,
        } = element_groups;
        match element.kind.shape {
            ElementShape::Point => self.mesh.points.push(Point {
                tag,
                node: nodes[0],
                entity,
                groups,
            }),
            ElementShape::Line(kind) => {
                let line = Line::new(tag, kind, entity, |i| nodes[i]);
                let mut line = if reversed { line.reversed() } else { line };
                line.groups = groups;
                let mut other = line.reversed();
                self.mesh.lines.push(line);
                if !against.is_empty() {
                    other.groups = against;
                    self.mesh.lines.push(other);
                }
            }
            ElementShape::Cell(kind) => {
                let cell = Cell::new(tag, kind, entity, |i| nodes[i]);
                let mut cell = if reversed { cell.reversed() } else { cell };
                cell.groups = groups;
                self.mesh.cells.push(cell);
            }
        }
    }
}
