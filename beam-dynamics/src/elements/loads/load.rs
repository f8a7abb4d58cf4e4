//! Loads as elements: forces and moments that a factor and a signal multiply.

use std::fmt::Debug;

use nalgebra::Vector3;

use super::factor::LoadFactor;
use crate::elements::{
    Element, Energetic, Energy, EnergySlope, Exchange, Growth, Local, LocalJacobian, LocalResidual,
    Motion, Signal, SmallMotion, Structure, has,
};
use crate::model::{Equation, Scalar};

/// Data common to all loads.
#[derive(Debug, Clone)]
pub(in crate::elements) struct Head {
    label: String,
    /// The nodes that carry the load.
    nodes: Vec<usize>,
    factor: LoadFactor,
    signal: Signal,
    /// Scalars of the signal.
    scalars: Vec<Scalar>,
}

impl Head {
    /// Data of a load on the nodes of the given indices.
    pub fn new(label: impl Into<String>, nodes: Vec<usize>, factor: LoadFactor) -> Self {
        Self {
            label: label.into(),
            nodes,
            factor,
            signal: Signal::default(),
            scalars: Vec::new(),
        }
    }

    /// Multiplies the load with a signal.
    pub fn drive(&mut self, signal: Signal) {
        self.scalars.clear();
        self.signal = signal.bound(&mut self.scalars);
    }
}

/// Takes a force or a moment on a node of the element.
pub(in crate::elements) type Add<'a> = dyn FnMut(usize, Equation, &Vector3<f64>) + 'a;

/// Forces and moments that are proportional to a factor.
pub(in crate::elements) trait Load: Debug + Send + Sync {
    /// The data common to all loads.
    fn head(&self) -> &Head;

    /// The longest arm from a node to a point at which it acts, undeformed \[m\].
    fn arm(&self) -> f64 {
        0.0
    }

    /// Adds the load times `size`.
    fn add(&self, size: f64, at: &Local<'_>, add: &mut Add<'_>);

    /// Adds the variation of the load times `size` by the motion of its nodes.
    fn add_variation(&self, size: f64, at: &Local<'_>, out: &mut LocalJacobian);
}

/// Adds the variation of a load times `factor` and its signal, including the variation of the
/// signal.
fn add_variations(load: &impl Load, factor: f64, at: &Local<'_>, out: &mut LocalJacobian) {
    let (signal, now) = (&load.head().signal, at.instant());
    load.add_variation(factor * signal.value(&now), at, out);
    signal.gradient(&now, |scalar, slope| {
        load.add(factor * slope, at, &mut |node, equation, value| {
            out.add_by_scalar((node, equation), (scalar, false), value);
        });
    });
}

/// Adds a load times `factor` and its signal.
fn add_whole(load: &impl Load, factor: f64, at: &Local<'_>, out: &mut LocalResidual) {
    let size = factor * load.head().signal.value(&at.instant());
    load.add(size, at, &mut |node, equation, value| {
        out.add(node, equation, value);
    });
}

impl<T: Load> Element for T {
    fn label(&self) -> &str {
        &self.head().label
    }

    fn nodes(&self) -> &[usize] {
        &self.head().nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.head().scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        visit(&self.head().signal);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        add_whole(self, self.head().factor.value(at.loading), at, out);
        let Some(out) = jacobian else { return };
        add_variations(self, self.head().factor.value(at.loading), at, out);
    }

    has!(energetic: Energetic, growth: Growth, structure: Structure);
}

impl<T: Load> Energetic for T {
    fn stored(&self, _at: &Local<'_>) -> Energy {
        Energy::default()
    }

    fn exchanged(&self) -> Exchange {
        Exchange::Driven
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Zero
    }
}

impl<T: Load> Growth for T {
    fn add_by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        add_whole(self, self.head().factor.derivative(), at, out);
    }

    fn add_prestress(&self, at: &Local<'_>, _motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        add_variations(self, self.head().factor.derivative(), at, out);
    }
}

impl<T: Load> Structure for T {
    fn arm(&self) -> f64 {
        self.arm()
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        Vec::new()
    }

    fn loaded_turn(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    fn undefined(&self, _at: &Local<'_>) -> Option<String> {
        None
    }
}
