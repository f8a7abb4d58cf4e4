//! Modes of systems with many slow states, such as the lags of the air at a blade.
//!
//! The states of some hundred strips are eigenvalues of the size of the lowest frequencies: the eigenvalues
//! nearest to zero are theirs. And the air damps the flapping of blades so much that no system without lags has
//! values near it. The air hardly changes the magnitude of a value, so that the mode of frequency w of the
//! structure alone is near the arc
//!
//! ```text
//! s = w (-zeta + i sqrt(1 - zeta^2)) ,     0 <= zeta < 1                                (D-430)
//! ```
//!
//! The eigenvalues are found in the space of the shapes x of the modes of the structure, and of the answers of the
//! complete system to each at shifts on its arc,
//!
//! ```text
//! y = (F_y + s F_y')^-1 F_y' x
//! ```
//!
//! which have the states of the air that each motion causes. A value of the space that is nearly one of the system is
//! corrected by inverse iteration ([`super::refined`]).

use faer::{Mat, c64};
use nalgebra::Complex;

use super::assignment::{assign, unlikeness};
use super::copies::{is_near, is_new};
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use super::motion::{MassMatrix, ModeMotion};
use super::sorted::Sorted;
use crate::assembly::Tangent;
use crate::model::NODE_UNKNOWNS;

/// Imaginary part of an oscillation as a part of its magnitude: pairs below it, of a damping ratio above
/// 0.95, are slow states that are coupled.
const OSCILLATES: f64 = 0.3;
/// Damping ratios of the shifts on an arc.
const DAMPING: [f64; 4] = [0.0, 0.3, 0.6, 0.85];
/// Modes of the space beyond the wanted ones.
const SPARE: usize = 4;
/// Error of a value of the space, relative, from which it is corrected.
const SEEN: f64 = 0.1;
/// Overlap of the shapes before and after the correction, below which the iteration has left the mode.
const SAME_SHAPE: f64 = 0.5;
impl EigenProblem<'_> {
    /// Whether slow values of scalars leave no `count` oscillations among the nearest values.
    pub(super) fn is_crowded(&self, sorted: &Sorted, count: usize) -> bool {
        let oscillates = |s: &&c64| s.im > OSCILLATES * s.norm();
        let found = sorted.above.iter().filter(oscillates).count();
        let slow = sorted.zeros + sorted.real.len() + sorted.above.len() - found;
        found < count && slow >= count && self.has_slow_scalars()
    }

    /// The `count` oscillations of lowest frequency of a system in which no air acts, and the other copies of
    /// the last one; scalars, such as states of the air, follow without lag.
    pub fn structural(&self, count: usize) -> Vec<Eigenpair> {
        match self.without_circuits(self.tangent()) {
            Some(alone) => self.lowest_of(&alone, count),
            None => self.lowest_complete(count),
        }
    }

    /// The same of another system, without scalars that lag.
    fn lowest_of(&self, tangent: &Tangent, count: usize) -> Vec<Eigenpair> {
        let problem = self.beside(tangent);
        problem.map_or_else(Vec::new, |problem| problem.lowest_complete(count))
    }

    /// The `count` oscillations of lowest frequency, and the other copies of the last one.
    fn lowest_complete(&self, count: usize) -> Vec<Eigenpair> {
        let mut pairs = self.lowest(count + self.copies()).pairs;
        pairs.truncate(with_copies(&pairs, count));
        pairs
    }

    /// The oscillations that are the `count` lowest modes of the structure alone, or else others of lowest magnitude, with
    /// the ones that grow, by ascending frequency; and the number of modes that are none of them.
    pub(super) fn beside_states(&self, count: usize) -> (Vec<Eigenpair>, usize) {
        let alone = self.without_circuits(self.vacuum().unwrap_or(self.tangent()));
        let modes = alone.map_or_else(Vec::new, |alone| self.lowest_of(&alone, count + SPARE));
        let found = self.confirmed_of(&self.in_space_of(&modes));
        let mass = MassMatrix::new(&self.tangent().by_rates, self.size() / NODE_UNKNOWNS);
        let mode_of = modes_of((&found, &modes), &mass);
        let wanted = modes.len().min(count);
        let has_mode = |mode: &usize| mode_of.contains(&Some(*mode));
        let lost = wanted - (0..wanted).filter(has_mode).count();
        let mut others: Vec<_> = (0..found.len())
            .filter(|root| mode_of[*root].is_none())
            .collect();
        let size = |root: usize| found[root].value().norm();
        others.sort_by(|a, b| size(*a).total_cmp(&size(*b)));
        others.truncate(lost);
        let is_wanted = |root: &usize| {
            let is_mode = mode_of[*root].is_some_and(|mode| mode < wanted);
            is_mode || others.contains(root) || found[*root].growth > 0.0
        };
        let wanted = (0..found.len()).filter(is_wanted);
        let mut pairs: Vec<_> = wanted.map(|root| found[root].clone()).collect();
        pairs.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
        (pairs, lost)
    }

    /// The oscillations of this system to which values of a space lead, accurate ones first.
    fn confirmed_of(&self, seen: &[Eigenpair]) -> Vec<Eigenpair> {
        let mut known: Vec<Eigenpair> = Vec::new();
        let mut used = vec![false; seen.len()];
        for (index, first) in seen.iter().enumerate() {
            if used[index] || first.residual > SEEN {
                continue;
            }
            let copies =
                (index..seen.len()).filter(|other| !used[*other] && is_near(first, &seen[*other]));
            let copies: Vec<_> = copies.collect();
            let Some(found) = self.refined((first, first.value()), SAME_SHAPE) else {
                continue;
            };
            // The vectors of copies in the space are not independent.
            let pairs = match copies.len() {
                1 => vec![found.clone()],
                count => self.vectors(&vec![found.value(); count]),
            };
            copies.iter().for_each(|copy| used[*copy] = true);
            for pair in pairs {
                let oscillates = pair.value().im > OSCILLATES * pair.value().norm();
                if oscillates && is_near(&found, &pair) && is_new(&pair, &known) {
                    known.push(pair);
                }
            }
        }
        known
    }

    /// Values of this system in the space of modes and of its answers to them, with their relative errors, accurate
    /// ones first.
    fn in_space_of(&self, modes: &[Eigenpair]) -> Vec<Eigenpair> {
        let size = self.size();
        let all = self.tangent().by_rates.pattern().size();
        let whole = |pair: &Eigenpair| {
            let mut vector = pair.vector();
            vector.resize(all, c64::new(0.0, 0.0));
            vector
        };
        let mut columns: Vec<Vec<c64>> = modes.iter().map(whole).collect();
        for copies in modes.chunk_by(is_near) {
            let starts: Vec<_> = copies
                .iter()
                .map(|own| self.rates_times(&whole(own)))
                .collect();
            let frequency = copies[0].value().norm();
            let shifts =
                DAMPING.map(|ratio| frequency * c64::new(-ratio, (1.0 - ratio * ratio).sqrt()));
            for shift in shifts.into_iter().filter(|shift| shift.norm() > 0.0) {
                let matrix = self.factorized(shift);
                let answer = |start: &Vec<c64>| {
                    let mut answer = start.clone();
                    matrix.as_ref()?.solve(&mut answer)?;
                    Some(answer)
                };
                columns.extend(starts.iter().filter_map(answer));
            }
        }
        let part = |i: usize, j: usize| {
            let entry = columns[j / 2][i];
            [entry.re, entry.im][j % 2]
        };
        let within = self
            .inverse()
            .within(&Mat::from_fn(all, 2 * columns.len(), part));
        let pair = |(s, vector, error): (c64, Mat<f64>, f64)| {
            let vector: Vec<_> = (0..size)
                .map(|i| c64::new(vector[(i, 0)], vector[(i, 1)]))
                .collect();
            Eigenpair::new(s, &vector, error)
        };
        let mut found: Vec<_> = within.into_iter().map(pair).collect();
        found.sort_by(|a, b| a.residual.total_cmp(&b.residual));
        found
    }
}

/// The mode of each root ([`assign`]), with the part of its energy in the space of the modes of one frequency as MAC.
fn modes_of((roots, modes): (&[Eigenpair], &[Eigenpair]), mass: &MassMatrix) -> Vec<Option<usize>> {
    let shapes: Vec<_> = roots
        .iter()
        .map(|root| ModeMotion::new(root, mass))
        .collect();
    let mut assurances: Vec<Vec<f64>> = vec![Vec::new(); roots.len()];
    for copies in modes.chunk_by(is_near) {
        let mut basis: Vec<ModeMotion> = Vec::new();
        for copy in copies {
            let own = ModeMotion::new(copy, mass);
            let along = basis.iter().map(|other| -other.product(&own));
            let factors: Vec<_> = along.chain([Complex::new(1.0, 0.0)]).collect();
            let all: Vec<_> = basis.iter().chain([&own]).cloned().collect();
            basis.push(ModeMotion::combined(&all, &factors));
        }
        for (own, shape) in assurances.iter_mut().zip(&shapes) {
            let parts = basis.iter().map(|mode| mode.product(shape).norm_sqr());
            own.extend(std::iter::repeat_n(parts.sum::<f64>(), copies.len()));
        }
    }
    let sizes = |root: usize, mode: usize| [roots[root].value().norm(), modes[mode].value().norm()];
    assign([roots.len(), modes.len()], |root, mode| {
        unlikeness(sizes(root, mode), assurances[root][mode])
    })
}

/// The number of the first `count` pairs, as far as there are so many, and of the other copies of the last one.
fn with_copies(pairs: &[Eigenpair], count: usize) -> usize {
    let count = count.min(pairs.len());
    let last = pairs[..count].last();
    let copies = pairs[count..].iter();
    count
        + copies
            .take_while(|pair| last.is_some_and(|last| is_near(last, pair)))
            .count()
}
