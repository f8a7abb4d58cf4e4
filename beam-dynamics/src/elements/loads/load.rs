//! Loads as elements: forces and moments that a factor and a signal multiply.

use std::fmt::Debug;

use super::factor::LoadFactor;
use crate::elements::{Along, Element, Exchange, Local, LocalJacobian, LocalResidual, Signal};
use crate::model::{Drive, Scalar};

/// What all loads have.
#[derive(Debug, Clone)]
pub(in crate::elements) struct Head {
    pub label: String,
    /// The nodes that carry the load.
    pub nodes: Vec<usize>,
    pub factor: LoadFactor,
    pub signal: Signal,
}

/// Forces and moments that are proportional to a factor.
pub(in crate::elements) trait Load: Debug + Send + Sync {
    /// What it has as all loads have it.
    fn head(&self) -> &Head;

    /// The longest arm from a node to a point at which it acts, undeformed \[m\].
    fn arm(&self) -> f64 {
        0.0
    }

    /// Adds the load times `factor`, and times its signal.
    fn add(&self, factor: f64, at: &Local<'_>, out: &mut LocalResidual);

    /// Adds its variation likewise, that of the signal included.
    fn add_variation(&self, factor: f64, at: &Local<'_>, out: &mut LocalJacobian);
}

impl<T: Load> Element for T {
    fn label(&self) -> &str {
        &self.head().label
    }

    fn nodes(&self) -> &[usize] {
        &self.head().nodes
    }

    fn scalars(&self) -> &[Scalar] {
        self.head().signal.scalars()
    }

    fn senses(&self) -> bool {
        self.head().signal.senses()
    }

    fn reach(&self) -> f64 {
        self.arm()
    }

    fn each_drive<'a>(&'a self, visit: &mut dyn FnMut(&'a Drive)) {
        self.head().signal.drive().into_iter().for_each(visit);
    }

    fn next_corner(&self, time: f64) -> f64 {
        self.head().signal.next_corner(time)
    }

    fn exchange(&self) -> Exchange {
        Exchange::Driven
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.add(self.head().factor.value(at.loading), at, out);
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.add_variation(self.head().factor.value(at.loading), at, out);
    }

    fn by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.add(self.head().factor.derivative(), at, out);
    }

    fn prestress(&self, at: &Local<'_>, _along: &Along<'_>, out: &mut LocalJacobian) {
        self.add_variation(self.head().factor.derivative(), at, out);
    }
}
