//! Random drives. Each has a seed of its own and is the same in every run.
//!
//! The smooth one is a sum of N sines, one in each of N equal intervals of a band of
//! frequencies, at a random frequency in the interval and with a random phase (D-193):
//!
//! ```text
//! x(t) = mean + sigma sqrt(2/N) sum_i sin(2 pi f_i t + phi_i)
//! ```
//!
//! Its mean square over a long time about the mean is sigma^2, its spectrum is flat in
//! the band and zero outside, and it is normal by the central limit; it has all
//! derivatives. [Shinozuka1972] gives the method. The other one has independent normal
//! numbers at equal intervals and straight pieces between them.

use std::f64::consts::TAU;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

use super::DriveValue;

/// A number from 0 to below 1, of 53 bits.
fn uniform(random: &mut Pcg64Mcg) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A smooth random number of a band of frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct BandNoise {
    mean: f64,
    amplitude: f64,
    /// Angular frequency [rad/s] and phase [rad] of each sine.
    waves: Vec<[f64; 2]>,
}

impl BandNoise {
    /// A drive of mean and standard deviation \[unit of the drive\], with `terms` sines in
    /// a `band` of frequencies \[Hz\].
    pub fn new([mean, deviation]: [f64; 2], band: [f64; 2], terms: usize, seed: u64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let stretch = (band[1] - band[0]) / terms as f64;
        let mut wave = |i: usize| {
            let frequency = band[0] + stretch * (i as f64 + uniform(&mut random));
            [TAU * frequency, TAU * uniform(&mut random)]
        };
        Self {
            mean,
            amplitude: deviation * (2.0 / terms as f64).sqrt(),
            waves: (0..terms).map(&mut wave).collect(),
        }
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let mut sum = DriveValue::default();
        for [omega, phase] in &self.waves {
            let (sin, cos) = (omega * time + phase).sin_cos();
            sum.value += sin;
            sum.rate += omega * cos;
            sum.acceleration -= omega * omega * sin;
        }
        let mut value = sum.scaled(self.amplitude);
        value.value += self.mean;
        value
    }
}

/// A random number with straight pieces between independent normal numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteppedNoise {
    /// Mean [unit of the drive].
    pub mean: f64,
    /// Standard deviation of the numbers at the ends of the intervals [unit of the drive].
    pub deviation: f64,
    /// Time between two numbers [s].
    pub interval: f64,
    /// Seed.
    pub seed: u64,
}

impl SteppedNoise {
    /// Index of the interval that begins at or before a time.
    fn index(&self, time: f64) -> f64 {
        let index = (time / self.interval).floor();
        if (index + 1.0) * self.interval <= time {
            index + 1.0
        } else {
            index
        }
    }

    /// The number at the beginning of an interval (Box and Muller).
    fn number(&self, index: f64) -> f64 {
        let mut random = Pcg64Mcg::seed_from_u64(self.seed);
        // Two numbers per interval, found without the previous ones.
        random.advance((index as i64).saturating_mul(2) as u128);
        let radius = (-2.0 * (1.0 - uniform(&mut random)).ln()).sqrt();
        let angle = TAU * uniform(&mut random);
        self.mean + self.deviation * radius * angle.cos()
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let index = self.index(time);
        let [before, after] = [self.number(index), self.number(index + 1.0)];
        let part = time / self.interval - index;
        DriveValue {
            value: before + part * (after - before),
            rate: (after - before) / self.interval,
            acceleration: 0.0,
        }
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        (self.index(time) + 1.0) * self.interval
    }
}
