//! Counters and times of the phases of a step.

use super::Counters;

/// Steps from the first on of which each is timed.
const TIMED: usize = 64;
/// Every step of this number is timed after them, and counts for all.
const SAMPLE: usize = 16;

/// Counts the work of a step, and times its phases, each from the end of the previous one.
/// Reading the clock costs as much as a phase of a small model: of long runs a sample of the
/// steps is timed.
pub(super) struct Meter<'a> {
    /// The counters so far.
    pub counters: &'a mut Counters,
    /// The elapsed time [s].
    clock: &'a dyn Fn() -> f64,
    /// Start of the current phase \[s\].
    began: f64,
    /// Steps for which the times of this one count; zero if it is not timed.
    weight: usize,
}

impl<'a> Meter<'a> {
    /// Starts the first phase of a step, at the time `began` \[s\] as [`Self::start`] gives it.
    pub fn new(counters: &'a mut Counters, clock: &'a dyn Fn() -> f64, began: f64) -> Self {
        Self {
            weight: weight(counters.steps),
            counters,
            clock,
            began,
        }
    }

    /// The time at the start of a step \[s\]; zero if the step is not timed.
    pub fn start(counters: &Counters, clock: &dyn Fn() -> f64) -> f64 {
        match weight(counters.steps) {
            0 => 0.0,
            _ => clock(),
        }
    }

    /// Ends a phase, and adds its time to the counter selected by `of`.
    pub fn end_phase(&mut self, of: fn(&mut Counters) -> &mut f64) {
        if self.weight == 0 {
            return;
        }
        let now = (self.clock)();
        *of(self.counters) += self.weight as f64 * (now - self.began);
        self.began = now;
    }
}

/// Number of steps for which the times of a step count, of which `steps` are before it.
fn weight(steps: usize) -> usize {
    match steps {
        0..TIMED => 1,
        _ if steps.is_multiple_of(SAMPLE) => SAMPLE,
        _ => 0,
    }
}

impl std::fmt::Debug for Meter<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.counters.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// A clock that advances by one second with every reading: 1000 steps of one phase each
    /// take 1000 s, of which a sample is measured.
    #[test]
    fn a_sample_counts_for_all_steps() {
        let (now, readings) = (Cell::new(0.0), Cell::new(0));
        let clock = || {
            now.set(now.get() + 1.0);
            readings.set(readings.get() + 1);
            now.get()
        };
        let mut counters = Counters::default();
        for _ in 0..1024 {
            let began = Meter::start(&counters, &clock);
            Meter::new(&mut counters, &clock, began)
                .end_phase(|counters| &mut counters.residual_time);
            counters.steps += 1;
        }
        assert_eq!(counters.residual_time, 1024.0);
        assert_eq!(readings.get(), 2 * (64 + 60));
    }
}
