//! Differences of states, and the sizes relative to which they are measured.

use std::f64::consts::TAU;

use shared_geom::rotation::gibbs;

use crate::case::Model;
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State};
use crate::modes::MassMatrix;

/// The variation that leads from the state `start` to the state `end`, zero for algebraic unknowns:
/// rotations as parameters of `R_end R_start^T`, so that whole turns vanish.
pub(super) fn seen(end: &State, start: &State, algebraic: &[bool]) -> Vec<f64> {
    let mut d = Vec::with_capacity(algebraic.len());
    for (end, start) in end.nodes.iter().zip(&start.nodes) {
        d.extend((end.position - start.position).iter());
        d.extend(gibbs::from_rotation(&(end.rotation * start.rotation.transpose())).iter());
        d.extend((end.momentum - start.momentum).iter());
        d.extend((end.angular_momentum - start.angular_momentum).iter());
    }
    d.extend(std::iter::repeat_n(0.0, start.multipliers.len()));
    d.extend(end.scalars.iter().zip(&start.scalars).map(|(a, b)| a - b));
    d.resize(algebraic.len(), 0.0);
    for (value, _) in d.iter_mut().zip(algebraic).filter(|(_, is)| **is) {
        *value = 0.0;
    }
    d
}

/// The size of each unknown: the model's for positions, one radian, the momenta of its node moving
/// by these in a period, and the scale of a scalar; one for algebraic unknowns.
pub(super) fn sizes(
    model: &Model,
    (state, conditions): (&State, &Conditions),
    algebraic: &[bool],
    period: f64,
) -> Vec<f64> {
    let system = &model.system;
    let (_, masses) = masses(model, (state, conditions));
    let known = masses.iter().filter(|masses| masses[0] > 0.0);
    let count = known.clone().count().max(1) as f64;
    let mean = known.map(|masses| masses[0]).sum::<f64>() / count;
    let size = system.size();
    let mut sizes = Vec::with_capacity(algebraic.len());
    for [mass, inertia] in masses {
        let mass = if mass > 0.0 {
            mass
        } else {
            mean.max(f64::MIN_POSITIVE)
        };
        let inertia = if inertia > 0.0 {
            inertia
        } else {
            mass * size * size
        };
        let (momentum, angular) = (mass * size * TAU / period, inertia * TAU / period);
        for (count, own) in [(3, size), (3, 1.0), (3, momentum), (3, angular)] {
            sizes.extend(std::iter::repeat_n(own, count));
        }
    }
    sizes.extend(std::iter::repeat_n(1.0, state.multipliers.len()));
    sizes.extend(system.scalars().iter().map(|scalar| scalar.unknown.scale));
    sizes.resize(algebraic.len(), 1.0);
    for (value, _) in sizes.iter_mut().zip(algebraic).filter(|(_, is)| **is) {
        *value = 1.0;
    }
    sizes
}

/// The mass matrix, and mass \[kg\] and mean moment of inertia \[kg m^2\] of each node.
pub(super) fn masses(
    model: &Model,
    (state, conditions): (&State, &Conditions),
) -> (MassMatrix, Vec<[f64; 2]>) {
    let tangent = model.system.tangent(state, conditions);
    let mean = |node: usize, equation: Equation| {
        let first = NODE_UNKNOWNS * node + equation.row();
        let diagonal = (first..first + 3).map(|i| tangent.by_rates.entry(i, i).abs());
        diagonal.sum::<f64>() / 3.0
    };
    let nodes = 0..state.nodes.len();
    let of_nodes =
        nodes.map(|node| [Equation::Momentum, Equation::AngularMomentum].map(|of| mean(node, of)));
    let matrix = MassMatrix::new(&tangent.by_rates, state.nodes.len());
    (matrix, of_nodes.collect())
}

/// The index of the largest entry relative to its size, and this part.
pub(super) fn worst(d: &[f64], sizes: &[f64]) -> (usize, f64) {
    let parts = d.iter().zip(sizes).map(|(d, size)| (d / size).abs());
    let mut worst = (0, 0.0);
    for (i, part) in parts.enumerate() {
        if part.is_nan() {
            return (i, f64::INFINITY);
        }
        if part > worst.1 {
            worst = (i, part);
        }
    }
    worst
}
