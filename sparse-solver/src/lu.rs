//! Factorization of many matrices on one pattern: pivots are chosen once and kept while they
//! are good enough.
//!
//! The first matrix is scaled, and its pivots are chosen ([`pivots`]) and sorted so that the
//! columns of a block are consecutive ([`order`]); the pattern of the factors is found in dense
//! blocks ([`structure`]). Each matrix then needs arithmetic only ([`numbers`],
//! [`elimination`], [`solution`]), for large matrices in parallel branches ([`branches`]).
//!
//! References: [DavisPalamadai2010], which also keeps pivots and pattern.

mod branches;
mod dissection;
mod elimination;
mod fill;
mod lines;
mod lists;

mod numbers;
mod order;
mod pivots;
mod plans;
mod solution;
mod structure;

use std::sync::Arc;

use crate::number::{LANES, Number, Row};
use elimination::Scaled;
use numbers::Numbers;
use structure::Structure;

pub(crate) use plans::Plans;

use super::scales::scales;
use crate::pattern::Pattern;

/// Growth of the factors up to which they are accepted without a check of the residual of the
/// solution: at most six of sixteen digits are lost.
const TRUSTED_GROWTH: f64 = 1e6;
/// Growth of the factors above which other pivots are chosen.
const LARGEST_GROWTH: f64 = 1e10;
/// Ratio to the least pivot at the choice of pivots, below which a pivot is round-off: the
/// matrix has become singular, or needs other pivots.
const SHRUNK: f64 = 0.1;

/// All choices and patterns found once, for one matrix, and reused for others.
#[derive(Debug)]
pub(crate) struct Plan {
    /// Scales of rows and of columns, in the order of elimination.
    scales: [Vec<f64>; 2],
    structure: Structure,
    /// Relative size below which a pivot is treated as zero.
    least_pivot: f64,
}

/// Factors of a matrix.
#[derive(Debug)]
pub(crate) struct Lu<T: Number> {
    plan: Arc<Plan>,
    numbers: Numbers<T>,
    growth: f64,
    /// Least pivot, relative to the matrix.
    least: f64,
}

impl Plan {
    /// Chooses pivots for the matrix of the given values; `None` if it is singular.
    fn new<T: Number>(pattern: &Arc<Pattern>, values: &[T]) -> Option<Self> {
        let scales = scales(pattern, values)?;
        let pivots = pivots::choose(pattern, values, (&scales.0, &scales.1))?;
        let (pivots, branches) = order::ordered(pattern, &pivots);
        let taken = |scale: &[f64], of: &[u32]| {
            let lines = of.iter();
            lines.map(|&line| scale[line as usize]).collect()
        };
        Some(Self {
            scales: [
                taken(&scales.0, &pivots.rows),
                taken(&scales.1, &pivots.columns),
            ],
            structure: Structure::new(pattern, pivots, &branches),
            least_pivot: 0.0,
        })
    }

    /// Equations and their scales.
    pub fn row_scales(&self) -> impl Iterator<Item = (usize, f64)> + Clone + '_ {
        let rows = self.structure.pivots.rows.iter().map(|&row| row as usize);
        rows.zip(self.scales[0].iter().copied())
    }

    /// Size of the buffer of a solution [numbers].
    pub fn buffer_len(&self) -> usize {
        solution::buffer_len(&self.structure)
    }
}

impl<T: Number> Lu<T> {
    /// Chooses pivots for the matrix of the given values, and factorizes it; `None` if it is
    /// singular.
    pub fn choose(pattern: &Arc<Pattern>, values: &[T]) -> Option<Self> {
        let mut plan = Plan::new(pattern, values)?;
        let mut numbers = Numbers::new(&plan.structure);
        let (growth, least) = compute(&plan, &mut numbers, values)?;
        plan.least_pivot = (least * SHRUNK).min(f64::EPSILON);
        Some(Self {
            plan: Arc::new(plan),
            numbers,
            growth,
            least,
        })
    }

    /// Factorizes by a plan made for another matrix; `None` if the plan does not suit.
    pub fn by_plan(plan: &Arc<Plan>, values: &[T]) -> Option<Self> {
        let mut numbers = Numbers::new(&plan.structure);
        let (growth, least) = compute(plan, &mut numbers, values)?;
        (least >= plan.least_pivot).then(|| Self {
            plan: Arc::clone(plan),
            numbers,
            growth,
            least,
        })
    }

    /// Factorizes another matrix by the same plan; `None` if other pivots are needed.
    pub fn factorize(&mut self, values: &[T]) -> Option<()> {
        (self.growth, self.least) = compute(&self.plan, &mut self.numbers, values)?;
        (self.least >= self.plan.least_pivot).then_some(())
    }

    /// The plan by which the matrix was factorized.
    pub fn plan(&self) -> &Arc<Plan> {
        &self.plan
    }

    /// Least pivot, relative to the matrix.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// Whether the factors are accurate to all but a few digits.
    pub fn is_trusted(&self) -> bool {
        self.growth < TRUSTED_GROWTH
    }

    /// Replaces b by x; `ordered` is a buffer of [`Plan::buffer_len`] numbers.
    pub fn solve<R: Row<T>>(&self, b: &mut [R], ordered: &mut [R]) {
        let Plan {
            scales: [row_scales, column_scales],
            structure,
            ..
        } = &*self.plan;
        let pivots = &structure.pivots;
        let rows = pivots.rows.iter().zip(row_scales);
        for (value, (&row, scale)) in ordered.iter_mut().zip(rows) {
            *value = b[row as usize].scaled(*scale);
        }
        solution::solve(structure, &self.numbers, ordered);
        let columns = pivots.columns.iter().zip(column_scales);
        for (value, (&column, scale)) in ordered.iter().zip(columns) {
            b[column as usize] = value.scaled(*scale);
        }
    }

    /// Number of stored values of the factors.
    pub fn stored(&self) -> usize {
        let structure = &self.plan.structure;
        structure.panel_values + structure.segment_values * LANES
    }
}

/// Computes the factors; returns their growth, and the least pivot relative to the matrix.
fn compute<T: Number>(plan: &Plan, numbers: &mut Numbers<T>, values: &[T]) -> Option<(f64, f64)> {
    let matrix = Scaled {
        values,
        row_scales: &plan.scales[0],
        column_scales: &plan.scales[1],
    };
    let growth = numbers.factorize(&plan.structure, matrix)?;
    (growth.factor() < LARGEST_GROWTH).then(|| (growth.factor(), growth.least()))
}

#[cfg(test)]
mod tests;
