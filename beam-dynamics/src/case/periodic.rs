//! The requested periodic motion.

use super::TransientSettings;

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
}

/// A mean over the period that must have a value.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicTarget {
    /// Name.
    pub name: String,
    /// Label of the element that integrates the quantity.
    pub integral: String,
    /// The required mean [unit of the quantity].
    pub value: f64,
    /// Size relative to which errors are measured [unit of the quantity].
    pub scale: f64,
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
    /// Names of the controls and labels of the elements of which they are the state.
    pub controls: Vec<(String, String)>,
    /// Targets, as many as controls.
    pub targets: Vec<PeriodicTarget>,
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
        }
    }

    /// Number of stages of a step.
    pub fn stages(&self) -> usize {
        2 + usize::from(self.three_stages)
    }
}
