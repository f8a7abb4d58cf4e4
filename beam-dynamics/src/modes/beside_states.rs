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

use super::copies::{CONFIRMED, groups, is_new};
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use super::sorted::Sorted;
use crate::assembly::Tangent;

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
        self.structural_of(self.tangent(), count)
    }

    fn structural_of(&self, tangent: &Tangent, count: usize) -> Vec<Eigenpair> {
        let alone = self.without_circuits(tangent);
        let problem = self.beside(alone.as_ref().unwrap_or(tangent));
        problem.map_or_else(Vec::new, |problem| problem.lowest_complete(count))
    }

    /// The `count` oscillations of lowest frequency, and the other copies of the last one.
    fn lowest_complete(&self, count: usize) -> Vec<Eigenpair> {
        let mut pairs = self.lowest(count + self.copies()).pairs;
        let last = pairs.get(count.saturating_sub(1)).map(Eigenpair::value);
        let is_copy = |pair: &Eigenpair| {
            last.is_some_and(|last| (pair.value() - last).norm() <= CONFIRMED * last.norm())
        };
        let copies = pairs.iter().skip(count).take_while(|pair| is_copy(pair));
        pairs.truncate(count + copies.count());
        pairs
    }

    /// The `count` oscillations of lowest magnitude and copies of the last one, with others that grow, by ascending frequency; and how many fewer
    /// they are than the modes of the structure.
    pub(super) fn beside_states(&self, count: usize) -> (Vec<Eigenpair>, usize) {
        let alone = self.vacuum().unwrap_or(self.tangent());
        let modes = self.structural_of(alone, count + SPARE);
        let mut found = self.confirmed_of(&self.in_space_of(&modes));
        found.sort_by(|a, b| a.value().norm().total_cmp(&b.value().norm()));
        let wanted = modes.len().min(count);
        let lost = wanted.saturating_sub(found.len());
        let after = found.get(..count).and_then(<[_]>::last).cloned();
        let copies = found.iter().skip(count);
        let copies =
            copies.take_while(|pair| after.as_ref().is_some_and(|last| is_near(last, pair)));
        let first = (count + copies.count()).min(found.len());
        let beyond = found.split_off(first);
        found.extend(beyond.into_iter().filter(|pair| pair.growth > 0.0));
        found.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
        (found, lost)
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
        let mut columns: Vec<Vec<c64>> = Vec::new();
        for pair in modes {
            let mut start = pair.vector();
            start.resize(all, c64::new(0.0, 0.0));
            columns.push(start);
        }
        let frequency = |pair: &Eigenpair| c64::new(0.0, pair.angular_frequency);
        for group in groups(&modes.iter().map(frequency).collect::<Vec<_>>()) {
            let own = modes.iter().zip(&columns);
            let own = own.filter(|(pair, _)| group.contains(&frequency(pair)));
            let starts: Vec<_> = own.map(|(_, start)| self.rates_times(start)).collect();
            for ratio in DAMPING {
                let shift = group[0].im * c64::new(-ratio, (1.0 - ratio * ratio).sqrt());
                let Some(matrix) = self.factorized(shift) else {
                    continue;
                };
                for start in &starts {
                    let mut answer = start.clone();
                    if matrix.solve(&mut answer).is_some() {
                        columns.push(answer);
                    }
                }
            }
        }
        let part = |i: usize, j: usize| {
            let entry = columns[j / 2][i];
            if j % 2 == 0 { entry.re } else { entry.im }
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

/// Whether two values may be copies of one.
fn is_near(a: &Eigenpair, b: &Eigenpair) -> bool {
    (a.value() - b.value()).norm() <= CONFIRMED * a.value().norm()
}
