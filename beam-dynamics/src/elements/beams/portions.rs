//! Forces at an evaluation point on the two portions that meet there.
//!
//! The force F and the moment M at the point P act with plus on the node before it and
//! with minus on the node after it, at x each:
//!
//! ```text
//! force  +- F                     moment  +- [ M + (P - x) x F ]
//! ```
//!
//! Their variations, with `d P = N_j (d x_j - [f_j]x theta_j)`:
//!
//! ```text
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{skew, skew_skew, skew_times};

use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::Variable;

const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
const RATES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];

/// Nodes whose portions meet at each evaluation point: the force of the point acts
/// with plus on the first and with minus on the second.
pub(super) const NEIGHBORS: [(usize, usize); 2] = [(0, 1), (1, 2)];

/// Force and moment at an evaluation point, model axes, and what they hang on.
pub(super) struct Internal {
    pub point: PointKinematics,
    /// Force [N] and moment [N m] in model axes.
    pub force: Vector3<f64>,
    pub moment: Vector3<f64>,
}

/// Derivatives of force and moment by position and rotation of one node, or by their
/// rates.
#[derive(Clone, Copy)]
pub(super) struct ByNode {
    pub force: [Matrix3<f64>; 2],
    pub moment: [Matrix3<f64>; 2],
}

impl Internal {
    /// Adds force and moment to the two nodes beside the point.
    pub fn add_forces(
        &self,
        nodal: &NodalKinematics,
        (plus, minus): (usize, usize),
        out: &mut LocalResidual,
    ) {
        for (node, sign) in [(plus, 1.0), (minus, -1.0)] {
            let arm = self.point.p - nodal.x[node];
            out.add(node, Force, &(sign * self.force));
            out.add(node, Moment, &(sign * self.moment));
            out.add(node, Moment, &(sign * arm.cross(&self.force)));
        }
    }

    /// Adds the variations of the forces on the two nodes beside the point by positions
    /// and rotations.
    pub fn add_tangent(
        &self,
        nodal: &NodalKinematics,
        shape: &Shape,
        variation: &[ByNode; 3],
        (plus, minus): (usize, usize),
        out: &mut LocalJacobian,
    ) {
        let skew_force = skew(&self.force);
        for (node, sign) in [(plus, 1.0), (minus, -1.0)] {
            let arm = sign * (self.point.p - nodal.x[node]);
            for (j, by) in variation.iter().enumerate() {
                let n = shape.n[j];
                let own = if j == node { 1.0 } else { 0.0 };
                // [F]x (d P - d x)
                let lever = [
                    sign * (n - own) * skew_force,
                    (-sign * n) * skew_skew(&self.force, &nodal.f[j]),
                ];
                for (k, variable) in UNKNOWNS.into_iter().enumerate() {
                    let moment = sign * by.moment[k] + skew_times(&arm, &by.force[k]) - lever[k];
                    out.add((node, Force), (j, variable), &(sign * by.force[k]));
                    out.add((node, Moment), (j, variable), &moment);
                }
            }
        }
    }

    /// Adds the variations by velocities and angular velocities, at a fixed place.
    pub fn add_rates(
        &self,
        nodal: &NodalKinematics,
        variation: &[ByNode; 3],
        (plus, minus): (usize, usize),
        out: &mut LocalJacobian,
    ) {
        for (node, sign) in [(plus, 1.0), (minus, -1.0)] {
            let arm = sign * (self.point.p - nodal.x[node]);
            for (j, by) in variation.iter().enumerate() {
                for (k, variable) in RATES.into_iter().enumerate() {
                    let moment = sign * by.moment[k] + skew_times(&arm, &by.force[k]);
                    out.add((node, Force), (j, variable), &(sign * by.force[k]));
                    out.add((node, Moment), (j, variable), &moment);
                }
            }
        }
    }
}
