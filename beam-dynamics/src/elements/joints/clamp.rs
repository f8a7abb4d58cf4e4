//! Clamp: a node held in place and attitude by the model's frame.
//!
//! With the held position `x_0` and axes `e_b` (columns of `R_0`), and `e_a` the axes
//! of the node (columns of `R`):
//!
//! ```text
//! x - x_0 = 0                                                   multipliers: force
//! e_a2 . e_b3 = 0,   e_a3 . e_b1 = 0,   e_a1 . e_b2 = 0         multipliers: moment
//! ```
//!
//! The virtual work of the reactions is `-lambda . d Phi`: the force on the node is
//! `-lambda`, the couple of `e_a . e_b` is `-lambda (e_a x e_b)`.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, RowVector3, Vector3};
use shared_geom::rotation::skew;

use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Observations, Reaction};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, Variable};

/// Pairs (axis of the node, axis of the frame) that are kept orthogonal. At the held
/// attitude `e_a x e_b` is, in turn, along the axes 1, 2 and 3.
const PAIRS: [(usize, usize); 3] = [(1, 2), (2, 0), (0, 1)];

/// Holds a node to the frame of the model.
#[derive(Debug, Clone)]
pub struct Clamp {
    label: String,
    nodes: [usize; 1],
    position: Vector3<f64>,
    rotation: Matrix3<f64>,
}

impl Clamp {
    /// Holds node number `index` in its undeformed place and attitude.
    pub fn new(label: impl Into<String>, index: usize, node: &Node) -> Self {
        Self {
            label: label.into(),
            nodes: [index],
            position: node.position,
            rotation: node.rotation,
        }
    }

    /// Axis `a` of the node and axis `b` of the frame, for each pair.
    fn axes(&self, rotation: &Matrix3<f64>) -> [(Vector3<f64>, Vector3<f64>); 3] {
        PAIRS.map(|(a, b)| {
            (
                rotation.column(a).into_owned(),
                self.rotation.column(b).into_owned(),
            )
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
        6
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let node = &at.nodes[0];
        let lambda = at.multipliers;
        out.add(0, Force, &-Vector3::new(lambda[0], lambda[1], lambda[2]));
        for i in 0..3 {
            out.add_constraint(i, node.position[i] - self.position[i]);
        }
        for (i, (a, b)) in self.axes(&node.rotation).into_iter().enumerate() {
            out.add(0, Moment, &-(lambda[3 + i] * a.cross(&b)));
            out.add_constraint(3 + i, a.dot(&b));
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        for i in 0..3 {
            let mut unit = Vector3::zeros();
            unit[i] = 1.0;
            out.add_multiplier((0, Force), i, &-unit);
            out.add_constraint(i, (0, Variable::Position), &unit.transpose());
        }
        let mut stiffness = Matrix3::zeros();
        for (i, (a, b)) in self.axes(&at.nodes[0].rotation).into_iter().enumerate() {
            let couple = a.cross(&b);
            // d(a x b) = [b]x [a]x theta; d(a . b) = (a x b) . theta.
            stiffness -= at.multipliers[3 + i] * skew(&b) * skew(&a);
            out.add_multiplier((0, Moment), 3 + i, &-couple);
            let row: RowVector3<f64> = couple.transpose();
            out.add_constraint(3 + i, (0, Variable::Rotation), &row);
        }
        out.add((0, Moment), (0, Variable::Rotation), &stiffness);
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let lambda = at.multipliers;
        let couples = self.axes(&at.nodes[0].rotation).into_iter().enumerate();
        let moment = couples
            .map(|(i, (a, b))| -lambda[3 + i] * a.cross(&b))
            .sum();
        out.reactions.push(Reaction {
            joint: self.label.clone(),
            node: self.nodes[0],
            force: -Vector3::new(lambda[0], lambda[1], lambda[2]),
            moment,
        });
    }
}
