//! Numbers that change with time.
//!
//! A [`Drive`] is a given function of time that knows its first and second derivative
//! and the times at which it is not smooth.

use std::sync::Arc;

mod formula;

pub use formula::Formula;

/// A number that changes with time, with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DriveValue {
    /// The number [its unit].
    pub value: f64,
    /// Its first derivative [its unit/s].
    pub rate: f64,
    /// Its second derivative [its unit/s^2].
    pub acceleration: f64,
}

impl DriveValue {
    /// A number that does not change.
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    /// The number times a constant.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            value: factor * self.value,
            rate: factor * self.rate,
            acceleration: factor * self.acceleration,
        }
    }
}

/// A given function of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Always the same.
    Constant(f64),
    /// An expression of time.
    Formula(Arc<Formula>),
    /// A drive times a constant.
    Scaled(f64, Arc<Drive>),
}

impl Default for Drive {
    fn default() -> Self {
        Self::Constant(0.0)
    }
}

impl Drive {
    /// The value at `time` \[s\]; at a corner that after it.
    pub fn at(&self, time: f64) -> DriveValue {
        match self {
            Self::Constant(value) => DriveValue::constant(*value),
            Self::Formula(formula) => formula.at(time),
            Self::Scaled(factor, drive) => drive.at(time).scaled(*factor),
        }
    }

    /// The first time after `time` at which the drive or its first derivative jumps \[s\];
    /// infinite when there is none.
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Constant(_) => f64::INFINITY,
            Self::Formula(formula) => formula.next_corner(time),
            Self::Scaled(_, drive) => drive.next_corner(time),
        }
    }

    /// The first and the last time at which it has a value \[s\].
    pub fn domain(&self) -> [f64; 2] {
        match self {
            Self::Constant(_) | Self::Formula(_) => ALWAYS,
            Self::Scaled(_, drive) => drive.domain(),
        }
    }

    /// The number that it always has, if it does not change.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Scaled(factor, drive) => drive.constant().map(|value| factor * value),
            Self::Formula(_) => None,
        }
    }

    /// The drive times a constant.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            drive if factor == 1.0 => drive,
            Self::Constant(value) => Self::Constant(factor * value),
            Self::Scaled(own, drive) => Self::Scaled(factor * own, drive),
            drive => Self::Scaled(factor, Arc::new(drive)),
        }
    }
}

/// All times.
const ALWAYS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
