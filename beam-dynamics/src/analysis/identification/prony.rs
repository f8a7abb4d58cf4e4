//! Prony's sum by the matrix pencil [HuaSarkar1990].
//!
//! The samples `y_n = sum_m c_m z_m^n` of M poles fill a Hankel matrix of rank M. With the first M
//! right singular vectors V, without their last row (V1) and without their first (V2):
//!
//! ```text
//! H_ij = y_{i+j} = U S V^T        z_m = eigenvalues of V1^+ V2        s_m = ln z_m / dt
//! ```
//!
//! and the c_m follow by least squares.

use std::f64::consts::PI;

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use nalgebra::Complex;

use super::record::Thinned;
use crate::result::{IdentificationMethod, IdentifiedMode};

/// Most poles.
const MOST: usize = 60;
/// Angle of a pole below which it does not oscillate, as a part of one turn over the record.
const SLOW: f64 = 0.25;

/// Prony's sum.
pub(super) struct Sum {
    /// The oscillations, the largest part of the record first.
    pub modes: Vec<IdentifiedMode>,
    /// Root mean square of the rest over the one of the record without its constant \[-\].
    pub residual: f64,
}

/// The sum of a record; singular values below the part `noise` of the largest are noise. `None` if a
/// decomposition did not converge.
pub(super) fn sum(thinned: &Thinned, noise: f64) -> Option<Sum> {
    let values = &thinned.record.values;
    let (count, step) = (values.len(), thinned.record.step);
    let mean = values.iter().sum::<f64>() / count as f64;
    let moving: Vec<f64> = values.iter().map(|value| value - mean).collect();
    let size = root_mean_square(&moving);
    let largest = values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    if size <= f64::EPSILON * largest {
        return Some(Sum {
            modes: Vec::new(),
            residual: 0.0,
        });
    }
    let poles = poles(&moving, noise)?;
    let (coefficients, fitted) = amplitudes(&poles, &moving);
    let parts = poles
        .iter()
        .zip(coefficients)
        .filter_map(|(pole, coefficient)| {
            let exponent = pole.ln() / step;
            let is_slow = pole.arg() * (count as f64) < SLOW * 2.0 * PI;
            // Poles on the negative axis alternate from sample to sample.
            let alternates = PI - pole.arg() < 1e-6;
            (!is_slow && !alternates).then(|| {
                let part = (0..count).map(|n| 2.0 * (coefficient * pole.powu(n as u32)).re);
                let filter = thinned.response(exponent).norm();
                IdentifiedMode {
                    method: IdentificationMethod::Prony,
                    frequency: exponent.im,
                    growth: exponent.re,
                    amplitude: Some(2.0 * coefficient.norm() / filter),
                    share: Some(root_mean_square(&part.collect::<Vec<_>>()) / size),
                    scatter: None,
                }
            })
        });
    let mut modes: Vec<_> = parts.collect();
    modes.sort_by(|a, b| b.share.unwrap_or(0.0).total_cmp(&a.share.unwrap_or(0.0)));
    let rest: Vec<f64> = moving.iter().zip(&fitted).map(|(y, fit)| y - fit).collect();
    Some(Sum {
        modes,
        residual: root_mean_square(&rest) / size,
    })
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// The poles, those above the real axis and on it.
fn poles(values: &[f64], noise: f64) -> Option<Vec<Complex<f64>>> {
    let pencil = values.len() / 3;
    let rows = values.len() - pencil;
    let hankel = Mat::from_fn(rows, pencil + 1, |i, j| values[i + j]);
    let decomposed = hankel.thin_svd().ok()?;
    let sizes = decomposed.S().column_vector();
    let least = noise * sizes[0];
    let rank = (0..sizes.nrows()).take_while(|&i| sizes[i] > least).count();
    let rank = rank.clamp(1, MOST.min(pencil / 2).max(1));
    let vectors = decomposed.V();
    let (first, second) = (
        vectors.submatrix(0, 0, pencil, rank),
        vectors.submatrix(1, 0, pencil, rank),
    );
    let solved = first.col_piv_qr().solve_lstsq(second);
    let found = solved.submatrix(0, 0, rank, rank).eigenvalues().ok()?;
    let found = found.into_iter().map(|pole| Complex::new(pole.re, pole.im));
    Some(
        found
            .filter(|pole| pole.im >= 0.0 && pole.norm() > 0.0)
            .collect(),
    )
}

/// The coefficients c of the poles above the axis, and the sum at the samples.
fn amplitudes(poles: &[Complex<f64>], values: &[f64]) -> (Vec<Complex<f64>>, Vec<f64>) {
    let count = values.len();
    // Growing motions are scaled by their last sample: no power overflows.
    let scale = |pole: &Complex<f64>| {
        if pole.norm() > 1.0 {
            pole.powu(count as u32 - 1).norm()
        } else {
            1.0
        }
    };
    let scales: Vec<f64> = poles.iter().map(scale).collect();
    // y = sum a Re z^n - b Im z^n, with 2 c = a + i b; poles on the axis have no b.
    let parts: Vec<(usize, bool)> = (0..poles.len())
        .flat_map(|j| [(j, false), (j, true)])
        .filter(|&(j, is_second)| !is_second || poles[j].im > 0.0)
        .collect();
    let columns = Mat::from_fn(count, parts.len(), |n, column| {
        let (j, is_second) = parts[column];
        let power = poles[j].powu(n as u32) / scales[j];
        if is_second { -power.im } else { power.re }
    });
    let right = Mat::from_fn(count, 1, |n, _| values[n]);
    let found = columns.col_piv_qr().solve_lstsq(&right);
    let mut coefficients = vec![Complex::new(0.0, 0.0); poles.len()];
    let mut fitted = vec![0.0; count];
    for (column, &(j, is_second)) in parts.iter().enumerate() {
        let value = found[(column, 0)];
        let half = value / (2.0 * scales[j]);
        coefficients[j] += if is_second {
            Complex::new(0.0, half)
        } else {
            Complex::new(half, 0.0)
        };
        for (n, fit) in fitted.iter_mut().enumerate() {
            *fit += value * columns[(n, column)];
        }
    }
    (coefficients, fitted)
}
