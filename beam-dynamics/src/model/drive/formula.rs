//! Drives that are expressions of time.

use shared_geom::expression::{Expression, Jet};

use super::DriveValue;

/// An expression of time, which is its only variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    expression: Expression,
    /// Unit of time of the expression [s].
    second: f64,
}

impl Formula {
    /// The expression, in which time is in units of `unit` \[s\].
    pub fn new(expression: Expression, unit: f64) -> Self {
        let second = unit;
        Self { expression, second }
    }

    /// The value at `time` \[s\].
    pub fn at(&self, time: f64) -> DriveValue {
        let jet = self.expression.at(|_| Jet::variable(time / self.second));
        DriveValue {
            value: jet.value,
            rate: jet.first / self.second,
            acceleration: jet.second / (self.second * self.second),
        }
    }

    /// The first corner or jump after `time` \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        let counted = |_, time| Jet::line(time / self.second, 1.0 / self.second);
        self.expression.next_corner(time, counted)
    }
}
