//! A system without some of its constraints, or with others.

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

    /// The same system with what is driven by velocities held in its undeformed place, see
    /// [`Element::held`]; the order of the unknowns is the same. `None` where nothing is.
    #[must_use]
    pub fn held(&self) -> Option<Self> {
        let rest = self.rest();
        let held = self.elements.iter().enumerate().map(|(index, element)| {
            let nodes = self.motions(index, &rest);
            element.held(&nodes).map(Arc::<dyn Element>::from)
        });
        let held: Vec<_> = held.collect();
        if held.iter().all(Option::is_none) {
            return None;
        }
        let pairs = self.elements.iter().zip(held);
        let elements = pairs.map(|(own, held)| held.unwrap_or_else(|| Arc::clone(own)));
        Some(Self::of(self.nodes.clone(), elements.collect()))
    }
}
