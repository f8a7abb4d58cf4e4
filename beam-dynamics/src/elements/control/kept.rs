//! A state for the search of periodic motion: a control that stays as it is, or the integral of a
//! quantity.
//!
//! With q the quantity, zero for a control, w its weight, one or a wave of a harmonic, and r one in the
//! equilibrium of a start and on the way to it, and zero in time,
//!
//! ```text
//! z' - (1 - r) w q + r ( z - z_0 ) / s = 0 ,     s = 1 second
//! w = 2 cos( n Omega (t - t_0) )  or  2 sin( n Omega (t - t_0) )                  (D-320)
//! ```

use super::inputs::Inputs;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// A weight whose product with a quantity has a harmonic of the quantity as its mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Frequency of the harmonic [rad/s].
    pub frequency: f64,
    /// Instant at which its angle is zero [s].
    pub from: f64,
    /// Whether it is the sine, else the cosine.
    pub is_sine: bool,
}

impl Wave {
    /// Its value at a time \[s\].
    pub fn at(&self, time: f64) -> f64 {
        let (sin, cos) = (self.frequency * (time - self.from)).sin_cos();
        2.0 * if self.is_sine { sin } else { cos }
    }
}

/// A control, or an integral.
#[derive(Debug, Clone)]
pub struct Kept {
    label: String,
    start: f64,
    inputs: Inputs,
    wave: Option<Wave>,
    /// The state, and the scalars of the quantity.
    scalars: Vec<Scalar>,
}

impl Kept {
    /// The unknown of a control (a start that is constant) or an integral called `name`, of the given
    /// scale; the label of its element is `owner`.
    pub fn state(owner: &str, name: &str, start: ScalarStart, scale: f64) -> Scalar {
        Scalar::new(ScalarSpec {
            owner: owner.to_owned(),
            unknown: Quantity::new(name, "-", scale),
            equation: Quantity::new(format!("rate of {name}"), "1/s", scale),
            has_rate: true,
            rate: None,
            start,
        })
    }

    /// The element of a control, a `state` (see [`Self::state`]) that begins at `start`.
    pub fn control(state: Scalar, start: f64) -> Self {
        Self {
            start,
            ..Self::integral(state, Vec::new(), None)
        }
    }

    /// The element of a `state` that is the integral of the sum of `signals`, times a `wave` if there
    /// is one.
    pub fn integral(state: Scalar, signals: Vec<Signal>, wave: Option<Wave>) -> Self {
        let label = state.owner.clone();
        let mut scalars = vec![state];
        Self {
            label,
            start: 0.0,
            inputs: Inputs::new(signals, &mut scalars),
            wave,
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
        let resting = at.loading.resting;
        let weight = self.wave.map_or(1.0, |wave| wave.at(at.loading.time));
        let share = (resting - 1.0) * weight;
        out.add_scalar(0, at.scalars.rates[0]);
        out.add_scalar(0, resting * (at.scalars.values[0] - self.start));
        for value in self.inputs.values(at) {
            out.add_scalar(0, share * value);
        }
        let Some(out) = jacobian else { return };
        out.add_scalar(0, 0, 1.0, true);
        out.add_scalar(0, 0, resting, false);
        self.inputs.gradient(at, |_, scalar, slope| {
            out.add_scalar(0, scalar, share * slope, false);
        });
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    // 2 cos 0 = 2 and 2 sin 0 = 0 at the first instant; a quarter of a turn later the reverse.
    #[test]
    fn waves_begin_at_the_first_instant() {
        let wave = |is_sine| Wave {
            frequency: 4.0,
            from: 0.3,
            is_sine,
        };
        let later = 0.3 + PI / 8.0;
        for (is_sine, time, expected) in [
            (false, 0.3, 2.0),
            (true, 0.3, 0.0),
            (false, later, 0.0),
            (true, later, 2.0),
        ] {
            assert!((wave(is_sine).at(time) - expected).abs() < 1e-15);
        }
    }
}
