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
/// Relative distance of values that are nearly equal.
const NEAR: f64 = 1e-4;
/// Share of the energy of the blades from which on a mode has one pattern.
const ONE_PATTERN: f64 = 0.9999;

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

/// Replaces modes whose `values` \[1/s\] are nearly equal by the combinations for which a Hermitian `form` of two
/// modes has the values of one of its parts, such as the energies of patterns times a number of each.
pub fn separate_by(
    modes: &mut [ModeMotion],
    values: &[Complex<f64>],
    form: impl Fn(&ModeMotion, &ModeMotion) -> Complex<f64>,
) {
    for first in 0..modes.len() {
        let is_copy =
            |i: &usize| (values[*i] - values[first]).norm() <= COPIES * values[first].norm();
        let copies: Vec<_> = (0..modes.len()).filter(is_copy).collect();
        if copies.len() < 2 || copies[0] != first {
            continue;
        }
        let own: Vec<_> = copies.iter().map(|i| modes[*i].clone()).collect();
        let n = own.len();
        let weighted = DMatrix::from_fn(n, n, |i, j| form(&own[i], &own[j]));
        for (index, pure) in copies
            .into_iter()
            .zip(pure(&own, &weighted).into_iter().flatten())
        {
            modes[index] = pure;
        }
    }
}

/// Replaces modes of a rotor whose `values` \[1/s\] are nearly equal by combinations in which the blades have one
/// pattern each, if these exist: the round-off of nearly equal values mixes their vectors. Each combination takes
/// the place of the mode that it is most of.
pub fn separate_patterns(modes: &mut [ModeMotion], values: &[Complex<f64>], rotor: &Rotor) {
    for first in 0..modes.len() {
        let is_near =
            |i: &usize| (values[*i] - values[first]).norm() <= NEAR * values[first].norm();
        let near: Vec<_> = (0..modes.len()).filter(is_near).collect();
        let own: Vec<_> = near.iter().map(|i| modes[*i].clone()).collect();
        if near.len() < 2 || near[0] != first || is_pure(&own, rotor) {
            continue;
        }
        let Some(pure) = pure_patterns(&own, rotor).filter(|pure| is_pure(pure, rotor)) else {
            continue;
        };
        let mut free: Vec<_> = (0..near.len()).collect();
        for mode in pure {
            let part = |place: &usize| own[*place].product(&mode).norm_sqr();
            let most = (0..free.len()).max_by(|a, b| part(&free[*a]).total_cmp(&part(&free[*b])));
            if let Some(most) = most {
                modes[near[free.swap_remove(most)]] = mode;
            }
        }
    }
}

/// Whether the blades have one pattern in each mode in which they move.
fn is_pure(modes: &[ModeMotion], rotor: &Rotor) -> bool {
    let mut whirls = modes.iter().filter_map(|mode| rotor.whirl(mode));
    whirls.all(|whirl| whirl.share >= ONE_PATTERN)
}

/// The combinations of modes with one pattern each; `None` if the modes are not independent.
fn pure_patterns(modes: &[ModeMotion], rotor: &Rotor) -> Option<Vec<ModeMotion>> {
    let parts: Vec<_> = modes.iter().map(|mode| rotor.parts(mode)).collect();
    let weighted = DMatrix::from_fn(modes.len(), modes.len(), |i, j| {
        let energies = parts[i].energies(&parts[j]).into_iter().zip(1..);
        let weighted = energies.map(|(energy, number)| energy * f64::from(number));
        weighted.sum::<Complex<f64>>()
    });
    pure(modes, &weighted)
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
    let weighted = DMatrix::from_fn(n, n, |i, j| {
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
    });
    pure(modes, &weighted)
}

/// The combinations of modes that are pure by weighted energies; `None` if the modes are not independent.
fn pure(modes: &[ModeMotion], weighted: &DMatrix<Complex<f64>>) -> Option<Vec<ModeMotion>> {
    let n = modes.len();
    let gram = hermitian(&DMatrix::from_fn(n, n, |i, j| modes[i].product(&modes[j])));
    let weighted = hermitian(weighted);
    if weighted.iter().any(|value| !value.norm_sqr().is_finite()) {
        return None;
    }
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
