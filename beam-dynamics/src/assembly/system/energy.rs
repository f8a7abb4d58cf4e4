//! The energy of a system.

use super::System;
use crate::elements::Energy;
use crate::model::{Conditions, State};

impl System {
    /// Energy of all elements.
    pub fn energy(&self, state: &State, conditions: &Conditions) -> Energy {
        let mut sum = Energy::default();
        for (index, element) in self.elements.iter().enumerate() {
            let nodes = self.motions(index, state);
            sum += element.energy(&self.seen_by(index, &nodes, state, conditions));
        }
        sum
    }
}
