//! Force and moment on a node.
//!
//! A force F at the offset `f = R f~` from the node, and a moment M, times the load's factor and
//! its signal s, which depends on time and on sensors:
//!
//! ```text
//! force balance    F                   dead:      F = const,   M = const
//! moment balance   M + f x F           follower:  F = R F~,    M = R M~
//! ```
//!
//! Variations, with the rotation theta of the node:
//!
//! ```text
//! dead:       d (f x F) = [F]x [f]x theta
//! follower:   d F = -[F]x theta,   d (M + f x F) = -[M + f x F]x theta
//! signal:     d (s F) = F ds
//! ```
//!
//! References: [Masarati], forces and moments on nodes.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

use super::factor::{LoadFactor, Turning};
use super::load::{Add, Head, Load};
use crate::elements::{Local, LocalJacobian, Signal};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, Variable};

/// A force and a moment on an undeformed node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalForce {
    /// Force, model's axes [N].
    pub force: Vector3<f64>,
    /// Moment about the point of attack, model's axes [N m].
    pub moment: Vector3<f64>,
    /// Point of attack from the node, in the node's axes [m].
    pub offset: Vector3<f64>,
    /// Whether it keeps its direction.
    pub turning: Turning,
    /// Factor with which it grows.
    pub factor: LoadFactor,
}

/// A force and a moment on a node.
#[derive(Debug, Clone)]
pub struct NodalLoad {
    head: Head,
    load: NodalForce,
    /// Undeformed attitude of the node.
    rotation: Matrix3<f64>,
}

/// The load at the current state, for the factor one.
struct Acting {
    force: Vector3<f64>,
    arm: Vector3<f64>,
    /// About the node.
    moment: Vector3<f64>,
}

impl NodalLoad {
    /// `load` on node `index`.
    pub fn new(label: impl Into<String>, index: usize, node: &Node, load: NodalForce) -> Self {
        Self {
            head: Head::new(label, vec![index], load.factor),
            load,
            rotation: node.rotation,
        }
    }

    /// The load times a signal.
    #[must_use]
    pub fn driven(mut self, signal: Signal) -> Self {
        self.head.drive(signal);
        self
    }

    fn acting(&self, node: &NodeMotion) -> Acting {
        let turn = match self.load.turning {
            Turning::Dead => Matrix3::identity(),
            Turning::Follower => node.rotation * self.rotation.transpose(),
        };
        let force = turn * self.load.force;
        let arm = node.rotation * self.load.offset;
        Acting {
            force,
            arm,
            moment: turn * self.load.moment + arm.cross(&force),
        }
    }
}

impl Load for NodalLoad {
    fn head(&self) -> &Head {
        &self.head
    }

    fn arm(&self) -> f64 {
        self.load.offset.norm()
    }

    fn add(&self, size: f64, at: &Local<'_>, add: &mut Add<'_>) {
        let acting = self.acting(&at.nodes[0]);
        add(0, Force, &(size * acting.force));
        add(0, Moment, &(size * acting.moment));
    }

    fn add_variation(&self, size: f64, at: &Local<'_>, out: &mut LocalJacobian) {
        let Acting { force, arm, moment } = self.acting(&at.nodes[0]);
        let column = (0, Variable::Rotation);
        match self.load.turning {
            Turning::Dead => {
                let by_rotation = size * skew(&force) * skew(&arm);
                out.add((0, Moment), column, &by_rotation);
            }
            Turning::Follower => {
                out.add((0, Force), column, &(-size * skew(&force)));
                out.add((0, Moment), column, &(-size * skew(&moment)));
            }
        }
    }
}
