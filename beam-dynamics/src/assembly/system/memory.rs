//! Memory of elements of accepted steps, and scalars that elements settle themselves.

use super::System;
use super::layout::Workspace;
use crate::elements::{Local, Settling};
use crate::model::{Conditions, ScalarStart, State};

impl System {
    /// Replaces the scalars that Newton's method does not find by their values at rest in the
    /// motion of the state.
    pub fn settle_scalars(&self, state: &mut State, conditions: &Conditions) {
        self.replace_scalars(state, conditions, |settling, at, values| {
            settling.settle(at, values);
        });
    }

    /// Replaces the first guesses of scalars that settle by values near the ones at rest in the motion
    /// of the state.
    pub fn begin_scalars(&self, state: &mut State, conditions: &Conditions) {
        let before = state.scalars.clone();
        self.replace_scalars(state, conditions, |settling, at, values| {
            settling.begin(at, values);
        });
        let scalars = self.scalars().iter().zip(before);
        for (value, (scalar, before)) in state.scalars.iter_mut().zip(scalars) {
            if scalar.start != ScalarStart::Settled {
                *value = before;
            }
        }
    }

    fn replace_scalars(
        &self,
        state: &mut State,
        conditions: &Conditions,
        replace: impl Fn(&dyn Settling, &Local<'_>, &mut [f64]),
    ) {
        let mut values = Vec::new();
        for (index, element) in self.elements.iter().enumerate() {
            let Some(settling) = element.settling() else {
                continue;
            };
            values.clear();
            self.seen(index, state, conditions, |at| {
                values.extend_from_slice(at.scalars.values);
                replace(settling, at, &mut values);
            });
            for (scalar, value) in self.numbering.scalars_of(index).iter().zip(&values) {
                state.scalars[*scalar] = *value;
            }
        }
    }

    /// Begins the elements' memory of a run in time from `state`.
    pub fn begin_memory(&self, state: &mut State, conditions: &Conditions) {
        let mut memory = std::mem::take(&mut state.memory);
        for (index, range) in self.numbering.remembering() {
            let own = &mut memory[range.clone()];
            if let Some(element) = self.elements[*index].memory() {
                self.seen(*index, state, conditions, |at| element.begin(at, own));
            }
        }
        state.memory = memory;
    }

    /// Updates the elements' memory with the accepted `state`, the last one before `time` \[s\],
    /// under the conditions at that time. Does not allocate.
    pub fn remember(
        &self,
        state: &mut State,
        (conditions, time): (&Conditions, f64),
        work: &mut Workspace,
    ) {
        let mut conditions = *conditions;
        conditions.loading.time = time;
        let mut memory = std::mem::take(&mut state.memory);
        for (index, range) in self.numbering.remembering() {
            let at = self.placed(*index, state, &conditions, &mut work.buffers.gathered);
            if let Some(element) = self.elements[*index].memory() {
                element.accept(&at, &mut memory[range.clone()]);
            }
        }
        state.memory = memory;
    }
}
