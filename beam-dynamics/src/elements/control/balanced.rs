//! A control in an equilibrium: its equation is the one of a target.
//!
//! With the control u, the quantity q of the target, its value v, the sizes s of both, and the part w
//! of the target, one under the conditions of the trim, and zero without constant loads and in the
//! equilibrium of the first guess u_0,
//!
//! ```text
//! (1 - w) ( u - u_0 ) / s_u + w ( q - v ) / s_q = 0                               (D-321)
//! ```

use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// A control with its target.
#[derive(Debug, Clone)]
pub struct Balanced {
    label: String,
    guess: f64,
    value: f64,
    sizes: [f64; 2],
    /// The control and the quantity of the target.
    scalars: [Scalar; 2],
}

impl Balanced {
    /// The unknown of a control called `name`, of the given first guess and size; the label of its
    /// element is `owner`.
    pub fn control(owner: &str, name: &str, guess: f64, scale: f64) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: owner.to_owned(),
            unknown: Quantity::new(name, "-", scale),
            equation: Quantity::new(format!("target of {name}"), "-", 1.0),
            has_rate: false,
            rate: None,
            start: ScalarStart::Constant(guess),
        })
    }

    /// The element of a `control` (see [`Self::control`]) with its first guess, and of the `quantity`
    /// with its required value and its size.
    pub fn new((control, guess): (Scalar, f64), quantity: Scalar, [value, size]: [f64; 2]) -> Self {
        Self {
            label: control.owner.clone(),
            guess,
            value,
            sizes: [control.unknown.scale, size],
            scalars: [control, quantity],
        }
    }
}

impl Element for Balanced {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let part = at.loading.constant * (1.0 - at.loading.released);
        let slopes = [(1.0 - part) / self.sizes[0], part / self.sizes[1]];
        for (i, expected) in [self.guess, self.value].into_iter().enumerate() {
            out.add_scalar(0, slopes[i] * (at.scalars.values[i] - expected));
        }
        let Some(out) = jacobian else { return };
        for (i, slope) in slopes.into_iter().enumerate() {
            out.add_scalar(0, i, slope, false);
        }
    }
}
