//! A system without some of its constraints.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::System;
use crate::elements::{Element, ReducedElement};

impl System {
    /// The same system, but for constraints, given by the numbers of their multipliers:
    /// "the multiplier is zero" stands in the place of each. The order of the unknowns is
    /// the same.
    #[must_use]
    pub fn without(&self, constraints: &[usize]) -> Self {
        let mut removed: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (index, _) in self.elements.iter().enumerate() {
            let own = self.numbering.multipliers_of(index);
            let of_it = constraints.iter().filter(|i| own.contains(i));
            let of_it: Vec<_> = of_it.map(|i| i - own.start).collect();
            if !of_it.is_empty() {
                removed.insert(index, of_it);
            }
        }
        let elements = self.elements.iter().enumerate().map(|(index, element)| {
            let element = Arc::clone(element);
            match removed.remove(&index) {
                None => element,
                Some(removed) => {
                    Arc::new(ReducedElement::new(element, removed)) as Arc<dyn Element>
                }
            }
        });
        let elements = elements.collect();
        Self::of(self.nodes.clone(), elements)
    }
}
