//! What single elements tell of a state, and the energy of all.

use super::System;
use crate::elements::{Element, Energy, LocalJacobian, LocalResidual, Observations};
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

    /// The first element, with its number, whose residual or Jacobian has no value at a
    /// state.
    pub fn without_value(
        &self,
        state: &State,
        conditions: &Conditions,
    ) -> Option<(usize, &dyn Element)> {
        let mut elements = self.elements.iter().enumerate();
        let (index, element) =
            elements.find(|(index, _)| !self.has_value(*index, state, conditions))?;
        Some((index, element.as_ref()))
    }

    /// Whether residual and Jacobian of the element number `element` have values at a state.
    pub fn has_value(&self, element: usize, state: &State, conditions: &Conditions) -> bool {
        let nodes = self.motions(element, state);
        let at = self.seen_by(element, &nodes, state, conditions);
        let element = &self.elements[element];
        let mut residual = LocalResidual::new(nodes.len(), element.own_rows());
        let mut jacobian = LocalJacobian::unmarked(nodes.len(), element.own_rows());
        element.residual(&at, &mut residual);
        element.jacobian(&at, &mut jacobian);
        let derivatives = jacobian
            .by_unknowns()
            .iter()
            .chain(jacobian.by_rates().iter());
        let mut numbers = residual.values().iter().chain(derivatives);
        numbers.all(|number| number.is_finite())
    }

    /// Why the element number `element` has no value at a state, in words, where it can tell.
    pub fn why_without_value(
        &self,
        element: usize,
        state: &State,
        conditions: &Conditions,
    ) -> Option<String> {
        let nodes = self.motions(element, state);
        let at = self.seen_by(element, &nodes, state, conditions);
        self.elements[element].without_value(&at)
    }

    /// The first element that can say why it has no value at a state, and why.
    pub fn first_without_value(
        &self,
        state: &State,
        conditions: &Conditions,
    ) -> Option<(&dyn Element, String)> {
        let mut elements = self.elements.iter().enumerate();
        elements.find_map(|(index, element)| {
            let why = self.why_without_value(index, state, conditions)?;
            Some((element.as_ref(), why))
        })
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
