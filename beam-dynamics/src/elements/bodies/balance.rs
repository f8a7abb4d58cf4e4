//! Balance of momentum and angular momentum of a node.
//!
//! In components of a frame that turns with `Omega`, with `v` the velocity of the
//! node in space:
//!
//! ```text
//! momentum            beta                                     (bodies subtract theirs)
//! angular momentum    gamma
//! force balance     - (beta'  + Omega x beta)                  (elements add their forces)
//! moment balance    - (gamma' + Omega x gamma) - v x beta      (moments about the moving node)
//! ```
//!
//! References: [Masarati], balance equations of a rigid body about a moving point.

use nalgebra::Matrix3;
use shared_geom::rotation::{skew, skew_skew};

use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::Equation::{AngularMomentum, Force, Moment, Momentum};
use crate::model::Variable;

/// The node's own terms in its equations. Every node has one.
#[derive(Debug, Clone)]
pub struct NodeBalance {
    label: String,
    nodes: [usize; 1],
}

impl NodeBalance {
    /// The balance of node `node`.
    pub fn new(label: impl Into<String>, node: usize) -> Self {
        Self {
            label: label.into(),
            nodes: [node],
        }
    }
}

impl Element for NodeBalance {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let node = &at.nodes[0];
        let omega = &at.frame.angular_velocity;
        let v = node.velocity_in_space(at.frame);

        out.add(0, Momentum, &node.momentum);
        out.add(0, AngularMomentum, &node.angular_momentum);
        out.add(0, Force, &-node.momentum_rate);
        out.add(0, Force, &-omega.cross(&node.momentum));
        out.add(0, Moment, &-node.angular_momentum_rate);
        out.add(0, Moment, &-omega.cross(&node.angular_momentum));
        out.add(0, Moment, &-v.cross(&node.momentum));
        let Some(out) = jacobian else { return };
        let node = &at.nodes[0];
        let identity = Matrix3::identity();
        let turning = at.frame.skew();
        let v = skew(&node.velocity_in_space(at.frame));
        let beta = &node.momentum;
        let by_position = skew_skew(beta, &at.frame.angular_velocity);

        out.add((0, Momentum), (0, Variable::Momentum), &identity);
        out.add(
            (0, AngularMomentum),
            (0, Variable::AngularMomentum),
            &identity,
        );
        out.add((0, Force), (0, Variable::MomentumRate), &-identity);
        out.add((0, Force), (0, Variable::Momentum), &-turning);
        out.add((0, Moment), (0, Variable::AngularMomentumRate), &-identity);
        out.add((0, Moment), (0, Variable::AngularMomentum), &-turning);
        // An integration scheme may write gamma in the axes of the node.
        let zero = Matrix3::zeros();
        out.add((0, AngularMomentum), (0, Variable::Rotation), &zero);
        out.add((0, Moment), (0, Variable::Rotation), &zero);
        out.add((0, Moment), (0, Variable::Momentum), &-v);
        out.add((0, Moment), (0, Variable::Velocity), &skew(beta));
        out.add((0, Moment), (0, Variable::Position), &by_position);
    }
}
