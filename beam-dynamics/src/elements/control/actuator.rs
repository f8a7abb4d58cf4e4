//! A servo of second order: a signal with known rate and second derivative, as required by joints
//! that follow a signal.
//!
//! With the position a, its rate v, the command u, the natural frequency `omega` and the damping
//! ratio `zeta`,
//!
//! ```text
//! a' - v = 0
//! v' - s( v, g ) g = 0 ,    g = omega^2 ( sat(u) - a ) - 2 zeta omega v           (D-279)
//! ```
//!
//! `sat(u)` is the command within its limits,
//!
//! ```text
//! sat(u) = min( max( u, u_1 ), u_2 )
//! ```
//!
//! and the magnitude of the rate to L: s is one, except near L for an acceleration g away from zero
//! rate,
//!
//! ```text
//! s = r ( 2 - r ) ,    r = ( L - |v| ) / ( 0.05 L )    for g v > 0 and r < 1
//! ```
//!
//! so that the rate does not wind up beyond its limit.

use super::inputs::Inputs;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart};

/// Part of the largest rate over which the acceleration falls to zero.
const BAND: f64 = 0.05;
/// Response of an actuator to its command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    /// Natural frequency, above zero [rad/s].
    pub frequency: f64,
    /// Damping ratio [-].
    pub damping: f64,
    /// The least and the largest command [unit of the position].
    pub limits: Option<[f64; 2]>,
    /// The largest rate, above zero [unit of the position/s].
    pub rate_limit: Option<f64>,
}

/// A number with its derivative.
type Slope = [f64; 2];

impl Servo {
    /// `sat(u)`.
    fn command(&self, u: f64) -> Slope {
        let Some([least, most]) = self.limits else {
            return [u, 1.0];
        };
        match u {
            u if u < least => [least, 0.0],
            u if u > most => [most, 0.0],
            _ => [u, 1.0],
        }
    }

    /// `s(v, g)`, and its derivative by v.
    fn gate(&self, v: f64, g: f64) -> Slope {
        let Some(limit) = self.rate_limit else {
            return [1.0, 0.0];
        };
        let outward = if g < 0.0 { -1.0 } else { 1.0 };
        let r = (limit - outward * v) / (BAND * limit);
        if r < 1.0 {
            [r * (2.0 - r), -outward * 2.0 * (1.0 - r) / (BAND * limit)]
        } else {
            [1.0, 0.0]
        }
    }

    /// `s g` with its derivatives by a, v and u.
    fn acceleration(&self, [a, v, u]: [f64; 3]) -> [f64; 4] {
        let square = self.frequency * self.frequency;
        let resisting = 2.0 * self.damping * self.frequency;
        let [command, slope] = self.command(u);
        let g = square * (command - a) - resisting * v;
        let [s, by_rate] = self.gate(v, g);
        [
            s * g,
            -s * square,
            by_rate * g - s * resisting,
            s * square * slope,
        ]
    }
}

/// An actuator between a signal and a scalar.
#[derive(Debug, Clone)]
pub struct Actuator {
    label: String,
    servo: Servo,
    command: Inputs,
    /// The position, its rate, and the scalars that the command reads.
    scalars: Vec<Scalar>,
}

impl Actuator {
    /// The unknown of the position of an actuator called `label`, which starts at rest at `start`.
    pub fn position(label: &str, start: ScalarStart) -> Scalar {
        let scalar = |[name, unit, equation, of]: [&str; 4], rate: Option<Scalar>, start| {
            Scalar::new(ScalarSpec {
                owner: label.to_owned(),
                unknown: Quantity::new(name, unit, 1.0),
                equation: Quantity::new(equation, of, 1.0),
                has_rate: true,
                rate,
                start,
            })
        };
        let of_rate = match start {
            ScalarStart::Value(_) | ScalarStart::Constant(_) => ScalarStart::Value(0.0),
            ScalarStart::Settled => ScalarStart::Settled,
        };
        let rate = scalar(["rate", "1/s", "acceleration", "1/s^2"], None, of_rate);
        scalar(["position", "-", "rate", "1/s"], Some(rate), start)
    }

    /// The actuator of a `position` (see [`Self::position`]) that follows a `command`.
    pub fn new(label: impl Into<String>, servo: Servo, command: Signal, position: Scalar) -> Self {
        let mut scalars = vec![position];
        let rate = scalars[0].rate.clone();
        scalars.extend(rate);
        Self {
            label: label.into(),
            servo,
            command: Inputs::new(vec![command], &mut scalars),
            scalars,
        }
    }

    fn acceleration(&self, at: &Local<'_>) -> [f64; 4] {
        let command = self.command.values(at).sum();
        let values = at.scalars.values;
        self.servo.acceleration([values[0], values[1], command])
    }
}

impl Element for Actuator {
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
        self.command.signals().iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        out.add_scalar(0, at.scalars.rates[0]);
        out.add_scalar(0, -at.scalars.values[1]);
        out.add_scalar(1, at.scalars.rates[1]);
        out.add_scalar(1, -self.acceleration(at)[0]);
        let Some(out) = jacobian else { return };
        let [_, by_position, by_rate, by_command] = self.acceleration(at);
        out.add_scalar(0, 0, 1.0, true);
        out.add_scalar(0, 1, -1.0, false);
        out.add_scalar(1, 1, 1.0, true);
        out.add_scalar(1, 0, -by_position, false);
        out.add_scalar(1, 1, -by_rate, false);
        self.command.gradient(at, |_, scalar, slope| {
            out.add_scalar(1, scalar, -by_command * slope, false);
        });
    }
}
