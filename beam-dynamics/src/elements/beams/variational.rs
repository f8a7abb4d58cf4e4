//! The variational beam: work-equivalent loads, and their tangent.
//!
//! A moment `sigma` on the rotation of the section and a moment `m` on its curvature give, at the
//! nodes and with `a = T^T A^T sigma + S^T m`, `b = T m`, `z_j = N_j a + N'_j b / J0`,
//!
//! ```text
//! y_j  = A_j^T z_j   (j = 1, 3)           y_2 = sigma - y_1 - y_3
//! P    = D(T^T.; A^T sigma) + H           Q   = D(T.; m)
//! E_jk = N_j N_k P + (N_j N'_k Q^T + N'_j N_k Q) / J0
//! d y_j = A_j^T E_jk A_k (theta_k - theta_2) + A D(T^-T.; z_j) A_j (theta_j - theta_2)
//!         + T_j^T [sigma]x theta_2 - [y_j]x theta_2 + T_j^T d sigma
//! ```
//!
//! A force q and a moment m on the line do the work of `sum N_j d p_j . q + theta . m`:
//!
//! ```text
//! force_j = N_j q                         moment_j = f_j x N_j q + T_j^T m
//! ```

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{product, skew, skew_skew, skew_times};

use super::forces::LineForce;
use super::strain::SectionPoint;
use crate::elements::LocalJacobian;
use crate::elements::carried::LoadShare;
use crate::model::Equation;
use crate::model::Equation::{Force, Moment};
use crate::model::Variable::Rotation;

/// `d y_j` by the rotation of node k at fixed sigma and m.
pub(super) fn moment_variation(
    at: &SectionPoint<'_>,
    sigma: &Vector3<f64>,
    m: &Vector3<f64>,
) -> [[Matrix3<f64>; 3]; 3] {
    let SectionPoint {
        nodal,
        shape,
        point,
        theta,
        ..
    } = at;
    let relative = &nodal.relative;
    let carried = nodal.a.transpose() * sigma;
    let bent = point.map.tangent_transpose_derivative(&point.psi_prime);
    let a = point.tangent.tr_mul(&carried) + bent.tr_mul(m);
    let b = point.tangent * m;
    let p = point.map.tangent_transpose_derivative(&carried)
        + point.map.second_derivative(&point.psi_prime, m);
    let q = point.map.tangent_derivative(m);
    let mut out = [[Matrix3::zeros(); 3]; 3];
    for (j, k) in [(0, 0), (0, 2), (2, 0), (2, 2)] {
        let [n, slope] = [&shape.n, &shape.d.map(|d| d / at.j0)];
        let e = n[j] * n[k] * p + n[j] * slope[k] * q.transpose() + slope[j] * n[k] * q;
        out[j][k] = product(&product(&relative[j / 2].transpose(), &e), &relative[k / 2]);
    }
    for j in [0, 2] {
        let z = shape.n[j] * a + at.slope(j) * b;
        let inverse = nodal.outer[j / 2].tangent_inverse_transpose_derivative(&z);
        out[j][j] += product(&product(&nodal.a, &inverse), &relative[j / 2]);
        let y = relative[j / 2].tr_mul(&z);
        let turned = theta[j].tr_mul(&skew(sigma)) - skew(&y);
        out[j][1] = turned - out[j][0] - out[j][2];
    }
    for k in 0..3 {
        out[1][k] = -out[0][k] - out[2][k];
    }
    out
}

/// Adds a load on the line.
pub(super) fn add_on_line(
    at: &SectionPoint<'_>,
    load: &LineForce,
    mut add: impl FnMut(usize, Equation, &Vector3<f64>),
) {
    for j in 0..3 {
        let force = at.shape.n[j] * load.force;
        add(j, Force, &force);
        add(j, Moment, &at.nodal.f[j].cross(&force));
        add(j, Moment, &at.theta[j].tr_mul(&load.moment));
    }
}

/// The part of a load on the line that acts on each node.
pub(super) fn shares(at: &SectionPoint<'_>) -> [LoadShare; 3] {
    std::array::from_fn(|j| LoadShare {
        force: at.shape.n[j],
        moment_by_force: at.shape.n[j] * skew(&at.nodal.f[j]),
        moment_by_moment: at.theta[j].transpose(),
    })
}

/// Adds the variation of a load on the line.
pub(super) fn add_on_line_variation(
    at: &SectionPoint<'_>,
    load: &LineForce,
    out: &mut LocalJacobian,
) {
    let by_moment = if load.moment == Vector3::zeros() {
        None
    } else {
        Some(moment_variation(at, &load.moment, &Vector3::zeros()))
    };
    for j in 0..3 {
        let n = at.shape.n[j];
        for k in 0..3 {
            let mut moment = by_moment.map_or_else(Matrix3::zeros, |by| by[j][k]);
            if let Some([force, turned]) = &load.by_rotation {
                let by_force = n * force[k];
                out.add((j, Force), (k, Rotation), &by_force);
                moment += skew_times(&at.nodal.f[j], &by_force) + at.theta[j].tr_mul(&turned[k]);
            }
            if j == k {
                moment += n * skew_skew(&load.force, &at.nodal.f[j]);
            }
            out.add((j, Moment), (k, Rotation), &moment);
        }
    }
}
