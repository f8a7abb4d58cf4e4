//! The constraints of one element of a loop.

use std::ops::Range;

use nalgebra::DMatrix;

use crate::assembly::system::{System, Workspace};
use crate::elements::{Level, Queries};
use crate::model::{Conditions, NODE_UNKNOWNS, State};

/// Unknowns of the motion of a node.
pub(super) const MOTION: usize = 6;

/// An element of a loop.
#[derive(Debug, Clone)]
pub(super) struct Member {
    /// Index of the element.
    element: usize,
    /// The index of its first constraint in the loop.
    first: usize,
    levels: Vec<Level>,
    /// Its nodes, by their indices in the loop.
    pub nodes: Vec<usize>,
    /// Its rows of A, in the columns of its nodes, six each.
    pub rows: DMatrix<f64>,
}

impl Member {
    /// The element with index `element`, whose constraints begin at `first`, on these nodes of the
    /// loop.
    pub fn new(system: &System, element: usize, first: usize, nodes: Vec<usize>) -> Self {
        let own = &system.elements[element];
        let levels: Vec<_> = (0..own.multipliers()).map(|i| own.level(i)).collect();
        Self {
            element,
            first,
            rows: DMatrix::zeros(levels.len(), MOTION * nodes.len()),
            levels,
            nodes,
        }
    }

    /// Its constraints by their indices in the loop.
    pub fn constraints(&self) -> Range<usize> {
        self.first..self.first + self.levels.len()
    }

    /// Writes its rows, and the force along a unit displacement of each constraint to `forces`,
    /// which holds all of the loop. Rotations are scaled by `size` \[m\].
    pub fn read(
        &mut self,
        system: &System,
        (state, conditions): (&State, &Conditions),
        size: f64,
        work: &mut Workspace,
        forces: &mut [f64],
    ) {
        let local = system.local_jacobian(self.element, state, conditions, work);
        let below = NODE_UNKNOWNS * self.nodes.len();
        for (number, level) in self.levels.iter().enumerate() {
            let from = match level {
                Level::Position => local.by_unknowns(),
                Level::Velocity => local.by_rates(),
            };
            let (mut along, mut about) = (0.0_f64, 0.0_f64);
            for node in 0..self.nodes.len() {
                let entry = |i: usize| from[(below + number, NODE_UNKNOWNS * node + i)];
                let norm = |i: usize| entry(i).hypot(entry(i + 1)).hypot(entry(i + 2));
                (along, about) = (along.max(norm(0)), about.max(norm(3)));
                for i in 0..3 {
                    self.rows[(number, MOTION * node + i)] = entry(i);
                    self.rows[(number, MOTION * node + 3 + i)] = entry(3 + i) / size;
                }
            }
            let force = if along > 0.0 { along } else { about / size };
            let force = if force > 0.0 { force } else { 1.0 };
            forces[self.first + number] = force;
            self.rows.row_mut(number).scale_mut(1.0 / force);
        }
    }
}
