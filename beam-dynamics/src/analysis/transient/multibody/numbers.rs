//! Conversion of motions of nodes, multipliers and scalars to the numbers of the integration
//! schemes, and back.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::gibbs::{self, Attitude, Increment};

use super::own_axes::{Following, OwnAxes};
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

/// Numbers of all nodes, twelve per node, and of the multipliers and the scalars.
pub(super) fn split(values: &[f64], nodes: usize) -> (std::slice::Chunks<'_, f64>, &[f64]) {
    let (of_nodes, of_multipliers) = values.split_at(NODE_UNKNOWNS * nodes);
    (of_nodes.chunks(NODE_UNKNOWNS), of_multipliers)
}

/// Multipliers and scalars of `base`, plus their changes.
pub(super) fn move_own(state: &mut State, base: &State, changes: &[f64]) {
    let bases = base.multipliers.iter().chain(&base.scalars);
    let numbers = state.multipliers.iter_mut().chain(&mut state.scalars);
    for ((number, base), change) in numbers.zip(bases).zip(changes) {
        *number = base + change;
    }
}

/// One Newton iteration for the polar factor: removes the round-off of many products.
pub(super) fn orthogonal(r: &Matrix3<f64>) -> Matrix3<f64> {
    r * (1.5 * Matrix3::identity() - 0.5 * r.transpose() * r)
}

/// Axes in which an angular momentum is integrated: fixed in space, or following a node from its
/// latest accepted attitude.
type Axes<'a> = Option<(&'a OwnAxes, &'a Matrix3<f64>)>;

/// Angular momentum and its rate in the axes of integration: axes that follow the node, or fixed in
/// space.
pub(super) type Integrated = [Vector3<f64>; 2];

/// The angular momentum of a node in its axes of integration.
fn integrated(node: &NodeMotion, follows: Option<Following>) -> Integrated {
    let (gamma, rate) = (node.angular_momentum, node.angular_momentum_rate);
    let Some(Following {
        axes,
        angular_velocity,
    }) = follows
    else {
        return [gamma, rate];
    };
    let back = axes.transpose();
    [back * gamma, back * (rate - angular_velocity.cross(&gamma))]
}

/// The same for the latest accepted state of a node, from which its axes follow it.
pub(super) fn integrated_latest(node: &NodeMotion, own: Option<&OwnAxes>) -> Integrated {
    let follows = own.map(|own| own.at_origin(&node.rotation, &node.angular_velocity));
    integrated(node, follows)
}

/// Number of the vectors of a node that its turning axes carry: angular momenta in own axes follow
/// the node.
pub(super) fn lifted(own: Option<&OwnAxes>) -> usize {
    if own.is_some() { 3 } else { 4 }
}

/// The attitude of a node with its angular velocity relative to axes that turn with `axes` \[rad/s\].
pub(super) fn relative(node: &NodeMotion, axes: &Vector3<f64>) -> Attitude {
    Attitude {
        rotation: node.rotation,
        angular_velocity: node.angular_velocity - axes,
    }
}

/// The attitude of a node after a correction relative to axes that turn with `axes` \[rad/s\].
pub(super) fn corrected(turn: &Increment, node: &NodeMotion, axes: &Vector3<f64>) -> Attitude {
    let mut turned = gibbs::corrected(turn, &relative(node, axes));
    turned.angular_velocity += axes;
    turned
}

/// The rates of the latest accepted state, of which the changes relative to itself are zero; of a
/// node as its turning axes see it, and of itself.
pub(super) fn write_latest(
    [seen, node]: [&NodeMotion; 2],
    own: Option<&OwnAxes>,
    (y, rates): (&mut [f64], &mut [f64]),
) {
    y.fill(0.0);
    let gamma_rate = match own {
        None => seen.angular_momentum_rate,
        Some(_) => integrated_latest(node, own)[1],
    };
    let slopes = [
        seen.velocity,
        seen.angular_velocity,
        seen.momentum_rate,
        gamma_rate,
    ];
    write_variables(slopes, rates);
}

/// Changes of a node from the latest accepted state, `origin`, and its rates; of the node as its
/// turning axes see it, and of itself.
pub(super) fn write(
    [seen, node]: [&NodeMotion; 2],
    origin: &NodeMotion,
    own: Option<&OwnAxes>,
    (y, rates): (&mut [f64], &mut [f64]),
) {
    let turn = gibbs::relative(&attitude(seen), &origin.rotation);
    let axes = |own: &OwnAxes| own.at(&origin.rotation, &node.rotation, &node.angular_velocity);
    let [gamma, gamma_rate] = match own {
        None => integrated(seen, None),
        Some(own) => integrated(node, Some(axes(own))),
    };
    let before = match own {
        None => origin.angular_momentum,
        Some(_) => origin.rotation.tr_mul(&origin.angular_momentum),
    };
    let changes = [
        seen.position - origin.position,
        turn.parameters,
        seen.momentum - origin.momentum,
        gamma - before,
    ];
    write_variables(changes, y);
    let slopes = [seen.velocity, turn.rate, seen.momentum_rate, gamma_rate];
    write_variables(slopes, rates);
}

/// The four vector variables of a node as numbers.
fn write_variables(variables: [Vector3<f64>; 4], numbers: &mut [f64]) {
    for (numbers, variable) in numbers.chunks_exact_mut(3).zip(variables) {
        numbers.copy_from_slice(variable.as_slice());
    }
}

/// A node moved from `base` by changes of its unknowns and of their rates; `turned` is its new
/// attitude, and `gamma` its angular momentum in the axes of integration.
pub(super) fn moved(
    base: &NodeMotion,
    turned: &Attitude,
    (gamma, axes): (&Integrated, Axes<'_>),
    (y, rates): (&[f64], &[f64]),
) -> NodeMotion {
    let [gamma, gamma_rate] = match axes {
        None => *gamma,
        Some((own, origin)) => {
            let Following {
                axes,
                angular_velocity,
            } = own.at(origin, &turned.rotation, &turned.angular_velocity);
            let in_space = axes * gamma[0];
            [
                in_space,
                axes * gamma[1] + angular_velocity.cross(&in_space),
            ]
        }
    };
    NodeMotion {
        position: base.position + part(y, 0),
        rotation: turned.rotation,
        momentum: base.momentum + part(y, 2),
        angular_momentum: gamma,
        velocity: base.velocity + part(rates, 0),
        angular_velocity: turned.angular_velocity,
        momentum_rate: base.momentum_rate + part(rates, 2),
        angular_momentum_rate: gamma_rate,
    }
}

/// An angular momentum in its axes of integration, moved by changes of the unknowns and of their
/// rates.
pub(super) fn moved_momentum(
    [gamma, rate]: &Integrated,
    (y, rates): (&[f64], &[f64]),
) -> Integrated {
    [gamma + part(y, 3), rate + part(rates, 3)]
}
