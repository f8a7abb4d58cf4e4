//! Levels of the constraints of a system, and their derivatives.

use super::{System, Tangent};
use crate::elements::{Element, Level, Queries};
use crate::model::{NODE_UNKNOWNS, Variable};

impl System {
    /// Level of each constraint, in the order of the multipliers.
    pub fn levels(&self) -> Vec<Level> {
        let of = |element: &dyn Element| -> Vec<Level> {
            (0..element.multipliers())
                .map(|i| element.level(i))
                .collect()
        };
        self.elements().flat_map(of).collect()
    }

    /// Entries of `Phi_y`: constraint, index of the unknown, value. Constraints of positions are
    /// differentiated by displacements and rotations, constraints of velocities by their rates;
    /// `wanted` are the requested levels.
    pub fn constraint_rows(&self, tangent: &Tangent, wanted: &[Level]) -> Vec<(usize, usize, f64)> {
        let levels = self.levels();
        let first = NODE_UNKNOWNS * self.nodes.len();
        let mut rows = Vec::new();
        for level in wanted {
            let matrix = match level {
                Level::Position => &tangent.by_unknowns,
                Level::Velocity => &tangent.by_rates,
            };
            let entries = matrix.triplets().filter(|&(row, column, _)| {
                let moves = column % NODE_UNKNOWNS < Variable::Momentum.column();
                let own = row.checked_sub(first).and_then(|row| levels.get(row));
                column < first && moves && own == Some(level)
            });
            rows.extend(entries.map(|(row, column, value)| (row - first, column, value)));
        }
        rows
    }
}
