//! The model as read so far: nodes, and the parts attached to them.
//!
//! The name of a wrong card is kept, so that its users are not reported to use an unknown
//! name.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Key, Table};
use shared_geom::error::nearest_name;

use super::aerodynamics::{Aerodynamics, Disks};
use super::beam_card::Beam;
use super::beam_section::Properties;
use super::driven_joint::DrivenJoint;
use super::drives;
use super::formulation::Inertia;
use super::frames::Frames;
use super::held::HeldTwice;
use super::hinge_card::HingeCard;
use super::hub::Hub;
use super::problem::InputProblem;
use super::properties::Catalog;
use crate::assembly::System;
use crate::case::{BladeNodes, FrameRotation, InitialMotion, Model};
use crate::elements::beams::{self, BeamInertia, LumpedMass, lumped_bodies};
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::joints::{Hinge, clamped, rigid_connection};
use crate::elements::laws::Law;
use crate::elements::{Element, EnergyPart, Reading};
use crate::model::{Node, Scalar};

mod air;
mod blades;
mod broken;
mod catalogs;
mod electrodes;
mod lookup;
mod remarks;
mod watch;

pub(super) use air::AirBlade;
pub(super) use electrodes::{ElectrodeCard, names as electrode_names};
pub(super) use lookup::LookUp;

/// The node with a name.
#[derive(Debug, Clone, Copy)]
struct Named {
    /// Index of the node; `None` if it could not be read.
    node: Option<usize>,
    /// Line of its card.
    line: usize,
}

/// The model during reading.
#[derive(Debug)]
pub(super) struct ModelBuilder {
    properties: Catalog,
    drives: drives::Catalog,
    frames: Frames,
    samplings: Vec<(usize, f64)>,
    aerodynamics: Aerodynamics,
    disks: Disks,
    hub: Option<Hub>,
    nodes: Vec<Node>,
    initial: Vec<InitialMotion>,
    /// Axes of the blade to which each node belongs.
    blade_axes: Vec<Option<Matrix3<f64>>>,
    names: BTreeMap<String, Named>,
    broken_blades: BTreeSet<String>,
    broken_rotors: Vec<String>,
    /// Names of the blades of each card of several blades, by the name of the card.
    blade_cards: BTreeMap<String, Vec<String>>,
    used: BTreeSet<usize>,
    beams: Vec<Beam>,
    clamps: BTreeMap<usize, usize>,
    bodies: Vec<(String, usize, RigidInertia)>,
    /// Hinges, rigid connections and supports.
    joints: Vec<Box<dyn Element>>,
    loads: Vec<Box<dyn Element>>,
    /// Sensors, control laws and actuators.
    control: Vec<Box<dyn Element>>,
    electrodes: Vec<ElectrodeCard>,
    /// Node of a hub that is not held by the frame.
    hub_node: Option<usize>,
    blades: Vec<BladeNodes>,
    /// Axes of the tower, if there is one.
    tower: Option<Matrix3<f64>>,
    /// Blades with strips.
    air_blades: Vec<AirBlade>,
    remarks: Vec<String>,
    driven: Vec<DrivenJoint>,
    labels: BTreeMap<(&'static str, String), usize>,
    /// Readings of elements, by element names, with their scalars.
    watched: Vec<(String, Reading, Scalar)>,
    /// Energies of the model, with their scalars.
    watched_energies: Vec<(EnergyPart, Scalar)>,
    /// Unknowns of electrodes, by both indices, with names and scalars of sensors.
    watched_electrodes: Vec<([usize; 2], String, Scalar)>,
    /// Whether some beam or other user of a node could not be attached.
    loose_ends: bool,
    /// Whether the air or strips could not be read.
    broken_air: bool,
    broken: bool,
}

impl ModelBuilder {
    /// An empty model; `hub` is `None` if its card is wrong.
    pub fn new(properties: Catalog, hub: Option<Hub>) -> Self {
        let remarks = properties.remarks.clone();
        Self {
            properties,
            drives: drives::Catalog::default(),
            frames: Frames::default(),
            samplings: Vec::new(),
            aerodynamics: Aerodynamics::default(),
            disks: Disks::new(),
            hub,
            nodes: Vec::new(),
            initial: Vec::new(),
            blade_axes: Vec::new(),
            names: BTreeMap::new(),
            broken_blades: BTreeSet::new(),
            broken_rotors: Vec::new(),
            blade_cards: BTreeMap::new(),
            used: BTreeSet::new(),
            beams: Vec::new(),
            clamps: BTreeMap::new(),
            bodies: Vec::new(),
            joints: Vec::new(),
            loads: Vec::new(),
            control: Vec::new(),
            electrodes: Vec::new(),
            hub_node: None,
            blades: Vec::new(),
            tower: None,
            air_blades: Vec::new(),
            remarks,
            driven: Vec::new(),
            labels: BTreeMap::new(),
            watched: Vec::new(),
            watched_energies: Vec::new(),
            watched_electrodes: Vec::new(),
            loose_ends: false,
            broken_air: false,
            broken: false,
        }
    }

    /// Nodes so far.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Beams so far.
    pub fn beams(&self) -> &[Beam] {
        &self.beams
    }

    /// Number of bodies so far.
    pub fn body_count(&self) -> usize {
        self.bodies.len()
    }

    /// Clamped nodes, in order.
    pub fn clamped(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.clamps.keys().copied()
    }

    /// Adds a node of a card; notes a name that is taken already.
    pub fn add_node(
        &mut self,
        node: Node,
        table: &Table<'_>,
        blade_axes: Option<Matrix3<f64>>,
    ) -> Option<usize> {
        let index = self.nodes.len();
        if !self.name_node(&node.label, Some(index), table) {
            return None;
        }
        self.nodes.push(node);
        self.initial.push(InitialMotion::default());
        self.blade_axes.push(blade_axes);
        Some(index)
    }

    /// Sets the initial motion of node `node`.
    pub fn set_initial(&mut self, node: usize, initial: InitialMotion) {
        self.initial[node] = initial;
    }

    /// Gives node `index`, or one that could not be read, another name.
    pub fn name_node(&mut self, name: &str, index: Option<usize>, table: &Table<'_>) -> bool {
        self.broken |= index.is_none();
        if let Some(first) = self.names.get(name) {
            let (kind, name) = ("node", name.to_owned());
            let line = table.document().line_words(first.line);
            table.note("name", &InputProblem::DoubledName { kind, name, line });
            self.broken = true;
            return false;
        }
        let line = table.line_of("name");
        self.names
            .insert(name.to_owned(), Named { node: index, line });
        true
    }

    /// Adds an element that is not part of the structure: a load, an imposed motion, a sensor.
    pub fn add_load(&mut self, load: Box<dyn Element>) {
        self.loads.push(load);
    }

    /// Adds an element that acts only on scalars.
    pub fn add_control(&mut self, element: Box<dyn Element>) {
        self.control.push(element);
    }

    /// The node called `name` under `key` of a card described by `user`.
    pub fn find_node(
        &mut self,
        name: &str,
        table: &Table<'_>,
        key: &str,
        user: &str,
    ) -> Option<usize> {
        let found = self.names.get(name).copied();
        if found.is_none() {
            self.note_unknown_node(name, table, key, user);
        }
        let node = found.and_then(|named| named.node);
        self.used.extend(node);
        self.broken |= node.is_none();
        node
    }

    fn note_unknown_node(&mut self, name: &str, table: &Table<'_>, key: &str, user: &str) {
        let known = self.names.keys().map(String::as_str);
        match nearest_name(name, known) {
            // The node that is probably meant is treated as used.
            Some(meant) => self.used.extend(self.names[meant].node),
            None => self.loose_ends = true,
        }
        if self.is_of_broken_part(name) {
            return;
        }
        let problem = InputProblem::UnknownName {
            kind: "node",
            name: name.to_owned(),
            user: user.to_owned(),
            known: self.names.keys().cloned().collect(),
        };
        table.note(key, &problem);
    }

    /// Notes that something uses a node.
    pub fn use_node(&mut self, node: usize) {
        self.used.insert(node);
    }

    /// Notes that the nodes used by a card are unknown.
    pub fn note_loose_end(&mut self) {
        self.broken = true;
        self.loose_ends = true;
    }

    /// The properties named under `properties` of a card described by `user`.
    pub fn find_properties(
        &mut self,
        table: &Table<'_>,
        key: &Key<Option<String>>,
        user: &str,
    ) -> Option<Properties> {
        let name = table.get(key)??;
        let found = self.properties.find(&name, (table, key.name()), user);
        self.broken |= found.is_none();
        found
    }

    /// Reserves a name for a thing of a kind; notes one that is taken already.
    pub fn take_label(&mut self, kind: &'static str, name: &str, table: &Table<'_>) -> bool {
        let key = (kind, name.to_owned());
        if let Some(&line) = self.labels.get(&key) {
            let line = table.document().line_words(line);
            let name = name.to_owned();
            table.note("name", &InputProblem::DoubledName { kind, name, line });
            self.broken = true;
            return false;
        }
        self.labels.insert(key, table.line_of("name"));
        true
    }

    /// Names of the joints with the lines of their cards.
    pub fn joint_lines(&self) -> impl Iterator<Item = (&str, usize)> {
        let joints = self.labels.iter().filter(|((kind, _), _)| *kind == "joint");
        joints.map(|((_, name), line)| (name.as_str(), *line))
    }

    /// Adds a beam, whose geometry has been checked.
    pub fn add_beam(&mut self, beam: Beam) {
        self.used.extend(beam.nodes);
        self.beams.push(beam);
    }

    /// Adds a body on a node.
    pub fn add_body(&mut self, label: String, node: usize, inertia: RigidInertia) {
        self.bodies.push((label, node, inertia));
    }

    /// Adds an element that joins nodes, or supports one.
    pub fn add_joint(&mut self, joint: Box<dyn Element>) {
        self.used.extend(joint.nodes());
        self.joints.push(joint);
    }

    /// Adds a hinge at `position` along `axis`, both in the model's frame; the second
    /// node turns relative to the first.
    pub fn add_hinge(
        &mut self,
        label: &str,
        nodes: [usize; 2],
        (position, axis): (Vector3<f64>, Vector3<f64>),
        card: &HingeCard,
    ) {
        let ends = nodes.map(|node| &self.nodes[node]);
        let mut hinge = Hinge::new(label, nodes, ends, &position, &axis, card.spring);
        if let Some(angle) = &card.relaxed {
            hinge = hinge.relaxed_by(angle.clone());
        }
        self.add_joint(boxed(hinge));
    }

    /// Holds the second node to the first, at any distance.
    pub fn add_rigid(&mut self, label: &str, nodes: [usize; 2]) {
        let ends = nodes.map(|node| &self.nodes[node]);
        self.add_joint(boxed(rigid_connection(label, nodes, ends)));
    }

    /// Hinges, rigid connections and supports so far.
    pub fn joints(&self) -> impl Iterator<Item = &dyn Element> {
        self.joints.iter().map(AsRef::as_ref)
    }

    /// Clamps a node; a node that is clamped already is noted under `key`.
    pub fn add_clamp(&mut self, node: usize, table: &Table<'_>, key: &str) {
        if let Some(&line) = self.clamps.get(&node) {
            let label = &self.nodes[node].label;
            table.note(key, &HeldTwice::new(label, line, table.document()));
            self.broken = true;
            return;
        }
        self.clamps.insert(node, table.line_of(key));
    }

    /// Notes problems of the model as a whole.
    pub fn check(&self, root: &Table<'_>) {
        const CARDS: [&str; 8] = [
            "blade", "rotor", "beam", "hinge", "rigid", "joint", "spring", "rod",
        ];
        let flies = root.has("transient") && (root.has("body") || root.has("joint"));
        let empty = self.beams.is_empty() && self.joints.is_empty() && !self.broken;
        let nothing = empty && (!flies || self.bodies.is_empty());
        if nothing || !(flies || CARDS.iter().any(|card| root.has(card))) {
            // [blade] instead of [[blade]] has been reported already.
            if !CARDS.iter().any(|card| root.is_table(card)) {
                let problem = match flies || self.bodies.is_empty() {
                    true => InputProblem::EmptyModel,
                    false => InputProblem::FreeBodies,
                };
                root.note("", &problem);
            }
            return;
        }
        let unused = (0..self.nodes.len()).filter(|node| !self.used.contains(node));
        for node in unused.filter(|_| !self.loose_ends) {
            let node = self.nodes[node].label.clone();
            let line = self.names.get(&node).map_or(1, |named| named.line);
            let unused = InputProblem::UnusedNode { node };
            root.document().note(line, &unused);
        }
        // Statics needs no mass.
        let massless = ["static", "buckling"].iter().any(|card| root.has(card));
        let massless = massless && !root.has("modes");
        if !self.broken && !massless && self.moving_mass() <= 0.0 {
            root.note("", &InputProblem::NoMass);
        }
    }

    /// Initial motion of each node, with its name and the line of its card.
    pub fn initial(&self) -> impl Iterator<Item = (&InitialMotion, &str, usize)> {
        let nodes = self.initial.iter().zip(&self.nodes);
        nodes.map(move |(initial, node)| {
            let line = self.names.get(&node.label).map_or(1, |named| named.line);
            (initial, node.label.as_str(), line)
        })
    }

    /// Mass that is not held by clamps \[kg\].
    fn moving_mass(&self) -> f64 {
        let on_clamps = self.bodies.iter().filter(|body| self.is_clamped(body.1));
        let held: f64 = on_clamps.map(|body| body.2.mass).sum();
        self.mass() - held
    }

    fn is_clamped(&self, node: usize) -> bool {
        self.clamps.contains_key(&node)
    }

    /// Mass of all beams and bodies \[kg\].
    pub fn mass(&self) -> f64 {
        let of_beams = self.beams.iter().flat_map(|beam| self.lumped(beam).bodies);
        let of_beams = of_beams.map(|body| body.mass);
        let of_bodies = self.bodies.iter().map(|body| body.2.mass);
        of_beams.chain(of_bodies).sum()
    }

    fn ends(&self, beam: &Beam) -> [&Node; 3] {
        beam.nodes.map(|node| &self.nodes[node])
    }

    pub(super) fn lumped(&self, beam: &Beam) -> LumpedMass {
        let ends = self.ends(beam);
        beam.properties
            .with_mass(|mass| lumped_bodies(&beam.geometry, ends, mass))
    }

    /// The checked model; `None` if some card could not be read, even if that was not
    /// noted: a model without a part is a different one.
    pub fn model(self, name: String, frame_rotation: FrameRotation) -> Option<Model> {
        if self.broken {
            return None;
        }
        let naming = self.naming()?;
        let mut elements = Vec::new();
        let scalars = self.scalars_of_electrodes();
        let mut law = None;
        for (index, beam) in self.beams.iter().enumerate() {
            elements.extend(self.beam_elements((index, beam), &scalars, &mut law));
        }
        for (label, node, inertia) in &self.bodies {
            elements.push(boxed(RigidBody::new(label, *node, *inertia)));
        }
        for &node in self.clamps.keys() {
            let label = self.name_of_clamp(node);
            elements.push(boxed(clamped(label, node, &self.nodes[node])));
        }
        elements.extend(self.circuits(&scalars));
        elements.extend(self.electrode_sensors(&scalars));
        elements.extend(self.joints);
        elements.extend(self.control);
        elements.extend(self.loads);
        let energies = &self.watched_energies;
        let elements = watch::adapt(elements, self.watched, energies, &self.nodes);
        Some(Model {
            initial: self.initial,
            beams: self.beams.iter().map(|beam| beam.nodes).collect(),
            blades: self.blades,
            naming,
            frame_rotation,
            ..Model::new(name, System::new(self.nodes, elements))
        })
    }

    /// Elements of beam `index`, given the unknowns of all electrodes and the law of the previous
    /// beam.
    fn beam_elements(
        &self,
        (index, beam): (usize, &Beam),
        scalars: &[Vec<Scalar>],
        law: &mut Option<Law<6>>,
    ) -> Vec<Box<dyn Element>> {
        let Beam {
            label,
            nodes,
            geometry,
            properties,
            inertia,
        } = beam;
        let ends = self.ends(beam);
        let elastic = beams::Beam::new(label, *nodes, *geometry, ends, properties.laws_like(law));
        let mut elements = vec![boxed(self.with_electrodes(index, elastic, scalars))];
        match inertia {
            Inertia::Consistent => {
                let inertia = properties
                    .with_mass(|mass| BeamInertia::new(label, *nodes, *geometry, ends, mass));
                elements.push(boxed(inertia));
            }
            Inertia::Lumped => {
                for (&node, body) in nodes.iter().zip(self.lumped(beam).bodies) {
                    elements.push(boxed(RigidBody::new(label, node, body)));
                }
            }
        }
        elements
    }
}

fn boxed(element: impl Element + 'static) -> Box<dyn Element> {
    Box::new(element)
}
