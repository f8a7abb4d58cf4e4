//! What constraints are made of: points that coincide and directions at right angles.
//!
//! A point and axes are attached to a node, `f = R f~`, `E = R E~`. The virtual work of
//! the reactions is `-lambda . d Phi`:
//!
//! ```text
//! coincidence    Phi = (x_a + f_a) - (x_b + f_b)      on a: force -lambda, moment -f_a x lambda
//!                                                     on b: the opposite, with f_b
//! orthogonality  Phi = e_a . e_b                      on a: moment -lambda (e_a x e_b)
//!                                                     on b: the opposite
//! ```
//!
//! Variations, with spatial rotations `theta`:
//!
//! ```text
//! d f = -[f]x theta                          d(f x lambda) = [lambda]x [f]x theta
//! d(e_a . e_b) = (e_a x e_b) . (theta_a - theta_b)
//! d(e_a x e_b) = [e_b]x [e_a]x theta_a - [e_a]x [e_b]x theta_b
//! ```
//!
//! The frame of the model stands for a node that does not move.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, Variable};

/// A point and axes fixed to a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attachment {
    /// Offset of the point from the node, in node axes [m].
    pub offset: Vector3<f64>,
    /// The axes (columns) in node axes [-].
    pub axes: Matrix3<f64>,
}

impl Attachment {
    /// The point and the axes of the undeformed model that move with `node`: `position`
    /// and `axes` (columns) are given in the model's frame.
    pub fn to(node: &Node, position: &Vector3<f64>, axes: &Matrix3<f64>) -> Self {
        let back = node.rotation.transpose();
        Self {
            offset: back * (position - node.position),
            axes: back * axes,
        }
    }

    /// Where the point and the axes are now, for local node number `node`.
    pub(super) fn at(&self, node: usize, motion: &NodeMotion) -> (Point, Matrix3<f64>) {
        let arm = motion.rotation * self.offset;
        let point = Point {
            node,
            place: motion.position + arm,
            arm,
        };
        (point, motion.rotation * self.axes)
    }
}

/// A point that moves with a node.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// Local number of the node.
    node: usize,
    /// Place [m].
    pub place: Vector3<f64>,
    /// Offset from the node, model axes [m].
    arm: Vector3<f64>,
}

impl Point {
    /// Force and moment on the node by the multipliers `lambda`: those of a point with
    /// sign plus in the constraint.
    pub fn reaction(&self, lambda: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        (-lambda, -self.arm.cross(lambda))
    }

    /// Adds the share of this point in the three constraints from `first` on, with
    /// `sign`, and its reactions.
    pub fn residual(&self, sign: f64, first: usize, lambda: &[f64], out: &mut LocalResidual) {
        let (force, moment) = self.reaction(&three(lambda, first));
        out.add(self.node, Force, &(sign * force));
        out.add(self.node, Moment, &(sign * moment));
        for i in 0..3 {
            out.add_constraint(first + i, sign * self.place[i]);
        }
    }

    /// Derivatives of [`Self::residual`].
    pub fn jacobian(&self, sign: f64, first: usize, lambda: &[f64], out: &mut LocalJacobian) {
        let arm = skew(&self.arm);
        let by_rotation = -sign * arm;
        let moment = -sign * skew(&three(lambda, first)) * arm;
        let (position, rotation) = (Variable::Position, Variable::Rotation);
        for i in 0..3 {
            let mut unit = Vector3::zeros();
            unit[i] = sign;
            out.add_constraint(first + i, (self.node, position), &unit.transpose());
            let row = by_rotation.row(i).into_owned();
            out.add_constraint(first + i, (self.node, rotation), &row);
            out.add_multiplier((self.node, Force), first + i, &-unit);
            let column = -sign * arm.column(i);
            out.add_multiplier((self.node, Moment), first + i, &column);
        }
        out.add((self.node, Moment), (self.node, rotation), &moment);
    }
}

/// The multipliers from `first` on.
pub(super) fn three(lambda: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(lambda[first], lambda[first + 1], lambda[first + 2])
}

/// A direction that turns with a node, or stands in the frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Direction {
    /// Local number of the node; `None` for the frame.
    pub node: Option<usize>,
    /// The unit vector, model axes [-].
    pub axis: Vector3<f64>,
}

impl Direction {
    /// Column `axis` of the axes `of` that turn with local node `node`.
    pub fn of(node: Option<usize>, of: &Matrix3<f64>, axis: usize) -> Self {
        Self {
            node,
            axis: of.column(axis).into_owned(),
        }
    }
}

/// Two directions that are kept at right angles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Orthogonality {
    pub a: Direction,
    pub b: Direction,
}

impl Orthogonality {
    /// The couple on a for a multiplier of one: `-(e_a x e_b)`.
    pub fn couple(&self) -> Vector3<f64> {
        -self.a.axis.cross(&self.b.axis)
    }

    /// The ends that turn with a node, with the sign of their couple.
    fn ends(&self) -> impl Iterator<Item = (usize, f64)> {
        let ends = [(self.a.node, 1.0), (self.b.node, -1.0)];
        ends.into_iter()
            .filter_map(|(node, sign)| Some((node?, sign)))
    }

    /// Adds constraint number `row` and its couples.
    pub fn residual(&self, row: usize, lambda: &[f64], out: &mut LocalResidual) {
        out.add_constraint(row, self.a.axis.dot(&self.b.axis));
        for (node, sign) in self.ends() {
            out.add(node, Moment, &(sign * lambda[row] * self.couple()));
        }
    }

    /// Derivatives of [`Self::residual`].
    pub fn jacobian(&self, row: usize, lambda: &[f64], out: &mut LocalJacobian) {
        let rotation = Variable::Rotation;
        let (a, b) = (skew(&self.a.axis), skew(&self.b.axis));
        for (node, sign) in self.ends() {
            out.add_constraint(row, (node, rotation), &(-sign * self.couple().transpose()));
            out.add_multiplier((node, Moment), row, &(sign * self.couple()));
            for (by, _) in self.ends() {
                let of_cross = if Some(by) == self.a.node {
                    b * a
                } else {
                    -a * b
                };
                let block = -sign * lambda[row] * of_cross;
                out.add((node, Moment), (by, rotation), &block);
            }
        }
    }
}
