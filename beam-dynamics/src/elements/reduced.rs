//! An element without some of its constraints.

use std::sync::Arc;

use nalgebra::Vector3;

use super::{
    Along, Charges, ConstraintRates, ConstraintWords, Element, Energy, Exchange, Level, Local,
    LocalJacobian, LocalResidual, Motion, Observations, PlaceJump, Signal,
};
use crate::model::{Loading, NodeMotion, Scalar, Scalars};

/// Number of multipliers of all but unusual elements.
const FEW: usize = 16;

/// An element in which "the multiplier is zero" stands in the place of some constraints.
#[derive(Debug)]
pub struct ReducedElement {
    element: Arc<dyn Element>,
    removed: Vec<usize>,
}

impl ReducedElement {
    /// `element` without its constraints number `removed`.
    pub fn new(element: Arc<dyn Element>, removed: Vec<usize>) -> Self {
        Self { element, removed }
    }

    /// Calls with what the element sees, the multipliers of removed constraints at zero.
    fn with<T>(&self, at: &Local<'_>, call: impl FnOnce(&Local<'_>) -> T) -> T {
        let count = at.multipliers.len();
        let mut few = [0.0; FEW];
        let mut many = Vec::new();
        let kept = match count <= FEW {
            true => &mut few[..count],
            false => {
                many.resize(count, 0.0);
                &mut many[..]
            }
        };
        kept.copy_from_slice(at.multipliers);
        self.removed.iter().for_each(|&i| kept[i] = 0.0);
        call(&Local {
            multipliers: kept,
            ..*at
        })
    }
}

impl Element for ReducedElement {
    fn label(&self) -> &str {
        self.element.label()
    }

    fn nodes(&self) -> &[usize] {
        self.element.nodes()
    }

    fn multipliers(&self) -> usize {
        self.element.multipliers()
    }

    fn scalars(&self) -> &[Scalar] {
        self.element.scalars()
    }

    fn memory(&self) -> usize {
        self.element.memory()
    }

    fn begin(&self, at: &Local<'_>, memory: &mut [f64]) {
        self.with(at, |at| self.element.begin(at, memory));
    }

    fn accept(&self, at: &Local<'_>, memory: &mut [f64]) {
        self.with(at, |at| self.element.accept(at, memory));
    }

    fn acts(&self) -> bool {
        self.element.acts()
    }

    fn joins_nodes(&self) -> bool {
        self.element.joins_nodes()
    }

    fn charges(&self, at: &Local<'_>, out: &mut Charges) {
        self.with(at, |at| self.element.charges(at, out));
    }

    fn level(&self, constraint: usize) -> Level {
        self.element.level(constraint)
    }

    fn constraint_words(&self, constraint: usize) -> ConstraintWords {
        self.element.constraint_words(constraint)
    }

    fn constraint_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        let knows = self.element.constraint_rates(at, out);
        for &constraint in &self.removed {
            out.by_time[constraint] = 0.0;
            out.convective[constraint] = 0.0;
        }
        knows
    }

    fn reach(&self) -> f64 {
        self.element.reach()
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.element.each_signal(visit);
    }

    fn next_corner(&self, time: f64) -> f64 {
        self.element.next_corner(time)
    }

    fn jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PlaceJump> {
        self.element.jump(between, scalars)
    }

    fn held(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        let held = self.element.held(undeformed)?;
        let reduced = Self::new(Arc::from(held), self.removed.clone());
        Some(Box::new(reduced))
    }

    fn winding(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        self.element.winding(at)
    }

    fn without_value(&self, at: &Local<'_>) -> Option<String> {
        self.element.without_value(at)
    }

    fn is_turned_over(&self, at: &Local<'_>) -> bool {
        self.element.is_turned_over(at)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        self.with(at, |at| self.element.energy(at))
    }

    fn exchange(&self) -> Exchange {
        self.element.exchange()
    }

    fn keeps_energy(&self) -> bool {
        self.element.keeps_energy()
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.with(at, |at| self.element.residual(at, out));
        for &constraint in &self.removed {
            out.remove_constraint(constraint, at.multipliers[constraint]);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.with(at, |at| self.element.jacobian(at, out));
        for &constraint in &self.removed {
            out.remove_constraint(constraint);
        }
    }

    fn motions(&self) -> Vec<Motion> {
        self.element.motions()
    }

    fn by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.with(at, |at| self.element.by_factor(at, out));
        for &constraint in &self.removed {
            out.remove_constraint(constraint, 0.0);
        }
    }

    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        self.with(at, |at| self.element.prestress(at, along, out));
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        self.with(at, |at| self.element.observe(at, out));
    }
}
