//! The values of columns at the steps of a run.

use std::collections::BTreeMap;

use super::AcceptedStep;
use super::air_columns::AirColumns;
use crate::case::{Column, ElectrodeQuantity, Model, OutputSettings, Quantity};
use crate::elements::{
    ElectrodeState, Instant, JointMotion, NodeReading, Observations, Reading, Signal,
};
use crate::model::{NodeMotion, Scalars};

/// Finds the values of columns. Only elements that some column needs are evaluated.
#[derive(Debug)]
pub struct ColumnValues<'a> {
    model: &'a Model,
    columns: &'a [Column],
    /// Elements to evaluate, with the columns that use their results.
    requested: Vec<RequestedColumns>,
    /// Columns that need no element.
    direct: Vec<usize>,
    /// Columns of the motion of nodes.
    nodes: Vec<(usize, NodeReading)>,
    /// Columns of energy.
    energy: Vec<usize>,
    /// Columns of the air.
    air: AirColumns,
    /// Columns of electrodes.
    electrodes: Vec<usize>,
    /// Columns of signals, with the scalars of the model.
    signals: Vec<(usize, Signal)>,
    observed: Observations,
    /// The nodes of a reading.
    seen: Vec<NodeMotion>,
    /// Angles of joints with their full turns at the latest step, by name [rad].
    angles: BTreeMap<String, f64>,
}

/// An element and the columns that are filled from its results.
#[derive(Debug)]
struct RequestedColumns {
    element: usize,
    columns: Vec<usize>,
}

impl<'a> ColumnValues<'a> {
    /// The columns of `settings`, with the nodes of `model`.
    pub fn new(model: &'a Model, settings: &'a OutputSettings) -> Self {
        let columns = &settings.columns[..];
        let mut values = Self {
            model,
            columns,
            requested: Vec::new(),
            direct: Vec::new(),
            nodes: Vec::new(),
            energy: Vec::new(),
            air: AirColumns::default(),
            electrodes: Vec::new(),
            signals: Vec::new(),
            observed: Observations::default(),
            seen: Vec::new(),
            angles: BTreeMap::new(),
        };
        for (index, column) in columns.iter().enumerate() {
            match &column.quantity {
                Quantity::Element { label, .. } => values.request(label, index),
                Quantity::Node(quantity) => {
                    let reading = NodeReading::new(quantity, model.system.nodes());
                    values.nodes.push((index, reading));
                }
                Quantity::Energy(_) => values.energy.push(index),
                Quantity::Electrode { .. } => values.electrodes.push(index),
                quantity @ (Quantity::Strip { .. } | Quantity::Rotor { .. }) => {
                    values.air.add(index, quantity, &model.system);
                }
                Quantity::Signal(signal) => {
                    // Scalars that are not unknowns of any element follow at the end and
                    // are zero.
                    let mut all = model.system.scalars().to_vec();
                    values.signals.push((index, signal.clone().bound(&mut all)));
                }
                _ => values.direct.push(index),
            }
        }
        values
    }

    /// Notes that a column needs results of the elements called `label`.
    fn request(&mut self, label: &str, column: usize) {
        let elements = self.model.system.elements().enumerate();
        for (element, _) in elements.filter(|(_, element)| element.label() == label) {
            match self
                .requested
                .iter_mut()
                .find(|requested| requested.element == element)
            {
                Some(requested) => requested.columns.push(column),
                None => self.requested.push(RequestedColumns {
                    element,
                    columns: vec![column],
                }),
            }
        }
    }

    /// The columns.
    pub fn columns(&self) -> &'a [Column] {
        self.columns
    }

    /// Continues from the full turns that the angles of joints had.
    pub fn go_on(&mut self, angles: &BTreeMap<String, f64>) {
        self.angles.clone_from(angles);
    }

    /// The angles of the joints that are followed, with their full turns, by name [rad].
    pub fn angles(&self) -> &BTreeMap<String, f64> {
        &self.angles
    }

    /// Follows the angles of joints over full turns; must be called at every step.
    pub fn follow(&mut self, accepted: &AcceptedStep<'_>) {
        for requested in &self.requested {
            let is_angle = |index: &usize| is_angle(&self.columns[*index].quantity);
            if !requested.columns.iter().any(is_angle) {
                continue;
            }
            self.observed.joints.clear();
            let system = &self.model.system;
            let (state, conditions) = (accepted.state, accepted.conditions);
            system.observe_element(requested.element, state, conditions, &mut self.observed);
            for joint in &self.observed.joints {
                let before = self.angles.get(&joint.joint);
                let angle = before.map_or(joint.angle, |before| joint.unwrapped(*before));
                if let Some(angle) = angle {
                    self.angles.insert(joint.joint.clone(), angle);
                }
            }
        }
    }

    /// Writes the values at `accepted` to `out`, one per column in its unit; NaN if an
    /// element reports no value.
    pub fn evaluate(&mut self, accepted: &AcceptedStep<'_>, out: &mut [f64]) {
        out.fill(f64::NAN);
        for &index in &self.direct {
            out[index] = self.direct_value(&self.columns[index].quantity, accepted);
        }
        if !self.energy.is_empty() {
            let energy = self
                .model
                .system
                .energy(accepted.state, accepted.conditions);
            for &index in &self.energy {
                if let Quantity::Energy(part) = self.columns[index].quantity {
                    out[index] = energy.part(part);
                }
            }
        }
        self.evaluate_nodes(accepted, out);
        self.evaluate_electrodes(accepted, out);
        self.evaluate_signals(accepted, out);
        self.air.evaluate(&self.model.system, accepted, out);
        for requested in &self.requested {
            self.observed.sections.clear();
            self.observed.reactions.clear();
            self.observed.joints.clear();
            self.observed.springs.clear();
            let system = &self.model.system;
            system.observe_element(
                requested.element,
                accepted.state,
                accepted.conditions,
                &mut self.observed,
            );
            for &index in &requested.columns {
                let quantity = &self.columns[index].quantity;
                let reported = if is_angle(quantity) {
                    self.observed.joints.first().and_then(|joint| {
                        let before = self.angles.get(&joint.joint);
                        before.map_or(joint.angle, |before| joint.unwrapped(*before))
                    })
                } else {
                    let rotation = |node: usize| accepted.state.nodes[node].rotation;
                    reading(quantity).and_then(|of| of.of(&self.observed, rotation))
                };
                if let Some(value) = reported {
                    out[index] = value;
                }
            }
        }
        for (value, column) in out.iter_mut().zip(self.columns) {
            *value /= column.factor;
        }
    }

    fn evaluate_nodes(&mut self, accepted: &AcceptedStep<'_>, out: &mut [f64]) {
        for (index, reading) in &self.nodes {
            let nodes = reading
                .nodes()
                .iter()
                .map(|&node| accepted.state.nodes[node]);
            self.seen.clear();
            self.seen.extend(nodes);
            out[*index] = reading.value(&self.seen, &accepted.conditions.frame);
        }
    }

    fn evaluate_electrodes(&self, accepted: &AcceptedStep<'_>, out: &mut [f64]) {
        if self.electrodes.is_empty() {
            return;
        }
        let found = (self.model.system).electrodes(accepted.state, accepted.conditions);
        for &index in &self.electrodes {
            let Quantity::Electrode {
                electrode,
                quantity,
            } = self.columns[index].quantity
            else {
                continue;
            };
            if let Some(found) = found.get(electrode) {
                out[index] = of_electrode(found, quantity);
            }
        }
    }

    fn evaluate_signals(&self, accepted: &AcceptedStep<'_>, out: &mut [f64]) {
        let state = accepted.state;
        let now = Instant {
            time: accepted.conditions.loading.time,
            scalars: Scalars {
                values: &state.scalars,
                rates: &state.scalar_rates,
            },
        };
        for (index, signal) in &self.signals {
            out[*index] = signal.value(&now);
        }
    }

    /// A number that needs no element, in SI units.
    fn direct_value(&self, quantity: &Quantity, accepted: &AcceptedStep<'_>) -> f64 {
        let state = accepted.state;
        match quantity {
            Quantity::Momentum(part) => {
                let sum = state.nodes.iter().map(|node| node.momentum).sum();
                part.of(&sum)
            }
            Quantity::AngularMomentum { about, part } => {
                let of_node = |node: &NodeMotion| {
                    node.angular_momentum + (node.position - about).cross(&node.momentum)
                };
                let sum = state.nodes.iter().map(of_node).sum();
                part.of(&sum)
            }
            // At a corner the value before it, as in the whole row.
            Quantity::Drive(drive) => drive.at(accepted.conditions.loading.time).value,
            Quantity::StepLength => accepted.length,
            Quantity::Iterations => accepted.iterations as f64,
            // These come from nodes and elements.
            Quantity::Node(_)
            | Quantity::Element { .. }
            | Quantity::Strip { .. }
            | Quantity::Rotor { .. }
            | Quantity::Electrode { .. }
            | Quantity::Signal(_)
            | Quantity::Energy(_) => f64::NAN,
        }
    }
}

/// The reading of an element for a column.
fn reading(quantity: &Quantity) -> Option<&Reading> {
    match quantity {
        Quantity::Element { reading, .. } => Some(reading),
        _ => None,
    }
}

fn is_angle(quantity: &Quantity) -> bool {
    let angle = JointMotion::Angle;
    matches!(reading(quantity), Some(Reading::Joint { motion, .. }) if *motion == angle)
}

fn of_electrode(electrode: &ElectrodeState, quantity: ElectrodeQuantity) -> f64 {
    match quantity {
        ElectrodeQuantity::Voltage => electrode.voltage,
        ElectrodeQuantity::Charge => electrode.charge,
        ElectrodeQuantity::Current => electrode.current,
    }
}

#[cfg(test)]
#[path = "columns_tests.rs"]
mod tests;
