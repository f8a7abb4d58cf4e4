//! Motions of nodes, multipliers and scalars as the numbers that formulas see, and back.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::gibbs::{self, Attitude};

use super::own_axes::OwnAxes;
use crate::model::{NODE_UNKNOWNS, NodeMotion, State};

/// The three numbers of a vector variable of a node.
pub(super) fn part(values: &[f64], variable: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&values[3 * variable..3 * variable + 3])
}

pub(super) fn attitude(node: &NodeMotion) -> Attitude {
    Attitude {
        rotation: node.rotation,
        angular_velocity: node.angular_velocity,
    }
}

/// Numbers of all nodes, twelve each, and of the multipliers and the scalars.
pub(super) fn split(values: &[f64], nodes: usize) -> (std::slice::Chunks<'_, f64>, &[f64]) {
    let (of_nodes, of_multipliers) = values.split_at(NODE_UNKNOWNS * nodes);
    (of_nodes.chunks(NODE_UNKNOWNS), of_multipliers)
}

/// Multipliers and scalars of `base`, moved.
pub(super) fn move_own(state: &mut State, base: &State, changes: &[f64]) {
    let bases = base.multipliers.iter().chain(&base.scalars);
    let numbers = state.multipliers.iter_mut().chain(&mut state.scalars);
    for ((number, base), change) in numbers.zip(bases).zip(changes) {
        *number = base + change;
    }
}

/// One step of Newton's iteration for the polar factor: takes away the round-off of many
/// products.
pub(super) fn orthogonal(r: &Matrix3<f64>) -> Matrix3<f64> {
    r * (1.5 * Matrix3::identity() - 0.5 * r.transpose() * r)
}

/// Where an angular momentum is integrated: in space, or in axes that follow a node from
/// its latest accepted attitude.
type Axes<'a> = Option<(&'a OwnAxes, &'a Matrix3<f64>)>;

/// Angular momentum and its rate as they are integrated.
fn integrated(node: &NodeMotion, axes: Axes<'_>) -> [Vector3<f64>; 2] {
    let (gamma, rate) = (node.angular_momentum, node.angular_momentum_rate);
    let Some((own, origin)) = axes else {
        return [gamma, rate];
    };
    let follows = own.at(origin, &node.rotation, &node.angular_velocity);
    let back = follows.axes.transpose();
    [back * gamma, back * (rate - follows.spin.cross(&gamma))]
}

pub(super) fn write(
    node: &NodeMotion,
    origin: &NodeMotion,
    own: Option<&OwnAxes>,
    (y, rates): (&mut [f64], &mut [f64]),
) {
    let turn = gibbs::relative(&attitude(node), &origin.rotation);
    let axes = own.map(|own| (own, &origin.rotation));
    let [gamma, gamma_rate] = integrated(node, axes);
    let changes = [
        node.position - origin.position,
        turn.parameters,
        node.momentum - origin.momentum,
        gamma - integrated(origin, axes)[0],
    ];
    let slopes = [node.velocity, turn.rate, node.momentum_rate, gamma_rate];
    for i in 0..4 {
        y[3 * i..3 * i + 3].copy_from_slice(changes[i].as_slice());
        rates[3 * i..3 * i + 3].copy_from_slice(slopes[i].as_slice());
    }
}

/// A node moved from `base` by changes of its unknowns and of their rates; `turned` is
/// its attitude after it. The rates of `base` count as far as `kept`.
pub(super) fn moved(
    (base, kept): (&NodeMotion, f64),
    turned: &Attitude,
    axes: Axes<'_>,
    (y, rates): (&[f64], &[f64]),
) -> NodeMotion {
    let [gamma, gamma_rate] = integrated(base, axes);
    let (gamma, gamma_rate) = (gamma + part(y, 3), kept * gamma_rate + part(rates, 3));
    let [gamma, gamma_rate] = match axes {
        None => [gamma, gamma_rate],
        Some((own, origin)) => {
            let follows = own.at(origin, &turned.rotation, &turned.angular_velocity);
            let in_space = follows.axes * gamma;
            let turning = follows.spin.cross(&in_space);
            [in_space, follows.axes * gamma_rate + turning]
        }
    };
    NodeMotion {
        position: base.position + part(y, 0),
        rotation: turned.rotation,
        momentum: base.momentum + part(y, 2),
        angular_momentum: gamma,
        velocity: kept * base.velocity + part(rates, 0),
        angular_velocity: turned.angular_velocity,
        momentum_rate: kept * base.momentum_rate + part(rates, 2),
        angular_momentum_rate: gamma_rate,
    }
}
