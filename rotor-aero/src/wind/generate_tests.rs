//! Tests of generated boxes: variance, spectrum, coherence, seeds, the file.

use super::*;
use crate::wind::{read_bts, write_bts};

fn input(planes: usize, points: [usize; 2], seed: u64) -> GeneratorInput {
    GeneratorInput {
        spectrum: Kaimal {
            speed: 12.0,
            sigma: 2.0,
            scale: 42.0,
        },
        hub_height: 90.0,
        exponent: Some(0.2),
        planes,
        points,
        time_step: 0.1,
        steps: [10.0, 20.0],
        seed,
    }
}

/// Fluctuations of a component at a point over time.
fn at(values: &BoxValues, y: usize, z: usize, component: usize) -> Vec<f64> {
    let index = values.grid.index(y, z) + component;
    let all: Vec<f64> = values.planes.iter().map(|plane| plane[index]).collect();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    all.iter().map(|value| value - mean).collect()
}

fn mean_of(values: &BoxValues, z: usize) -> f64 {
    let index = values.grid.index(0, z);
    values.planes.iter().map(|plane| plane[index]).sum::<f64>() / values.planes.len() as f64
}

fn variance(series: &[f64]) -> f64 {
    series.iter().map(|value| value * value).sum::<f64>() / series.len() as f64
}

#[test]
fn variances_and_means() {
    let values = generate(&input(2048, [5, 4], 1)).unwrap();
    let sigmas = [2.0, 1.6, 1.0_f64];
    for y in 0..5 {
        for z in 0..4 {
            for component in [1, 2] {
                // one phase per frequency: the variance is exact
                let found = variance(&at(&values, y, z, component));
                assert!((found / sigmas[component].powi(2) - 1.0).abs() < 1e-12);
            }
        }
    }
    // u: sums of phases. The variance of a point has the relative deviation
    // sqrt(sum S^2 (1 - sum h^4))/sum S, which is at most 0.28 here: the first frequency has a
    // fifth of the variance. The mean over 20 points that are hardly coherent beyond the lowest
    // frequencies stays below 3 of these deviations over sqrt(8).
    let points = (0..20).map(|i| variance(&at(&values, i % 5, i / 5, 0)));
    let mean = points.sum::<f64>() / 20.0;
    assert!((mean / 4.0 - 1.0).abs() < 0.3, "{mean}");
    // the profile is exact, since the fluctuations have no mean
    for z in 0..4 {
        let height = 60.0 + 20.0 * z as f64;
        let expected = 12.0 * (height / 90.0_f64).powf(0.2);
        assert!((mean_of(&values, z) - expected).abs() < 1e-12);
    }
}

/// The mean over seeds of the variance of u at one point, with its sampling error.
#[test]
fn the_variance_of_u_over_seeds() {
    let found: Vec<f64> = (0..40)
        .map(|seed| variance(&at(&generate(&input(512, [2, 2], seed)).unwrap(), 1, 1, 0)))
        .collect();
    let mean = found.iter().sum::<f64>() / 40.0;
    let spread = found.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / 39.0;
    // four standard errors of the mean
    assert!(
        (mean - 4.0).abs() < 4.0 * (spread / 40.0).sqrt(),
        "{mean} {spread}"
    );
}

fn transform(series: &[f64]) -> Vec<Complex<f64>> {
    let mut buffer: Vec<_> = series
        .iter()
        .map(|value| Complex::new(*value, 0.0))
        .collect();
    FftPlanner::new()
        .plan_fft_forward(buffer.len())
        .process(&mut buffer);
    buffer
}

/// At v the periodogram is the scaled spectrum, with the slope -5/3 at high frequencies.
#[test]
fn the_spectrum_is_the_given_one() {
    let input = input(4096, [2, 1], 3);
    let values = generate(&input).unwrap();
    let spectrum = transform(&at(&values, 1, 0, 1));
    let power = |m: usize| spectrum[m].norm_sqr();
    let model = |m: usize| input.spectrum.spectrum(1, m as f64 / 409.6);
    for m in [2, 10, 100, 1000, 2000] {
        let ratio = power(m) / power(1) * model(1) / model(m);
        assert!((ratio - 1.0).abs() < 1e-9, "{m}: {ratio}");
    }
    // 1 to 4.9 Hz: 6 f L/V is 57 to 280, the exponent is -5/3 within 1/57
    let slope = (power(2000) / power(410)).ln() / (2000.0 / 410.0_f64).ln();
    assert!((slope + 5.0 / 3.0).abs() < 0.02, "{slope}");
}

/// Coherence of u over seeds and a band of frequencies, at two distances.
#[test]
fn the_coherence_is_the_given_one() {
    let (mut cross, mut power) = ([0.0; 2], [0.0; 3]);
    // 0.05 to 0.15 Hz, of a box of 102.4 s
    let band = 5..=15;
    for seed in 0..60 {
        let mut input = input(1024, [3, 1], 100 + seed);
        input.steps = [8.0, 8.0];
        let values = generate(&input).unwrap();
        let points = [0, 1, 2].map(|y| transform(&at(&values, y, 0, 0)));
        for m in band.clone() {
            for i in 0..3 {
                power[i] += points[i][m].norm_sqr();
            }
            for i in 0..2 {
                cross[i] += (points[0][m] * points[i + 1][m].conj()).re;
            }
        }
    }
    let kaimal = input(1024, [3, 1], 0).spectrum;
    for (i, distance) in [8.0, 16.0].into_iter().enumerate() {
        let found = cross[i] / (power[0] * power[i + 1]).sqrt();
        // the mean of the coherence, weighted by the spectrum
        let weights = band.clone().map(|m| {
            let f = m as f64 / 102.4;
            let weight = kaimal.spectrum(0, f);
            [weight, weight * kaimal.coherence(distance, f)]
        });
        let [all, part] = weights.fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
        let expected = part / all;
        // 660 samples: standard error below 1/sqrt(2 * 660) (1 - c^2), four of them
        let error = 4.0 * (1.0 - expected * expected) / 1320.0_f64.sqrt();
        assert!(
            (found - expected).abs() < error,
            "{found} {expected} {error}"
        );
    }
}

#[test]
fn seeds_decide() {
    let one = generate(&input(64, [3, 2], 1)).unwrap();
    assert_eq!(generate(&input(64, [3, 2], 1)).unwrap(), one);
    assert_ne!(generate(&input(64, [3, 2], 2)).unwrap(), one);
}

#[test]
fn a_generated_box_is_written_and_read() {
    let values = generate(&input(64, [3, 2], 1)).unwrap();
    let file = tempfile::NamedTempFile::new().unwrap();
    write_bts(file.path(), &values).unwrap();
    let read = read_bts(file.path(), None).unwrap();
    assert!(read.grid().periodic);
    let found: f64 = read.velocity(&[0.0, 0.0, 90.0], 1.0).unwrap()[0];
    assert!((found - 12.0).abs() < 8.0);
}

#[test]
fn useless_boxes_are_refused() {
    let mut wrong = input(2, [3, 0], 1);
    wrong.hub_height = -1.0;
    wrong.spectrum.sigma = f64::NAN;
    wrong.spectrum.scale = 0.0;
    wrong.exponent = Some(f64::INFINITY);
    // points, bottom, planes, sigma, scale, exponent
    assert_eq!(generate(&wrong).unwrap_err().iter().count(), 6);
    let mut still = input(16, [2, 2], 1);
    still.spectrum.sigma = 0.0;
    assert!(generate(&still).unwrap().planes[3][1].abs() < 1e-15);
}
