//! The linear systems of time integration: one pattern, many matrices.

use std::sync::Arc;

use super::general::{GeneralLu, GeneralSolver};
use super::lu::{Lu, Plans};
use crate::pattern::{Pattern, Sparse};

/// Ratio to the usual least pivot below which a matrix may be nearly singular.
const DOUBTFUL: f64 = 1e-3;
/// Residual of a solution, relative to the terms of each equation, above which it is refined:
/// Newton's method does not need a smaller one [-].
const REFINED_ABOVE: f64 = 1e-9;
/// Residual below which the factors are used for further solutions without another check.
const VOUCHED_BELOW: f64 = 1e-12;
/// Residual above which a solution is rejected [-].
const WRONG_ABOVE: f64 = 1e-6;
/// Size of terms of an equation, relative to the largest ones, below which they are rounding
/// [-].
const SMALL: f64 = 1e-12;

/// Number of operations of a solver, by kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LinearCounts {
    /// Factorizations on pivots of an earlier matrix.
    pub refactorizations: usize,
    /// Choices of pivots.
    pub pivotings: usize,
    /// Factorizations by the general method, if no chosen pivots are good enough.
    pub fallbacks: usize,
    /// Refinements of solutions.
    pub refinements: usize,
}

/// Factorizes successive matrices on one pattern, and solves with the last.
///
/// Pivots are kept from matrix to matrix while the factors do not grow and solutions satisfy
/// their equations. Otherwise the other pivots of the last few choices are tried, since matrices
/// recur, as the matrices of a rotor in each revolution; then new ones are chosen, and if these fail
/// too, the general factorization is used, which chooses pivots for every matrix. Nothing is
/// allocated while pivots are kept.
///
/// References: [Arioli1989], the error of a solution.
#[derive(Debug)]
pub struct StepSolver {
    matrix: Sparse,
    factors: Factors,
    /// Plans of the last choices.
    plans: Plans,
    /// Whether a solution with these factors had a negligible residual.
    is_vouched: bool,
    right_side: Vec<f64>,
    /// Residual of the last solution, empty until one is checked.
    residual: Vec<f64>,
    /// Sum of the absolute values of the terms of each equation, for that residual.
    sizes: Vec<f64>,
    /// Largest of the least pivots of all choices since the last reset, each relative to its
    /// matrix.
    usual_least: f64,
    /// Unknowns in the order of elimination.
    ordered: Vec<f64>,
    counts: LinearCounts,
    fallback: GeneralSolver,
}

#[derive(Debug)]
enum Factors {
    None,
    /// On pivots of an earlier matrix.
    Kept(Box<Lu<f64>>),
    /// On pivots of this matrix.
    Chosen(Box<Lu<f64>>),
    Fallback(Box<GeneralLu<f64>>),
}

impl Factors {
    /// Replaces b by x; `None` without factors.
    fn solve(&self, b: &mut [f64], ordered: &mut [f64]) -> Option<()> {
        match self {
            Self::None => return None,
            Self::Kept(lu) | Self::Chosen(lu) => lu.solve(b, ordered),
            Self::Fallback(lu) => lu.solve(b),
        }
        Some(())
    }
}

impl StepSolver {
    /// A solver for matrices on a pattern.
    pub fn new(pattern: &Arc<Pattern>) -> Self {
        let zeros = vec![0.0; pattern.size()];
        Self {
            matrix: Sparse::zero(Arc::clone(pattern)),
            factors: Factors::None,
            plans: Plans::default(),
            is_vouched: false,
            right_side: zeros.clone(),
            residual: Vec::new(),
            ordered: zeros,
            sizes: Vec::new(),
            usual_least: 0.0,
            counts: LinearCounts::default(),
            fallback: GeneralSolver::new(pattern),
        }
    }

    /// Number of operations so far, by kind.
    pub fn counts(&self) -> LinearCounts {
        self.counts
    }

    /// Number of stored values of the factors on chosen pivots, zeros in their blocks included.
    pub fn stored(&self) -> usize {
        match &self.factors {
            Factors::Kept(lu) | Factors::Chosen(lu) => lu.stored(),
            Factors::None | Factors::Fallback(_) => 0,
        }
    }

    /// Factorizes `matrix`; `None` if it is singular or not finite.
    pub fn factorize(&mut self, matrix: &Sparse) -> Option<()> {
        self.matrix.values_mut().copy_from_slice(matrix.values());
        self.factorize_written()
    }

    /// The last matrix, in which the next one may be written. That one must be factorized
    /// before any solution.
    pub fn matrix_mut(&mut self) -> &mut Sparse {
        &mut self.matrix
    }

    /// Factorizes the matrix written to [`Self::matrix_mut`]; `None` if it is singular or not
    /// finite.
    pub fn factorize_written(&mut self) -> Option<()> {
        self.is_vouched = false;
        let last = std::mem::replace(&mut self.factors, Factors::None);
        let mut failed = None;
        if let Factors::Kept(mut lu) | Factors::Chosen(mut lu) = last {
            if lu.factorize(self.matrix.values()).is_some() {
                self.counts.refactorizations += 1;
                self.factors = Factors::Kept(lu);
                return Some(());
            }
            failed = Some(Arc::clone(lu.plan()));
        }
        if !self.is_finite() {
            return None;
        }
        let Some(failed) = failed else {
            return self.choose_pivots();
        };
        match self.plans.factorize(self.matrix.values(), Some(&failed)) {
            Some(lu) => {
                self.counts.refactorizations += 1;
                self.make_buffer(&lu);
                self.factors = Factors::Kept(Box::new(lu));
                Some(())
            }
            None => self.choose_pivots(),
        }
    }

    /// Makes the buffer of the solutions long enough.
    fn make_buffer(&mut self, lu: &Lu<f64>) {
        let length = lu.plan().buffer_len();
        self.ordered
            .reserve_exact(length.saturating_sub(self.ordered.len()));
        self.ordered.resize(length, 0.0);
    }

    /// Whether all entries of the last matrix are finite numbers.
    pub fn is_finite(&self) -> bool {
        self.matrix.values().iter().all(|value| value.is_finite())
    }

    /// Removes the last matrix and all data kept from it, such as the order of its pivots: the
    /// next one is factorized like the first.
    pub fn forget(&mut self) {
        self.factors = Factors::None;
        self.plans.clear();
        self.usual_least = 0.0;
    }

    /// Solves `A x = b` with the last matrix and replaces `b` by x; `None` if there is no
    /// matrix, or x is not finite.
    pub fn solve(&mut self, b: &mut [f64]) -> Option<()> {
        if b.iter().any(|value| !value.is_finite()) {
            return None;
        }
        self.right_side.copy_from_slice(b);
        if self.attempt(b)? {
            return Some(());
        }
        if matches!(self.factors, Factors::Kept(_)) {
            self.choose_pivots()?;
            b.copy_from_slice(&self.right_side);
            if self.attempt(b)? {
                return Some(());
            }
        }
        self.fall_back()?;
        b.copy_from_slice(&self.right_side);
        self.attempt(b)?.then_some(())
    }

    /// Whether the last matrix may be nearly singular: its pivots are much smaller than the
    /// pivots chosen since the last reset.
    pub fn is_doubtful(&self) -> bool {
        match &self.factors {
            Factors::None => false,
            Factors::Kept(lu) | Factors::Chosen(lu) => lu.least() < DOUBTFUL * self.usual_least,
            Factors::Fallback(_) => true,
        }
    }

    /// Solves `A x = b` with the current factors as they are and replaces `b` by x; `None` if
    /// there are no factors.
    pub fn respond(&mut self, b: &mut [f64]) -> Option<()> {
        self.factors.solve(b, &mut self.ordered)
    }

    fn choose_pivots(&mut self) -> Option<()> {
        self.counts.pivotings += 1;
        match Lu::choose(self.matrix.pattern(), self.matrix.values()) {
            Some(lu) => {
                self.usual_least = self.usual_least.max(lu.least());
                self.is_vouched = false;
                self.make_buffer(&lu);
                self.plans.store(lu.plan(), self.matrix.pattern());
                self.factors = Factors::Chosen(Box::new(lu));
            }
            None => self.fall_back()?,
        }
        Some(())
    }

    /// The general factorization; `None` if it does not solve `A x = A 1`.
    fn fall_back(&mut self) -> Option<()> {
        self.counts.fallbacks += 1;
        self.factors = Factors::None;
        let factors = self.fallback.factorize(self.matrix.values())?;
        let mut b = vec![0.0; self.right_side.len()];
        self.matrix.multiply_add(&vec![1.0; b.len()], &mut b);
        factors.solve(&mut b);
        if b.iter().any(|value| !value.is_finite()) {
            return None;
        }
        self.factors = Factors::Fallback(Box::new(factors));
        Some(())
    }

    /// Solves with the current factors; returns whether x satisfies the equations.
    fn attempt(&mut self, b: &mut [f64]) -> Option<bool> {
        self.factors.solve(b, &mut self.ordered)?;
        let finite = |x: &[f64]| x.iter().all(|value| value.is_finite());
        let is_general = match &self.factors {
            Factors::Kept(lu) | Factors::Chosen(lu) if self.is_vouched || lu.is_trusted() => {
                return Some(finite(b));
            }
            factors => matches!(factors, Factors::Fallback(_)),
        };
        let mut error = self.error(b);
        self.is_vouched = error < VOUCHED_BELOW && !is_general;
        if error > REFINED_ABOVE || is_general {
            self.refine(b);
            error = self.error(b);
        }
        Some(finite(b) && (error < WRONG_ABOVE || is_general))
    }

    /// Corrects x by the solution for its residual.
    fn refine(&mut self, x: &mut [f64]) {
        self.counts.refinements += 1;
        // There are factors: x was computed with them.
        let _ = self.factors.solve(&mut self.residual, &mut self.ordered);
        let corrections = x.iter_mut().zip(&self.residual);
        corrections.for_each(|(x, correction)| *x += correction);
    }

    /// Largest residual `b - A x` relative to the terms of its equation,
    /// `|r_i| / (|A| |x| + |b|)_i` (D-135).
    fn error(&mut self, x: &[f64]) -> f64 {
        self.residual.clone_from(&self.right_side);
        self.sizes.clear();
        self.sizes.extend(self.right_side.iter().map(|b| b.abs()));
        for (row, column, value) in self.matrix.triplets() {
            let term = value * x[column];
            self.residual[row] -= term;
            self.sizes[row] += term.abs();
        }
        let of = (&self.residual[..], &self.sizes[..]);
        match &self.factors {
            Factors::None => 0.0,
            Factors::Kept(lu) | Factors::Chosen(lu) => worst(lu.plan().row_scales(), of),
            Factors::Fallback(lu) => worst(lu.row_scales().iter().copied().enumerate(), of),
        }
    }
}

/// The largest residual relative to the size of its equation, by equations and their scales.
fn worst(
    scales: impl Iterator<Item = (usize, f64)> + Clone,
    (residual, sizes): (&[f64], &[f64]),
) -> f64 {
    let scaled = scales.clone().map(|(row, scale)| scale * sizes[row]);
    let floor = (SMALL * scaled.fold(0.0, f64::max)).max(f64::MIN_POSITIVE);
    scales.fold(0.0, |worst: f64, (row, scale)| {
        worst.max(scale * residual[row].abs() / (scale * sizes[row]).max(floor))
    })
}
