//! A system without some of its constraints, with others, or with constraints that share their
//! loads.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{System, loops};
use crate::assembly::redundancy::Redundant;
use crate::elements::{Adapted, Element, Queries};
use crate::model::NODE_UNKNOWNS;

impl System {
    /// The same system without the constraints given by the indices of their multipliers: each is
    /// replaced by "the multiplier is zero". The order of the unknowns is the same.
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
                Some(removed) => Arc::new(Adapted::reduced(element, removed)) as Arc<dyn Element>,
            }
        });
        let elements = elements.collect();
        Self::of(self.nodes.clone(), elements)
    }

    /// The same system with velocity-driven parts held in their undeformed position, see
    /// [`Element::held`]; the order of the unknowns is the same. `None` if there are none.
    #[must_use]
    pub fn held(&self) -> Option<Self> {
        let rest = self.rest();
        let held = self.elements.iter().map(|element| {
            let nodes = element.nodes().iter().map(|&node| rest.nodes[node]);
            let nodes: Vec<_> = nodes.collect();
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

    /// The same system, with constraints of which `redundant` follow from others: the constraints
    /// of a loop share their loads (see [`super::Sharing`]), with a compliance \[m/N\] of the order
    /// of a mass's motion per unit force in a step.
    #[must_use]
    pub fn with_shared_loads(&self, redundant: &[Redundant], compliance: f64) -> Self {
        let groups: Vec<_> = redundant.iter().map(Redundant::group).collect();
        let mut system = Self {
            loops: loops::find(self, &groups),
            compliance,
            layouts: Vec::new(),
            kinds: Vec::new(),
            ..self.clone()
        };
        system.find_pattern();
        system
    }

    /// The same system without the constraints that follow from others, if there are any.
    pub fn independent(&self) -> Option<Self> {
        let redundant = self
            .loops
            .iter()
            .flat_map(|of| of.redundant.iter().copied());
        let redundant: Vec<_> = redundant.collect();
        (!redundant.is_empty()).then(|| self.without(&redundant))
    }

    /// Number of the constraints of each loop that follow from others, and the name of its
    /// first joint.
    pub fn redundant_of_loops(&self) -> impl Iterator<Item = (usize, &str)> {
        self.loops.iter().filter_map(|of| {
            let first = of.elements.first()?;
            Some((of.redundant.len(), self.elements[*first].label()))
        })
    }

    /// Number of loads that balance each other in all loops: the number of rows and columns of the
    /// pattern after the unknowns (see [`super::Sharing`]).
    pub fn surpluses(&self) -> usize {
        self.loops.iter().map(|of| of.redundant.len()).sum()
    }

    /// Entries of the matrix through which constraints share their loads.
    pub(super) fn shared_entries(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let of_constraints = NODE_UNKNOWNS * self.nodes.len();
        let mut next = self.numbering.unknowns();
        self.loops.iter().flat_map(move |of| {
            let surpluses = next..next + of.redundant.len();
            next = surpluses.end;
            let own = of.elements.iter();
            let own = own.flat_map(|&element| self.numbering.multipliers_of(element));
            let own = own.map(move |i| of_constraints + i);
            own.flat_map(move |i| surpluses.clone().flat_map(move |k| [(i, k), (k, i)]))
        })
    }
}
