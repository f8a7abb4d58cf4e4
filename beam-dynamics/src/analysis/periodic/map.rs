//! The derivative of the motion over a period by its first state, as products.
//!
//! With `d = (dx, theta, d beta, d gamma | dz)` the spatial variation of a state, a step of Radau
//! IIA at its converged stages gives
//!
//! ```text
//! sum_j (h a_ij F_xi + delta_ij F_K) dK_j + F_lambda d lambda_i = -F_y d_{n-1}
//! d_n = U ( d_{n-1} + h sum_j a_sj dK_j ) ,
//! theta_n = G(u_s) U dg_s + R(u_s) U theta_{n-1}                                       (D-441)
//! ```
//!
//! with the rotation U of the axes in which a node is integrated.
//!
//! Redundant coordinates and constraints need no projection: two steps map all n directions onto a
//! space of the dimension of the true states, so that the map of a period has the multipliers of the
//! motion, and zeros.

use faer::Mat;
use nalgebra::{Matrix3, Vector3};

use crate::assembly::Sparse;
use crate::model::NODE_UNKNOWNS;
use crate::solver::Factorization;

/// The linearized step.
pub(super) struct StepMap {
    /// The matrix of all stages.
    pub factors: Factorization,
    /// `F_y` of each stage by the first state of the step.
    pub by_base: Vec<Sparse>,
    /// G U, R U and U of each node at the end.
    pub carried: Vec<[Matrix3<f64>; 3]>,
    /// `h a_sj` of the end [s].
    pub weights: Vec<f64>,
}

impl StepMap {
    /// Replaces the variations in the columns of `d` by those a step later; `None` if they are not
    /// finite.
    fn apply(&self, algebraic: &[bool], d: &mut Mat<f64>) -> Option<()> {
        let (n, stages, columns) = (algebraic.len(), self.by_base.len(), d.ncols());
        let mut rates = Mat::zeros(stages * n, columns);
        let mut product = vec![0.0; n];
        for column in 0..columns {
            for (stage, by_base) in self.by_base.iter().enumerate() {
                product.fill(0.0);
                by_base.multiply_add(d.col_as_slice(column), &mut product);
                let out = rates.col_as_slice_mut(column);
                for (i, value) in product.iter().enumerate() {
                    out[stages * i + stage] = -value;
                }
            }
        }
        self.factors.solve_columns(&mut rates)?;
        for column in 0..columns {
            self.add(
                rates.col_as_slice(column),
                algebraic,
                d.col_as_slice_mut(column),
            );
        }
        Some(())
    }

    /// Adds the changes of a step of the given rates of all stages.
    fn add(&self, rates: &[f64], algebraic: &[bool], d: &mut [f64]) {
        let stages = self.weights.len();
        let change = |i: usize| -> f64 {
            let own = &rates[stages * i..stages * (i + 1)];
            own.iter().zip(&self.weights).map(|(k, w)| k * w).sum()
        };
        for (node, [tangent, rotation, axes]) in self.carried.iter().enumerate() {
            for vector in 0..4 {
                let first = NODE_UNKNOWNS * node + 3 * vector;
                let before = Vector3::from_column_slice(&d[first..first + 3]);
                let change = Vector3::new(change(first), change(first + 1), change(first + 2));
                let later = match vector {
                    1 => tangent * change + rotation * before,
                    _ => axes * (before + change),
                };
                d[first..first + 3].copy_from_slice(later.as_slice());
            }
        }
        let others = NODE_UNKNOWNS * self.carried.len();
        for (i, &is_algebraic) in algebraic.iter().enumerate().skip(others) {
            if is_algebraic {
                d[i] = 0.0
            } else {
                d[i] += change(i)
            }
        }
    }
}

/// The linearized period: the monodromy map of a state.
pub(super) struct PeriodMap {
    steps: Vec<StepMap>,
    algebraic: Vec<bool>,
    /// See [`PeriodMap::travel`].
    travel: Vec<f64>,
}

impl PeriodMap {
    /// The product of all `steps`; `travel` has the sums over the steps of the sizes of the changes of the
    /// scalars.
    pub fn new(steps: Vec<StepMap>, algebraic: Vec<bool>, travel: &[f64]) -> Self {
        let mut all = vec![0.0; algebraic.len() - travel.len()];
        all.extend_from_slice(travel);
        Self {
            steps,
            algebraic,
            travel: all,
        }
    }

    /// The sum over the steps of the sizes of the changes of each unknown in the motion; zero for others than
    /// scalars.
    pub fn travel(&self) -> &[f64] {
        &self.travel
    }

    /// Number of entries of a variation, with algebraic unknowns, whose entries are zero.
    pub fn size(&self) -> usize {
        self.algebraic.len()
    }

    /// Whether each unknown has no rate.
    pub fn algebraic(&self) -> &[bool] {
        &self.algebraic
    }

    /// Number of steps.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.steps.first().map_or(0, |step| step.carried.len())
    }

    /// Replaces any vector by a variation of the end that the constraints allow: the last two steps.
    pub fn project(&self, d: &mut [f64]) -> Option<()> {
        for (value, _) in d.iter_mut().zip(&self.algebraic).filter(|(_, is)| **is) {
            *value = 0.0;
        }
        let mut columns = Mat::from_fn(d.len(), 1, |i, _| d[i]);
        for step in &self.steps[self.steps.len().saturating_sub(2)..] {
            step.apply(&self.algebraic, &mut columns)?;
        }
        d.copy_from_slice(columns.col_as_slice(0));
        Some(())
    }

    /// Replaces a variation by that a period later.
    pub fn apply(&self, d: &mut [f64]) -> Option<()> {
        let mut columns = Mat::from_fn(d.len(), 1, |i, _| d[i]);
        self.follow(&mut columns, &mut |_, _| ())?;
        d.copy_from_slice(columns.col_as_slice(0));
        Some(())
    }

    /// The same; returns the sum over the steps of the sizes of the changes of each entry.
    pub fn apply_with_travel(&self, d: &mut [f64]) -> Option<Vec<f64>> {
        let (mut before, mut travel) = (d.to_vec(), vec![0.0; d.len()]);
        let mut columns = Mat::from_fn(d.len(), 1, |i, _| d[i]);
        self.follow(&mut columns, &mut |_, columns| {
            let now = columns.col_as_slice(0);
            for (sum, (before, now)) in travel.iter_mut().zip(before.iter_mut().zip(now)) {
                *sum += (now - *before).abs();
                *before = *now;
            }
        })?;
        d.copy_from_slice(&before);
        Some(travel)
    }

    /// Replaces the variations in the columns by those a period later; they are shown to `visit`
    /// after each step, numbered from one.
    pub fn follow(&self, d: &mut Mat<f64>, visit: &mut dyn FnMut(usize, &Mat<f64>)) -> Option<()> {
        for (number, step) in self.steps.iter().enumerate() {
            step.apply(&self.algebraic, d)?;
            visit(number + 1, d);
        }
        Some(())
    }
}

#[cfg(test)]
mod tests;
