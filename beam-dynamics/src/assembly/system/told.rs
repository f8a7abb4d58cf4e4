//! What single elements tell of a state.

use super::System;
use crate::elements::Observations;
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
}
