//! Names in output, looked up without counting as a use; locations of nodes and joints.

use std::collections::BTreeMap;

use shared_geom::document::{Document, Table};
use shared_geom::error::SourceLocation;

use super::ModelBuilder;
use crate::elements::joints::clamped;
use crate::elements::{Adapted, Axes, Element, Queries, Reading};
use crate::input::problem::InputProblem;
use crate::model::NodeMotion;

/// A name in output under a key of a card; the object is not treated as used. Each method
/// notes an unknown name.
pub struct LookUp<'a> {
    pub builder: &'a ModelBuilder,
    pub table: &'a Table<'a>,
    pub key: &'a str,
    pub name: &'a str,
    /// The card, as text.
    pub user: &'a str,
}

impl ModelBuilder {
    /// Locations of the nodes, and of the joints by name.
    pub fn locations(
        &self,
        document: &Document,
    ) -> (Vec<SourceLocation>, BTreeMap<String, SourceLocation>) {
        let nodes = self.initial();
        let nodes = nodes.map(|(_, _, line)| document.location(line));
        let joints = self.joint_lines();
        let joints = joints.map(|(name, line)| (name.to_owned(), document.location(line)));
        (nodes.collect(), joints.collect())
    }

    /// Number of cards with a name of a kind: `joint`, `spring`.
    pub fn count_of(&self, kind: &str) -> usize {
        let kinds = self.labels.keys().map(|label| label.0);
        kinds.filter(|own| *own == kind).count()
    }

    /// Names of the clamped nodes, with the lines that clamp them.
    pub fn clamp_lines(&self) -> impl Iterator<Item = (&str, usize)> {
        let name = |node: usize| self.nodes[node].label.as_str();
        self.clamps
            .iter()
            .map(move |(node, line)| (name(*node), *line))
    }
}

impl LookUp<'_> {
    /// The node.
    pub fn node(&self) -> Option<usize> {
        let names = &self.builder.names;
        if let Some(named) = names.get(self.name) {
            return named.node;
        }
        if !self.builder.is_of_broken_part(self.name) {
            self.note_unknown("node", names.keys().cloned().collect());
        }
        None
    }

    /// The axes of the node or, if no node has the name, of the `[[frame]]`.
    pub fn axes(&self) -> Option<Axes> {
        let (names, frames) = (&self.builder.names, &self.builder.frames);
        if let Some(named) = names.get(self.name) {
            return named.node.map(Axes::Node);
        }
        if let Some(axes) = frames.axes_of(self.name) {
            return axes.map(Axes::Fixed);
        }
        if !self.builder.is_of_broken_part(self.name) {
            let known = names.keys().chain(frames.names()).cloned();
            self.note_unknown("node or frame", known.collect());
        }
        None
    }

    /// Whether there is a beam of this name.
    pub fn beam(&self) -> bool {
        let labels = || self.builder.beams.iter().map(|beam| &beam.label);
        let is_known = labels().any(|label| label == self.name);
        let is_broken = || self.builder.is_of_broken_part(self.name) || self.is_taken("beam");
        if !is_known && !is_broken() {
            self.note_unknown("beam", labels().cloned().collect());
        }
        is_known
    }

    /// Index of the electrode.
    pub fn electrode(&self) -> Option<usize> {
        let mut cards = self.builder.electrodes.iter();
        let found = cards.position(|card| card.label == self.name);
        if found.is_none() && !self.is_taken("electrode") {
            // Including wrong electrodes.
            let labels = self.builder.labels.keys();
            let known = labels.filter(|(kind, _)| *kind == "electrode");
            self.note_unknown("electrode", known.map(|(_, name)| name.clone()).collect());
        }
        found
    }

    /// The nodes of the joint, clamp, support or imposed motion.
    pub fn joint(&self) -> Option<Vec<usize>> {
        let builder = self.builder;
        let clamp = |node: &usize| (builder.name_of_clamp(*node), vec![*node]);
        let moving = builder.loads.iter().filter(|load| load.multipliers() > 0);
        let of_element = |element: &dyn Element| {
            let label = element.label().to_owned();
            (label, element.nodes().to_vec())
        };
        let elements = builder.joints.iter().chain(moving);
        let elements = elements.map(|element| of_element(element.as_ref()));
        let mut all = builder.clamps.keys().map(clamp).chain(elements);
        let mut known = Vec::new();
        let found = all.find_map(|(label, nodes)| {
            if label == self.name {
                Some(nodes)
            } else {
                known.push(label);
                None
            }
        });
        let mut kinds = ["joint", "spring", "rod", "imposed"].into_iter();
        let is_broken = || builder.is_of_broken_part(self.name);
        if found.is_none() && !kinds.any(|kind| self.is_taken(kind)) && !is_broken() {
            self.note_unknown("joint or spring", known);
        }
        found
    }

    /// Whether a card of the kind has the name, though it may be wrong.
    fn is_taken(&self, kind: &'static str) -> bool {
        let label = (kind, self.name.to_owned());
        self.builder.labels.contains_key(&label)
    }

    fn note_unknown(&self, kind: &'static str, known: Vec<String>) {
        let (name, user) = (self.name.to_owned(), self.user.to_owned());
        let problem = InputProblem::UnknownName {
            kind,
            name,
            user,
            known,
        };
        self.table.note(self.key, &problem);
    }
}

impl ModelBuilder {
    /// Nodes of the joint, clamp, support or imposed motion called `name`; empty if it does
    /// not exist.
    pub fn nodes_of_joint(&self, name: &str) -> Vec<usize> {
        let clamps = self.clamps.keys().copied();
        let mut clamps = clamps.filter(|node| self.name_of_clamp(*node) == name);
        let elements = self.joints.iter().chain(&self.loads);
        let mut elements = elements.filter(|one| one.label() == name);
        let nodes = elements.next().map(|element| element.nodes().to_vec());
        nodes.unwrap_or_else(|| clamps.next().into_iter().collect())
    }

    /// Whether the element called `label` reports a reading.
    pub fn reports(&self, label: &str, reading: &Reading) -> bool {
        if let Reading::Section { .. } = reading {
            return self.beams.iter().any(|beam| beam.label == label);
        }
        let clamp = |&node: &usize| clamped(self.name_of_clamp(node), node, &self.nodes[node]);
        let clamps: Vec<_> = self.clamps.keys().map(clamp).collect();
        let clamps = clamps.iter().map(|clamp| clamp as &dyn Element);
        let elements = self.joints.iter().chain(&self.loads).map(AsRef::as_ref);
        let mut all = elements.chain(clamps).filter(|one| one.label() == label);
        all.any(|element| {
            let rest = element.nodes().iter();
            let rest: Vec<_> = rest
                .map(|&node| NodeMotion::at_rest(&self.nodes[node]))
                .collect();
            Adapted::reports(element, reading, &rest)
        })
    }

    /// The name of the clamp of a node.
    pub fn name_of_clamp(&self, node: usize) -> String {
        format!("clamp of {}", self.nodes[node].label)
    }

    /// The nodes of most interest in a run in time: all that move if they are few, else the
    /// ends of lines of beams and the nodes of bodies, up to `most`.
    pub fn main_nodes(&self, most: usize) -> Vec<usize> {
        let moves = |node: &usize| !self.clamps.contains_key(node);
        let all: Vec<_> = (0..self.nodes.len()).filter(moves).collect();
        if all.len() <= most {
            return all;
        }
        let (mut uses, mut is_outer) = (vec![0; self.nodes.len()], vec![false; self.nodes.len()]);
        for beam in &self.beams {
            beam.nodes.iter().for_each(|&node| uses[node] += 1);
            is_outer[beam.nodes[0]] = true;
            is_outer[beam.nodes[2]] = true;
        }
        let is_end = |node: usize| uses[node] == 1 && is_outer[node];
        let mut carries = vec![false; self.nodes.len()];
        let bodies = self.bodies.iter();
        bodies.for_each(|body| carries[body.1] = true);
        let mut found: Vec<_> = all.iter().copied().filter(|node| is_end(*node)).collect();
        let bodies = all.iter().filter(|node| carries[**node] && !is_end(**node));
        found.extend(bodies);
        found.truncate(most);
        found
    }
}
