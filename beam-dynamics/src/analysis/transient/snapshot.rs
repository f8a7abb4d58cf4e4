//! Data from which a run is continued: its accepted states as plain numbers.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};

use crate::case::Model;
use crate::integrator::Progress;
use crate::model::{NodeMotion, State};
use crate::result::Snapshot;

use super::failure::TransientFailure;

/// Numbers of a node: position, orientation by columns, momenta, velocities, rates.
const OF_NODE: usize = 30;

/// All data to continue from the accepted `states`, the latest first; the times are spent by the
/// recorder and by the whole run \[s\].
pub(super) fn take(
    model: &Model,
    states: &[State],
    (step, progress): (usize, Progress),
    [output_time, total_time]: [f64; 2],
) -> Snapshot {
    let nodes = model.system.nodes();
    Snapshot {
        model: String::new(),
        angles: BTreeMap::new(),
        nodes: nodes.iter().map(|node| node.label.clone()).collect(),
        multipliers: model.system.numbering().multipliers(),
        step,
        progress,
        output_time,
        total_time,
        states: states.iter().map(numbers).collect(),
    }
}

fn numbers(state: &State) -> Vec<f64> {
    let of_node = |node: &NodeMotion| {
        let mut numbers = Vec::with_capacity(OF_NODE);
        numbers.extend(node.position.iter());
        numbers.extend(node.rotation.iter());
        for vector in [
            &node.momentum,
            &node.angular_momentum,
            &node.velocity,
            &node.angular_velocity,
            &node.momentum_rate,
            &node.angular_momentum_rate,
        ] {
            numbers.extend(vector.iter());
        }
        numbers
    };
    let of_nodes = state.nodes.iter().flat_map(of_node);
    let rest = [
        &state.multipliers,
        &state.scalars,
        &state.scalar_rates,
        &state.memory,
    ];
    let rest = rest.into_iter().flatten().copied();
    of_nodes.chain(rest).collect()
}

/// The two accepted states of a snapshot of this model, the latest first.
pub(super) fn states(model: &Model, snapshot: &Snapshot) -> Result<[State; 2], TransientFailure> {
    let mismatch = |reason: String| TransientFailure::Resume { reason };
    if let Some(reason) = difference(model, snapshot) {
        return Err(mismatch(reason));
    }
    let nodes = model.system.nodes().len();
    let numbering = model.system.numbering();
    let own = [numbering.multipliers(), numbering.scalars()];
    let length = OF_NODE * nodes + own[0] + 2 * own[1] + numbering.memory();
    match &snapshot.states[..] {
        [latest, before] if latest.len() == length && before.len() == length => {
            Ok([latest, before].map(|numbers| state(numbers, nodes, own)))
        }
        _ => Err(mismatch("its states are incomplete".to_owned())),
    }
}

/// Difference between a snapshot and a model of these nodes and joints, as text.
pub fn difference(model: &Model, snapshot: &Snapshot) -> Option<String> {
    let nodes = model.system.nodes();
    let (found, expected) = (snapshot.nodes.len(), nodes.len());
    if found != expected {
        return Some(format!("it has {found} nodes, the model {expected}"));
    }
    let mut pairs = snapshot.nodes.iter().zip(nodes);
    if let Some((found, node)) = pairs.find(|(found, node)| **found != node.label) {
        let expected = &node.label;
        return Some(format!("it has node \"{found}\", the model \"{expected}\""));
    }
    let (found, expected) = (snapshot.multipliers, model.system.numbering().multipliers());
    (found != expected)
        .then(|| format!("its joints have {found} constraints, the model {expected}"))
}

/// A state of the given numbers of nodes, multipliers and scalars; the rest is memory.
fn state(numbers: &[f64], nodes: usize, [multipliers, scalars]: [usize; 2]) -> State {
    let (of_nodes, rest) = numbers.split_at(OF_NODE * nodes);
    let (multipliers, rest) = rest.split_at(multipliers);
    let (scalars, rest) = rest.split_at(scalars);
    let (scalar_rates, memory) = rest.split_at(scalars.len());
    let of_node = |numbers: &[f64]| {
        let vector = |first: usize| Vector3::from_column_slice(&numbers[first..first + 3]);
        NodeMotion {
            position: vector(0),
            rotation: Matrix3::from_column_slice(&numbers[3..12]),
            momentum: vector(12),
            angular_momentum: vector(15),
            velocity: vector(18),
            angular_velocity: vector(21),
            momentum_rate: vector(24),
            angular_momentum_rate: vector(27),
        }
    };
    State {
        nodes: of_nodes.chunks(OF_NODE).map(of_node).collect(),
        multipliers: multipliers.to_vec(),
        scalars: scalars.to_vec(),
        scalar_rates: scalar_rates.to_vec(),
        memory: memory.to_vec(),
    }
}
