//! How the constraints of a system change by themselves.

use super::System;
use crate::elements::{ConstraintRates, Element};
use crate::model::{Conditions, NodeMotion, State};

impl System {
    /// `d Phi / d t` at fixed positions, and what is left of the last derivative without
    /// accelerations, of all constraints in the order of the multipliers (see
    /// [`ConstraintRates`]); `None` when some element does not know.
    pub fn constraint_rates(
        &self,
        state: &State,
        conditions: &Conditions,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let count = self.numbering.multipliers();
        let (mut by_time, mut convective) = (vec![0.0; count], vec![0.0; count]);
        for (index, element) in self.elements.iter().enumerate() {
            let nodes = element.nodes().iter().map(|&node| state.nodes[node]);
            let nodes: Vec<NodeMotion> = nodes.collect();
            let range = self.numbering.multipliers_of(index);
            let mut out = ConstraintRates {
                by_time: &mut by_time[range.clone()],
                convective: &mut convective[range],
            };
            let at = self.seen_by(index, &nodes, state, conditions);
            if !element.constraint_rates(&at, &mut out) {
                return None;
            }
        }
        Some((by_time, convective))
    }

    /// The first element that holds a rotation that it drives half a turn off.
    pub fn turned_over(&self, state: &State, conditions: &Conditions) -> Option<&dyn Element> {
        let held = self.elements.iter().enumerate();
        let mut held = held.filter(|(_, element)| element.multipliers() > 0);
        let over = held.find(|(index, element)| match *element.nodes() {
            [b] => {
                let nodes = [state.nodes[b]];
                element.is_turned_over(&self.seen_by(*index, &nodes, state, conditions))
            }
            [a, b] => {
                let nodes = [a, b].map(|node| state.nodes[node]);
                element.is_turned_over(&self.seen_by(*index, &nodes, state, conditions))
            }
            _ => false,
        });
        over.map(|(_, element)| element.as_ref())
    }
}
