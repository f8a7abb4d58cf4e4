//! The requested periodic motion.

use super::{AutoPilot, TransientSettings, TrimControl, TrimTarget, Words};

/// Search of a periodic motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PeriodicMethod {
    /// Period after period until the motion repeats.
    March,
    /// Newton's method for the first state.
    Shooting,
}

/// The requested characteristic multipliers.
#[derive(Debug, Clone, PartialEq)]
pub struct FloquetSettings {
    /// Number of multipliers, the largest first; a pair counts as two.
    pub count: usize,
    /// Frequencies nearest to which the exponents are shown; empty: by the content of the mode
    /// [rad/s].
    pub near: Vec<f64>,
    /// Whether the error of the steps is estimated by a second analysis with half their number.
    pub estimates_error: bool,
    /// Words in the names of modes.
    pub words: Words,
}

/// The requested periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicSettings {
    /// First instant, start, iteration of a step, and redundant constraints.
    pub start: TransientSettings,
    /// Period [s].
    pub period: f64,
    /// Steps in a period.
    pub steps: usize,
    /// Whether Radau IIA has three stages, else two.
    pub three_stages: bool,
    /// The method.
    pub method: PeriodicMethod,
    /// Largest change of the state in a period, in sizes of the model, radians and sizes of the
    /// momenta and scalars [-].
    pub tolerance: f64,
    /// Largest number of Newton iterations.
    pub iterations: usize,
    /// Largest number of periods of a march.
    pub periods: usize,
    /// Periods that are marched before shooting.
    pub settle: usize,
    /// Speed of the rotor whose revolution defines the period, if any [rad/s].
    pub speed: Option<f64>,
    /// Number of harmonics of the columns.
    pub harmonics: usize,
    /// The requested multipliers.
    pub floquet: Option<FloquetSettings>,
    /// Controls that are found with the motion.
    pub controls: Vec<TrimControl>,
    /// Means over the period: the targets of the controls, then others, which are only computed.
    pub targets: Vec<TrimTarget>,
    /// The auto-pilot that finds the controls, in place of `method`.
    pub pilot: Option<AutoPilot>,
}

impl PeriodicSettings {
    /// By shooting over `period` \[s\] in `steps` steps of three stages from the given state at time
    /// zero, with the defaults of an input file for everything else.
    pub fn new(period: f64, steps: usize) -> Self {
        let mut start = TransientSettings::new(period, period / steps as f64);
        start.newton.correction = 1e-12;
        Self {
            start,
            period,
            steps,
            three_stages: true,
            method: PeriodicMethod::Shooting,
            tolerance: 1e-9,
            iterations: 20,
            periods: 1000,
            settle: 1,
            speed: None,
            harmonics: 8,
            floquet: None,
            controls: Vec::new(),
            targets: Vec::new(),
            pilot: None,
        }
    }

    /// Revolutions of the rotor in a period, if it has a speed.
    pub fn revolutions(&self) -> Option<usize> {
        let turns = self.speed?.abs() * self.period / std::f64::consts::TAU;
        Some((turns.round() as usize).max(1))
    }

    /// Number of stages of a step.
    pub fn stages(&self) -> usize {
        2 + usize::from(self.three_stages)
    }
}
