//! Results of periodic motion.

use nalgebra::Complex;

/// A period of a march, or an iteration of Newton's method.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicPass {
    /// Largest change of the state in the period, or error of a target, relative to its scale [-].
    pub residual: f64,
    /// Its unknown, or target, as text.
    pub worst: String,
    /// Products with the linearized period for the correction; zero without one.
    pub products: usize,
    /// Part of the correction that was applied [-].
    pub part: f64,
    /// Means of the targets over the period [unit of each].
    pub reached: Vec<f64>,
}

/// Size of the growth, in estimated errors, up to which it is not known.
const DOUBTFUL: f64 = 2.0;

/// A frequency at which a mode is seen in the fixed frame, beside the chosen one.
#[derive(Debug, Clone, PartialEq)]
pub struct SeenFrequency {
    /// The frequency [rad/s].
    pub frequency: f64,
    /// Share of the energy [-].
    pub share: f64,
    /// As [`FloquetMode::shape`], at this frequency \[any unit\].
    pub shape: Vec<Complex<f64>>,
}

/// A characteristic multiplier with its mode; of a pair the one with the positive frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct FloquetMode {
    /// The multiplier [-].
    pub multiplier: Complex<f64>,
    /// The exponent on the chosen branch [1/s].
    pub exponent: Complex<f64>,
    /// Number of fundamental frequencies added to the principal branch.
    pub branch: i32,
    /// Share of the energy at the chosen frequency [-].
    pub share: f64,
    /// The other frequencies at which it is seen, the largest share first.
    pub others: Vec<SeenFrequency>,
    /// Residual of the multiplier, `|M v - mu v| / |mu v|` [-].
    pub residual: f64,
    /// Estimated error of the exponent by the steps [1/s].
    pub error: Option<f64>,
    /// The motion as text.
    pub name: String,
    /// The pattern of the blades after the name and the number of the mode, perhaps empty; `None` of models
    /// without multiblade coordinates, whose modes have the name of the largest motion.
    pub pattern: Option<String>,
    /// Number of blades of the rotor that moves, zero of a part outside the blades; `None` without multiblade coordinates.
    pub blades: Option<usize>,
    /// Frequency in axes that turn with the blades [rad/s].
    pub in_blades: f64,
    /// Motion and momentum in multiblade coordinates at the shown frequency; empty without equal blades
    /// \[any unit\].
    pub in_coordinates: [Vec<Complex<f64>>; 2],
    /// Motion of all parts at the chosen frequency, which is positive, in the fixed frame: three
    /// entries of each, times the roots of their masses \[any unit\].
    pub shape: Vec<Complex<f64>>,
    /// Whether it is the free choice of the azimuth or of the time: a multiplier of one.
    pub is_neutral: bool,
}

impl FloquetMode {
    /// The motion with the pattern of the blades, as text.
    pub fn label(&self) -> String {
        format!(
            "{}{}",
            self.name,
            self.pattern.as_deref().unwrap_or_default()
        )
    }

    /// Frequency \[rad/s\].
    pub fn frequency(&self) -> f64 {
        self.exponent.im.abs()
    }

    /// Damping ratio; `None` at frequency zero.
    pub fn damping_ratio(&self) -> Option<f64> {
        let size = self.exponent.norm();
        (self.exponent.im != 0.0 && size > 0.0).then(|| -self.exponent.re / size)
    }

    /// Whether it decays, grows, or neither is known because of the error of the steps.
    pub fn stability(&self) -> Stability {
        let error = self.error.unwrap_or(0.0);
        match self.exponent.re {
            _ if self.is_neutral => Stability::Neutral,
            growth if growth.abs() <= DOUBTFUL * error => Stability::Unknown,
            growth if growth > 0.0 => Stability::Unstable,
            _ => Stability::Stable,
        }
    }
}

/// Growth of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// It decays.
    Stable,
    /// It grows.
    Unstable,
    /// It is the free choice of the azimuth or of the time.
    Neutral,
    /// The growth is below twice its estimated error.
    Unknown,
}

impl Stability {
    /// As text.
    pub fn word(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::Neutral => "azimuth",
            Self::Unknown => "below error",
        }
    }
}

/// The largest multipliers.
#[derive(Debug, Clone, PartialEq)]
pub struct FloquetTable {
    /// The modes, by falling size of the multipliers.
    pub modes: Vec<FloquetMode>,
    /// Products with the linearized period.
    pub products: usize,
    /// Dimension of the space of all images of the period, if it was built: at least the number of
    /// independent states.
    pub states: Option<usize>,
}

/// Stall of the strips of a motion with at least 0.3 of the largest speed of the instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stall {
    /// Their angle of attack of largest magnitude [rad].
    pub largest_angle: f64,
    /// Part of these strips, over all instants, that are beyond stall [-].
    pub part: f64,
}

impl Stall {
    /// As text, given the instants that it is of.
    pub fn text(&self, when: &str) -> String {
        let strips = match self.part {
            0.0 => "no strip of the blades is".to_owned(),
            part => format!("{:.1} % of the strips of the blades are", 100.0 * part),
        };
        format!(
            "{strips} beyond stall (less than 0.7 of the chord with attached flow) {when}, at \
             angles of attack up to {:.1} deg",
            self.largest_angle.to_degrees()
        )
    }
}

/// The result of a periodic motion.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicResult {
    /// Name of the model.
    pub name: String,
    /// Period [s].
    pub period: f64,
    /// Steps in a period.
    pub steps: usize,
    /// Stages of a step.
    pub stages: usize,
    /// Periods or iterations.
    pub passes: Vec<PeriodicPass>,
    /// Whether the motion repeats.
    pub is_periodic: bool,
    /// Periods that were integrated.
    pub periods: usize,
    /// Controls: names and values \[unit of each\].
    pub controls: Vec<(String, f64)>,
    /// Means of the targets over the period \[unit of each\]; empty without a motion that repeats.
    pub targets: Vec<f64>,
    /// Multipliers, if requested.
    pub floquet: Option<FloquetTable>,
    /// Stall of the blades in the motion with the controls, if there are controls and strips.
    pub stall: Option<Stall>,
    /// Remarks.
    pub remarks: Vec<String>,
}

/// Mean and harmonics of a column over a period.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonics {
    /// The mean [unit of the column].
    pub mean: f64,
    /// Factors of the cosine and the sine of each harmonic, from the first instant of the period
    /// [unit of the column].
    pub parts: Vec<[f64; 2]>,
}

impl Harmonics {
    /// The largest of the mean and the sizes of the harmonics.
    pub fn largest(&self) -> f64 {
        let sizes = self.parts.iter().map(|[cosine, sine]| cosine.hypot(*sine));
        sizes.fold(self.mean.abs(), f64::max)
    }

    /// Of values at equal distances over a period, the end left out, by the trapezoidal rule, exact
    /// for harmonics below half the number of values:
    ///
    /// ```text
    /// c_m = 2/n sum_k y_k cos(2 pi m k/n) ,   s_m = 2/n sum_k y_k sin(2 pi m k/n)      (D-442)
    /// ```
    pub fn of(values: &[f64], count: usize) -> Self {
        let n = values.len();
        let sum = |m: usize, wave: fn(f64) -> f64| {
            let angle = |k: usize| std::f64::consts::TAU * ((m * k) % n) as f64 / n as f64;
            let terms = values.iter().enumerate();
            terms.map(|(k, value)| value * wave(angle(k))).sum::<f64>() / n as f64
        };
        let count = count.min(n.saturating_sub(1) / 2);
        Self {
            mean: sum(0, f64::cos),
            parts: (1..=count)
                .map(|m| [2.0 * sum(m, f64::cos), 2.0 * sum(m, f64::sin)])
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // A sum of cosines and sines has these factors: the rule is exact for them.
    #[test]
    fn harmonics_of_a_sum_of_waves() {
        let wave = |k: usize| {
            let t = std::f64::consts::TAU * k as f64 / 16.0;
            2.0 + 3.0 * t.cos() - 4.0 * (2.0 * t).sin() + 0.5 * (7.0 * t).cos()
        };
        let values: Vec<_> = (0..16).map(wave).collect();
        let found = Harmonics::of(&values, 20);
        assert_eq!(found.parts.len(), 7);
        assert!((found.mean - 2.0).abs() < 1e-14);
        for (m, [c, s]) in found.parts.iter().enumerate() {
            let expected = match m + 1 {
                1 => [3.0, 0.0],
                2 => [0.0, -4.0],
                7 => [0.5, 0.0],
                _ => [0.0; 2],
            };
            assert!((c - expected[0]).abs() < 1e-13 && (s - expected[1]).abs() < 1e-13);
        }
    }
}
