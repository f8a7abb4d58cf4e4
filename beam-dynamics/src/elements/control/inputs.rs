//! Inputs of control laws.

use crate::elements::{Local, Signal};
use crate::model::Scalar;

/// Signals of an element.
#[derive(Debug, Clone)]
pub(super) struct Inputs(Vec<Signal>);

impl Inputs {
    /// The signals of an element with the given own scalars, to which the scalars that they read
    /// are added.
    pub fn new(mut signals: Vec<Signal>, scalars: &mut Vec<Scalar>) -> Self {
        signals.iter_mut().for_each(|signal| signal.bind(scalars));
        Self(signals)
    }

    /// The signals.
    pub fn signals(&self) -> &[Signal] {
        &self.0
    }

    /// Their values.
    pub fn values(&self, at: &Local<'_>) -> impl Iterator<Item = f64> {
        let now = at.instant();
        self.0.iter().map(move |signal| signal.value(&now))
    }

    /// Calls `add` with their derivatives: index of the input, index of the scalar, derivative.
    pub fn gradient(&self, at: &Local<'_>, mut add: impl FnMut(usize, usize, f64)) {
        for (j, signal) in self.0.iter().enumerate() {
            signal.gradient(&at.instant(), |scalar, slope| add(j, scalar, slope));
        }
    }
}
