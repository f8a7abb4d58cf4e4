//! Modes of equal multipliers: any combination of them is a mode too. Uncoupled blades of a rotor have the same
//! multiplier in each pattern; the modes that are one pattern each are sought.
//!
//! With `G_ij = v_i^H M v_j` and the energies `W_ij` of the patterns, each with a weight of its own, the pure
//! combinations are the eigenvectors of `W c = w G c`.

use faer::c64;
use nalgebra::{Complex, DMatrix};

use super::content::{Motion, Observer};
use crate::model::NODE_UNKNOWNS;
use crate::solver::{Largest, Ritz};

/// Distance of equal multipliers relative to their size.
const EQUAL: f64 = 1e-6;
/// Error of multipliers by the round-off of the period, in size up to one: strongly damped ones differ by it.
const ROUND_OFF: f64 = 1e-11;

/// Replaces modes of equal multipliers by pure ones; `sizes` are the ones of the unknowns.
pub(super) fn separate(found: &mut Largest, observer: &Observer<'_>, sizes: &[f64]) {
    let pairs = &mut found.pairs;
    for first in 0..pairs.len() {
        let value = pairs[first].value;
        let is_equal = |own: &Ritz| (own.value - value).norm() <= EQUAL * value.norm() + ROUND_OFF;
        let copies: Vec<_> = (0..pairs.len()).filter(|i| is_equal(&pairs[*i])).collect();
        if copies.len() < 2 || copies[0] != first {
            continue;
        }
        let own: Vec<_> = copies.iter().map(|i| pairs[*i].clone()).collect();
        if let Some(factors) = pure(&own, observer, sizes) {
            for (column, index) in copies.into_iter().enumerate() {
                pairs[index].vector = combined(&own, factors.column(column).as_slice());
            }
        }
    }
}

/// The combinations (columns) that are pure; `None` if the motions are not independent.
fn pure(pairs: &[Ritz], observer: &Observer<'_>, sizes: &[f64]) -> Option<DMatrix<Complex<f64>>> {
    let n = pairs.len();
    let is_real = pairs.iter().all(|pair| pair.value.im == 0.0);
    let patterns = pairs.iter().map(|pair| {
        let motion = motion(pair, sizes, observer.masses.len());
        observer.patterns(motion, is_real)
    });
    let patterns: Vec<_> = patterns.collect();
    let mut gram = DMatrix::<Complex<f64>>::zeros(n, n);
    let mut weighted = gram.clone();
    let product = |a: &[Complex<f64>], b: &[Complex<f64>]| {
        let terms = a.iter().zip(b).map(|(a, b)| a.conj() * b);
        terms.sum::<Complex<f64>>()
    };
    for i in 0..n {
        for j in 0..n {
            let pairs = patterns[i].iter().zip(&patterns[j]);
            for (number, ((_, a), (_, b))) in pairs.enumerate() {
                let energy = product(a, b);
                gram[(i, j)] += energy;
                weighted[(i, j)] += energy * number as f64;
            }
        }
    }
    // W c = w L L^H c with c = L^-H d: (L^-1 W L^-H) d = w d.
    let inverse = gram.cholesky()?.l().try_inverse()?;
    let standard = &inverse * weighted * inverse.adjoint();
    let standard = (&standard + standard.adjoint()) * Complex::from(0.5);
    if standard.iter().any(|value| !value.norm_sqr().is_finite()) {
        return None;
    }
    Some(inverse.adjoint() * standard.symmetric_eigen().eigenvectors)
}

/// Position and rotation of each node in the vector of a multiplier.
fn motion(pair: &Ritz, sizes: &[f64], nodes: usize) -> Vec<[Motion; 2]> {
    let value = |i: usize| Complex::new(pair.vector[0][i], pair.vector[1][i]) * sizes[i];
    let vector = |i: usize| Motion::new(value(i), value(i + 1), value(i + 2));
    let of_node = |node: usize| [0, 3].map(|first| vector(NODE_UNKNOWNS * node + first));
    (0..nodes).map(of_node).collect()
}

/// The sum of the vectors, each times its factor, of unit length.
fn combined(pairs: &[Ritz], factors: &[Complex<f64>]) -> [Vec<f64>; 2] {
    let size = pairs.first().map_or(0, |pair| pair.vector[0].len());
    let mut sum = vec![c64::new(0.0, 0.0); size];
    for (pair, factor) in pairs.iter().zip(factors) {
        for (i, sum) in sum.iter_mut().enumerate() {
            *sum += c64::new(pair.vector[0][i], pair.vector[1][i]) * c64::new(factor.re, factor.im);
        }
    }
    let length = sum.iter().map(|own| own.norm_sqr()).sum::<f64>().sqrt();
    let length = if length > 0.0 { length } else { 1.0 };
    [
        sum.iter().map(|own| own.re / length).collect(),
        sum.iter().map(|own| own.im / length).collect(),
    ]
}
