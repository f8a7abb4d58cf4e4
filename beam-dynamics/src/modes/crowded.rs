//! Modes of systems with many slow real eigenvalues, such as the lags of the air at a blade.
//!
//! The lags of some hundred strips are real eigenvalues of the size of the lowest frequencies: the
//! eigenvalues nearest to zero are theirs. The oscillations are found from a system whose scalars
//! follow without lag, and each is corrected in the complete system by inverse iteration with a
//! changing shift,
//!
//! ```text
//! y = (F_y + sigma F_y')^-1 F_y' x        mu = <x, y> / <x, x>        s = sigma - 1 / mu
//! ```
//!
//! which keeps the shape while the value converges.

use faer::c64;

use super::copies::{CONFIRMED, is_new, orthonormalize, product};
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use super::sorted::{OVERDAMPED, Sorted};

/// Corrections of one value.
const CORRECTIONS: usize = 12;
/// Corrections at the shift of the start, so that the shape determines the mode.
const HELD: usize = 2;
/// Change of a value, relative, at which its correction ends.
const CONVERGED: f64 = 1e-10;
/// Parts of a value between which its shift is, so that the matrix is never singular.
const BESIDE: f64 = 1e-7;
/// Imaginary part of an oscillation as a part of its magnitude: pairs below it, of a damping ratio above
/// 0.95, are slow states that are coupled.
const OSCILLATES: f64 = 0.3;
/// Overlap of the shapes without and with the lags, below which they are different modes.
const SAME_SHAPE: f64 = 0.5;

impl EigenProblem<'_> {
    /// Whether slow values of scalars leave no `count` oscillations among the nearest values.
    pub(super) fn is_crowded(&self, sorted: &Sorted, count: usize) -> bool {
        let oscillates = |s: &&c64| s.im > OSCILLATES * s.norm();
        let found = sorted.above.iter().filter(oscillates).count();
        let slow = sorted.zeros + sorted.real.len() + sorted.above.len() - found;
        found < count && slow >= count && self.has_slow_scalars()
    }

    /// The `count` oscillations of lowest frequency of a system without air, or without lags of
    /// scalars, that lead to one in this system; and how many lead to none.
    pub(super) fn beyond_the_crowd(&self, count: usize) -> (Vec<Eigenpair>, usize) {
        let (mut pairs, lost) = match self.half_air() {
            Some(half) => self.followed_from_vacuum(half, count),
            None => self.without_lags(count),
        };
        pairs.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
        (pairs, lost)
    }

    /// The first new pair among the candidates of each mode, and how many modes have none.
    pub(super) fn new_ones<C: Iterator<Item = Eigenpair>>(
        &self,
        modes: impl Iterator<Item = C>,
    ) -> (Vec<Eigenpair>, usize) {
        let (mut known, mut lost) = (Vec::new(), 0);
        for mut candidates in modes {
            match candidates.find(|pair| is_new(pair, &known)) {
                Some(pair) => known.push(pair),
                None => lost += 1,
            }
        }
        (known, lost)
    }

    /// The modes of lowest frequency of a system without lags of scalars, corrected in this one.
    fn without_lags(&self, count: usize) -> (Vec<Eigenpair>, usize) {
        let Some(tangent) = self.without_circuits(self.tangent()) else {
            return (Vec::new(), 0);
        };
        let Some(problem) = self.beside(&tangent) else {
            return (Vec::new(), 0);
        };
        let found = problem.lowest_complete(count);
        let corrected = |pair| self.corrected(pair, SAME_SHAPE).into_iter();
        self.new_ones(found.iter().map(corrected))
    }

    /// The `count` oscillations of lowest frequency, and the other copies of the last one.
    pub(super) fn lowest_complete(&self, count: usize) -> Vec<Eigenpair> {
        let mut pairs = self.lowest(count + self.copies()).pairs;
        let last = pairs.get(count.saturating_sub(1)).map(Eigenpair::value);
        let is_copy = |pair: &Eigenpair| {
            last.is_some_and(|last| (pair.value() - last).norm() <= CONFIRMED * last.norm())
        };
        let copies = pairs.iter().skip(count).take_while(|pair| is_copy(pair));
        pairs.truncate(count + copies.count());
        pairs
    }

    /// The pair of the complete system that has the shape of `pair`, with an overlap of at least
    /// `least`; `None` if the iteration leaves this shape, or ends at a motion that does not oscillate.
    pub(super) fn corrected(&self, pair: &Eigenpair, least: f64) -> Option<Eigenpair> {
        let oscillates = |found: &Eigenpair| found.value().im > OVERDAMPED * found.value().norm();
        self.refined((pair, pair.value()), least).filter(oscillates)
    }

    /// The pair of the complete system that has the shape of `pair`, from a first value, with an overlap
    /// of at least `least`, which may not oscillate; `None` if the iteration leaves this shape.
    pub(super) fn refined(
        &self,
        (pair, first): (&Eigenpair, c64),
        least: f64,
    ) -> Option<Eigenpair> {
        let size = self.size();
        let all = self.tangent().by_rates.pattern().size();
        let mut start = pair.vector();
        start.resize(all, c64::new(0.0, 0.0));
        orthonormalize(std::slice::from_mut(&mut start), size);
        let mut vector = start.clone();
        let mut value = first;
        for step in 0..CORRECTIONS {
            let shift = if step < HELD {
                first
            } else {
                value * (1.0 + BESIDE)
            };
            let mut next = self.rates_times(&vector);
            self.factorized(shift)?.solve(&mut next)?;
            let factor = product(&vector, &next, size);
            orthonormalize(std::slice::from_mut(&mut next), size);
            let found = shift - factor.inv();
            vector = next;
            if !found.is_finite() {
                return None;
            }
            let change = (found - value).norm();
            value = found;
            if step > HELD && change <= CONVERGED * value.norm() {
                break;
            }
        }
        if product(&start, &vector, size).norm() < least {
            return None;
        }
        let residual = self.inverse().residual(value, &vector);
        let corrected = Eigenpair::new(value, &vector[..size], residual);
        (residual <= CONFIRMED).then_some(corrected)
    }
}
