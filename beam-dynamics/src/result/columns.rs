//! The numbers of columns at the moments of a run.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::Moment;
use crate::case::{
    Axes, Column, ElectrodeQuantity, EnergyPart, JointMotion, Model, NodeQuantity, NodeVector,
    OutputQuestion, Part, Quantity, SpringVector,
};
use crate::elements::{
    ElectrodeState, Energy, Instant, Observations, Reaction, SectionState, Signal,
};
use crate::model::{NodeMotion, Scalars, State};

/// Finds the numbers of columns. Only elements that some column needs are asked.
#[derive(Debug)]
pub struct ColumnValues<'a> {
    model: &'a Model,
    columns: &'a [Column],
    /// Elements that are asked, with the columns that use their answer.
    asked: Vec<Asked>,
    /// Columns that need no element.
    direct: Vec<usize>,
    /// Columns of energy.
    energy: Vec<usize>,
    /// Columns of electrodes.
    electrodes: Vec<usize>,
    /// Columns of signals, with the numbers of the scalars that each reads.
    signals: Vec<(usize, Signal)>,
    observed: Observations,
    /// Angles of joints with their full turns at the latest moment, by name [rad].
    angles: BTreeMap<String, f64>,
}

/// An element and the columns that are filled from what it tells.
#[derive(Debug)]
struct Asked {
    element: usize,
    columns: Vec<usize>,
}

impl<'a> ColumnValues<'a> {
    /// Those of the columns of `question`, whose nodes are those of `model`.
    pub fn new(model: &'a Model, question: &'a OutputQuestion) -> Self {
        let columns = &question.columns[..];
        let mut values = Self {
            model,
            columns,
            asked: Vec::new(),
            direct: Vec::new(),
            energy: Vec::new(),
            electrodes: Vec::new(),
            signals: Vec::new(),
            observed: Observations::default(),
            angles: BTreeMap::new(),
        };
        for (index, column) in columns.iter().enumerate() {
            match &column.quantity {
                Quantity::Section { beam: label, .. }
                | Quantity::Reaction { joint: label, .. }
                | Quantity::Joint { joint: label, .. }
                | Quantity::Spring { spring: label, .. } => {
                    values.ask(label, index);
                }
                Quantity::Energy(_) => values.energy.push(index),
                Quantity::Electrode { .. } => values.electrodes.push(index),
                Quantity::Signal(signal) => {
                    // Scalars of which no element makes an unknown come behind, and count as zero.
                    let mut all = model.system.scalars().to_vec();
                    values.signals.push((index, signal.clone().bound(&mut all)));
                }
                _ => values.direct.push(index),
            }
        }
        values
    }

    /// Notes that a column needs what the elements called `label` tell.
    fn ask(&mut self, label: &str, column: usize) {
        let elements = self.model.system.elements().enumerate();
        for (element, _) in elements.filter(|(_, element)| element.label() == label) {
            match self.asked.iter_mut().find(|asked| asked.element == element) {
                Some(asked) => asked.columns.push(column),
                None => self.asked.push(Asked {
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

    /// Goes on with the full turns that the angles of joints had.
    pub fn go_on(&mut self, angles: &BTreeMap<String, f64>) {
        self.angles.clone_from(angles);
    }

    /// The angles of the joints that are followed, with their full turns, by name [rad].
    pub fn angles(&self) -> &BTreeMap<String, f64> {
        &self.angles
    }

    /// Follows the angles of joints over full turns; to be told of every step.
    pub fn follow(&mut self, moment: &Moment<'_>) {
        for asked in &self.asked {
            let is_angle = |index: &usize| is_angle(&self.columns[*index].quantity);
            if !asked.columns.iter().any(is_angle) {
                continue;
            }
            self.observed.joints.clear();
            let system = &self.model.system;
            let (state, conditions) = (moment.state, moment.conditions);
            system.observe_element(asked.element, state, conditions, &mut self.observed);
            for joint in &self.observed.joints {
                let before = self.angles.get(&joint.joint);
                let angle = before.map_or(joint.angle, |before| joint.unwrapped(*before));
                if let Some(angle) = angle {
                    self.angles.insert(joint.joint.clone(), angle);
                }
            }
        }
    }

    /// Writes the numbers at `moment` to `out`, one a column in its unit; not a number
    /// where an element tells nothing.
    pub fn evaluate(&mut self, moment: &Moment<'_>, out: &mut [f64]) {
        out.fill(f64::NAN);
        for &index in &self.direct {
            out[index] = self.direct_value(&self.columns[index].quantity, moment);
        }
        if !self.energy.is_empty() {
            let energy = self.model.system.energy(moment.state, moment.conditions);
            for &index in &self.energy {
                if let Quantity::Energy(part) = self.columns[index].quantity {
                    out[index] = energy_part(&energy, part);
                }
            }
        }
        self.evaluate_electrodes(moment, out);
        self.evaluate_signals(moment, out);
        for asked in &self.asked {
            self.observed.sections.clear();
            self.observed.reactions.clear();
            self.observed.joints.clear();
            self.observed.springs.clear();
            let system = &self.model.system;
            system.observe_element(
                asked.element,
                moment.state,
                moment.conditions,
                &mut self.observed,
            );
            for &index in &asked.columns {
                let quantity = &self.columns[index].quantity;
                let told = match is_angle(quantity) {
                    true => self.observed.joints.first().and_then(|joint| {
                        let before = self.angles.get(&joint.joint);
                        before.map_or(joint.angle, |before| joint.unwrapped(*before))
                    }),
                    false => told(quantity, &self.observed, moment.state),
                };
                if let Some(value) = told {
                    out[index] = value;
                }
            }
        }
        for (value, column) in out.iter_mut().zip(self.columns) {
            *value /= column.factor;
        }
    }

    fn evaluate_electrodes(&self, moment: &Moment<'_>, out: &mut [f64]) {
        if self.electrodes.is_empty() {
            return;
        }
        let found = (self.model.system).electrodes(moment.state, moment.conditions);
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

    fn evaluate_signals(&self, moment: &Moment<'_>, out: &mut [f64]) {
        let state = moment.state;
        let now = Instant {
            time: moment.conditions.loading.time,
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
    fn direct_value(&self, quantity: &Quantity, moment: &Moment<'_>) -> f64 {
        let state = moment.state;
        match quantity {
            Quantity::Node(quantity) => self.of_node(quantity, moment),
            Quantity::Momentum(part) => {
                let sum = state.nodes.iter().map(|node| node.momentum).sum();
                of_vector(&sum, *part, &Axes::Model, state)
            }
            Quantity::AngularMomentum { about, part } => {
                let of_node = |node: &NodeMotion| {
                    node.angular_momentum + (node.position - about).cross(&node.momentum)
                };
                let sum = state.nodes.iter().map(of_node).sum();
                of_vector(&sum, *part, &Axes::Model, state)
            }
            // At a corner the value before it, as all of the row.
            Quantity::Drive(drive) => drive.at(moment.conditions.loading.time).value,
            Quantity::StepLength => moment.length,
            Quantity::Iterations => moment.iterations as f64,
            // These are those of elements.
            Quantity::Section { .. }
            | Quantity::Reaction { .. }
            | Quantity::Joint { .. }
            | Quantity::Spring { .. }
            | Quantity::Electrode { .. }
            | Quantity::Signal(_)
            | Quantity::Energy(_) => f64::NAN,
        }
    }

    fn of_node(&self, quantity: &NodeQuantity, moment: &Moment<'_>) -> f64 {
        let NodeQuantity { node, against, .. } = *quantity;
        let state = moment.state;
        let vector = match self.turned(quantity, state) {
            Some(vector) => vector,
            None => {
                let of = |node| self.moved(quantity.vector, node, moment);
                of(node) - against.map_or_else(Vector3::zeros, of)
            }
        };
        // Angles about axes are no vector.
        match (quantity.vector, quantity.part) {
            (NodeVector::Euler(_), Part::Component(k)) => vector[k],
            (_, part) => of_vector(&vector, part, &quantity.axes, state),
        }
    }

    /// Rotations: from the undeformed attitude or from the axes of the model, or the same
    /// as the other node sees it.
    fn turned(&self, quantity: &NodeQuantity, state: &State) -> Option<Vector3<f64>> {
        let undeformed = |node: usize| self.model.system.nodes()[node].rotation;
        let now = |node: usize| state.nodes[node].rotation;
        let attitude = |of: &dyn Fn(usize) -> Matrix3<f64>| match quantity.against {
            Some(other) => of(other).transpose() * of(quantity.node),
            None => of(quantity.node),
        };
        match quantity.vector {
            NodeVector::Rotation => {
                let turned = attitude(&now) * attitude(&undeformed).transpose();
                Some(vector::from_rotation(&turned))
            }
            NodeVector::Attitude => Some(vector::from_rotation(&attitude(&now))),
            NodeVector::Euler(axes) => Some(euler_angles(&attitude(&now), axes)),
            _ => None,
        }
    }

    /// Vectors of a node that are subtracted from each other.
    fn moved(&self, vector: NodeVector, node: usize, moment: &Moment<'_>) -> Vector3<f64> {
        let frame = &moment.conditions.frame;
        let motion = &moment.state.nodes[node];
        match vector {
            NodeVector::Position => motion.position,
            NodeVector::Displacement => motion.position - self.model.system.nodes()[node].position,
            NodeVector::Velocity => motion.velocity,
            NodeVector::VelocityInSpace => motion.velocity_in_space(frame),
            NodeVector::AngularVelocity => motion.angular_velocity,
            NodeVector::AngularVelocityInSpace => motion.angular_velocity_in_space(frame),
            NodeVector::Momentum => motion.momentum,
            NodeVector::AngularMomentum => motion.angular_momentum,
            NodeVector::Rotation | NodeVector::Attitude | NodeVector::Euler(_) => Vector3::zeros(),
        }
    }
}

fn is_angle(quantity: &Quantity) -> bool {
    let angle = JointMotion::Angle;
    matches!(quantity, Quantity::Joint { motion, .. } if *motion == angle)
}

/// What an element tells for a column, in SI units.
fn told(quantity: &Quantity, observed: &Observations, state: &State) -> Option<f64> {
    match quantity {
        Quantity::Section {
            point,
            strain,
            component,
            ..
        } => {
            let section: &SectionState = observed.sections.get(*point)?;
            let all: &Vector6<f64> = match strain {
                true => &section.strain,
                false => &section.internal_force,
            };
            all.iter().nth(*component).copied()
        }
        Quantity::Reaction {
            node,
            moment,
            part,
            axes,
            ..
        } => {
            let mut reactions = observed.reactions.iter();
            let reaction: &Reaction = reactions.find(|reaction| reaction.node == *node)?;
            let vector = match moment {
                true => &reaction.moment,
                false => &reaction.force,
            };
            let axes = match axes {
                Axes::End(end) => Axes::Fixed(*observed.joints.first()?.axes.get(*end)?),
                axes => *axes,
            };
            Some(of_vector(vector, *part, &axes, state))
        }
        Quantity::Joint { motion, part, .. } => {
            let joint = observed.joints.first()?;
            let vector = match motion {
                JointMotion::Angle => return joint.angle,
                JointMotion::Displacement => &joint.displacement,
                JointMotion::Rotation => &joint.rotation,
                JointMotion::Velocity => &joint.velocity,
                JointMotion::AngularVelocity => &joint.angular_velocity,
            };
            Some(of_vector(vector, *part, &Axes::Model, state))
        }
        Quantity::Spring { vector, part, .. } => {
            let spring = observed.springs.first()?;
            let vector = match vector {
                SpringVector::Displacement => &spring.displacement,
                SpringVector::Rotation => &spring.rotation,
                SpringVector::Force => &spring.force,
                SpringVector::Moment => &spring.moment,
            };
            Some(of_vector(vector, *part, &Axes::Model, state))
        }
        _ => None,
    }
}

fn of_electrode(electrode: &ElectrodeState, quantity: ElectrodeQuantity) -> f64 {
    match quantity {
        ElectrodeQuantity::Voltage => electrode.voltage,
        ElectrodeQuantity::Charge => electrode.charge,
        ElectrodeQuantity::Current => electrode.current,
    }
}

fn energy_part(energy: &Energy, part: EnergyPart) -> f64 {
    match part {
        EnergyPart::Kinetic => energy.kinetic,
        EnergyPart::Elastic => energy.elastic,
        EnergyPart::Gravity => energy.gravity,
        EnergyPart::Electric => energy.electric,
        EnergyPart::Total => energy.total(),
    }
}

/// A part of a vector of the model's frame.
fn of_vector(vector: &Vector3<f64>, part: Part, axes: &Axes, state: &State) -> f64 {
    let Part::Component(k) = part else {
        return vector.norm();
    };
    match axes {
        Axes::Model | Axes::End(_) => vector[k],
        Axes::Fixed(axes) => axes.column(k).dot(vector),
        Axes::Node(node) => state.nodes[*node].rotation.column(k).dot(vector),
    }
}

/// Angles a, b, c of `R = R_i(a) R_j(b) R_k(c)`, turns about the axes i, j, k that the
/// turns before have moved. With l the axis that is neither i nor j, and e = 1 where
/// i, j, l follow each other (else -1), the entries of the product are
///
/// ```text
/// k = i:  R_ii = cos b,  R_ji = sin a sin b,  R_li = -e cos a sin b,
///         R_ij = sin b sin c,  R_il = e sin b cos c
/// k = l:  R_il = e sin b,  R_jl = -e sin a cos b,  R_ll = cos a cos b,
///         R_ij = -e cos b sin c,  R_ii = cos b cos c
/// ```
///
/// Where the first and the last axis fall together, the last angle is zero.
fn euler_angles(r: &Matrix3<f64>, [i, j, k]: [usize; 3]) -> Vector3<f64> {
    /// Sine below which two axes count as one.
    const LOCKED: f64 = 1e-9;
    let l = 3 - i - j;
    let e = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let (side, middle) = match k == i {
        true => {
            let side = r[(j, i)].hypot(r[(l, i)]);
            (side, side.atan2(r[(i, i)]))
        }
        false => {
            let side = r[(i, i)].hypot(r[(i, j)]);
            (side, (e * r[(i, l)]).atan2(side))
        }
    };
    if side < LOCKED {
        return Vector3::new((e * r[(l, j)]).atan2(r[(j, j)]), middle, 0.0);
    }
    match k == i {
        true => Vector3::new(
            r[(j, i)].atan2(-e * r[(l, i)]),
            middle,
            r[(i, j)].atan2(e * r[(i, l)]),
        ),
        false => Vector3::new(
            (-e * r[(j, l)]).atan2(r[(l, l)]),
            middle,
            (-e * r[(i, j)]).atan2(r[(i, i)]),
        ),
    }
}

#[cfg(test)]
#[path = "columns_tests.rs"]
mod tests;
