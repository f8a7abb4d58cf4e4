//! Rates of the constraints of a system at fixed positions and velocities.

use super::System;
use crate::elements::{ConstraintRates, Element, Local, Queries};
use crate::model::{Conditions, NodeMotion, Scalars, State};

impl System {
    /// `d Phi / d t` at fixed positions, and the last derivative without accelerations, of all
    /// constraints in the order of the multipliers (see [`ConstraintRates`]); `None` if an element
    /// does not know them.
    pub fn constraint_rates(
        &self,
        state: &State,
        conditions: &Conditions,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let count = self.numbering.multipliers();
        let (mut by_time, mut convective) = (vec![0.0; count], vec![0.0; count]);
        for (index, element) in self.elements.iter().enumerate() {
            let range = self.numbering.multipliers_of(index);
            let mut out = ConstraintRates {
                by_time: &mut by_time[range.clone()],
                convective: &mut convective[range],
            };
            let call = |at: &Local<'_>| element.constraint_rates(at, &mut out);
            if !self.seen(index, state, conditions, call) {
                return None;
            }
        }
        Some((by_time, convective))
    }

    /// The first element with a rotation 180 deg away from its prescribed rotation.
    pub fn turned_over(&self, state: &State, conditions: &Conditions) -> Option<&dyn Element> {
        let held = self.elements.iter().enumerate();
        let mut held = held.filter(|(_, element)| element.multipliers() > 0);
        let over = held.find(|(index, element)| {
            let call = |at: &Local<'_>| element.is_turned_over(at);
            self.seen_by_few(*index, state, conditions, call) == Some(true)
        });
        over.map(|(_, element)| element.as_ref())
    }

    /// The first element with a rotation that has passed half a turn between two states, each with
    /// its own conditions.
    pub fn wound(
        &self,
        before: (&State, &Conditions),
        now: (&State, &Conditions),
    ) -> Option<&dyn Element> {
        let mut elements = self.elements.iter().enumerate();
        let wound = elements.find(|(index, element)| {
            let rotation = |(state, conditions): (&State, &Conditions)| {
                let found = self.seen_by_few(*index, state, conditions, |at| element.winding(at));
                found.flatten()
            };
            // Most elements have none.
            rotation(now).is_some_and(|now| {
                let before = rotation(before);
                before.is_some_and(|before| (now - before).norm() > std::f64::consts::PI)
            })
        });
        wound.map(|(_, element)| element.as_ref())
    }

    /// Calls with the data visible to an element of one node or two, without scalars; `None` for
    /// others. Does not allocate.
    fn seen_by_few<T>(
        &self,
        index: usize,
        state: &State,
        conditions: &Conditions,
        call: impl FnOnce(&Local<'_>) -> T,
    ) -> Option<T> {
        let at = |nodes: &[NodeMotion]| {
            call(&Local {
                nodes,
                multipliers: &state.multipliers[self.numbering.multipliers_of(index)],
                scalars: Scalars::NONE,
                memory: &[],
                frame: &conditions.frame,
                loading: &conditions.loading,
            })
        };
        let consecutive = self.layouts[index].consecutive;
        match (self.elements[index].nodes(), consecutive) {
            _ if !self.numbering.scalars_of(index).is_empty() => None,
            (nodes, Some(first)) if nodes.len() <= 2 => {
                Some(at(&state.nodes[first..first + nodes.len()]))
            }
            (&[a, b], None) => Some(at(&[a, b].map(|node| state.nodes[node]))),
            _ => None,
        }
    }
}
