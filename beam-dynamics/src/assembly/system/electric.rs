//! Circuits of a system: their unknowns, and how they follow the motion.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::System;
use crate::elements::{Charges, ElectricKind, ElectricUnknown, ElectrodeState, Element};
use crate::model::{Conditions, State};

/// What is unknown of circuits at a given motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settling {
    /// Everything: the circuits are at rest.
    AtRest,
    /// Voltages and rates: charges, and currents of inductances, are what they are.
    InMotion,
}

/// The electric unknowns that elements bring, in the order of their numbers.
pub(super) fn numbered(elements: &[Arc<dyn Element>]) -> Vec<ElectricUnknown> {
    let brought = elements.iter().flat_map(|element| element.brings());
    let mut brought: Vec<_> = brought.collect();
    brought.sort_by_key(|own| own.0);
    brought.into_iter().map(|own| own.1).collect()
}

impl System {
    /// Whether each electric unknown has a rate.
    pub fn electric_rates(&self) -> impl Iterator<Item = bool> + '_ {
        self.electric.iter().map(ElectricUnknown::has_rate)
    }

    /// What each electric unknown is.
    pub fn electric_kinds(&self) -> impl Iterator<Item = ElectricKind> + Clone + '_ {
        self.electric.iter().map(|own| own.kind)
    }

    /// Voltages, charges and currents of all electrodes.
    pub fn electrodes(&self, state: &State, conditions: &Conditions) -> Vec<ElectrodeState> {
        let mut charges = Charges::default();
        for (index, element) in self.elements.iter().enumerate() {
            let nodes = self.motions(index, state);
            let at = self.seen_by(index, &nodes, state, conditions);
            element.charges(&at, &mut charges);
        }
        charges.electrodes()
    }

    /// Brings the electric unknowns of a state in line with its motion and with what acts;
    /// their equations are linear in them. Where these have no solution the state stays as
    /// it is.
    pub fn settle_circuits(&self, state: &mut State, conditions: &Conditions, settling: Settling) {
        let n = self.electric.len();
        if n == 0 {
            return;
        }
        let is_rate = |i: usize| settling == Settling::InMotion && self.electric[i].has_rate();
        state.electric_rates.fill(0.0);
        let first = self.numbering.first_electric();
        let tangent = self.tangent(state, conditions);
        let residual = self.residual(state, conditions).values;
        let matrix = DMatrix::from_fn(n, n, |i, j| {
            let from = match is_rate(j) {
                true => &tangent.by_rates,
                false => &tangent.by_unknowns,
            };
            from.entry(first + i, first + j)
        });
        let right = DVector::from_iterator(n, residual[first..].iter().map(|value| -value));
        let Some(change) = matrix.lu().solve(&right) else {
            return;
        };
        for (i, change) in change.iter().enumerate() {
            match is_rate(i) {
                true => state.electric_rates[i] = *change,
                false => state.electric[i] += change,
            }
        }
    }
}
