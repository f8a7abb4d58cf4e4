//! Counters and times of the phases of a step.

use super::Counters;

/// Counts the work of a step, and times its phases, each from the end of the previous one:
/// reading the clock costs as much as a phase of a small model.
pub(super) struct Meter<'a> {
    /// The counters so far.
    pub counters: &'a mut Counters,
    /// The elapsed time [s].
    clock: &'a dyn Fn() -> f64,
    /// Start of the current phase [s].
    began: f64,
}

impl<'a> Meter<'a> {
    /// Starts the first phase at the time `began` \[s\].
    pub fn new(counters: &'a mut Counters, clock: &'a dyn Fn() -> f64, began: f64) -> Self {
        Self {
            counters,
            clock,
            began,
        }
    }

    /// Ends a phase, and adds its time to the counter selected by `of`.
    pub fn end_phase(&mut self, of: fn(&mut Counters) -> &mut f64) {
        let now = (self.clock)();
        *of(self.counters) += now - self.began;
        self.began = now;
    }
}

impl std::fmt::Debug for Meter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.counters.fmt(f)
    }
}
