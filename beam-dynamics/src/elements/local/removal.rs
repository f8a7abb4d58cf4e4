//! Removal of constraints from an element.

use super::{LocalJacobian, LocalResidual};
impl LocalResidual {
    /// Replaces a constraint by "the multiplier is zero".
    pub fn remove_constraint(&mut self, constraint: usize, multiplier: f64) {
        if self.is_ignored() {
            return;
        }
        let row = self.size.multiplier(constraint);
        self.values[row] = multiplier;
        self.sizes[row] = multiplier.abs();
    }
}

impl LocalJacobian {
    /// Replaces a constraint by "the multiplier is zero": its row and its column are cleared.
    pub fn remove_constraint(&mut self, constraint: usize) {
        let index = self.size.multiplier(constraint);
        for matrix in [&mut self.by_unknowns, &mut self.by_rates] {
            matrix.row_mut(index).fill(0.0);
            matrix.column_mut(index).fill(0.0);
        }
        self.by_unknowns[(index, index)] = 1.0;
        if !self.touched.is_empty() {
            self.touched.row_mut(index).fill(false);
            self.touched.column_mut(index).fill(false);
            self.touched[(index, index)] = true;
        }
    }
}
