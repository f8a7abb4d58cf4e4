//! Names in output: looked up, without counting as a use.

use shared_geom::document::Table;

use super::ModelBuilder;
use crate::elements::joints::clamped;
use crate::elements::{Adapted, Axes, Element, Queries, Reading};
use crate::input::problem::InputProblem;
use crate::model::NodeMotion;

impl ModelBuilder {
    /// Number of cards with a name of a kind: `joint`, `spring`.
    pub fn count_of(&self, kind: &str) -> usize {
        let kinds = self.labels.keys().map(|label| label.0);
        kinds.filter(|own| *own == kind).count()
    }

    /// The node called `name` under `key` of a card described by `user`; the node is not
    /// treated as used.
    pub fn look_up_node(
        &self,
        name: &str,
        table: &Table<'_>,
        key: &str,
        user: &str,
    ) -> Option<usize> {
        if let Some(named) = self.names.get(name) {
            return named.node;
        }
        if !self.is_of_broken_blade(name) {
            let known = self.names.keys().cloned().collect();
            note_unknown("node", name, user, known, (table, key));
        }
        None
    }

    /// The axes of the node or, if no node has the name, of the `[[frame]]` called `name`.
    pub fn look_up_axes(
        &self,
        name: &str,
        table: &Table<'_>,
        key: &str,
        user: &str,
    ) -> Option<Axes> {
        if let Some(named) = self.names.get(name) {
            return named.node.map(Axes::Node);
        }
        if let Some(axes) = self.frames.axes_of(name) {
            return axes.map(Axes::Fixed);
        }
        if !self.is_of_broken_blade(name) {
            let nodes = self.names.keys().cloned();
            let known = nodes.chain(self.frames.names().cloned()).collect();
            note_unknown("node or frame", name, user, known, (table, key));
        }
        None
    }

    /// Whether there is a beam called `name`; notes an unknown name.
    pub fn look_up_beam(&self, name: &str, table: &Table<'_>, key: &str, user: &str) -> bool {
        let labels = || self.beams.iter().map(|beam| &beam.label);
        let is_known = labels().any(|label| label == name);
        if !is_known && !self.is_of_broken_blade(name) && !self.is_taken("beam", name) {
            let known = labels().cloned().collect();
            note_unknown("beam", name, user, known, (table, key));
        }
        is_known
    }

    /// Index of the electrode called `name`; notes an unknown name.
    pub fn look_up_electrode(
        &self,
        name: &str,
        table: &Table<'_>,
        key: &str,
        user: &str,
    ) -> Option<usize> {
        let mut cards = self.electrodes.iter();
        let found = cards.position(|card| card.label == name);
        if found.is_none() && !self.is_taken("electrode", name) {
            // Including wrong electrodes.
            let labels = self.labels.keys();
            let known = labels.filter(|(kind, _)| *kind == "electrode");
            let known = known.map(|(_, name)| name.clone()).collect();
            note_unknown("electrode", name, user, known, (table, key));
        }
        found
    }

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

    /// The nodes of the joint, clamp, support or imposed motion called `name`; notes an
    /// unknown name.
    pub fn look_up_joint(
        &self,
        name: &str,
        table: &Table<'_>,
        key: &str,
        user: &str,
    ) -> Option<Vec<usize>> {
        let clamp = |node: &usize| (self.name_of_clamp(*node), vec![*node]);
        let moving = self.loads.iter().filter(|load| load.multipliers() > 0);
        let of_element = |element: &dyn Element| {
            let label = element.label().to_owned();
            (label, element.nodes().to_vec())
        };
        let elements = self.joints.iter().chain(moving);
        let elements = elements.map(|element| of_element(element.as_ref()));
        let mut all = self.clamps.keys().map(clamp).chain(elements);
        let mut known = Vec::new();
        let found = all.find_map(|(label, nodes)| match label == name {
            true => Some(nodes),
            false => {
                known.push(label);
                None
            }
        });
        let is_broken = ["joint", "spring", "rod", "imposed"]
            .iter()
            .any(|kind| self.is_taken(kind, name));
        if found.is_none() && !is_broken {
            note_unknown("joint or spring", name, user, known, (table, key));
        }
        found
    }

    /// The nodes of most interest in a run in time: all that move if they are few, else the
    /// ends of lines of beams and the nodes of bodies, up to `most`.
    pub fn main_nodes(&self, most: usize) -> Vec<usize> {
        let moves = |node: &usize| !self.clamps.contains_key(node);
        let all: Vec<_> = (0..self.nodes.len()).filter(moves).collect();
        if all.len() <= most {
            return all;
        }
        let uses = |node: usize| {
            let of_beams = self.beams.iter().flat_map(|beam| beam.nodes);
            of_beams.filter(|other| *other == node).count()
        };
        let is_end = |node: usize| {
            let ends = self
                .beams
                .iter()
                .flat_map(|beam| [beam.nodes[0], beam.nodes[2]]);
            uses(node) == 1 && ends.into_iter().any(|end| end == node)
        };
        let has_body = |node: usize| self.bodies.iter().any(|body| body.1 == node);
        let mut found: Vec<_> = all.iter().copied().filter(|node| is_end(*node)).collect();
        let bodies = all
            .iter()
            .filter(|node| has_body(**node) && !is_end(**node));
        found.extend(bodies);
        found.truncate(most);
        found
    }

    fn is_taken(&self, kind: &'static str, name: &str) -> bool {
        self.labels.contains_key(&(kind, name.to_owned()))
    }

    fn is_of_broken_blade(&self, name: &str) -> bool {
        let blade = name.split_once('/').map(|parts| parts.0);
        blade.is_some_and(|blade| self.broken_blades.contains(blade))
    }
}

fn note_unknown(
    kind: &'static str,
    name: &str,
    user: &str,
    known: Vec<String>,
    (table, key): (&Table<'_>, &str),
) {
    let (name, user) = (name.to_owned(), user.to_owned());
    let problem = InputProblem::UnknownName {
        kind,
        name,
        user,
        known,
    };
    table.note(key, &problem);
}
