//! Signals: numbers that depend on time and on scalars, as a drive, the value of a sensor or
//! the output of a controller.
//!
//! ```text
//! s   = f( t, q_1, q_2, ... ) ,     d s = sum_i f_,i d q_i
//! s'  = f_,t + sum_i f_,i q_i'
//! s'' = f_,tt + 2 sum_i f_,ti q_i' + sum_ij f_,ij q_i' q_j' + sum_i f_,i q_i''     (D-278)
//! ```
//!
//! The rate of a scalar is an unknown if it occurs in an equation, and its second derivative is
//! known if its rate is a scalar too ([`crate::model::ScalarSpec::rate`]), as for an actuator.

use std::sync::Arc;

use shared_geom::expression::{Expression, Jet};

use crate::model::{Drive, DriveValue, Scalar, ScalarStart, Scalars};

/// The instant at which signals are evaluated. Missing scalars are zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant<'a> {
    /// The time [s].
    pub time: f64,
    /// The scalars of the element.
    pub scalars: Scalars<'a>,
}

impl Instant<'_> {
    /// The time zero; all scalars are zero.
    pub const START: Self = Self::at(0.0);

    /// A time [s]; all scalars are zero.
    pub const fn at(time: f64) -> Self {
        Self {
            time,
            scalars: Scalars::NONE,
        }
    }
}

/// A scalar that an expression reads.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The scalar.
    pub scalar: Scalar,
    /// SI units in one unit of the expression [SI unit of the scalar].
    pub unit: f64,
}

/// An expression of time and of scalars.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensing {
    /// Its variables are time, then the inputs in their order.
    expression: Expression,
    inputs: Vec<Input>,
    /// Unit of time of the expression [s].
    second: f64,
    /// Unit of its value [unit of the signal].
    factor: f64,
}

/// Indices of an input, and of its rate if that is a scalar too, among the scalars of an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputIndices {
    value: usize,
    rate: Option<usize>,
}

/// The derivatives of a signal that must be known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Smoothness {
    /// None: the value may jump.
    Value,
    /// The rate: the value does not jump.
    Rate,
    /// The second derivative too: the rate does not jump.
    Acceleration,
}

/// A number that depends on time and on scalars.
#[derive(Debug, Clone, PartialEq)]
pub enum Signal {
    /// Only of time.
    Drive(Drive),
    /// Of time and of scalars.
    Sensing {
        /// The expression.
        of: Arc<Sensing>,
        /// Indices of the inputs in the element, see [`Signal::bind`].
        indices: Vec<InputIndices>,
    },
}

impl Default for Signal {
    /// Always one.
    fn default() -> Self {
        Self::Drive(Drive::Constant(1.0))
    }
}

impl From<Drive> for Signal {
    fn from(drive: Drive) -> Self {
        Self::Drive(drive)
    }
}

/// The index of a scalar in a list, to which it is appended if missing.
pub(super) fn index_in(scalars: &mut Vec<Scalar>, scalar: &Scalar) -> usize {
    let known = scalars.iter().position(|own| own == scalar);
    known.unwrap_or_else(|| {
        scalars.push(scalar.clone());
        scalars.len() - 1
    })
}

impl Signal {
    /// An expression whose variables are time, in units of `second` \[s\], and then the
    /// inputs; its value is in units of `factor`.
    pub fn sensing(expression: Expression, inputs: Vec<Input>, [second, factor]: [f64; 2]) -> Self {
        Self::Sensing {
            of: Arc::new(Sensing {
                expression,
                inputs,
                second,
                factor,
            }),
            indices: Vec::new(),
        }
    }

    /// The value of a scalar itself.
    pub fn scalar(scalar: Scalar) -> Self {
        let input = Input { scalar, unit: 1.0 };
        Self::sensing(Expression::variable(1), vec![input], [1.0, 1.0])
    }

    /// Whether it depends on scalars.
    pub fn senses(&self) -> bool {
        matches!(self, Self::Sensing { .. })
    }

    /// Localizes its inputs in the `scalars` of an element, to which missing ones are appended.
    /// Before that every input is zero.
    pub fn bind(&mut self, scalars: &mut Vec<Scalar>) {
        if let Self::Sensing { of, indices } = self {
            let index = |input: &Input| InputIndices {
                value: index_in(scalars, &input.scalar),
                rate: (input.scalar.rate.as_ref()).map(|rate| index_in(scalars, rate)),
            };
            *indices = of.inputs.iter().map(index).collect();
        }
    }

    /// The same, bound to `scalars`.
    #[must_use]
    pub fn bound(mut self, scalars: &mut Vec<Scalar>) -> Self {
        self.bind(scalars);
        self
    }

    /// Its value \[unit of the signal\].
    pub fn value(&self, at: &Instant<'_>) -> f64 {
        match self {
            Self::Drive(drive) => drive.at(at.time).value,
            Self::Sensing { of, indices } => {
                let variable = |index| Jet::constant(of.jet(index, indices, at).value);
                of.factor * of.expression.at(variable).value
            }
        }
    }

    /// Its value, with its first and second derivative as far as they are known
    /// ([`Self::rougher_than`]); zero if unknown.
    pub fn at(&self, at: &Instant<'_>) -> DriveValue {
        match self {
            Self::Drive(drive) => drive.at(at.time),
            Self::Sensing { of, indices } => {
                let found = of.expression.at(|index| of.jet(index, indices, at));
                DriveValue {
                    value: of.factor * found.value,
                    rate: of.factor * found.first,
                    acceleration: of.factor * found.second,
                }
            }
        }
    }

    /// Calls `add` with its derivatives: index of the scalar in the element, derivative.
    pub fn gradient(&self, at: &Instant<'_>, mut add: impl FnMut(usize, f64)) {
        let Self::Sensing { of, indices } = self else {
            return;
        };
        for (i, (input, entry)) in of.inputs.iter().zip(indices).enumerate() {
            let jet = of.expression.at(|index| {
                let value = of.jet(index, indices, at).value;
                Jet::line(value, f64::from(u8::from(index == i + 1)))
            });
            add(entry.value, of.factor * jet.first / input.unit);
        }
    }

    /// Its derivative by a scalar of the element.
    pub fn slope(&self, at: &Instant<'_>, scalar: usize) -> f64 {
        let mut slope = 0.0;
        self.gradient(at, |by, value| {
            if by == scalar {
                slope += value;
            }
        });
        slope
    }

    /// Calls `add` with the derivatives of its rate: index of the scalar in the element,
    /// derivative, whether it is by the rate of the scalar.
    pub fn gradient_of_rate(&self, at: &Instant<'_>, mut add: impl FnMut(usize, f64, bool)) {
        let Self::Sensing { of, indices } = self else {
            return;
        };
        for (i, (input, entry)) in of.inputs.iter().zip(indices).enumerate() {
            // Along time, along the input, and along both: the mixed derivative is half of the
            // second derivative along both, less the other two.
            let along = |time: f64, own: f64| {
                of.expression.at(|index| {
                    let jet = of.jet(index, indices, at);
                    let step = if index == i + 1 { own } else { 0.0 };
                    Jet::line(jet.value, time * jet.first + step)
                })
            };
            let [both, by_time, own] = [along(1.0, 1.0), along(1.0, 0.0), along(0.0, 1.0)];
            let factor = of.factor / input.unit;
            let mixed = 0.5 * (both.second - by_time.second - own.second);
            add(entry.value, factor * mixed, false);
            match entry.rate {
                Some(rate) => add(rate, factor * own.first, false),
                None => add(entry.value, factor * own.first, true),
            }
        }
    }

    /// Whether it depends on a scalar of the element.
    pub fn reads(&self, scalar: usize) -> bool {
        match self {
            Self::Drive(_) => false,
            Self::Sensing { indices, .. } => indices.iter().any(|index| index.value == scalar),
        }
    }

    /// A scalar that it reads, with fewer known derivatives than required.
    pub fn rougher_than(&self, needed: Smoothness) -> Option<&Scalar> {
        let Self::Sensing { of, .. } = self else {
            return None;
        };
        let rough = |scalar: &&Scalar| match (needed, scalar.start) {
            (Smoothness::Value, _) | (_, ScalarStart::Constant(_)) => false,
            (Smoothness::Rate, _) => !scalar.has_rate,
            (Smoothness::Acceleration, _) => scalar.rate.is_none(),
        };
        of.inputs.iter().map(|input| &input.scalar).find(rough)
    }

    /// Its drive, if it depends on no scalar.
    pub fn drive(&self) -> Option<&Drive> {
        match self {
            Self::Drive(drive) => Some(drive),
            Self::Sensing { .. } => None,
        }
    }

    /// Its value, if it is constant.
    pub fn constant(&self) -> Option<f64> {
        self.drive()?.constant()
    }

    /// The first corner or jump in time after `time` \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Drive(drive) => drive.next_corner(time),
            Self::Sensing { of, .. } => {
                let variable = |index, time: f64| match index {
                    0 => Jet::line(time / of.second, 1.0 / of.second),
                    // Scalars are not known ahead and cause no corners.
                    _ => Jet::constant(f64::NAN),
                };
                of.expression.next_corner(time, variable)
            }
        }
    }
}

/// A number of a list, zero beyond its end.
fn number(of: &[f64], index: usize) -> f64 {
    of.get(index).copied().unwrap_or(0.0)
}

impl Sensing {
    /// A variable with its derivatives by the time in seconds.
    fn jet(&self, index: usize, indices: &[InputIndices], at: &Instant<'_>) -> Jet {
        let Some(i) = index.checked_sub(1) else {
            return Jet::line(at.time / self.second, 1.0 / self.second);
        };
        let Some(&InputIndices { value, rate }) = indices.get(i) else {
            return Jet::constant(0.0);
        };
        let [first, second] = match rate {
            Some(rate) => [at.scalars.values, at.scalars.rates].map(|of| number(of, rate)),
            None => [number(at.scalars.rates, value), 0.0],
        };
        let unit = self.inputs[i].unit;
        Jet {
            value: number(at.scalars.values, value) / unit,
            first: first / unit,
            second: second / unit,
        }
    }
}
