//! Energy and power of single elements, without allocation.

use super::System;
use super::layout::{Buffers, Workspace};
use crate::elements::{Energy, Queries};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, State};

impl System {
    /// Number of elements.
    pub fn element_count(&self) -> usize {
        self.elements.len()
    }

    /// Energy of the element with index `element` at a state.
    pub fn energy_of(
        &self,
        element: usize,
        (state, conditions): (&State, &Conditions),
        work: &mut Workspace,
    ) -> Energy {
        let at = self.placed(element, state, conditions, &mut work.buffers.gathered);
        self.elements[element].energy(&at)
    }

    /// Power of the forces of the element with index `element` on its nodes \[W\],
    ///
    /// ```text
    /// P = sum over nodes ( F . v + M . omega )
    /// ```
    pub fn power_of(
        &self,
        element: usize,
        (state, conditions): (&State, &Conditions),
        work: &mut Workspace,
    ) -> f64 {
        let Buffers { gathered, of_kinds } = &mut work.buffers;
        let local = &mut of_kinds[self.layouts[element].kind].residual;
        local.clear();
        let at = self.placed(element, state, conditions, gathered);
        self.elements[element].residual(&at, local);
        let rows = local.values().chunks_exact(NODE_UNKNOWNS);
        let powers = rows.zip(at.nodes).map(|(rows, node)| {
            let [force, moment] = [Equation::Force, Equation::Moment].map(|equation| {
                let first = equation.row();
                &rows[first..first + 3]
            });
            let (v, omega) = (&node.velocity, &node.angular_velocity);
            (0..3)
                .map(|i| force[i] * v[i] + moment[i] * omega[i])
                .sum::<f64>()
        });
        powers.sum()
    }
}
