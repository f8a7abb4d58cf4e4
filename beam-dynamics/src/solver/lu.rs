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
mod numbers;
mod order;
mod pivots;
mod solution;
mod structure;

use std::sync::Arc;

use numbers::{Numbers, Scaled};
use pivots::Pivots;
use structure::Structure;

use super::linear::scales;
use crate::assembly::{Pattern, Sparse};

/// Growth of the factors up to which they are taken without a look at the residual of
/// the solution: six of sixteen digits are lost at most.
const TRUSTED_GROWTH: f64 = 1e6;
/// Growth of the factors above which other pivots are chosen.
const LARGEST_GROWTH: f64 = 1e10;
/// Part of the least pivot, when pivots were chosen, below which a pivot is round-off:
/// the matrix has become singular, or needs others.
const SHRUNK: f64 = 0.1;

/// Factors of a matrix, on pivots that were chosen for an earlier one.
#[derive(Debug)]
pub(super) struct KeptLu {
    pivots: Pivots,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// The same scales in the order of elimination.
    ordered_scales: [Vec<f64>; 2],
    structure: Structure,
    numbers: Numbers,
    /// Unknowns in the order of elimination.
    ordered: Vec<f64>,
    growth: f64,
    /// Relative size below which a pivot is none.
    least_pivot: f64,
    /// Least pivot, relative to the matrix.
    least: f64,
}

impl KeptLu {
    /// Chooses pivots for `matrix`, and factorizes it; `None` when it is singular.
    pub fn new(matrix: &Sparse) -> Option<Self> {
        let pattern: &Arc<Pattern> = matrix.pattern();
        let magnitudes: Vec<_> = matrix.values().iter().map(|value| value.abs()).collect();
        let (row_scale, column_scale) = scales(pattern, &magnitudes)?;
        let places = matrix.triplets();
        let scales: Vec<_> = places
            .map(|(i, j, _)| row_scale[i] * column_scale[j])
            .collect();
        let scaled: Vec<_> = matrix
            .values()
            .iter()
            .zip(&scales)
            .map(|(a, s)| a * s)
            .collect();
        let pivots = order::postordered(pattern, &pivots::choose(pattern, &scaled)?);
        let structure = Structure::new(pattern, &pivots);
        let taken = |scale: &[f64], of: &[usize]| of.iter().map(|&line| scale[line]).collect();
        let mut lu = Self {
            numbers: Numbers::new(&structure),
            ordered: vec![0.0; pattern.size()],
            growth: f64::INFINITY,
            least_pivot: 0.0,
            least: 0.0,
            ordered_scales: [
                taken(&row_scale, &pivots.rows),
                taken(&column_scale, &pivots.columns),
            ],
            pivots,
            row_scale,
            column_scale,
            structure,
        };
        let least = lu.compute(matrix)?;
        lu.least_pivot = (least * SHRUNK).min(f64::EPSILON);
        lu.least = least;
        Some(lu)
    }

    /// Factorizes another matrix on the same pattern; `None` when other pivots are needed.
    pub fn factorize(&mut self, matrix: &Sparse) -> Option<()> {
        let least = self.compute(matrix)?;
        self.least = least;
        (least >= self.least_pivot).then_some(())
    }

    /// Computes the factors; the least pivot, relative to the matrix.
    fn compute(&mut self, matrix: &Sparse) -> Option<f64> {
        let matrix = Scaled {
            values: matrix.values(),
            row_scales: &self.ordered_scales[0],
            column_scales: &self.ordered_scales[1],
        };
        let growth = self.numbers.factorize(&self.structure, matrix)?;
        self.growth = growth.factor();
        (self.growth < LARGEST_GROWTH).then(|| growth.least())
    }

    /// Least pivot, relative to the matrix.
    pub fn least(&self) -> f64 {
        self.least
    }

    /// Whether the factors are as good as the matrix but for a few digits.
    pub fn is_trusted(&self) -> bool {
        self.growth < TRUSTED_GROWTH
    }

    /// Replaces b by x.
    pub fn solve(&mut self, b: &mut [f64]) {
        let ordered = self.ordered.iter_mut().zip(&self.pivots.rows);
        ordered.for_each(|(value, &row)| *value = b[row] * self.row_scale[row]);
        solution::solve(&self.structure, &self.numbers, &mut self.ordered);
        for (value, &column) in self.ordered.iter().zip(&self.pivots.columns) {
            b[column] = value * self.column_scale[column];
        }
    }

    /// Scale of each equation.
    pub fn row_scales(&self) -> &[f64] {
        &self.row_scale
    }

    /// Numbers that are stored for the factors.
    pub fn stored(&self) -> usize {
        self.structure.panel_values + self.structure.segment_values * structure::LANES
    }
}
