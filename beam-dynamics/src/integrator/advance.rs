//! One accepted step after the other.

use serde::{Deserialize, Serialize};

use super::{Counters, Dae, Scheme, StepFailure, StepLimits, Stepping};

/// An accepted step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepped {
    /// Time reached [s].
    pub time: f64,
    /// Length of the step [s].
    pub length: f64,
    /// Iterations of the step.
    pub iterations: usize,
    /// Longer steps that were tried before it.
    pub rejected: usize,
}

/// Integrates a system step by step.
#[derive(Debug)]
pub struct Integrator {
    progress: Progress,
}

/// All that an integrator knows of the steps behind it: with the two latest accepted
/// states of the system, what a run needs to go on as if it had not been stopped.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// Time of the latest accepted state [s].
    pub time: f64,
    /// The effort so far.
    pub counters: Counters,
}

impl Integrator {
    /// An integrator of `dae`, whose latest accepted state is that at time `from` \[s\];
    /// states before it do not count. `None` when the pattern is structurally singular.
    pub fn new(
        _dae: &dyn Dae,
        _scheme: Scheme,
        _stepping: Stepping,
        _limits: StepLimits,
        from: f64,
    ) -> Option<Self> {
        Some(Self {
            progress: Progress {
                time: from,
                counters: Counters::default(),
            },
        })
    }

    /// Makes one accepted step, towards `until` \[s\] and not beyond, tried shorter where
    /// it must. It lands on `until` and on the corners of the system to the last bit.
    /// `clock` tells the time that passes \[s\], for the times of the phases.
    ///
    /// # Errors
    ///
    /// When the least step is reached; the system then is as before the call.
    pub fn step(
        &mut self,
        _dae: &mut dyn Dae,
        _until: f64,
        _clock: &dyn Fn() -> f64,
    ) -> Result<Stepped, StepFailure> {
        unimplemented!()
    }

    /// Time of the latest accepted state \[s\].
    pub fn time(&self) -> f64 {
        self.progress.time
    }

    /// The effort so far.
    pub fn counters(&self) -> &Counters {
        &self.progress.counters
    }

    /// What a run needs to go on from here, bit for bit. What would not come back, a kept
    /// Jacobian and the order of its pivots, is dropped, so that this run goes on as one
    /// that starts from the snapshot.
    pub fn snapshot(&mut self) -> Progress {
        self.progress
    }

    /// Goes on from a snapshot, made with the same scheme and stepping; the system must
    /// have its two latest accepted states of that time.
    pub fn restore(&mut self, progress: &Progress) {
        self.progress = *progress;
    }

    /// Forgets the states before the latest, as after a change from outside; `renewed`
    /// tells whether the rates of the latest can be relied on.
    pub fn restart(&mut self, _renewed: bool) {}
}
