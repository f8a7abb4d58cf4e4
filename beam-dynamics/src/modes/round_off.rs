//! Motions that have no more stiffness than round-off.
//!
//! Stiffnesses are sums of larger ones, of which digits are lost. With the matrix K of the
//! forces by the motions, M the mass and epsilon the round-off of one number, the frequency
//! of a motion q can be computed if it is above about
//!
//! ```text
//! omega_0^2 = epsilon |q|^T |K| |q| / ( q^H M q )                               (D-284)
//! ```
//!
//! The mass is the mass that moves, not the mass of the heaviest or the lightest body.

use faer::{Mat, c64};

use crate::assembly::{Entry, Sparse, Tangent};
use crate::model::{Equation, NODE_UNKNOWNS};

/// Motions of a node: its displacement and rotation, the first of its unknowns.
const MOTIONS: usize = NODE_UNKNOWNS / 2;

/// Stiffness and mass of the nodes, for the frequency that round-off may give a motion.
#[derive(Debug)]
pub(super) struct RoundOff {
    stiffness: Vec<Entry>,
    mass: Vec<Entry>,
}

impl RoundOff {
    /// Of a tangent with so many unknowns of nodes.
    pub fn new(tangent: &Tangent, size: usize) -> Self {
        let forces = |matrix: &Sparse, first: usize| -> Vec<Entry> {
            let wanted = |&(row, column, value): &Entry| {
                let row_of_node = (row % NODE_UNKNOWNS).wrapping_sub(first);
                let is_motion = row_of_node.max(column % NODE_UNKNOWNS) < MOTIONS;
                row.max(column) < size && value != 0.0 && is_motion
            };
            let entries = matrix.triplets().filter(wanted);
            entries
                .map(|(row, column, value)| (row - first, column, value))
                .collect()
        };
        Self {
            stiffness: forces(&tangent.by_unknowns, Equation::Force.row()),
            mass: forces(&tangent.by_rates, Equation::Momentum.row()),
        }
    }

    /// omega_0 \[1/s\] of a vector in all unknowns, real and imaginary part a column each.
    pub fn frequency(&self, vector: &Mat<f64>) -> f64 {
        let at = |index: usize| c64::new(vector[(index, 0)], vector[(index, 1)]);
        let stiffness = |&(i, j, value): &Entry| at(i).norm() * value.abs() * at(j).norm();
        let mass = |&(i, j, value): &Entry| -value * (at(i).conj() * at(j)).re;
        let stiffness: f64 = self.stiffness.iter().map(stiffness).sum();
        let mass: f64 = self.mass.iter().map(mass).sum();
        (f64::EPSILON * stiffness / mass.max(f64::MIN_POSITIVE)).sqrt()
    }
}
