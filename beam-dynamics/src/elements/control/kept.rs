//! A state for the search of periodic motion: a control that stays as it is, or the integral of a
//! quantity.
//!
//! With q the quantity, zero for a control, and r one in the equilibrium of a start and zero in time,
//!
//! ```text
//! z' - (1 - r) q + r ( z - z_0 ) / s = 0 ,     s = 1 second                       (D-209)
//! ```

use super::inputs::Inputs;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// A control, or an integral.
#[derive(Debug, Clone)]
pub struct Kept {
    label: String,
    start: f64,
    inputs: Inputs,
    /// The state, and the scalars of the quantity.
    scalars: Vec<Scalar>,
}

impl Kept {
    /// The unknown of a control or an integral called `name`, of the given start and scale; the
    /// label of its element is `owner`.
    pub fn state(owner: &str, name: &str, start: f64, scale: f64) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: owner.to_owned(),
            unknown: Quantity::new(name, "-", scale),
            equation: Quantity::new(format!("rate of {name}"), "1/s", scale),
            has_rate: true,
            rate: None,
            start: ScalarStart::Value(start),
        })
    }

    /// The element of a `state` (see [`Self::state`]): the integral of the sum of `signals`, which is
    /// constant without signals.
    pub fn new(state: Scalar, start: f64, signals: Vec<Signal>) -> Self {
        let label = state.owner.clone();
        let mut scalars = vec![state];
        Self {
            label,
            start,
            inputs: Inputs::new(signals, &mut scalars),
            scalars,
        }
    }
}

impl Element for Kept {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.inputs.signals().iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let resting = at.loading.released;
        out.add_scalar(0, at.scalars.rates[0]);
        out.add_scalar(0, resting * (at.scalars.values[0] - self.start));
        for value in self.inputs.values(at) {
            out.add_scalar(0, (resting - 1.0) * value);
        }
        let Some(out) = jacobian else { return };
        out.add_scalar(0, 0, 1.0, true);
        out.add_scalar(0, 0, resting, false);
        self.inputs.gradient(at, |_, scalar, slope| {
            out.add_scalar(0, scalar, (resting - 1.0) * slope, false);
        });
    }
}
