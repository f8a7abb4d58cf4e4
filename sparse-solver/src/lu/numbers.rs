//! The values of the factors, and their growth.

use super::elimination::{Area, Extremes, Scaled, Sizes, eliminate};
use super::structure::{Part, Structure};
use crate::number::{LANES, Number};

/// Values of the factors.
#[derive(Debug)]
pub(super) struct Numbers<T: Number> {
    /// Values of the panels, row by row.
    pub lower: Vec<T>,
    /// Values of the segments.
    pub upper: Vec<T::Lanes>,
    /// `1/u_dd` [-].
    pub inverse_pivots: Vec<T>,
    /// Rows of the strips being computed, zero between strips: each branch has its own ones, and
    /// the trunk, which is computed after them, all.
    columns: Vec<T::Lanes>,
    /// Rows of the trunk in the strip of each branch.
    beyond: Vec<Vec<T::Lanes>>,
    /// Largest values of each panel, by columns: of its columns of L, and of its rows of U.
    sizes: Vec<[Sizes; 2]>,
}

/// Largest values of a factorization.
#[derive(Debug, Clone, Copy)]
pub(super) struct Growth {
    /// Of the matrix [-].
    matrix: f64,
    /// Of the columns of L in a panel times the rows of U in it, the largest [-].
    product: f64,
    /// Least pivot [-].
    least_pivot: f64,
}

impl Growth {
    /// Ratio of the rounding error of the factors to the rounding error of the matrix [-]
    /// (D-134).
    pub fn factor(&self) -> f64 {
        self.product / self.matrix
    }

    /// Least pivot relative to the matrix [-].
    pub fn least(&self) -> f64 {
        self.least_pivot / self.matrix
    }
}

impl<T: Number> Numbers<T> {
    pub fn new(structure: &Structure) -> Self {
        let n = structure.trunk.columns.end;
        let of_trunk = structure.trunk.columns.len();
        let branches = structure.branches.iter();
        Self {
            lower: vec![T::ZERO; structure.panel_values],
            upper: vec![T::NONE; structure.segment_values],
            inverse_pivots: vec![T::ZERO; n],
            columns: vec![T::NONE; n],
            beyond: branches.map(|_| vec![T::NONE; of_trunk]).collect(),
            sizes: vec![[[0.0; LANES]; 2]; structure.panels.len()],
        }
    }

    /// Computes the factors, branches in parallel; `None` if a pivot is zero, or a value not
    /// finite.
    pub fn factorize(&mut self, structure: &Structure, matrix: Scaled<'_, T>) -> Option<Growth> {
        let found = self.compute(structure, matrix);
        let Some(found) = found else {
            self.columns.fill(T::NONE);
            let of_branches = self.beyond.iter_mut();
            of_branches.for_each(|rows| rows.fill(T::NONE));
            return None;
        };
        let product = |[lower, upper]: &[Sizes; 2]| largest(lower).max(1.0) * largest(upper);
        let products = self.sizes.iter().map(product);
        Some(Growth {
            matrix: found.matrix,
            product: products.fold(0.0, f64::max),
            least_pivot: found.least_pivot,
        })
    }

    fn compute(&mut self, structure: &Structure, matrix: Scaled<'_, T>) -> Option<Extremes> {
        let mut whole = Area {
            lower: &mut self.lower,
            upper: &mut self.upper,
            inverse_pivots: &mut self.inverse_pivots,
            sizes: &mut self.sizes,
            columns: &mut self.columns[..],
            first: [0; 4],
        };
        let given = (structure, matrix);
        let branches = side_by_side(given, &structure.branches, whole.again(), &mut self.beyond)?;
        let trunk = eliminate(given, &structure.trunk, whole, None)?;
        Some(branches.and(trunk))
    }
}

/// Eliminates independent parts.
fn side_by_side<T: Number>(
    given: (&Structure, Scaled<'_, T>),
    parts: &[Part],
    area: Area<'_, T>,
    beyond: &mut [Vec<T::Lanes>],
) -> Option<Extremes> {
    match (parts, beyond) {
        ([part], [beyond, ..]) => eliminate(given, part, area, Some(beyond)),
        ([_, _, ..], beyond) => {
            let half = parts.len() / 2;
            let (parts, later) = parts.split_at(half);
            let (beyond, later_rows) = beyond.split_at_mut(half);
            let (area, later_area) = area.split(&later[0]);
            let (first, second) = rayon::join(
                || side_by_side(given, parts, area, beyond),
                || side_by_side(given, later, later_area, later_rows),
            );
            Some(first?.and(second?))
        }
        _ => Some(Extremes::NONE),
    }
}

fn largest(of: &Sizes) -> f64 {
    of.iter().fold(0.0, |a, b| a.max(*b))
}
