//! Turbulence boxes from Kaimal spectra by the method of Veers (1988).
//!
//! ```text
//! C_jk = Coh(r_jk, f),   C = H H^T,   u_j(t) = sum_f A(f) sum_k H_jk cos(2 pi f t + phi_k(f))
//! A(f)^2/2 = S(f) df, scaled so that the sum over all f of the box is sigma^2
//! ```
//!
//! u is coherent; v and w have independent phases at each point (the standard has no coherence
//! for them). The box is periodic. Equal seeds give equal boxes on all machines of equal `sin` and
//! `cos`.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use shared_geom::error::Diagnostics;

use super::grid::{BoxGrid, BoxValues, report, wrong};
use super::kaimal::Kaimal;
use super::profile::{MeanWind, Shear};

/// A box to be generated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneratorInput {
    /// Spectra.
    pub spectrum: Kaimal,
    /// Height of the hub: the middle of the box \[m\].
    pub hub_height: f64,
    /// Exponent of the power law of the mean wind, which is a part of u; without it u is the deviation
    /// alone \[-\].
    pub exponent: Option<f64>,
    /// Number of time steps.
    pub planes: usize,
    /// Number of points along y and z.
    pub points: [usize; 2],
    /// Time step \[s\].
    pub time_step: f64,
    /// Distance of points along y and z \[m\].
    pub steps: [f64; 2],
    /// Seed of the phases.
    pub seed: u64,
}

impl GeneratorInput {
    fn grid(&self) -> BoxGrid {
        let [lateral, vertical] = self.points;
        let [lateral_step, vertical_step] = self.steps;
        let height = vertical_step * vertical.saturating_sub(1) as f64;
        BoxGrid {
            planes: self.planes,
            lateral,
            vertical,
            tower: 0,
            time_step: self.time_step,
            lateral_step,
            vertical_step,
            speed: self.spectrum.speed,
            bottom: self.hub_height - 0.5 * height,
            hub_height: self.hub_height,
            periodic: true,
        }
    }

    fn check(&self, grid: &BoxGrid) -> Result<(), Diagnostics> {
        let mut problems = grid.problems();
        if grid.bottom.is_nan() || grid.bottom <= 0.0 {
            problems.push(wrong(
                "bottom of the box [m]",
                grid.bottom,
                "above the ground",
            ));
        }
        if self.planes < 4 {
            let what = "number of planes of the box";
            problems.push(wrong(what, self.planes as f64, "at least 4"));
        }
        let Kaimal { sigma, scale, .. } = self.spectrum;
        if !(sigma >= 0.0 && sigma.is_finite()) {
            problems.push(wrong("standard deviation [m/s]", sigma, "zero or more"));
        }
        if !(scale > 0.0 && scale.is_finite()) {
            problems.push(wrong("scale of turbulence [m]", scale, "a positive number"));
        }
        if let Some(exponent) = self.exponent.filter(|exponent| !exponent.is_finite()) {
            problems.push(wrong("exponent of the power law", exponent, "a number"));
        }
        report("the generated box", &problems)
    }
}

/// Random phases from 0 to 2 pi.
struct Phases(Pcg64Mcg);

impl Phases {
    fn next(&mut self) -> f64 {
        TAU * (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn unit(&mut self) -> Complex<f64> {
        Complex::from_polar(1.0, self.next())
    }
}

/// Amplitudes per component and frequency 1, 2, ...: `A(f)`.
fn amplitudes(input: &GeneratorInput, component: usize) -> Vec<f64> {
    let step = 1.0 / (input.time_step * input.planes as f64);
    // without the highest frequency, whose phase is not free
    let frequencies = 1..input.planes.div_ceil(2);
    let spectrum = |m: usize| input.spectrum.spectrum(component, step * m as f64);
    let densities: Vec<f64> = frequencies.map(spectrum).collect();
    let sigma = input.spectrum.sigmas()[component];
    let sum: f64 = densities.iter().sum();
    if sum.is_nan() || sum <= 0.0 {
        return vec![0.0; densities.len()];
    }
    let scaled = |density: &f64| (2.0 * sigma * sigma * density / sum).sqrt();
    densities.iter().map(scaled).collect()
}

/// Distances of all points from each other \[m\].
fn distances(grid: &BoxGrid) -> DMatrix<f64> {
    let count = grid.lateral * grid.vertical;
    let at = |point: usize| {
        let (z, y) = (point / grid.lateral, point % grid.lateral);
        [y as f64 * grid.lateral_step, z as f64 * grid.vertical_step]
    };
    DMatrix::from_fn(count, count, |j, k| {
        let [a, b] = [at(j), at(k)];
        (a[0] - b[0]).hypot(a[1] - b[1])
    })
}

/// Spectra of u at all points, one list of the frequencies 1, 2, ... per point.
fn coherent(input: &GeneratorInput, grid: &BoxGrid, phases: &mut Phases) -> Vec<Vec<Complex<f64>>> {
    let amplitudes = amplitudes(input, 0);
    let distances = distances(grid);
    let count = distances.nrows();
    let step = 1.0 / (input.time_step * input.planes as f64);
    let mut all = vec![Vec::with_capacity(amplitudes.len()); count];
    for (index, amplitude) in amplitudes.iter().enumerate() {
        let frequency = step * (index + 1) as f64;
        let draw = DVector::from_fn(count, |_, _| phases.unit());
        let coherence = distances.map(|r| input.spectrum.coherence(r, frequency));
        // a factor exists: an exponential of the distance is positive definite
        let factor = coherence.cholesky().map(|factor| factor.unpack());
        for (j, list) in all.iter_mut().enumerate() {
            let sum = match &factor {
                Some(h) => (0..=j).map(|k| draw[k] * h[(j, k)]).sum(),
                None => draw[j],
            };
            list.push(sum * *amplitude);
        }
    }
    all
}

/// Spectrum of v or w at one point.
fn independent(amplitudes: &[f64], phases: &mut Phases) -> Vec<Complex<f64>> {
    amplitudes
        .iter()
        .map(|amplitude| phases.unit() * *amplitude)
        .collect()
}

/// The velocity over time of a spectrum: `Re sum_m X_m exp(2 pi i m n/N)`.
fn series(spectrum: &[Complex<f64>], planes: usize, fft: &dyn Fft<f64>) -> Vec<f64> {
    let mut buffer = vec![Complex::new(0.0, 0.0); planes];
    buffer[1..=spectrum.len()].copy_from_slice(spectrum);
    fft.process(&mut buffer);
    buffer.iter().map(|value| value.re).collect()
}

/// Generates a periodic box.
///
/// # Errors
/// All numbers that are not usable, among them a box that reaches below the ground.
pub fn generate(input: &GeneratorInput) -> Result<BoxValues, Diagnostics> {
    let grid = input.grid();
    input.check(&grid)?;
    let mut phases = Phases(Pcg64Mcg::seed_from_u64(input.seed));
    let fft = FftPlanner::new().plan_fft_inverse(input.planes);
    let mean = MeanWind {
        speed: input.exponent.map_or(0.0, |_| input.spectrum.speed),
        reference_height: input.hub_height,
        shear: Shear::Power {
            exponent: input.exponent.unwrap_or_default(),
        },
        ..MeanWind::default()
    };
    let mut planes = vec![vec![0.0; grid.values()]; grid.planes];
    let mut add = |point: usize, component: usize, spectrum: &[Complex<f64>], mean: f64| {
        let series = series(spectrum, input.planes, fft.as_ref());
        for (plane, value) in planes.iter_mut().zip(series) {
            plane[3 * point + component] = value + mean;
        }
    };
    for (point, spectrum) in coherent(input, &grid, &mut phases).iter().enumerate() {
        let z = grid.bottom + (point / grid.lateral) as f64 * grid.vertical_step;
        add(point, 0, spectrum, mean.velocity(&[0.0, 0.0, z], 0.0)[0]);
    }
    for component in [1, 2] {
        let amplitudes = amplitudes(input, component);
        for point in 0..grid.lateral * grid.vertical {
            let spectrum = independent(&amplitudes, &mut phases);
            add(point, component, &spectrum, 0.0);
        }
    }
    Ok(BoxValues { grid, planes })
}

#[cfg(test)]
#[path = "generate_tests.rs"]
mod tests;
