//! Vectors of copies of one eigenvalue.

use faer::c64;

use super::eigenpair::Eigenpair;
use crate::model::NODE_UNKNOWNS;

/// Values within this part of each other cannot be distinguished.
const SAME: f64 = 1e-9;
/// Two unit vectors of more overlap than this are the same.
const PARALLEL: f64 = 0.9;
/// Part of itself by which a value may differ from another one that is the same.
pub(super) const CONFIRMED: f64 = 1e-3;
/// Part of a unit vector outside of the space of the copies of its value above which it is a new one.
const APART: f64 = 0.03;

/// Values that are the same up to round-off, put together; ascending.
pub(super) fn groups(values: &[c64]) -> Vec<Vec<c64>> {
    let mut sorted = values.to_vec();
    sorted.sort_by(|a, b| a.im.total_cmp(&b.im).then(a.re.total_cmp(&b.re)));
    let mut groups: Vec<Vec<c64>> = Vec::new();
    for value in sorted {
        match groups.last_mut() {
            Some(group) if (value - group[0]).norm() <= SAME * value.norm() => group.push(value),
            _ => groups.push(vec![value]),
        }
    }
    groups
}

/// Whether no two of the vectors are nearly parallel.
pub(super) fn is_independent(pairs: &[Eigenpair]) -> bool {
    let vectors: Vec<_> = pairs.iter().map(Eigenpair::vector).collect();
    // The vectors are of unit size.
    let overlap = |i: usize, j: usize| product(&vectors[i], &vectors[j], vectors[i].len()).norm();
    (0..vectors.len()).all(|i| (0..i).all(|j| overlap(i, j) < PARALLEL))
}

/// Whether the values of two pairs may be copies of one.
pub(super) fn is_near(a: &Eigenpair, b: &Eigenpair) -> bool {
    (a.value() - b.value()).norm() <= CONFIRMED * a.value().norm()
}

/// Whether a pair is none of the known ones, and no combination of copies among them.
pub fn is_new(pair: &Eigenpair, known: &[Eigenpair]) -> bool {
    let size = pair.real.len();
    let near = known.iter().filter(|other| is_near(pair, other));
    let near = near.map(Eigenpair::vector);
    let mut basis: Vec<_> = near.collect();
    orthonormalize(&mut basis, size);
    let mut own = pair.vector();
    orthonormalize(std::slice::from_mut(&mut own), size);
    let parts = basis.iter().map(|one| product(one, &own, size).norm_sqr());
    1.0 - parts.sum::<f64>() > APART * APART
}

/// `a^H b` over the positions and rotations of the nodes: the reactions, which follow
/// from these, are larger by the stiffness and would hide them.
pub(super) fn product(a: &[c64], b: &[c64], size: usize) -> c64 {
    let is_motion = |i: &usize| i % NODE_UNKNOWNS < NODE_UNKNOWNS / 2;
    (0..size)
        .filter(is_motion)
        .map(|i| a[i].conj() * b[i])
        .sum()
}

/// Orthonormalizes by Gram and Schmidt, twice for the round-off.
pub(super) fn orthonormalize(vectors: &mut [Vec<c64>], size: usize) {
    for j in 0..vectors.len() {
        let (before, rest) = vectors.split_at_mut(j);
        let vector = &mut rest[0];
        for other in before.iter().chain(before.iter()) {
            let along = product(other, vector, size);
            vector
                .iter_mut()
                .zip(other)
                .for_each(|(v, o)| *v -= along * o);
        }
        let norm = product(vector, vector, size).re.sqrt();
        if norm > 0.0 {
            vector.iter_mut().for_each(|v| *v /= norm);
        }
    }
}
