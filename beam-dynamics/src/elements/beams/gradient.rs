//! Gradient of the energy of a variational beam, and its tangent at fixed section forces.
//!
//! Strains of a beam depend only on the motion of its outer nodes relative to its middle one: with
//! `r_j = p_j - p_2`, `t_j = theta_j - theta_2` and the parameters psi_j (see
//! [`super::interpolation`]), at fixed `theta_2`,
//!
//! ```text
//! d l = N'_j / J0 d r_j       d psi = N_j A_j t_j      d psi' = N'_j / J0 A_j t_j     (j = 1, 3)
//! ```
//!
//! With the section force `q = [F~; M~]`, the weight `w = J0`, `F = w R F~`, `M = w M~`,
//! `B = A T` and `c = F x l`, the gradient at a point by l, psi and psi' is
//!
//! ```text
//! F                       B^T c + S^T M                    T M                   (D-282)
//! ```
//!
//! and its tangent at fixed section forces
//!
//! ```text
//!        by l        by psi                                          by psi'
//! l      0           -[F]x B                                         0
//! psi    B^T [F]x    D(T^T.; A^T c) + B^T [l]x [F]x B + H            D(T.; M)^T
//! psi'   0           D(T.; M)                                        0
//! ```
//!
//! The sums over the points by N_j and `N'_j / J0` are the gradient g_rj and g_psi,j, and its
//! tangent, by the r_j and psi_j of the element. The forces on the beam points at the outer
//! nodes are minus
//!
//! ```text
//! f_j = g_rj                  m_j = A_j^T g_psi,j
//! f_2 = - f_1 - f_3           m_2 = - m_1 - m_3 - r_j x f_j                          (D-283)
//! d f_j = theta_2 x f_j + d g_rj ,     d r_j = u_j = d p_j - d p_2
//! d m_j = theta_2 x m_j + A_j^T d g_psi,j + A D(T_j^-T.; g_psi,j) A_j t_j
//! ```
//!
//! where the argument of g is `u_j + [r_j]x theta_2`; an offset f from the node adds `f x f_j` to
//! its moment. The other part of the tangent, `W^T dq`, is common to all beams (see
//! [`super::forces`]). The whole is symmetric if the slopes of the law are, except for `-1/2
//! [m_j]x` of each node, m_j being the moment of the element there; these terms cancel at nodes in
//! balance.

use nalgebra::{Matrix3, Vector3, Vector6};
use shared_geom::rotation::{product, skew, skew_skew, skew_times, times_skew};

use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::Variable::{Position, Rotation};

/// The outer nodes.
const OUTER: [usize; 2] = [0, 2];

/// An evaluation point.
#[derive(Clone, Copy)]
pub(super) struct EvaluationPoint<'a> {
    pub shape: &'a Shape,
    /// Undeformed length per unit of xi [m].
    pub j0: f64,
    pub point: &'a PointKinematics,
}

impl EvaluationPoint<'_> {
    /// N and `N' / J0` of the outer nodes.
    fn weights(&self) -> [[f64; 2]; 2] {
        let Shape { n, d } = self.shape;
        [[n[0], d[0] / self.j0], [n[2], d[2] / self.j0]]
    }

    /// S of the section.
    fn bent(&self) -> Matrix3<f64> {
        let PointKinematics { map, psi_prime, .. } = self.point;
        map.tangent_transpose_derivative(psi_prime)
    }
}

/// The gradient by positions and rotations of the outer nodes.
struct Gradient {
    /// f of the outer nodes [N].
    forces: [Vector3<f64>; 2],
    /// g_psi due to the forces of the sections, and due to their moments [N m].
    by_psi: [[Vector3<f64>; 2]; 2],
}

impl Gradient {
    fn new(nodal: &NodalKinematics, points: &[(EvaluationPoint<'_>, &Vector6<f64>); 2]) -> Self {
        let zero = [Vector3::zeros(); 2];
        let mut sum = Self {
            forces: zero,
            by_psi: [zero; 2],
        };
        for (point, q) in points {
            let [force, moment] = section_forces(point, q);
            let PointKinematics { tangent, l, .. } = point.point;
            let bending = tangent.tr_mul(&nodal.a.tr_mul(&force.cross(l)));
            let bent = point.bent().tr_mul(&moment);
            let along = tangent * moment;
            for (k, [n, slope]) in point.weights().into_iter().enumerate() {
                sum.forces[k] += slope * force;
                sum.by_psi[k][0] += n * bending;
                sum.by_psi[k][1] += n * bent + slope * along;
            }
        }
        sum
    }
}

/// `F = w R F~` and `M = w M~`.
fn section_forces(point: &EvaluationPoint<'_>, q: &Vector6<f64>) -> [Vector3<f64>; 2] {
    let force = point.j0 * q.fixed_rows::<3>(0);
    [point.point.r * force, point.j0 * q.fixed_rows::<3>(3)]
}

/// Positions of the outer beam points relative to the middle one.
fn arms(nodal: &NodalKinematics) -> [Vector3<f64>; 2] {
    [nodal.p[0] - nodal.p[1], nodal.p[2] - nodal.p[1]]
}

/// Adds the forces on the nodes of the section forces q at both points.
pub(super) fn add_forces(
    nodal: &NodalKinematics,
    points: &[(EvaluationPoint<'_>, &Vector6<f64>); 2],
    out: &mut LocalResidual,
) {
    let Gradient { forces, by_psi } = Gradient::new(nodal, points);
    let (relative, arms) = (&nodal.relative, arms(nodal));
    let mut middle = [Vector3::zeros(); 2];
    for (k, j) in OUTER.into_iter().enumerate() {
        out.add(j, Force, &-forces[k]);
        out.add(1, Force, &forces[k]);
        for (sum, by) in middle.iter_mut().zip(&by_psi[k]) {
            let moment = relative[k].tr_mul(by);
            out.add(j, Moment, &-moment);
            *sum += moment;
        }
        middle[0] += arms[k].cross(&forces[k]);
    }
    for moment in middle {
        out.add(1, Moment, &moment);
    }
    let nodes = [forces[0], -forces[0] - forces[1], forces[1]];
    for (j, force) in nodes.into_iter().enumerate() {
        if nodal.f[j] != Vector3::zeros() {
            out.add(j, Moment, &-nodal.f[j].cross(&force));
        }
    }
}

/// Second derivatives by r and psi of the outer nodes, at fixed section forces; those by r and r
/// are zero.
#[derive(Default)]
struct Hessian {
    /// By r of the first node and psi of the second.
    rp: [[Matrix3<f64>; 2]; 2],
    /// By psi and psi.
    pp: [[Matrix3<f64>; 2]; 2],
}

impl Hessian {
    /// Adds the derivatives of a point of section force `q`; `a` are the axes of the middle node.
    fn add(&mut self, a: &Matrix3<f64>, point: &EvaluationPoint<'_>, q: &Vector6<f64>) {
        let PointKinematics {
            l,
            tangent,
            map,
            psi_prime,
            ..
        } = point.point;
        let [force, moment] = section_forces(point, q);
        let b = product(a, tangent);
        let turned = skew_times(&force, &b);
        let twisted = map.tangent_derivative(&moment);
        let pp = map.tangent_transpose_derivative(&a.tr_mul(&force.cross(l)))
            + product(&b.transpose(), &skew_times(l, &turned))
            + map.second_derivative(psi_prime, &moment);
        let weights = point.weights();
        for (j, [n, s]) in weights.into_iter().enumerate() {
            let by = n * pp + s * twisted;
            for (k, [m, t]) in weights.into_iter().enumerate() {
                self.rp[j][k] -= (s * m) * turned;
                self.pp[j][k] += m * by + (n * t) * twisted.transpose();
            }
        }
    }
}

/// Rows f and m of the outer nodes and of the middle one, by u_1, u_3, t_1, t_3 and theta_2.
struct Rows {
    forces: [[Matrix3<f64>; 5]; 3],
    moments: [[Matrix3<f64>; 5]; 3],
}

/// Adds the derivatives of the forces on the nodes at fixed section forces q of both points.
pub(super) fn add_geometric(
    nodal: &NodalKinematics,
    points: &[(EvaluationPoint<'_>, &Vector6<f64>); 2],
    out: &mut LocalJacobian,
) {
    let gradient = Gradient::new(nodal, points);
    let mut hessian = Hessian::default();
    for (point, q) in points {
        hessian.add(&nodal.a, point, q);
    }
    let zero = [[Matrix3::zeros(); 5]; 3];
    let mut rows = Rows {
        forces: zero,
        moments: zero,
    };
    let [first, last] = gradient.forces;
    let forces = [first, -first - last, last];
    rows.set_outer(nodal, &gradient, &hessian);
    rows.set_middle(&forces, &arms(nodal));
    for j in 0..3 {
        let offset = &nodal.f[j];
        let is_offset = *offset != Vector3::zeros();
        for k in 0..3 {
            let (_, turn) = by_node(&rows.forces[j], k, nodal);
            let (of_position, mut of_turn) = by_node(&rows.moments[j], k, nodal);
            if is_offset {
                of_turn += skew_times(offset, &turn);
                if j == k {
                    of_turn += skew_skew(&forces[j], offset);
                }
            }
            out.add((j, Force), (k, Rotation), &-turn);
            out.add((j, Moment), (k, Position), &-of_position);
            out.add((j, Moment), (k, Rotation), &-of_turn);
        }
    }
}

impl Rows {
    /// Derivatives of the outer nodes.
    fn set_outer(&mut self, nodal: &NodalKinematics, gradient: &Gradient, hessian: &Hessian) {
        let (relative, arms) = (&nodal.relative, arms(nodal));
        for (j, node) in OUTER.into_iter().enumerate() {
            let (force, moment) = (&mut self.forces[node], &mut self.moments[node]);
            let by_psi = gradient.by_psi[j][0] + gradient.by_psi[j][1];
            for k in 0..2 {
                force[2 + k] = product(&hessian.rp[j][k], &relative[k]);
                moment[k] = product(&hessian.rp[k][j], &relative[j]).transpose();
                let by_psi = product(&hessian.pp[j][k], &relative[k]);
                moment[2 + k] = product(&relative[j].transpose(), &by_psi);
            }
            let carried = nodal.outer[j].tangent_inverse_transpose_derivative(&by_psi);
            moment[2 + j] += product(&nodal.a, &product(&carried, &relative[j]));
            force[4] = -skew(&gradient.forces[j]);
            let around = times_skew(&moment[0], &arms[0]) + times_skew(&moment[1], &arms[1]);
            moment[4] = around - skew(&relative[j].tr_mul(&by_psi));
        }
    }

    /// Derivatives of the middle node (D-283).
    fn set_middle(&mut self, forces: &[Vector3<f64>; 3], arms: &[Vector3<f64>; 2]) {
        for k in 0..5 {
            let [first, _, last] = &self.forces;
            let lever = skew_times(&arms[0], &first[k]) + skew_times(&arms[1], &last[k]);
            self.moments[1][k] = -self.moments[0][k] - self.moments[2][k] - lever;
            self.forces[1][k] = -self.forces[0][k] - self.forces[2][k];
        }
        self.moments[1][0] += skew(&forces[0]);
        self.moments[1][1] += skew(&forces[2]);
    }
}

/// A row by position and rotation of node k.
fn by_node(
    [u1, u3, t1, t3, middle]: &[Matrix3<f64>; 5],
    k: usize,
    nodal: &NodalKinematics,
) -> (Matrix3<f64>, Matrix3<f64>) {
    let (point, mut turn) = match k {
        0 => (*u1, *t1),
        1 => (-u1 - u3, middle - t1 - t3),
        _ => (*u3, *t3),
    };
    let offset = &nodal.f[k];
    if *offset != Vector3::zeros() {
        turn -= times_skew(&point, offset);
    }
    (point, turn)
}
