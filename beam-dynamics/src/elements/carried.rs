//! A point that nodes carry: a body's point, or a point of the line of a beam.
//!
//! With the shares N_j, offsets f_j and turns T_j of the nodes, the point p, its axes R and its
//! motion relative to the frame are
//!
//! ```text
//! d p   = N_j (d x_j - [f_j]x theta_j)           theta = T_j theta_j
//! p'    = N_j (x'_j + omega_j x f_j)             omega = N_j omega_j
//! ```
//!
//! A force F and a moment M at the point act on node j as `n_j F` and `A_j F + B_j M`.

use nalgebra::{Matrix3, Vector3};

use super::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::NodeMotion;

/// The part of a load that acts on one node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct LoadShare {
    /// `n_j` \[-\].
    pub force: f64,
    /// `A_j` \[m\].
    pub moment_by_force: Matrix3<f64>,
    /// `B_j` \[-\].
    pub moment_by_moment: Matrix3<f64>,
}

/// The part of one node in the motion and in the loads of a point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Share {
    /// `N_j` \[-\].
    pub weight: f64,
    /// `f_j`, model axes \[m\].
    pub offset: Vector3<f64>,
    /// `T_j` \[-\].
    pub turn: Matrix3<f64>,
    /// Its part of the loads.
    pub load: LoadShare,
}

/// A point at a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct CarriedPoint {
    /// p, model axes \[m\].
    pub position: Vector3<f64>,
    /// R, columns are the axes that the point carries \[-\].
    pub rotation: Matrix3<f64>,
    /// Parts of the nodes, the first `count` of them.
    pub shares: [Share; 3],
    /// Number of nodes.
    pub count: usize,
}

impl CarriedPoint {
    /// Parts of the nodes.
    pub fn shares(&self) -> &[Share] {
        &self.shares[..self.count]
    }

    /// Velocity [m/s] and angular velocity [rad/s] relative to the frame.
    pub fn velocities(&self, nodes: &[NodeMotion]) -> [Vector3<f64>; 2] {
        let mut sums = [Vector3::zeros(); 2];
        for (share, node) in self.shares().iter().zip(nodes) {
            let turned = node.angular_velocity.cross(&share.offset);
            sums[0] += share.weight * (node.velocity + turned);
            sums[1] += share.weight * node.angular_velocity;
        }
        sums
    }

    /// Adds a force and a moment at the point, model axes [N, N m].
    pub fn add(&self, force: &Vector3<f64>, moment: &Vector3<f64>, out: &mut LocalResidual) {
        for (j, load) in self.loads() {
            out.add(j, Force, &(load.force * force));
            out.add(j, Moment, &(load.moment_by_force * force));
            out.add(j, Moment, &(load.moment_by_moment * moment));
        }
    }

    /// The nodes on which loads act, with their parts.
    pub fn loads(&self) -> impl Iterator<Item = (usize, &LoadShare)> {
        let loads = self.shares().iter().map(|share| &share.load).enumerate();
        // Portions of finite volumes are of one node.
        loads.filter(|(_, load)| **load != LoadShare::default())
    }

    /// Adds the variation of force and moment with a scalar of the element, or with its rate.
    pub fn add_by_scalar(
        &self,
        column: (usize, bool),
        by: &[Vector3<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        for (j, load) in self.loads() {
            out.add_by_scalar((j, Force), column, &(load.force * by[0]));
            let moment = load.moment_by_force * by[0] + load.moment_by_moment * by[1];
            out.add_by_scalar((j, Moment), column, &moment);
        }
    }
}
