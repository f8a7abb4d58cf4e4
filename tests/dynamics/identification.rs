//! Frequencies and growth of known oscillations, from their samples.

use std::f64::consts::TAU;

use beam_dynamics::analysis::identification::{
    IdentificationSettings, Record, RecordProblem, identify,
};
use beam_dynamics::result::{IdentificationMethod, IdentifiedMode};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

const SETTINGS: IdentificationSettings = IdentificationSettings {
    count: 6,
    noise: 1e-9,
};

/// Numbers between two limits.
struct Random(Pcg64Mcg);

impl Random {
    fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 * (0.5f64).powi(53)
    }
}

/// A motion `a exp(sigma t) cos(omega t + phi)`.
#[derive(Clone, Copy)]
struct Part {
    frequency: f64,
    growth: f64,
    amplitude: f64,
    phase: f64,
}

fn at(parts: &[Part], constant: f64, time: f64) -> f64 {
    let sum = parts.iter().map(|part| {
        part.amplitude * (part.growth * time).exp() * (part.frequency * time + part.phase).cos()
    });
    constant + sum.sum::<f64>()
}

fn samples(parts: &[Part], constant: f64, times: &[f64]) -> Vec<f64> {
    times
        .iter()
        .map(|time| at(parts, constant, *time))
        .collect()
}

fn times(count: usize, step: f64) -> Vec<f64> {
    (0..count).map(|k| 3.0 + step * k as f64).collect()
}

/// One to three motions at least a factor 1.4 apart, of 3 to 40 periods in the record.
fn random_parts(random: &mut Random, length: f64) -> Vec<Part> {
    let count = 1 + (random.between(0.0, 3.0) as usize).min(2);
    let mut frequency = TAU * random.between(4.0, 7.0) / length;
    (0..count)
        .map(|_| {
            let part = Part {
                frequency,
                growth: random.between(-4.0, 1.0) / length,
                amplitude: random.between(0.3, 1.0),
                phase: random.between(-3.0, 3.0),
            };
            frequency *= random.between(1.4, 2.2);
            part
        })
        .collect()
}

fn of_method(modes: &[IdentifiedMode], method: IdentificationMethod) -> Vec<IdentifiedMode> {
    let found = modes.iter().filter(|mode| mode.method == method);
    found.copied().collect()
}

/// Prony's sum is exact for sums of damped oscillations: round-off, times the condition of poles that
/// are apart by a turn over a third of the record or more.
#[test]
fn sums_of_damped_oscillations_are_found() {
    let mut random = Random::new(1);
    for case in 0..300 {
        let (count, step) = (
            random.between(150.0, 600.0) as usize,
            random.between(1e-3, 10.0),
        );
        let length = step * count as f64;
        let parts = random_parts(&mut random, length);
        let (times, constant) = (times(count, step), random.between(-5.0, 5.0));
        let record = Record::new(&times, &samples(&parts, constant, &times)).unwrap();
        let (modes, residual) = identify(&record, &SETTINGS).unwrap();
        assert!(residual < 1e-7, "{case}: {residual}");
        let found = of_method(&modes, IdentificationMethod::Prony);
        assert_eq!(found.len(), parts.len(), "{case}: {found:?}");
        for part in &parts {
            let near =
                |mode: &&IdentifiedMode| (mode.frequency / part.frequency - 1.0).abs() < 1e-6;
            let mode = found
                .iter()
                .find(near)
                .unwrap_or_else(|| panic!("{case}: {found:?}"));
            assert!((mode.growth - part.growth).abs() * length < 1e-5, "{case}");
            let start = part.amplitude * (3.0 * part.growth).exp();
            assert!(
                (mode.amplitude.unwrap() / start - 1.0).abs() < 1e-5,
                "{case}"
            );
        }
    }
}

/// One motion by all methods: the window of Hann takes the conjugate with a part of at most
/// `1 / (2 m)^3` for m periods, and the parabola through three of n samples in a period moves the
/// extremes by a part of `(2 pi / n)^2`.
#[test]
fn the_methods_agree_on_one_motion() {
    let mut random = Random::new(2);
    for case in 0..100 {
        let (count, length) = (600, 10.0);
        let part = Part {
            frequency: TAU * random.between(8.0, 15.0) / length,
            growth: random.between(-3.0, 1.0) / length,
            amplitude: 1.0,
            phase: random.between(-3.0, 3.0),
        };
        let times = times(count, length / count as f64);
        let record = Record::new(&times, &samples(&[part], 2.0, &times)).unwrap();
        let (modes, _) = identify(&record, &SETTINGS).unwrap();
        for method in [
            IdentificationMethod::Prony,
            IdentificationMethod::MovingBlock,
            IdentificationMethod::Decrement,
        ] {
            let found = of_method(&modes, method);
            assert_eq!(found.len(), 1, "{case} {method:?}");
            let [frequency, growth] = match method {
                IdentificationMethod::Prony => [1e-7, 1e-6],
                IdentificationMethod::MovingBlock => [2e-4, 3e-2],
                IdentificationMethod::Decrement => [1e-2, 3e-2],
            };
            let off = (found[0].frequency / part.frequency - 1.0).abs();
            assert!(off < frequency, "{case} {method:?}: {off}");
            let off = (found[0].growth - part.growth).abs() * length;
            assert!(off < growth, "{case} {method:?}: {off}");
        }
    }
}

/// Unequal steps: the cubic through four samples, of 100 or more in a period, has an error of
/// `(2 pi / 100)^4 / 40`.
#[test]
fn samples_at_unequal_times() {
    let mut random = Random::new(3);
    for case in 0..30 {
        let part = Part {
            frequency: TAU * random.between(3.0, 4.0),
            growth: random.between(-1.0, 0.0),
            amplitude: 1.0,
            phase: random.between(-3.0, 3.0),
        };
        let mut time = 0.0;
        let times: Vec<_> = (0..550)
            .map(|_| {
                time += random.between(1e-3, 2.4e-3);
                time
            })
            .collect();
        let record = Record::new(&times, &samples(&[part], 0.0, &times)).unwrap();
        let (modes, _) = identify(
            &record,
            &IdentificationSettings {
                noise: 1e-4,
                ..SETTINGS
            },
        )
        .unwrap();
        let off = (modes[0].frequency / part.frequency - 1.0).abs();
        assert!(off < 1e-5, "{case}: {off}");
        assert!((modes[0].growth - part.growth).abs() < 1e-3, "{case}");
    }
}

/// A filter keeps poles exactly; a motion of a hundred times the frequency is gone, not folded.
#[test]
fn long_records_are_filtered_and_thinned() {
    let part = |frequency: f64, growth: f64, amplitude: f64| Part {
        frequency: TAU * frequency,
        growth,
        amplitude,
        phase: 0.3,
    };
    let (slow, quick) = (part(1.5, -0.1, 1.0), part(151.0, 0.0, 0.5));
    let times = times(20_000, 1e-3);
    let record = Record::new(&times, &samples(&[slow, quick], 1.0, &times)).unwrap();
    let settings = IdentificationSettings {
        noise: 1e-3,
        ..SETTINGS
    };
    let (modes, _) = identify(&record, &settings).unwrap();
    assert!((modes[0].frequency / slow.frequency - 1.0).abs() < 1e-6);
    assert!((modes[0].growth - slow.growth).abs() < 1e-5);
    let start = (3.0 * slow.growth).exp();
    assert!((modes[0].amplitude.unwrap() / start - 1.0).abs() < 1e-5);
}

/// Noise of a thousandth of the amplitude: the deviation of the growth of n samples over the time T is
/// at least `sqrt(24 / n) noise / (a T)`, 2e-4 / T; ten times that.
#[test]
fn noise_moves_the_growth_by_its_size() {
    let mut random = Random::new(4);
    for case in 0..30 {
        let part = Part {
            frequency: TAU * random.between(0.8, 1.5),
            growth: random.between(-0.2, 0.0),
            amplitude: 1.0,
            phase: random.between(-3.0, 3.0),
        };
        let times = times(600, 10.0 / 600.0);
        let mut values = samples(&[part], 0.0, &times);
        for value in &mut values {
            let sum: f64 = (0..12).map(|_| random.between(-0.5, 0.5)).sum();
            *value += 1e-3 * sum;
        }
        let record = Record::new(&times, &values).unwrap();
        let settings = IdentificationSettings {
            noise: 1e-2,
            ..SETTINGS
        };
        let (modes, residual) = identify(&record, &settings).unwrap();
        assert!((modes[0].growth - part.growth).abs() < 2e-3, "{case}");
        assert!(residual < 1e-2, "{case}: {residual}");
    }
}

#[test]
fn records_without_oscillations_are_reported() {
    let times = times(100, 0.1);
    let found = |values: &[f64]| {
        let record = Record::new(&times, values)?;
        identify(&record, &SETTINGS).map(|(modes, _)| modes.len())
    };
    assert_eq!(found(&[2.0; 100]), Err(RecordProblem::NoOscillation));
    let decay: Vec<_> = times.iter().map(|time| (-time).exp()).collect();
    assert_eq!(found(&decay), Err(RecordProblem::NoOscillation));
    assert_eq!(found(&[1.0; 3]), Err(RecordProblem::Short { samples: 3 }));
    let mut values = decay;
    values[7] = f64::NAN;
    assert!(matches!(
        found(&values),
        Err(RecordProblem::Undefined { .. })
    ));
    let backward: Vec<_> = times.iter().rev().copied().collect();
    assert!(matches!(
        Record::new(&backward, &[1.0; 100]),
        Err(RecordProblem::Unordered { .. })
    ));
}

/// Any numbers give modes or a problem, never a panic.
#[test]
fn any_numbers_are_accepted() {
    let mut random = Random::new(5);
    for case in 0..200 {
        let count = random.between(1.0, 80.0) as usize;
        let kind = case % 4;
        let values: Vec<f64> = (0..count)
            .map(|k| match kind {
                0 => random.between(-1.0, 1.0),
                1 => f64::from_bits((random.between(0.0, 1.0) * 1.8e19) as u64),
                2 => 1e300 * random.between(-1.0, 1.0),
                _ => (-1f64).powi(k as i32),
            })
            .collect();
        let times: Vec<f64> = (0..count).map(|k| k as f64).collect();
        if let Ok(record) = Record::new(&times, &values) {
            let _found = identify(&record, &SETTINGS);
        }
    }
}
