//! Inputs of control laws.

use crate::elements::{Local, Signal};
use crate::model::{Drive, Scalar};

/// Signals of an element whose scalars come behind its own.
#[derive(Debug, Clone)]
pub(super) struct Inputs {
    signals: Vec<Signal>,
    /// Number of the first scalar of each signal in the element.
    firsts: Vec<usize>,
}

impl Inputs {
    /// Those of an element with the given own scalars, to which their own are added.
    pub fn new(signals: Vec<Signal>, scalars: &mut Vec<Scalar>) -> Self {
        let first = |signal: &Signal| {
            let first = scalars.len();
            scalars.extend_from_slice(signal.scalars());
            first
        };
        Self {
            firsts: signals.iter().map(first).collect(),
            signals,
        }
    }

    /// The signals, each with the number of its first scalar.
    fn each(&self) -> impl Iterator<Item = (usize, &Signal)> {
        self.firsts.iter().copied().zip(&self.signals)
    }

    /// Their values.
    pub fn values(&self, at: &Local<'_>) -> impl Iterator<Item = f64> {
        self.each().map(|(first, signal)| signal.value(at, first))
    }

    /// Calls `add` with their derivatives: number of the input, number of the scalar,
    /// derivative.
    pub fn gradient(&self, at: &Local<'_>, mut add: impl FnMut(usize, usize, f64)) {
        for (j, (first, signal)) in self.each().enumerate() {
            signal.gradient(at, first, |scalar, slope| add(j, scalar, slope));
        }
    }

    /// Whether one of them depends on scalars.
    pub fn sense(&self) -> bool {
        self.signals.iter().any(Signal::senses)
    }

    /// Those that are drives.
    pub fn drives(&self) -> impl Iterator<Item = &Drive> {
        self.signals.iter().filter_map(Signal::drive)
    }

    /// The first corner or jump after `time` that time alone makes \[s\].
    pub fn next_corner(&self, time: f64) -> f64 {
        let corners = self.signals.iter().map(|signal| signal.next_corner(time));
        corners.fold(f64::INFINITY, f64::min)
    }
}
