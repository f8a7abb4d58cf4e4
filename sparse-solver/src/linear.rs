//! Linear systems on one pattern: each matrix has its own factors, which can be used for any
//! number of solutions.
//!
//! Pivots and the pattern of the factors are reused for the next matrices while they are good
//! enough; a matrix for which no pivots are is factorized by `general`. Solutions of real
//! systems are refined once.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use faer::{Mat, c64};

use super::general::{GeneralLu, GeneralSolver};
use super::lu::{Lu, Plans};
use super::number::{LANES, Number, Row};
use crate::pattern::{Pattern, Sparse};

/// Factorizes matrices on one pattern. A clone has its own pivots from then on.
#[derive(Debug)]
pub struct LinearSolver {
    pattern: Arc<Pattern>,
    /// The stored plans, the latest first.
    plans: Mutex<Plans>,
    general: GeneralSolver,
}

/// A factorized matrix.
#[derive(Debug)]
pub struct Factorization {
    factors: Factors<f64>,
    matrix: Sparse,
}

/// A factorized complex matrix `A + s B` on the pattern of A and B.
#[derive(Debug)]
pub struct ComplexFactorization {
    factors: Factors<c64>,
}

#[derive(Debug)]
enum Factors<T: Number> {
    Kept(Lu<T>),
    General(Box<GeneralLu<T>>),
}

impl Clone for LinearSolver {
    fn clone(&self) -> Self {
        Self {
            pattern: Arc::clone(&self.pattern),
            plans: Mutex::new(self.plans().clone()),
            general: self.general.clone(),
        }
    }
}

impl LinearSolver {
    /// A solver for matrices on a pattern.
    pub fn new(pattern: &Arc<Pattern>) -> Self {
        Self {
            pattern: Arc::clone(pattern),
            plans: Mutex::default(),
            general: GeneralSolver::new(pattern),
        }
    }

    fn plans(&self) -> MutexGuard<'_, Plans> {
        self.plans.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Factorizes `matrix`; `None` if it is singular or not finite.
    ///
    /// # Panics
    /// If the matrix is on another pattern.
    pub fn factorize(&self, matrix: Sparse) -> Option<Factorization> {
        assert!(Arc::ptr_eq(&self.pattern, matrix.pattern()), "two patterns");
        Some(Factorization {
            factors: self.factors(matrix.values())?,
            matrix,
        })
    }

    /// Factorizes `a + s b`; `None` if it is singular to working precision.
    pub fn factorize_complex(
        &self,
        a: &Sparse,
        s: c64,
        b: &Sparse,
    ) -> Option<ComplexFactorization> {
        let values = a.values().iter().zip(b.values());
        let values: Vec<c64> = values.map(|(a, b)| s * *b + *a).collect();
        let factors = self.factors(&values)?;
        Some(ComplexFactorization { factors })
    }

    /// Factors by a stored plan, or by a new one made for this matrix and stored.
    fn factors<T: Number>(&self, values: &[T]) -> Option<Factors<T>> {
        let mut plans = self.plans().clone();
        if let Some(lu) = plans.factorize(values, None) {
            *self.plans() = plans;
            return Some(Factors::Kept(lu));
        }
        if values.iter().any(|value| !value.size().is_finite()) {
            return None;
        }
        match Lu::choose(&self.pattern, values).filter(Lu::is_trusted) {
            Some(lu) => {
                self.plans().store(lu.plan(), &self.pattern);
                Some(Factors::Kept(lu))
            }
            None => {
                let general = self.general.factorize(values)?;
                Some(Factors::General(Box::new(general)))
            }
        }
    }
}

impl ComplexFactorization {
    /// Solves `A x = b` and replaces `b` by x; `None` if x is not finite.
    pub fn solve(&self, b: &mut [c64]) -> Option<()> {
        match &self.factors {
            Factors::Kept(lu) => lu.solve(b, &mut vec![c64::ZERO; lu.plan().buffer_len()]),
            Factors::General(lu) => lu.solve(b),
        }
        b.iter().all(|value| value.is_finite()).then_some(())
    }
}

impl Factorization {
    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.matrix.pattern().size()
    }

    /// Solves `A x = b` with the factors as they are and replaces `b` by x; `None` if the
    /// solution is not finite.
    pub fn respond(&self, b: &mut [f64]) -> Option<()> {
        self.solve_once(b);
        b.iter().all(|value| value.is_finite()).then_some(())
    }

    /// Solves `A x = b` with one step of refinement and replaces `b` by x; `None` if the
    /// solution is not finite.
    pub fn solve(&self, b: &mut [f64]) -> Option<()> {
        let mut x = b.to_vec();
        self.solve_once(&mut x);
        self.subtract_product(b, &x);
        self.solve_once(b);
        b.iter_mut().zip(&x).for_each(|(b, x)| *b += x);
        b.iter().all(|value| value.is_finite()).then_some(())
    }

    /// Solves `A X = B` like [`Self::solve`], several columns at a time.
    pub fn solve_columns(&self, b: &mut Mat<f64>) -> Option<()> {
        let Factors::Kept(lu) = &self.factors else {
            let mut columns = 0..b.ncols();
            return columns.try_for_each(|j| self.solve(b.col_as_slice_mut(j)));
        };
        let none = <[f64; LANES] as Row<f64>>::NONE;
        let [mut right, mut x] = [(); 2].map(|()| vec![none; b.nrows()]);
        let mut buffer = vec![none; lu.plan().buffer_len()];
        for first in (0..b.ncols()).step_by(LANES) {
            let columns = first..b.ncols().min(first + LANES);
            right.fill(none);
            for (lane, j) in columns.clone().enumerate() {
                let rows = right.iter_mut().zip(b.col_as_slice(j));
                rows.for_each(|(row, value)| row[lane] = *value);
            }
            x.copy_from_slice(&right);
            lu.solve(&mut x, &mut buffer);
            self.subtract_product(&mut right, &x);
            lu.solve(&mut right, &mut buffer);
            for (lane, j) in columns.enumerate() {
                let rows = right.iter().zip(&x).zip(b.col_as_slice_mut(j));
                rows.for_each(|((rest, x), value)| *value = x[lane] + rest[lane]);
            }
        }
        b.is_all_finite().then_some(())
    }

    /// `b <- b - A x`.
    fn subtract_product<R: Row<f64>>(&self, b: &mut [R], x: &[R]) {
        let (pattern, values) = (self.matrix.pattern(), self.matrix.values());
        for (j, x) in x.iter().enumerate() {
            for index in pattern.column(j) {
                let row = &mut b[pattern.rows()[index] as usize];
                *row = row.minus(x.times(values[index]));
            }
        }
    }

    fn solve_once(&self, b: &mut [f64]) {
        match &self.factors {
            Factors::Kept(lu) => lu.solve(b, &mut vec![0.0; lu.plan().buffer_len()]),
            Factors::General(lu) => lu.solve(b),
        }
    }
}
