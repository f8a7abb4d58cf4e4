//! The balance of a model under given conditions, for Newton's method.

use std::sync::Arc;

use nalgebra::Vector3;
use shared_geom::rotation::vector;

use crate::assembly::{Residual, ScalarScales, System};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State};
use crate::solver::{Equations, Factorization, Jacobian, LinearSolver, Worst};

/// Sum relative to its terms below which it is round-off. Slender beams of many elements reach
/// about 1e-10.
const ROUND_OFF: f64 = 1e-13;

/// Weight of a change of a scalar relative to a change of a position: a voltage follows from the
/// difference of strains, with their round-off.
const OF_SCALARS: f64 = 1e-3;

/// The equations `F(y, 0) = 0` of a system, and a state that must satisfy them.
#[derive(Clone)]
pub(super) struct Balance<'a> {
    pub system: &'a System,
    pub solver: &'a LinearSolver,
    pub conditions: Conditions,
    pub state: State,
    scales: Scales,
    /// Factors of the last correction.
    factors: Option<Arc<Factorization>>,
}

impl<'a> Balance<'a> {
    pub fn new(
        system: &'a System,
        solver: &'a LinearSolver,
        conditions: Conditions,
        mut state: State,
    ) -> Self {
        system.settle_scalars(&mut state, &conditions);
        Self {
            system,
            solver,
            conditions,
            state,
            scales: Scales::of(system),
            factors: None,
        }
    }

    /// The same equations under other conditions, starting from another state.
    pub fn at(&self, conditions: Conditions, mut state: State) -> Self {
        self.system.settle_scalars(&mut state, &conditions);
        Self {
            conditions,
            state,
            scales: self.scales.clone(),
            factors: None,
            ..*self
        }
    }

    /// Size of the model [m].
    pub fn reach(&self) -> f64 {
        self.scales.reach()
    }

    /// The factorized derivative by the unknowns; `None` if it is singular.
    pub fn factorize(&self) -> Option<Factorization> {
        let tangent = self.system.by_unknowns(&self.state, &self.conditions);
        self.solver.factorize(tangent)
    }

    /// Derivative of the state by the factor of the proportional loads, `dy/d lambda = -F_y^-1
    /// F_lambda`.
    pub fn rate(&self, tangent: &Factorization) -> Option<Vec<f64>> {
        let mut rate = self.system.by_factor(&self.state, &self.conditions);
        rate.iter_mut().for_each(|value| *value = -*value);
        tangent.solve(&mut rate)?;
        Some(rate)
    }

    /// Whether nothing resists the motion `rate` that the loads drive: its image under the tangent,
    /// which is the load, is round-off of the terms summed in it.
    pub fn is_free(&self, rate: &[f64]) -> bool {
        let tangent = self.system.by_unknowns(&self.state, &self.conditions);
        let load = self.system.by_factor(&self.state, &self.conditions);
        let (mut terms, mut largest) = (vec![0.0; rate.len()], vec![0.0_f64; rate.len()]);
        for (row, column, value) in tangent.triplets() {
            terms[row] += (value * rate[column]).abs();
            largest[row] = largest[row].max(value.abs());
        }
        let greatest = |sums: &[f64]| {
            let scaled = sums.iter().zip(&largest);
            let scaled = scaled.filter(|(_, size)| **size > 0.0);
            scaled
                .map(|(sum, size)| sum.abs() / size)
                .fold(0.0, f64::max)
        };
        greatest(&load) < ROUND_OFF * greatest(&terms)
    }

    /// The sizes of the changes of a solution `x` of the factorized derivative A if every term in its equations
    /// changes by its own size, with weights w without a pattern: `|A^-1 w |A| |x||`. They are in the units of the
    /// unknowns, whatever the ones of the equations are. `None` if they are not finite.
    pub fn sensitivity(&self, factors: &Factorization, x: &[f64]) -> Option<Vec<f64>> {
        let tangent = self.system.by_unknowns(&self.state, &self.conditions);
        let mut terms = vec![0.0; x.len()];
        for (row, column, value) in tangent.triplets() {
            terms[row] += (value * x[column]).abs();
        }
        for (row, term) in terms.iter_mut().enumerate() {
            *term *= (1.0 + 0.618 * row as f64).sin();
        }
        factors.solve(&mut terms)?;
        Some(terms.into_iter().map(f64::abs).collect())
    }

    /// Whether a residual is round-off of the stiffness times the size of the model.
    pub fn is_round_off(&self, residual: &[f64]) -> bool {
        let tangent = self.system.by_unknowns(&self.state, &self.conditions);
        let mut largest = vec![0.0_f64; residual.len()];
        for (row, _, value) in tangent.triplets() {
            largest[row] = largest[row].max(value.abs());
        }
        let scaled = residual.iter().zip(&largest);
        let reach = self.reach().max(1.0);
        let mut scaled = scaled.map(|(value, size)| {
            // An infinite slope is no reference.
            size.is_finite() && value.abs() <= ROUND_OFF * size * reach
        });
        scaled.all(|is_small| is_small)
    }

    /// Displacement and rotation of every node from `before` to the present state, in the order of
    /// the unknowns; zero for all other unknowns.
    pub fn moved_from(&self, before: &State) -> Vec<f64> {
        let mut moved = vec![0.0; self.system.numbering().unknowns()];
        let nodes = self.state.nodes.iter().zip(&before.nodes);
        for (values, (now, then)) in moved.chunks_mut(NODE_UNKNOWNS).zip(nodes) {
            let turn = vector::from_rotation(&(now.rotation * then.rotation.transpose()));
            values[..3].copy_from_slice((now.position - then.position).as_slice());
            values[3..6].copy_from_slice(turn.as_slice());
        }
        moved
    }

    /// Scalar product of two motions: displacements in sizes of the model, rotations in
    /// radians, mean of all nodes [-].
    pub fn product(&self, a: &[f64], b: &[f64]) -> f64 {
        let nodes = self.state.nodes.len();
        let pairs = a.chunks(NODE_UNKNOWNS).zip(b.chunks(NODE_UNKNOWNS));
        let of_node = |(a, b): (&[f64], &[f64])| {
            let part = |i: usize| (0..3).map(|k| a[i + k] * b[i + k]).sum::<f64>();
            part(0) / (self.reach() * self.reach()) + part(3)
        };
        pairs.take(nodes).map(of_node).sum::<f64>() / nodes.max(1) as f64
    }

    /// Length of a motion [-].
    pub fn length(&self, motion: &[f64]) -> f64 {
        self.product(motion, motion).sqrt()
    }
}

impl Equations for Balance<'_> {
    fn residual(&mut self) -> (Vec<f64>, Worst) {
        let residual = self.system.residual(&self.state, &self.conditions);
        let worst = self.scales.worst(&residual);
        (residual.values, worst)
    }

    fn correction(&mut self, residual: &[f64], jacobian: Jacobian) -> Option<Vec<f64>> {
        if jacobian == Jacobian::Own || self.factors.is_none() {
            self.factors = Some(Arc::new(self.factorize()?));
        }
        let mut correction: Vec<_> = residual.iter().map(|value| -value).collect();
        self.factors.as_ref()?.respond(&mut correction)?;
        Some(correction)
    }

    /// Largest displacement in sizes of the model, rotation in radians, and change of a scalar
    /// relative to its scale.
    fn size(&self, correction: &[f64]) -> f64 {
        self.scales.size(correction, &self.state.scalars)
    }

    fn correct(&mut self, correction: &[f64]) {
        self.state.correct(correction);
        self.system
            .settle_scalars(&mut self.state, &self.conditions);
    }
}

/// Largest displacement in sizes of the model, and largest rotation in radians, of nodes whose
/// numbers begin with their displacements and rotations; NaN if one is NaN.
pub(super) fn largest_motion<'a>(nodes: impl Iterator<Item = &'a [f64]>, size: f64) -> f64 {
    let motions = nodes.flat_map(|node| {
        let part = |i: usize| Vector3::new(node[i], node[i + 1], node[i + 2]).norm();
        [part(0) / size, part(3)]
    });
    // The maximum of a number and NaN is the number: NaN must be checked.
    motions.fold(0.0, |largest: f64, motion| {
        if largest.is_nan() || motion.is_nan() {
            f64::NAN
        } else {
            largest.max(motion)
        }
    })
}

/// An equation and its residual, as text.
pub(super) fn worst_equation(system: &System, worst: &Worst) -> String {
    let name = system.equation(worst.index);
    name.off_by(worst.relative, worst.scale)
}

/// References for residuals and corrections of a model.
#[derive(Debug, Clone)]
pub(super) struct Scales {
    /// Index of the first multiplier, and of the first scalar.
    first: [usize; 2],
    /// Size of the model [m].
    size: f64,
    /// Distance of neighbors, the lever of moments, which are taken about the nodes [m].
    arm: f64,
    scalars: ScalarScales,
    equations: ScalarScales,
}

impl Scales {
    /// The references of `system`.
    pub fn of(system: &System) -> Self {
        let nodes = system.nodes().len();
        let size = system.size();
        Self {
            first: [NODE_UNKNOWNS * nodes, system.numbering().first_scalar()],
            size,
            arm: size / nodes.max(1) as f64,
            scalars: system.scalar_scales(|_| true),
            equations: system.scalar_equation_scales(),
        }
    }

    /// Size of the model \[m\].
    pub fn reach(&self) -> f64 {
        self.size
    }

    /// Size of a correction: the largest displacement in sizes of the model, rotation in radians,
    /// and weighted change of a scalar relative to its scale; `scalars` are the values before the
    /// correction. The equations are linear in momenta and multipliers, so that the residual shows
    /// their errors.
    pub fn size(&self, correction: &[f64], scalars: &[f64]) -> f64 {
        let [nodes, first] = self.first;
        let moved = largest_motion(correction[..nodes].chunks(NODE_UNKNOWNS), self.size);
        let changes = &correction[first..];
        let size = |i: usize| scalars[i].abs().max((scalars[i] + changes[i]).abs());
        let changed = OF_SCALARS * self.scalars.largest(changes, size).part;
        if changed > moved || changed.is_nan() {
            changed
        } else {
            moved
        }
    }

    /// The worst equation: residual relative to the largest term of its kind. The terms of moments,
    /// and angular momenta, include the largest force, or momentum, on a lever, and the terms of
    /// forces the largest moment over it: on a straight blade that turns the moments are only
    /// round-off of forces, and in pure bending the forces are round-off of moments. Equations of
    /// scalars are compared with equations of the same unit.
    pub fn worst(&self, residual: &Residual) -> Worst {
        let [nodes, first] = self.first;
        let mut largest = largest_of_kinds(&residual.sizes[..nodes]);
        for (force, moment) in [
            (Equation::Force, Equation::Moment),
            (Equation::Momentum, Equation::AngularMomentum),
        ] {
            let [of_forces, of_moments] = [force, moment].map(|kind| largest[kind as usize]);
            largest[moment as usize] = of_moments.max(self.arm * of_forces);
            if self.arm > 0.0 {
                largest[force as usize] = of_forces.max(of_moments / self.arm);
            }
        }
        // Equations of a kind have one scale. The terms of a constraint vanish with it: its
        // reference is one.
        let values = &residual.values;
        let of_nodes = largest_of_kinds(&values[..nodes]);
        let of_nodes = of_nodes.iter().zip(largest).enumerate();
        let of_nodes = of_nodes.map(|(kind, (&value, scale))| Worst {
            relative: if scale > 0.0 { value / scale } else { 0.0 },
            index: kind,
            scale,
        });
        let of_nodes = of_nodes.max_by(|a, b| a.relative.total_cmp(&b.relative));
        let of_nodes = of_nodes.filter(|_| nodes > 0).map(|worst| Worst {
            index: largest_at(&values[..nodes], |index| kind_of(index) == worst.index),
            ..worst
        });
        let of_constraints = &values[nodes..first];
        let of_constraints = (first > nodes).then(|| Worst {
            relative: of_constraints.iter().fold(0.0, |a, b| larger(a, b.abs())),
            index: nodes + largest_at(of_constraints, |_| true),
            scale: 1.0,
        });
        let size = |i: usize| residual.sizes[first + i];
        let of_scalars = self.equations.largest(&residual.values[first..], size);
        let of_scalars = Worst {
            relative: of_scalars.part,
            index: first + of_scalars.scalar,
            scale: of_scalars.scale,
        };
        let has_scalars = !self.equations.is_empty();
        let worst = of_nodes.into_iter().chain(of_constraints);
        let worst = worst.chain(has_scalars.then_some(of_scalars));
        worst
            .max_by(|a, b| a.relative.total_cmp(&b.relative))
            .unwrap_or_default()
    }
}

/// Kinds of equations of a node.
const KINDS: usize = Equation::ALL.len();

/// Kind of an equation of a node, by its index in the system.
fn kind_of(index: usize) -> usize {
    index % NODE_UNKNOWNS / 3
}

/// The largest magnitude in the equations of each kind; NaN is larger than all.
fn largest_of_kinds(nodes: &[f64]) -> [f64; KINDS] {
    let mut largest = [0.0_f64; KINDS];
    for node in nodes.chunks_exact(NODE_UNKNOWNS) {
        for (largest, values) in largest.iter_mut().zip(node.chunks_exact(3)) {
            let values = values.iter().map(|value| value.abs());
            *largest = values.fold(*largest, larger);
        }
    }
    largest
}

/// The larger of two numbers; NaN is larger than all.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// Index of the largest magnitude among the chosen values, the last of equal ones; NaN is larger
/// than all.
fn largest_at(values: &[f64], is_chosen: impl Fn(usize) -> bool) -> usize {
    let chosen = (0..values.len()).filter(|&index| is_chosen(index));
    let largest = chosen.max_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()));
    largest.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    // A displacement of 3 in a model of size 2, rotations of 1; then NaN at each index.
    #[test]
    fn a_motion_without_a_value_is_none() {
        let motion = |nodes: &[f64]| largest_motion(nodes.chunks(6), 2.0);
        let mut nodes = [0.0; 18];
        (nodes[1], nodes[9]) = (3.0, 1.0);
        assert!((motion(&nodes) - 1.5).abs() < 1e-15);
        for index in 0..nodes.len() {
            let mut nodes = nodes;
            nodes[index] = f64::NAN;
            assert!(motion(&nodes).is_nan(), "{index}");
        }
    }
}
