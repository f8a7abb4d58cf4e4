//! Signals: numbers that depend on time and on scalars, as what sensors find and what
//! controllers put out.
//!
//! ```text
//! s = f( t, q_1, q_2, ... ) ,     d s = sum_i f_,i d q_i
//! ```

use std::sync::Arc;

use shared_geom::expression::{Expression, Jet};

use super::Local;
use crate::model::{Drive, Scalar};

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
    /// The scalars of the inputs.
    scalars: Vec<Scalar>,
    /// Unit of time of the expression [s].
    second: f64,
    /// Unit of its value [unit of the signal].
    factor: f64,
}

/// A number that depends on time and on scalars.
#[derive(Debug, Clone, PartialEq)]
pub enum Signal {
    /// Of time alone.
    Drive(Drive),
    /// Of time and of scalars.
    Sensing(Arc<Sensing>),
}

impl Default for Signal {
    /// Always one.
    fn default() -> Self {
        Self::Drive(Drive::Constant(1.0))
    }
}

impl Signal {
    /// An expression whose variables are time, in units of `second` \[s\], and then the
    /// inputs; its value is in units of `factor`.
    pub fn sensing(expression: Expression, inputs: Vec<Input>, [second, factor]: [f64; 2]) -> Self {
        Self::Sensing(Arc::new(Sensing {
            expression,
            scalars: inputs.iter().map(|input| input.scalar.clone()).collect(),
            inputs,
            second,
            factor,
        }))
    }

    /// Whether it depends on scalars.
    pub fn senses(&self) -> bool {
        matches!(self, Self::Sensing(_))
    }

    /// The scalars on which it depends.
    pub fn scalars(&self) -> &[Scalar] {
        match self {
            Self::Drive(_) => &[],
            Self::Sensing(sensing) => &sensing.scalars,
        }
    }

    /// Its value for an element whose scalars are its own from number `first` on \[unit of the
    /// signal\].
    pub fn value(&self, at: &Local<'_>, first: usize) -> f64 {
        match self {
            Self::Drive(drive) => drive.at(at.loading.time).value,
            Self::Sensing(sensing) => {
                let variable = |index| Jet::constant(sensing.variable(index, at, first));
                sensing.factor * sensing.expression.at(variable).value
            }
        }
    }

    /// Calls `add` with its derivatives: number of the scalar in the element, derivative.
    pub fn gradient(&self, at: &Local<'_>, first: usize, mut add: impl FnMut(usize, f64)) {
        let Self::Sensing(sensing) = self else {
            return;
        };
        for (i, input) in sensing.inputs.iter().enumerate() {
            let jet = sensing.expression.at(|index| {
                let value = sensing.variable(index, at, first);
                match index == i + 1 {
                    true => Jet::variable(value),
                    false => Jet::constant(value),
                }
            });
            add(first + i, sensing.factor * jet.first / input.unit);
        }
    }

    /// The drive that it is, where it depends on no scalar.
    pub fn drive(&self) -> Option<&Drive> {
        match self {
            Self::Drive(drive) => Some(drive),
            Self::Sensing(_) => None,
        }
    }

    /// The first corner or jump after `time` that time alone makes \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Drive(drive) => drive.next_corner(time),
            Self::Sensing(sensing) => {
                let variable = |index, time: f64| match index {
                    0 => Jet::line(time / sensing.second, 1.0 / sensing.second),
                    // Scalars are not known ahead, and nothing follows from them.
                    _ => Jet::constant(f64::NAN),
                };
                sensing.expression.next_corner(time, variable)
            }
        }
    }
}

impl Sensing {
    fn variable(&self, index: usize, at: &Local<'_>, first: usize) -> f64 {
        match index.checked_sub(1) {
            None => at.loading.time / self.second,
            Some(i) => at.scalars.values[first + i] / self.inputs[i].unit,
        }
    }
}
