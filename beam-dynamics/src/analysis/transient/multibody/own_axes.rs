//! Angular momentum as the formulas see it: in the axes of its node.
//!
//! The formulas integrate numbers. The components of an angular momentum in space change
//! with the attitude of a body; those in its own axes, gamma~ = R^T gamma, do not:
//!
//! ```text
//! p      = gamma~ - gamma~_1          p' = R^T (gamma' - omega x gamma)
//! gamma  = R (gamma~_1 + p)           gamma' = R p' + omega x gamma
//!
//! d gamma  = R dp - [gamma]x theta
//! d gamma' = R dp' - [R p']x theta + [omega]x d gamma - [gamma]x d omega
//! ```
//!
//! A slender body that no moment turns about its long axis then keeps its spin to the last
//! digit. In space the error of the formula, of the size of the large moment of inertia,
//! is divided by the small one: the spin drifts, and grows without bound where a step
//! turns the body by about half the root of the ratio of the two.
//!
//! A free body keeps components in space, which no formula changes.

use nalgebra::Matrix3;
use shared_geom::rotation::skew;

use crate::assembly::{Combination, Pattern, System, Variation};
use crate::model::{Equation, NODE_UNKNOWNS, NodeMotion, Variable};

/// Places of a block of a matrix on the pattern, column by column.
type Block = [usize; 9];

/// The four blocks of a node that depend on how its angular momentum is written.
#[derive(Debug, Clone, Copy)]
pub(super) struct Blocks {
    definition_by_rotation: Block,
    definition_by_momentum: Block,
    balance_by_rotation: Block,
    balance_by_momentum: Block,
}

/// The blocks of each node whose angular momentum is integrated in its own axes: those
/// that other nodes, joints or springs act on; `None` for free ones.
pub(super) fn blocks(system: &System) -> Vec<Option<Blocks>> {
    let mut held = vec![false; system.nodes().len()];
    for element in system.elements() {
        let holds =
            element.multipliers() > 0 || element.nodes().len() > 1 || !element.motions().is_empty();
        if holds {
            element.nodes().iter().for_each(|&node| held[node] = true);
        }
    }
    let nodes = held.into_iter().enumerate();
    nodes
        .map(|(node, held)| held.then(|| of_node(system.pattern(), node)).flatten())
        .collect()
}

fn of_node(pattern: &Pattern, node: usize) -> Option<Blocks> {
    let first = NODE_UNKNOWNS * node;
    let block = |row: Equation, column: Variable| -> Option<Block> {
        let mut block = [0; 9];
        for (i, place) in block.iter_mut().enumerate() {
            let (row, column) = (first + row.row() + i % 3, first + column.column() + i / 3);
            *place = pattern.place(row, column)?;
        }
        Some(block)
    };
    let (rotation, momentum) = (Variable::Rotation, Variable::AngularMomentum);
    Some(Blocks {
        definition_by_rotation: block(Equation::AngularMomentum, rotation)?,
        definition_by_momentum: block(Equation::AngularMomentum, momentum)?,
        balance_by_rotation: block(Equation::Moment, rotation)?,
        balance_by_momentum: block(Equation::Moment, momentum)?,
    })
}

impl Blocks {
    /// Rewrites the derivatives of a node, which are by the components in space: only the
    /// balance of the node itself knows its angular momentum, as `gamma` in its definition
    /// and as `-gamma'` in the balance of moments.
    pub fn rewrite(&self, node: &NodeMotion, by: &Variation, sum: &mut Combination<'_>) {
        let (a, b) = (sum.by_unknowns, sum.by_rates);
        let (r, turn, spin) = (&node.rotation, &by.turn, &by.spin);
        let (gamma, omega) = (skew(&node.angular_momentum), skew(&node.angular_velocity));
        let own_rate =
            node.angular_momentum_rate - node.angular_velocity.cross(&node.angular_momentum);
        let values = sum.matrix.values_mut();
        set(values, &self.definition_by_momentum, &(a * r));
        set(values, &self.balance_by_momentum, &-(b * r + a * omega * r));
        add(values, &self.definition_by_rotation, &-(a * gamma * turn));
        let of_balance =
            a * (skew(&own_rate) + omega * gamma) * turn + gamma * (b * turn + a * spin);
        add(values, &self.balance_by_rotation, &of_balance);
    }
}

fn set(values: &mut [f64], block: &Block, new: &Matrix3<f64>) {
    for (place, value) in block.iter().zip(new.iter()) {
        values[*place] = *value;
    }
}

fn add(values: &mut [f64], block: &Block, more: &Matrix3<f64>) {
    for (place, value) in block.iter().zip(more.iter()) {
        values[*place] += *value;
    }
}
