//! What single elements tell of a state, and the energy of all.

use super::System;
use crate::elements::{Energy, Observations};
use crate::model::{Conditions, State};

impl System {
    /// Adds what the element number `element` tells of a state.
    pub fn observe_element(
        &self,
        element: usize,
        state: &State,
        conditions: &Conditions,
        out: &mut Observations,
    ) {
        let nodes = self.motions(element, state);
        let at = self.seen_by(element, &nodes, state, conditions);
        self.elements[element].observe(&at, out);
    }

    /// Energy of all elements at a state.
    pub fn energy(&self, state: &State, conditions: &Conditions) -> Energy {
        let mut sum = Energy::default();
        for (index, element) in self.elements.iter().enumerate() {
            let nodes = self.motions(index, state);
            sum += element.energy(&self.seen_by(index, &nodes, state, conditions));
        }
        sum
    }
}
