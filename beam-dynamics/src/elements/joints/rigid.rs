//! Rigid connection: two nodes that move as one body, at any distance.
//!
//! Node b is attached to node a where it is in the undeformed state:
//!
//! ```text
//! (x_a + f_a) - x_b = 0                                         multipliers: force
//! e_a2 . e_b3 = 0,   e_a3 . e_b1 = 0,   e_a1 . e_b2 = 0         multipliers: moment
//! ```
//!
//! with `f_a` the offset of b from a and `e_a` the axes of b as they turn with a.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::Matrix3;

use super::algebra::{Attachment, Direction, Orthogonality, Point, three};
use super::clamp::PAIRS;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Observations, Reaction};
use crate::model::{Node, NodeMotion};

/// Holds a node to another one.
#[derive(Debug, Clone)]
pub struct RigidConnection {
    label: String,
    nodes: [usize; 2],
    /// Place and axes of the second node on each of the two.
    attachments: [Attachment; 2],
}

impl RigidConnection {
    /// Holds the second of the nodes number `nodes`, undeformed at `undeformed`, to the
    /// first.
    pub fn new(label: impl Into<String>, nodes: [usize; 2], undeformed: [&Node; 2]) -> Self {
        let second = undeformed[1];
        Self {
            label: label.into(),
            nodes,
            attachments: undeformed
                .map(|node| Attachment::to(node, &second.position, &second.rotation)),
        }
    }

    fn ends(&self, nodes: &[NodeMotion]) -> [(Point, Matrix3<f64>); 2] {
        std::array::from_fn(|i| self.attachments[i].at(i, &nodes[i]))
    }

    fn right_angles(ends: &[(Point, Matrix3<f64>); 2]) -> [Orthogonality; 3] {
        PAIRS.map(|(a, b)| Orthogonality {
            a: Direction::of(Some(0), &ends[0].1, a),
            b: Direction::of(Some(1), &ends[1].1, b),
        })
    }
}

impl Element for RigidConnection {
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
        let ends = self.ends(at.nodes);
        ends[0].0.residual(1.0, 0, at.multipliers, out);
        ends[1].0.residual(-1.0, 0, at.multipliers, out);
        for (i, pair) in Self::right_angles(&ends).iter().enumerate() {
            pair.residual(3 + i, at.multipliers, out);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let ends = self.ends(at.nodes);
        ends[0].0.jacobian(1.0, 0, at.multipliers, out);
        ends[1].0.jacobian(-1.0, 0, at.multipliers, out);
        for (i, pair) in Self::right_angles(&ends).iter().enumerate() {
            pair.jacobian(3 + i, at.multipliers, out);
        }
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let ends = self.ends(at.nodes);
        let couples = Self::right_angles(&ends).into_iter().enumerate();
        let couple = couples
            .map(|(i, pair)| at.multipliers[3 + i] * pair.couple())
            .sum::<nalgebra::Vector3<f64>>();
        for (i, sign) in [(0, 1.0), (1, -1.0)] {
            let (force, moment) = ends[i].0.reaction(&three(at.multipliers, 0));
            out.reactions.push(Reaction {
                joint: self.label.clone(),
                node: self.nodes[i],
                force: sign * force,
                moment: sign * (moment + couple),
            });
        }
    }
}
