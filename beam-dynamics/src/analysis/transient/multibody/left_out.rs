//! Constraints that follow from others: their multipliers are zero instead.

use crate::assembly::{Combination, Residual, System};
use crate::model::NODE_UNKNOWNS;

/// The constraints that are left out.
#[derive(Debug)]
pub(super) struct LeftOut {
    /// Their numbers among the multipliers.
    constraints: Vec<usize>,
    /// Number of the first multiplier among the unknowns.
    first: usize,
    /// Entries of their rows on the pattern, and whether each is on the diagonal.
    entries: Vec<(usize, bool)>,
}

impl LeftOut {
    pub fn new(system: &System, constraints: Vec<usize>) -> Self {
        let pattern = system.pattern();
        let first = NODE_UNKNOWNS * system.nodes().len();
        let mut entries = Vec::new();
        for &constraint in &constraints {
            let row = first + constraint;
            for column in 0..pattern.size() {
                let place = pattern.place(row, column);
                entries.extend(place.map(|place| (place, column == row)));
            }
        }
        Self {
            constraints,
            first,
            entries,
        }
    }

    /// Their numbers among the multipliers.
    pub fn constraints(&self) -> &[usize] {
        &self.constraints
    }

    /// Puts the multipliers where the constraints stood.
    pub fn residual(&self, multipliers: &[f64], out: &mut Residual) {
        for &constraint in &self.constraints {
            let place = self.first + constraint;
            out.values[place] = multipliers[constraint];
            out.sizes[place] = multipliers[constraint].abs();
        }
    }

    /// Derivatives of [`Self::residual`].
    pub fn rewrite(&self, sum: &mut Combination<'_>) {
        let weight = sum.by_algebraic;
        let values = sum.matrix.values_mut();
        for &(place, on_diagonal) in &self.entries {
            values[place] = if on_diagonal { weight } else { 0.0 };
        }
    }
}
