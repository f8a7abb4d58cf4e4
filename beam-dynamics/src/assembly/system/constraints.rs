//! Levels of the constraints of a system, and their derivatives.

use super::{System, Tangent};
use crate::elements::{Element, Level};
use crate::model::{Conditions, NODE_UNKNOWNS, Variable};

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

    /// Unit of a constraint: that of a length or of an angle, or of its rate.
    pub fn unit_of_constraint(&self, constraint: usize) -> &'static str {
        let tangent = self.tangent(&self.rest(), &Conditions::at_rest());
        let levels = [Level::Position, Level::Velocity];
        let entries = self.constraint_rows(&tangent, &levels).into_iter();
        let mut of_it = entries.filter(|entry| entry.0 == constraint && entry.2 != 0.0);
        let is_length = of_it.any(|entry| entry.1 % NODE_UNKNOWNS < Variable::Rotation.column());
        match (is_length, self.levels().get(constraint)) {
            (true, Some(Level::Velocity)) => "m/s",
            (false, Some(Level::Velocity)) => "rad/s",
            (true, _) => "m",
            (false, _) => "rad",
        }
    }

    /// `Phi_y` by its entries: constraint, place of the unknown, value. Constraints of
    /// positions are differentiated by displacements and rotations, those of velocities by
    /// their rates; `wanted` are the levels that count.
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
                row >= first && column < first && moves && levels[row - first] == *level
            });
            rows.extend(entries.map(|(row, column, value)| (row - first, column, value)));
        }
        rows
    }
}
