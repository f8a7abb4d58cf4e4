//! Drives of few numbers: ramp, step, harmonic, doublet.

use std::f64::consts::TAU;

use super::{DriveValue, next_of};

/// From one value to another, constant before and after.
///
/// With `s = (t - t_0)/T` from 0 to 1, straight `a + (b - a) s`, or smooth (D-190)
///
/// ```text
/// a + (b - a) (10 s^3 - 15 s^4 + 6 s^5)
/// ```
///
/// whose first and second derivatives vanish at both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Value before [unit of the drive].
    pub from: f64,
    /// Value after [unit of the drive].
    pub to: f64,
    /// Time at which it begins [s].
    pub start: f64,
    /// Time at which it ends, after the start [s].
    pub end: f64,
    /// Whether it begins and ends without a corner.
    pub smooth: bool,
}

impl Ramp {
    pub(super) fn at(&self, time: f64) -> DriveValue {
        if time >= self.end {
            return DriveValue::constant(self.to);
        }
        if time < self.start {
            return DriveValue::constant(self.from);
        }
        let (length, rise) = (self.end - self.start, self.to - self.from);
        let s = (time - self.start) / length;
        let (f, f1, f2) = if self.smooth {
            (
                s * s * s * (10.0 - s * (15.0 - 6.0 * s)),
                30.0 * s * s * (1.0 - s) * (1.0 - s),
                60.0 * s * (1.0 - s) * (1.0 - 2.0 * s),
            )
        } else {
            (s, 1.0, 0.0)
        };
        DriveValue {
            value: self.from + rise * f,
            rate: rise * f1 / length,
            acceleration: rise * f2 / (length * length),
        }
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        if self.smooth {
            f64::INFINITY
        } else {
            next_of(&[self.start, self.end], time)
        }
    }
}

/// A jump from one value to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Value before [unit of the drive].
    pub from: f64,
    /// Value from the time on [unit of the drive].
    pub to: f64,
    /// Time of the jump [s].
    pub time: f64,
}

impl Step {
    pub(super) fn at(&self, time: f64) -> DriveValue {
        DriveValue::constant(if time >= self.time {
            self.to
        } else {
            self.from
        })
    }
}

/// A sine that begins and may end; before and after it has the values of its ends:
/// `mean + amplitude sin(2 pi f (t - t_0) + phase)` (D-191).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Mean [unit of the drive].
    pub mean: f64,
    /// Amplitude [unit of the drive].
    pub amplitude: f64,
    /// Frequency, above zero [Hz].
    pub frequency: f64,
    /// Phase at the start [rad].
    pub phase: f64,
    /// Time at which it begins [s].
    pub start: f64,
    /// Number of cycles; may be infinite [-].
    pub cycles: f64,
}

impl Harmonic {
    fn end(&self) -> f64 {
        self.start + self.cycles / self.frequency
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let held = |cycles: f64| {
            let angle = TAU * cycles + self.phase;
            DriveValue::constant(self.mean + self.amplitude * angle.sin())
        };
        if time < self.start {
            return held(0.0);
        }
        if time >= self.end() {
            return held(self.cycles);
        }
        let omega = TAU * self.frequency;
        let (sin, cos) = (omega * (time - self.start) + self.phase).sin_cos();
        DriveValue {
            value: self.mean + self.amplitude * sin,
            rate: self.amplitude * omega * cos,
            acceleration: -self.amplitude * omega * omega * sin,
        }
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        next_of(&[self.start, self.end()], time)
    }
}

/// Up for half the duration, down for the other half, zero before and after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Doublet {
    /// Height to either side [unit of the drive].
    pub amplitude: f64,
    /// Time at which it begins [s].
    pub start: f64,
    /// Duration of both halves [s].
    pub duration: f64,
}

impl Doublet {
    fn corners(&self) -> [f64; 3] {
        [0.0, 0.5, 1.0].map(|part| self.start + part * self.duration)
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let [start, middle, end] = self.corners();
        DriveValue::constant(match time {
            t if t < start || t >= end => 0.0,
            t if t < middle => self.amplitude,
            _ => -self.amplitude,
        })
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        next_of(&self.corners(), time)
    }
}
