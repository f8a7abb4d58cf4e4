//! Modes of equal frequency: any combination of them is a mode too, and the
//! eigenvalue solver returns an arbitrary one. Those that are pure flap, lag, torsion
//! or axial motion are sought, as for a round blade at rest.
//!
//! With `G_ij = q_i^H M q_j` and the weighted energies `W_ij = q_i^H P_w M q_j`,
//! weights 1, 2, 3, 4 of the four kinds, the pure combinations are the eigenvectors of
//! `W c = w G c`. On a rotor the ways in which the blades move together have weights
//! too, parts of one, so that collective, progressive and regressive modes are separated;
//! the kinds then count on the blades alone: flap and lag of a hub are directions of the
//! model, which would part its motions into those along x and y.

use nalgebra::{Complex, DMatrix, SVD};

use super::sorted::COPIES;
use super::{ModeMotion, Rotor};
use crate::model::NamingAxes;

/// Weight of the kinds of parts other than blades, on a rotor: enough to part the motions in
/// which no blade moves.
const BESIDE_BLADES: f64 = 1e-6;

/// Replaces modes of equal frequency by pure ones; `frequencies` ascend.
pub fn separate(
    modes: &mut [ModeMotion],
    frequencies: &[f64],
    axes: &[NamingAxes],
    rotor: Option<&Rotor>,
) {
    for copies in groups(frequencies) {
        if let Some(pure) = pure_combinations(&modes[copies.clone()], axes, rotor) {
            modes[copies].clone_from_slice(&pure);
        }
    }
}

/// Replaces modes of equal frequency, of unit energy and independent as [`separate`]
/// leaves them, by those combinations that are nearest to the modes `before`, as the
/// equal blades of a rotor need: with `A = C^H M B = X S Y^H` for the copies C and the
/// modes B that they overlap with most, `C X Y^H`.
pub fn align(modes: &mut [ModeMotion], frequencies: &[f64], before: &[ModeMotion]) {
    for copies in groups(frequencies) {
        let own = modes[copies.clone()].to_vec();
        let overlap = |b: &ModeMotion| own.iter().map(|c| c.product(b).norm_sqr()).sum::<f64>();
        let mut nearest: Vec<_> = before.iter().map(|b| (overlap(b), b)).collect();
        nearest.sort_by(|a, b| b.0.total_cmp(&a.0));
        if nearest.len() < own.len() {
            continue;
        }
        let n = own.len();
        let overlaps = DMatrix::from_fn(n, n, |i, j| own[i].product(nearest[j].1));
        // The decomposition does not end on numbers that are not finite.
        if overlaps.iter().any(|value| !value.norm_sqr().is_finite()) {
            continue;
        }
        if let SVD {
            u: Some(x),
            v_t: Some(y),
            ..
        } = overlaps.svd(true, true)
        {
            let turn = x * y;
            for (j, index) in copies.enumerate() {
                modes[index] = ModeMotion::combined(&own, turn.column(j).as_slice());
            }
        }
    }
}

/// Ranges of two or more modes of equal frequency; `frequencies` ascend.
fn groups(frequencies: &[f64]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut first = 0;
    while first < frequencies.len() {
        let limit = frequencies[first] * (1.0 + COPIES);
        let count = frequencies[first..]
            .iter()
            .take_while(|f| **f <= limit)
            .count();
        let end = first + count.max(1);
        if end - first > 1 {
            found.push(first..end);
        }
        first = end;
    }
    found
}

/// `None` when the modes are not independent.
fn pure_combinations(
    modes: &[ModeMotion],
    axes: &[NamingAxes],
    rotor: Option<&Rotor>,
) -> Option<Vec<ModeMotion>> {
    let n = modes.len();
    let mut nodes = vec![if rotor.is_some() { BESIDE_BLADES } else { 1.0 }; axes.len()];
    let of_blades = rotor.iter().flat_map(|rotor| rotor.nodes());
    of_blades.for_each(|node| nodes[node] = 1.0);
    let momenta = modes
        .iter()
        .map(|m| m.weighted_momentum(axes, [1.0, 2.0, 3.0, 4.0], &nodes));
    let momenta: Vec<_> = momenta.collect();
    let parts = rotor.map(|rotor| modes.iter().map(|m| rotor.parts(m)).collect::<Vec<_>>());
    let gram = hermitian(&DMatrix::from_fn(n, n, |i, j| modes[i].product(&modes[j])));
    let weighted = hermitian(&DMatrix::from_fn(n, n, |i, j| {
        let kinds = modes[i].along(&momenta[j]);
        let together = parts.as_ref().map(|parts| parts[i].energies(&parts[j]));
        let together = together.unwrap_or_default();
        // Weights below one, apart by as much as the number of blades allows.
        let step = 0.7 / together.len().max(1) as f64;
        let ways = together
            .iter()
            .zip(1..)
            .map(|(e, k)| e * step * f64::from(k));
        kinds + ways.sum::<Complex<f64>>()
    }));
    // W c = w L L^H c with c = L^-H d: (L^-1 W L^-H) d = w d.
    let inverse = gram.cholesky()?.l().try_inverse()?;
    let standard = hermitian(&(&inverse * weighted * inverse.adjoint()));
    let vectors = inverse.adjoint() * standard.symmetric_eigen().eigenvectors;
    let combine = |j: usize| ModeMotion::combined(modes, vectors.column(j).as_slice());
    Some((0..n).map(combine).collect())
}

fn hermitian(matrix: &DMatrix<Complex<f64>>) -> DMatrix<Complex<f64>> {
    (matrix + matrix.adjoint()) * Complex::new(0.5, 0.0)
}
