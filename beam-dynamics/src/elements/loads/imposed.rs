//! Imposed displacement and rotation of a node: a clamp that moves, in any of its six
//! components.
//!
//! In axes D with the held components i of displacement u and rotation phi, times the
//! factor s of the loads, and with the node's triad `a_i = R R_0^T d_i` and the driven
//! one `b = D R(s phi)`:
//!
//! ```text
//! d_i . (x - x_0) - s u_i = 0                     multiplier: force
//! a_j . b_k = 0                                   multiplier: moment
//! ```
//!
//! Pairs (j, k) for held rotations: three as those of a clamp; two, about all axes but
//! k, keep `a_k` orthogonal to both other driven axes, so that the node turns freely
//! about `b_k` however far; one keeps the two axes orthogonal that its own is normal to.
//! The reactions are those of a clamp: force `-lambda d_i`, couple
//! `-lambda (a_j x b_k)`. By the factor,
//!
//! ```text
//! d b_k / ds = D G(s phi) phi x b_k,   and  G(s phi) phi = phi
//! ```
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, RowVector3, Vector3};
use shared_geom::rotation::{skew, vector};

use super::factor::LoadFactor;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Observations, Reaction};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, Variable};

/// What is imposed on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImposedMotion {
    /// Displacement along each axis; `None` where the node is free [m].
    pub displacement: [Option<f64>; 3],
    /// Components of the rotation vector; `None` where the node is free [rad].
    pub rotation: [Option<f64>; 3],
    /// The axes (columns), in the model's axes [-].
    pub axes: Matrix3<f64>,
    /// What it grows with.
    pub factor: LoadFactor,
}

/// Imposes a motion on a node.
#[derive(Debug, Clone)]
pub struct Imposed {
    label: String,
    nodes: [usize; 1],
    position: Vector3<f64>,
    rotation: Matrix3<f64>,
    motion: ImposedMotion,
    /// Held axes of displacement.
    held: Vec<usize>,
    /// Pairs (axis of the node, driven axis) that are kept orthogonal.
    pairs: Vec<(usize, usize)>,
}

impl Imposed {
    /// Imposes `motion` on node number `index`.
    pub fn new(label: impl Into<String>, index: usize, node: &Node, motion: ImposedMotion) -> Self {
        Self {
            label: label.into(),
            nodes: [index],
            position: node.position,
            rotation: node.rotation,
            held: (0..3)
                .filter(|&i| motion.displacement[i].is_some())
                .collect(),
            pairs: pairs(&motion.rotation),
            motion,
        }
    }

    /// Rotation vector of the driven axes for the factor one, model's axes [rad].
    fn turn(&self) -> Vector3<f64> {
        let angle = |i: usize| self.motion.rotation[i].unwrap_or(0.0);
        self.motion.axes * Vector3::new(angle(0), angle(1), angle(2))
    }

    /// The axes of each pair: one of the node, one driven.
    fn axes(&self, node: &NodeMotion, factor: f64) -> Vec<(Vector3<f64>, Vector3<f64>)> {
        let own = node.rotation * self.rotation.transpose() * self.motion.axes;
        let driven = vector::to_rotation(&(factor * self.turn())) * self.motion.axes;
        let axes = |&(a, b): &(usize, usize)| (own.column(a).into(), driven.column(b).into());
        self.pairs.iter().map(axes).collect()
    }

    fn direction(&self, axis: usize) -> Vector3<f64> {
        self.motion.axes.column(axis).into()
    }

    /// Force and moment on the node, model's axes.
    fn reaction(&self, at: &Local<'_>) -> [Vector3<f64>; 2] {
        let factor = self.motion.factor.value(at.loading);
        let (of_force, of_moment) = at.multipliers.split_at(self.held.len());
        let held = self.held.iter().zip(of_force);
        let axes = self.axes(&at.nodes[0], factor);
        [
            held.map(|(&axis, lambda)| -*lambda * self.direction(axis))
                .sum(),
            axes.iter()
                .zip(of_moment)
                .map(|((a, b), lambda)| -*lambda * a.cross(b))
                .sum(),
        ]
    }
}

/// Pairs of axes to be kept orthogonal for the held components of a rotation.
fn pairs(rotation: &[Option<f64>; 3]) -> Vec<(usize, usize)> {
    let held: Vec<_> = (0..3).filter(|&i| rotation[i].is_some()).collect();
    let next = |i: usize| ((i + 1) % 3, (i + 2) % 3);
    match held[..] {
        // Both turn about the same free axis, which stays along the driven one.
        [i, j] => {
            let free = 3 - i - j;
            vec![(free, next(free).0), (free, next(free).1)]
        }
        // At the undeformed attitude e_a x e_b is along the held axis.
        _ => held.into_iter().map(next).collect(),
    }
}

impl Element for Imposed {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn multipliers(&self) -> usize {
        self.held.len() + self.pairs.len()
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let node = &at.nodes[0];
        let factor = self.motion.factor.value(at.loading);
        let [force, moment] = self.reaction(at);
        out.add(0, Force, &force);
        out.add(0, Moment, &moment);
        let moved = node.position - self.position;
        for (i, &axis) in self.held.iter().enumerate() {
            let imposed = factor * self.motion.displacement[axis].unwrap_or(0.0);
            out.add_constraint(i, self.direction(axis).dot(&moved) - imposed);
        }
        for (i, (a, b)) in self.axes(node, factor).into_iter().enumerate() {
            out.add_constraint(self.held.len() + i, a.dot(&b));
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let factor = self.motion.factor.value(at.loading);
        for (i, &axis) in self.held.iter().enumerate() {
            let direction = self.direction(axis);
            out.add_multiplier((0, Force), i, &-direction);
            out.add_constraint(i, (0, Variable::Position), &direction.transpose());
        }
        let first = self.held.len();
        let mut stiffness = Matrix3::zeros();
        for (i, (a, b)) in self.axes(&at.nodes[0], factor).into_iter().enumerate() {
            let couple = a.cross(&b);
            // d(a x b) = [b]x [a]x theta; d(a . b) = (a x b) . theta.
            stiffness -= at.multipliers[first + i] * skew(&b) * skew(&a);
            out.add_multiplier((0, Moment), first + i, &-couple);
            let row: RowVector3<f64> = couple.transpose();
            out.add_constraint(first + i, (0, Variable::Rotation), &row);
        }
        out.add((0, Moment), (0, Variable::Rotation), &stiffness);
    }

    fn by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let rate = self.motion.factor.derivative();
        let factor = self.motion.factor.value(at.loading);
        for (i, &axis) in self.held.iter().enumerate() {
            out.add_constraint(i, -rate * self.motion.displacement[axis].unwrap_or(0.0));
        }
        let first = self.held.len();
        let turn = rate * self.turn();
        let mut moment = Vector3::zeros();
        for (i, (a, b)) in self.axes(&at.nodes[0], factor).into_iter().enumerate() {
            let b_rate = turn.cross(&b);
            out.add_constraint(first + i, a.dot(&b_rate));
            moment -= at.multipliers[first + i] * a.cross(&b_rate);
        }
        out.add(0, Moment, &moment);
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let [force, moment] = self.reaction(at);
        out.reactions.push(Reaction {
            joint: self.label.clone(),
            node: self.nodes[0],
            force,
            moment,
        });
    }
}
