//! Samples at equal distances, from samples at any times, and filtered.
//!
//! A filter of weights h keeps the poles of a sum of exponentials, and multiplies each by its
//! response, so that thinned samples have the frequencies and the damping of the record exactly:
//!
//! ```text
//! y_n = sum_m c_m z_m^n       sum_k h_k y_{n+k} = sum_m c_m H(z_m) z_m^n ,   H(z) = sum_k h_k z^k
//! ```

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;
use shared_geom::error::Explain;
use shared_geom::units::rounded;

/// Fewest samples of a record.
const LEAST: usize = 20;
/// Difference of steps that are treated as equal, as a part of the step: the digits of tables.
const EQUAL: f64 = 1e-6;
/// Largest step, in mean steps: an interpolation over more invents the motion.
const GAP: f64 = 10.0;
/// Half the length of the filter over the distance of the thinned samples. The window of Blackman of
/// this length passes .3 and stops .5 of the new rate by 1e-4.
const HALF: usize = 14;
/// Frequency at the middle of the edge of the filter, times the distance of the thinned samples.
const EDGE: f64 = 0.4;

/// A problem of a record.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RecordProblem {
    /// Too few samples.
    #[error("{samples} samples are too few, expected at least {LEAST}")]
    Short {
        /// Their number.
        samples: usize,
    },
    /// A value that is not a number.
    #[error("the value at {} s is not a number", rounded(*.time))]
    Undefined {
        /// Its time \[s\].
        time: f64,
    },
    /// Times that do not increase.
    #[error("the times do not increase: {} s comes after {} s", rounded(.times[1]), rounded(.times[0]))]
    Unordered {
        /// A time and its successor \[s\].
        times: [f64; 2],
    },
    /// Samples missing.
    #[error(
        "the record has a gap: from {} s to {} s, {:.0} times its mean step",
        rounded(.times[0]), rounded(.times[1]), .steps
    )]
    Gap {
        /// Its beginning and end \[s\].
        times: [f64; 2],
        /// Its length in mean steps.
        steps: f64,
    },
    /// A constant, or a record of motions that do not oscillate.
    #[error("the record has no oscillation")]
    NoOscillation,
    /// A decomposition that did not converge.
    #[error("the sum of oscillations was not found: its singular values did not converge")]
    NoSum,
}

impl Explain for RecordProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Short { .. } => {
                "take a longer part of the run, or write more of its steps with \"every\" of [output]"
            }
            Self::Undefined { .. } => "take a part of the run with values, by --from and --to",
            Self::Unordered { .. } => "give the table of one run, with ascending times",
            Self::Gap { .. } => {
                "take the part before or behind it, by --from and --to, or write all rows"
            }
            Self::NoOscillation => {
                "choose a column that moves, or a part of the run in which it does"
            }
            Self::NoSum => "take another part of the run, by --from and --to",
        };
        Some(text.to_owned())
    }
}

/// Samples at equal distances.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Time of the first \[s\].
    pub start: f64,
    /// Distance \[s\].
    pub step: f64,
    /// The samples \[any unit\].
    pub values: Vec<f64>,
}

/// A filtered record.
pub(super) struct Thinned {
    pub record: Record,
    /// Weights of the filter; one without a filter.
    weights: Vec<f64>,
    /// Distance of its weights \[s\].
    step: f64,
}

impl Record {
    /// From samples at ascending times \[s\]; at unequal distances by cubic interpolation.
    ///
    /// # Errors
    /// All but [`RecordProblem::NoOscillation`] and [`RecordProblem::NoSum`].
    pub fn new(times: &[f64], values: &[f64]) -> Result<Self, RecordProblem> {
        let count = times.len().min(values.len());
        let (times, values) = (&times[..count], &values[..count]);
        if count < LEAST {
            return Err(RecordProblem::Short { samples: count });
        }
        if let Some(pair) = times
            .windows(2)
            .find(|pair| pair[1].partial_cmp(&pair[0]) != Some(std::cmp::Ordering::Greater))
        {
            return Err(RecordProblem::Unordered {
                times: [pair[0], pair[1]],
            });
        }
        let wrong = times
            .iter()
            .zip(values)
            .find(|(_, value)| !value.is_finite());
        if let Some((&time, _)) = wrong {
            return Err(RecordProblem::Undefined { time });
        }
        let start = times[0];
        let step = (times[count - 1] - start) / (count - 1) as f64;
        let gap = times.windows(2).find(|pair| pair[1] - pair[0] > GAP * step);
        if let Some(pair) = gap {
            return Err(RecordProblem::Gap {
                times: [pair[0], pair[1]],
                steps: (pair[1] - pair[0]) / step,
            });
        }
        let equal = times.iter().enumerate();
        let is_equal = equal
            .map(|(k, time)| (time - start - step * k as f64).abs())
            .all(|off| off <= EQUAL * step);
        let values = if is_equal {
            values.to_vec()
        } else {
            (0..count)
                .map(|k| between(times, values, start + step * k as f64))
                .collect()
        };
        Ok(Self {
            start,
            step,
            values,
        })
    }

    /// At most some number of samples: filtered by a low pass, then every so many.
    pub(super) fn thinned(&self, most: usize) -> Thinned {
        let stride = self.values.len().div_ceil(most.max(1)).max(1);
        if stride == 1 {
            return Thinned {
                record: self.clone(),
                weights: vec![1.0],
                step: self.step,
            };
        }
        let weights = low_pass(stride);
        let windows = self.values.windows(weights.len()).step_by(stride);
        let sum = |window: &[f64]| window.iter().zip(&weights).map(|(y, h)| y * h).sum();
        Thinned {
            record: Self {
                start: self.start,
                step: self.step * stride as f64,
                values: windows.map(sum).collect(),
            },
            weights,
            step: self.step,
        }
    }

    /// Time between the first and the last \[s\].
    pub fn length(&self) -> f64 {
        self.step * self.values.len().saturating_sub(1) as f64
    }
}

impl Thinned {
    /// The response of the filter to `exp(s t)` \[-\].
    pub fn response(&self, exponent: Complex<f64>) -> Complex<f64> {
        let weights = self.weights.iter().enumerate();
        weights
            .map(|(k, h)| (exponent * (self.step * k as f64)).exp() * *h)
            .sum()
    }
}

/// Weights of a low pass for a stride: a sinc in the window of Blackman, with the sum one.
fn low_pass(stride: usize) -> Vec<f64> {
    let half = (HALF * stride) as f64;
    let edge = EDGE / stride as f64;
    let weight = |k: usize| {
        let at = k as f64 - half;
        let sinc = if at == 0.0 {
            2.0 * edge
        } else {
            (TAU * edge * at).sin() / (PI * at)
        };
        let angle = PI * at / half;
        sinc * (0.42 + 0.5 * angle.cos() + 0.08 * (2.0 * angle).cos())
    };
    let weights: Vec<f64> = (0..=2 * HALF * stride).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.into_iter().map(|weight| weight / sum).collect()
}

/// The value at a time, by the cubic through the four nearest samples.
fn between(times: &[f64], values: &[f64], at: f64) -> f64 {
    let after = times.partition_point(|time| *time <= at);
    let first = after.saturating_sub(2).min(times.len() - 4);
    let nearest = first..first + 4;
    nearest
        .clone()
        .map(|k| {
            let others = nearest.clone().filter(|j| *j != k);
            let shape: f64 = others
                .map(|j| (at - times[j]) / (times[k] - times[j]))
                .product();
            values[k] * shape
        })
        .sum()
}
