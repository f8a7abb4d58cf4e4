//! Clamp: a node held in place and attitude by the model's frame, in all directions or
//! in some.
//!
//! With the held place `x_0` and axes `e_b` (columns of `E`) of the frame, and `e_a`
//! the axes that coincide with them in the undeformed state and turn with the node:
//!
//! ```text
//! e_bi . (x - x_0) = 0                                          multipliers: force
//! e_a2 . e_b3 = 0,   e_a3 . e_b1 = 0,   e_a1 . e_b2 = 0         multipliers: moment
//! ```
//!
//! Where the rotation about one axis, say 1, is free, the rows of the other two are
//! `e_a1 . e_b2 = 0`, `e_a1 . e_b3 = 0`, which stay independent at every angle.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, Vector3};

use super::algebra::{Attachment, Direction, Orthogonality};
use crate::elements::{
    ConstraintRates, Element, Local, LocalJacobian, LocalResidual, Observations, Reaction,
};
use crate::model::Equation::Force;
use crate::model::{Node, NodeMotion, Variable};

/// Pairs (axis of the node, axis of the frame) that are kept orthogonal. At the held
/// attitude `e_a x e_b` is, in turn, along the axes 1, 2 and 3.
pub(super) const PAIRS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// Holds a node to the frame of the model.
#[derive(Debug, Clone)]
pub struct Clamp {
    label: String,
    nodes: [usize; 1],
    position: Vector3<f64>,
    /// Axes in the frame.
    axes: Matrix3<f64>,
    /// The same axes on the node.
    attachment: Attachment,
    /// Axes along which the node is held.
    directions: Vec<usize>,
    /// Pairs of axes that are kept orthogonal.
    pairs: Vec<(usize, usize)>,
}

impl Clamp {
    /// Holds node number `index` in its undeformed place and attitude.
    pub fn new(label: impl Into<String>, index: usize, node: &Node) -> Self {
        Self::partial(label, index, node, &node.rotation, [true; 6])
    }

    /// Holds node number `index` in the directions `held`: three displacements along
    /// `axes` (columns, in the model's frame), three rotations about them.
    pub fn partial(
        label: impl Into<String>,
        index: usize,
        node: &Node,
        axes: &Matrix3<f64>,
        held: [bool; 6],
    ) -> Self {
        let free: Vec<_> = (0..3).filter(|axis| !held[3 + axis]).collect();
        let pairs = match free[..] {
            [axis] => vec![(axis, (axis + 1) % 3), (axis, (axis + 2) % 3)],
            _ => (0..3)
                .filter(|axis| held[3 + axis])
                .map(|axis| PAIRS[axis])
                .collect(),
        };
        Self {
            label: label.into(),
            nodes: [index],
            position: node.position,
            axes: *axes,
            attachment: Attachment::to(node, &node.position, axes),
            directions: (0..3).filter(|&axis| held[axis]).collect(),
            pairs,
        }
    }

    fn held(&self, direction: usize) -> Vector3<f64> {
        self.axes.column(direction).into_owned()
    }

    /// The kept right angles, each with its row.
    fn right_angles(&self, node: &NodeMotion) -> impl Iterator<Item = (usize, Orthogonality)> {
        let turned = node.rotation * self.attachment.axes;
        let (first, frame) = (self.directions.len(), self.axes);
        let pairs = self.pairs.clone().into_iter().enumerate();
        pairs.map(move |(i, (a, b))| {
            let pair = Orthogonality {
                a: Direction::of(Some(0), &turned, a),
                b: Direction::of(None, &frame, b),
            };
            (first + i, pair)
        })
    }
}

impl Element for Clamp {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn multipliers(&self) -> usize {
        self.directions.len() + self.pairs.len()
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let node = &at.nodes[0];
        for (row, &direction) in self.directions.iter().enumerate() {
            let axis = self.held(direction);
            out.add(0, Force, &-(at.multipliers[row] * axis));
            out.add_constraint(row, axis.dot(&(node.position - self.position)));
        }
        for (row, pair) in self.right_angles(node) {
            pair.residual(row, at.multipliers, out);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        for (row, &direction) in self.directions.iter().enumerate() {
            let axis = self.held(direction);
            out.add_multiplier((0, Force), row, &-axis);
            out.add_constraint(row, (0, Variable::Position), &axis.transpose());
        }
        for (row, pair) in self.right_angles(&at.nodes[0]) {
            pair.jacobian(row, at.multipliers, out);
        }
    }

    /// `Phi'' = ... + (omega x (omega x e_a)) . e_b`; the places are linear.
    fn constraint_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        let omega = &at.nodes[0].angular_velocity;
        out.by_time.fill(0.0);
        out.convective.fill(0.0);
        for (row, pair) in self.right_angles(&at.nodes[0]) {
            let turned = omega.cross(&omega.cross(&pair.a.axis));
            out.convective[row] = turned.dot(&pair.b.axis);
        }
        true
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let lambda = at.multipliers;
        let forces = self.directions.iter().enumerate();
        let couples = self.right_angles(&at.nodes[0]);
        out.reactions.push(Reaction {
            joint: self.label.clone(),
            node: self.nodes[0],
            force: forces.map(|(row, &i)| -lambda[row] * self.held(i)).sum(),
            moment: couples.map(|(row, pair)| lambda[row] * pair.couple()).sum(),
        });
    }
}
