//! Derivatives of an element by central differences.

use nalgebra::DMatrix;

use super::{Own, STEP, vary};
use crate::elements::{Element, LocalResidual, LocalSize, Queries};
use crate::model::{Conditions, NODE_UNKNOWNS, NodeMotion, Variable};

/// Derivatives by unknowns and by rates, by central differences.
pub(super) fn differences(
    element: &dyn Element,
    motion: &[NodeMotion],
    own: &Own,
    conditions: &Conditions,
) -> [DMatrix<f64>; 2] {
    let residual = |nodes: &[NodeMotion], own: &Own| {
        let mut out = LocalResidual::new(LocalSize::of(element));
        element.residual(&own.seen(nodes, conditions), &mut out);
        nalgebra::DVector::from_column_slice(out.values())
    };
    let first = NODE_UNKNOWNS * motion.len();
    let n = LocalSize::of(element).rows();
    let mut by = [DMatrix::zeros(n, n), DMatrix::zeros(n, n)];
    for node in 0..motion.len() {
        for (variable, axis) in Variable::ALL
            .into_iter()
            .flat_map(|v| (0..3).map(move |a| (v, a)))
        {
            let at = |step: f64| {
                let mut nodes = motion.to_vec();
                vary(&mut nodes[node], variable, axis, step);
                residual(&nodes, own)
            };
            let column = (at(STEP) - at(-STEP)) / (2.0 * STEP);
            let position = NODE_UNKNOWNS * node + variable.column() + axis;
            by[usize::from(variable.is_rate())].set_column(position, &column);
        }
    }
    let difference = |vary: &dyn Fn(&mut Own, f64)| {
        let at = |step: f64| {
            let mut changed = own.clone();
            vary(&mut changed, step);
            residual(motion, &changed)
        };
        (at(STEP) - at(-STEP)) / (2.0 * STEP)
    };
    for i in 0..own.multipliers.len() {
        let column = difference(&|own, step| own.multipliers[i] += step);
        by[0].set_column(first + i, &column);
    }
    for k in 0..own.scalars.len() {
        let position = first + own.multipliers.len() + k;
        let column = difference(&|own, step| own.scalars[k] += step);
        by[0].set_column(position, &column);
        let column = difference(&|own, step| own.scalar_rates[k] += step);
        by[1].set_column(position, &column);
    }
    by
}
