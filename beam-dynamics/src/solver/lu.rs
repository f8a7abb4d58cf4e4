//! Factorization of many matrices on one pattern: pivots are chosen once and kept while
//! they serve.
//!
//! The first matrix is scaled, its pivots are chosen ([`pivots`]) and brought into an
//! order in which blocks follow each other ([`order`]); the pattern of the factors is
//! found in dense blocks ([`structure`]). Each matrix then takes arithmetic alone
//! ([`numbers`], [`solution`]).
//!
//! References: [DavisPalamadai2010], which also keeps pivots and pattern.

mod lines;
mod number;
mod numbers;
mod order;
mod pivots;
mod solution;
mod structure;

use std::sync::Arc;

pub(super) use number::{LANES, Number, Row};
use numbers::{Numbers, Scaled};
use pivots::Pivots;
use structure::Structure;

use super::scales::{scaled, scales};
use crate::assembly::Pattern;

/// Growth of the factors up to which they are taken without a look at the residual of
/// the solution: six of sixteen digits are lost at most.
const TRUSTED_GROWTH: f64 = 1e6;
/// Growth of the factors above which other pivots are chosen.
const LARGEST_GROWTH: f64 = 1e10;
/// Part of the least pivot, when pivots were chosen, below which a pivot is round-off:
/// the matrix has become singular, or needs others.
const SHRUNK: f64 = 0.1;

/// All that is chosen and found once, for one matrix, and kept for others.
#[derive(Debug)]
pub(super) struct Plan {
    pivots: Pivots,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// The same scales in the order of elimination.
    ordered_scales: [Vec<f64>; 2],
    structure: Structure,
    /// Relative size below which a pivot is none.
    least_pivot: f64,
}

/// Factors of a matrix.
#[derive(Debug)]
pub(super) struct Lu<T: Number> {
    plan: Arc<Plan>,
    numbers: Numbers<T>,
    growth: f64,
    /// Least pivot, relative to the matrix.
    least: f64,
}

impl Plan {
    /// Chooses pivots for the matrix of the given values; `None` when it is singular.
    fn new<T: Number>(pattern: &Pattern, values: &[T]) -> Option<Self> {
        let scales = scales(pattern, values)?;
        let scaled = scaled(pattern, values, &scales);
        let pivots = order::postordered(pattern, &pivots::choose(pattern, &scaled)?);
        let taken = |scale: &[f64], of: &[usize]| of.iter().map(|&line| scale[line]).collect();
        let (row_scale, column_scale) = scales;
        Some(Self {
            structure: Structure::new(pattern, &pivots),
            ordered_scales: [
                taken(&row_scale, &pivots.rows),
                taken(&column_scale, &pivots.columns),
            ],
            pivots,
            row_scale,
            column_scale,
            least_pivot: 0.0,
        })
    }

    /// Scale of each equation.
    pub fn row_scales(&self) -> &[f64] {
        &self.row_scale
    }
}

impl<T: Number> Lu<T> {
    /// Chooses pivots for the matrix of the given values, and factorizes it; `None` when it
    /// is singular.
    pub fn choose(pattern: &Pattern, values: &[T]) -> Option<Self> {
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

    /// Factorizes by a plan that was made for another matrix; `None` when it does not serve.
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

    /// Factorizes another matrix by the same plan; `None` when other pivots are needed.
    pub fn factorize(&mut self, values: &[T]) -> Option<()> {
        (self.growth, self.least) = compute(&self.plan, &mut self.numbers, values)?;
        (self.least >= self.plan.least_pivot).then_some(())
    }

    /// By which the matrix was factorized.
    pub fn plan(&self) -> &Arc<Plan> {
        &self.plan
    }

    /// Least pivot, relative to the matrix.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// Whether the factors are as good as the matrix but for a few digits.
    pub fn is_trusted(&self) -> bool {
        self.growth < TRUSTED_GROWTH
    }

    /// Replaces b by x; `ordered` is a buffer of the same length.
    pub fn solve<R: Row<T>>(&self, b: &mut [R], ordered: &mut [R]) {
        let Plan {
            pivots,
            row_scale,
            column_scale,
            structure,
            ..
        } = &*self.plan;
        for (value, &row) in ordered.iter_mut().zip(&pivots.rows) {
            *value = b[row].scaled(row_scale[row]);
        }
        solution::solve(structure, &self.numbers, ordered);
        for (value, &column) in ordered.iter().zip(&pivots.columns) {
            b[column] = value.scaled(column_scale[column]);
        }
    }

    /// Numbers that are stored for the factors.
    pub fn stored(&self) -> usize {
        let structure = &self.plan.structure;
        structure.panel_values + structure.segment_values * LANES
    }
}

/// Computes the factors: how they grow, and the least pivot, relative to the matrix.
fn compute<T: Number>(plan: &Plan, numbers: &mut Numbers<T>, values: &[T]) -> Option<(f64, f64)> {
    let matrix = Scaled {
        values,
        row_scales: &plan.ordered_scales[0],
        column_scales: &plan.ordered_scales[1],
    };
    let growth = numbers.factorize(&plan.structure, matrix)?;
    (growth.factor() < LARGEST_GROWTH).then(|| (growth.factor(), growth.least()))
}
