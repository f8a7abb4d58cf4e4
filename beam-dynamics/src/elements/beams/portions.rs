//! The finite-volume beam: balance of the three portions between its evaluation points.
//!
//! The beam is cut at the evaluation points I and II into three portions, each in balance with its
//! node. The force `F = R F~` and the moment `M = R M~` at the point P act with a plus sign on the
//! node before it and with a minus sign on the node after it, each at x:
//!
//! ```text
//! force  +- F                     moment  +- [ M + (P - x) x F ]
//! ```
//!
//! with the variations, at fixed F~ and M~ and with `d P = N_j (d x_j - [f_j]x theta_j)`,
//!
//! ```text
//! d F = -[F]x theta        d M = -[M]x theta
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! A force q and a moment m on a portion act on its node as q and `(p - x) x q + m`.
//!
//! References: [Masarati], the three-node finite-volume beam (5.2-5.4).

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{skew, skew_skew, skew_times, times_skew};

use super::forces::{LineForce, Test};
use super::strain::SectionPoint;
use crate::elements::LocalJacobian;
use crate::elements::carried::LoadShare;
use crate::model::Equation;
use crate::model::Equation::{Force, Moment};
use crate::model::Variable::{Position, Rotation};

/// Nodes whose portions meet at each evaluation point, with the sign of its force.
const NEIGHBORS: [[(usize, f64); 2]; 2] = [[(0, 1.0), (1, -1.0)], [(1, 1.0), (2, -1.0)]];

/// W: minus the forces on the nodes by the section force, transposed.
pub(super) fn test(index: usize, at: &SectionPoint<'_>) -> Test {
    let rt = at.point.r.transpose();
    let mut out = Test::zeros();
    for (node, sign) in NEIGHBORS[index] {
        let turned = -sign * rt;
        let arm = at.point.p - at.nodal.x[node];
        // ([P - x]x R)^T = - R^T [P - x]x
        let lever = -times_skew(&turned, &arm);
        out.fixed_view_mut::<3, 3>(0, 6 * node).copy_from(&turned);
        out.fixed_view_mut::<3, 3>(0, 6 * node + 3)
            .copy_from(&lever);
        out.fixed_view_mut::<3, 3>(3, 6 * node + 3)
            .copy_from(&turned);
    }
    out
}

/// Adds the tangent at fixed section forces.
pub(super) fn add_geometric(
    index: usize,
    at: &SectionPoint<'_>,
    force: &Vector3<f64>,
    moment: &Vector3<f64>,
    out: &mut LocalJacobian,
) {
    let (force, moment) = (at.point.r * force, at.point.r * moment);
    for (node, sign) in NEIGHBORS[index] {
        let by_rotation =
            [&force, &moment].map(|of| at.theta.map(|theta| -sign * skew_times(of, &theta)));
        let load = LineForce {
            force: sign * force,
            moment: sign * moment,
            by_rotation: Some(by_rotation),
        };
        add_on_line_variation(node, at, &load, out);
    }
}

/// Adds a load on the portion of a node.
pub(super) fn add_on_line(
    node: usize,
    at: &SectionPoint<'_>,
    load: &LineForce,
    mut add: impl FnMut(usize, Equation, &Vector3<f64>),
) {
    let arm = at.point.p - at.nodal.x[node];
    add(node, Force, &load.force);
    add(node, Moment, &load.moment);
    add(node, Moment, &arm.cross(&load.force));
}

/// The part of a load on the portion of `node` that acts on each node.
pub(super) fn shares(node: usize, at: &SectionPoint<'_>) -> [LoadShare; 3] {
    let mut shares = [LoadShare::default(); 3];
    shares[node] = LoadShare {
        force: 1.0,
        moment_by_force: skew(&(at.point.p - at.nodal.x[node])),
        moment_by_moment: Matrix3::identity(),
    };
    shares
}

/// Adds the variation of a load on the portion of a node.
pub(super) fn add_on_line_variation(
    node: usize,
    at: &SectionPoint<'_>,
    load: &LineForce,
    out: &mut LocalJacobian,
) {
    let arm = at.point.p - at.nodal.x[node];
    for j in 0..3 {
        let n = at.shape.n[j];
        let own = if j == node { 1.0 } else { 0.0 };
        out.add(
            (node, Moment),
            (j, Position),
            &((own - n) * skew(&load.force)),
        );
        let mut by_turn: Matrix3<f64> = n * skew_skew(&load.force, &at.nodal.f[j]);
        if let Some([force, moment]) = &load.by_rotation {
            out.add((node, Force), (j, Rotation), &force[j]);
            by_turn += moment[j] + skew_times(&arm, &force[j]);
        }
        out.add((node, Moment), (j, Rotation), &by_turn);
    }
}
