//! Numbers that change with time.
//!
//! A [`Drive`] is a given function of time with its first and second derivative and the
//! times at which it is not smooth. At a corner or a jump it has the value and the
//! derivatives just after it.

use std::sync::Arc;

mod formula;
mod noise;
mod pace;
mod shape;
mod table;

#[cfg(test)]
mod tests;

pub use formula::Formula;
pub use noise::{BandNoise, SteppedNoise};
pub use pace::Pace;
pub use shape::{Doublet, Harmonic, Ramp, Step};
pub use table::{DriveTable, Extrapolation, Interpolation, TableProblem};

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
    /// A constant number.
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    /// The number times a constant.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            value: factor * self.value,
            rate: factor * self.rate,
            acceleration: factor * self.acceleration,
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
            acceleration: self.acceleration + other.acceleration,
        }
    }

    /// `(a b)' = a' b + a b'`, `(a b)'' = a'' b + 2 a' b' + a b''`.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            acceleration: self.acceleration * other.value
                + 2.0 * self.rate * other.rate
                + self.value * other.acceleration,
        }
    }
}

/// A given function of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Always the same.
    Constant(f64),
    /// From one value to another within a time interval.
    Ramp(Ramp),
    /// A jump.
    Step(Step),
    /// A sine.
    Harmonic(Harmonic),
    /// Up, then down by the same amount.
    Doublet(Doublet),
    /// Interpolated between given times.
    Table(Arc<DriveTable>),
    /// An expression of time.
    Formula(Arc<Formula>),
    /// A smooth random number of a band of frequencies.
    Band(Arc<BandNoise>),
    /// A random number with straight pieces.
    Noise(SteppedNoise),
    /// The sum of drives.
    Sum(Arc<[Drive]>),
    /// The product of drives.
    Product(Arc<[Drive]>),
    /// A drive times a constant.
    Scaled(f64, Arc<Drive>),
}

impl Default for Drive {
    fn default() -> Self {
        Self::Constant(0.0)
    }
}

impl Drive {
    /// All times \[s\].
    pub const ALWAYS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    /// The first and the last time at which all `drives` have a value \[s\].
    pub fn common_domain<'a>(drives: impl Iterator<Item = &'a Self>) -> [f64; 2] {
        let domains = drives.map(Self::domain);
        domains.fold(Self::ALWAYS, |all, own| {
            [all[0].max(own[0]), all[1].min(own[1])]
        })
    }

    /// The value at `time` \[s\]; at a corner the value after it. Outside of the domain it
    /// is NaN.
    pub fn at(&self, time: f64) -> DriveValue {
        match self {
            Self::Constant(value) => DriveValue::constant(*value),
            Self::Ramp(ramp) => ramp.at(time),
            Self::Step(step) => step.at(time),
            Self::Harmonic(harmonic) => harmonic.at(time),
            Self::Doublet(doublet) => doublet.at(time),
            Self::Table(table) => table.at(time),
            Self::Formula(formula) => formula.at(time),
            Self::Band(noise) => noise.at(time),
            Self::Noise(noise) => noise.at(time),
            Self::Sum(terms) => {
                let values = terms.iter().map(|term| term.at(time));
                values.fold(DriveValue::default(), DriveValue::plus)
            }
            Self::Product(factors) => {
                let values = factors.iter().map(|factor| factor.at(time));
                values.fold(DriveValue::constant(1.0), DriveValue::times)
            }
            Self::Scaled(factor, drive) => drive.at(time).scaled(*factor),
        }
    }

    /// The first time after `time` at which the drive or its first derivative jumps \[s\];
    /// infinite without one.
    pub fn next_corner(&self, time: f64) -> f64 {
        match self {
            Self::Constant(_) | Self::Band(_) => f64::INFINITY,
            Self::Ramp(ramp) => ramp.next_corner(time),
            Self::Step(step) => next_of(&[step.time], time),
            Self::Harmonic(harmonic) => harmonic.next_corner(time),
            Self::Doublet(doublet) => doublet.next_corner(time),
            Self::Table(table) => table.next_corner(time),
            Self::Formula(formula) => formula.next_corner(time),
            Self::Noise(noise) => noise.next_corner(time),
            Self::Sum(parts) | Self::Product(parts) => {
                let corners = parts.iter().map(|part| part.next_corner(time));
                corners.fold(f64::INFINITY, f64::min)
            }
            Self::Scaled(_, drive) => drive.next_corner(time),
        }
    }

    /// The first and the last time at which it has a value \[s\].
    pub fn domain(&self) -> [f64; 2] {
        match self {
            Self::Table(table) => table.domain(),
            Self::Sum(parts) | Self::Product(parts) => Self::common_domain(parts.iter()),
            Self::Scaled(_, drive) => drive.domain(),
            _ => Self::ALWAYS,
        }
    }

    /// The constant value, if the drive is constant.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Scaled(factor, drive) => drive.constant().map(|value| factor * value),
            _ => None,
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

/// The first of ascending `times` after `time`; infinite without one.
fn next_of(times: &[f64], time: f64) -> f64 {
    let next = times.iter().find(|corner| **corner > time);
    next.copied().unwrap_or(f64::INFINITY)
}
