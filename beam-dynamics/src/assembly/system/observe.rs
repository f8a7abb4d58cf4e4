//! Queries of single elements, and total energy.

use super::System;
use crate::elements::{
    Element, Energy, Local, LocalJacobian, LocalResidual, LocalSize, Observations, PositionJump,
    Queries,
};
use crate::model::{Conditions, State};

impl System {
    /// Adds the observations of the element with index `element` at a state.
    pub fn observe_element(
        &self,
        element: usize,
        state: &State,
        conditions: &Conditions,
        out: &mut Observations,
    ) {
        let call = |at: &Local<'_>| self.elements[element].observe(at, out);
        self.seen(element, state, conditions, call);
    }

    /// The first element, with its index, whose residual or Jacobian has no value at a state.
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

    /// Whether residual and Jacobian of the element with index `element` have values at a state.
    pub fn has_value(&self, element: usize, state: &State, conditions: &Conditions) -> bool {
        let index = element;
        let element = self.elements[index].as_ref();
        let size = LocalSize::of(element);
        let mut residual = LocalResidual::new(size);
        let mut jacobian = LocalJacobian::unmarked(size);
        self.seen(index, state, conditions, |at| {
            element.residual(at, &mut residual);
            element.jacobian(at, &mut jacobian);
        });
        let derivatives = jacobian
            .by_unknowns()
            .iter()
            .chain(jacobian.by_rates().iter());
        let mut numbers = residual.values().iter().chain(derivatives);
        numbers.all(|number| number.is_finite())
    }

    /// The reason as text why the element with index `element` has no value at a state, if the
    /// element knows it.
    pub fn why_without_value(
        &self,
        element: usize,
        state: &State,
        conditions: &Conditions,
    ) -> Option<String> {
        let own = &self.elements[element];
        self.seen(element, state, conditions, |at| own.without_value(at))
    }

    /// The first element that reports a reason for having no value at a state, with the reason.
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

    /// The first jump between two instants of a position that an element prescribes at a state, and
    /// the element.
    pub fn position_jump(
        &self,
        state: &State,
        between: [&Conditions; 2],
    ) -> Option<(&dyn Element, PositionJump)> {
        let loadings = between.map(|at| &at.loading);
        let mut elements = self.elements.iter().enumerate();
        elements.find_map(|(index, element)| {
            if element.multipliers() == 0 {
                return None;
            }
            let jump = |at: &Local<'_>| element.jump(loadings, at.scalars);
            let jump = self.seen(index, state, between[1], jump)?;
            Some((element.as_ref(), jump))
        })
    }

    /// Energy of all elements at a state.
    pub fn energy(&self, state: &State, conditions: &Conditions) -> Energy {
        let mut sum = Energy::default();
        for (index, element) in self.elements.iter().enumerate() {
            sum += self.seen(index, state, conditions, |at| element.energy(at));
        }
        sum
    }
}
