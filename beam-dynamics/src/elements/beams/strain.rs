//! Generalized strain of a three-node beam, differentiated once and twice.
//!
//! The strain depends on positions and rotations of the nodes (see [`super::interpolation`] for the
//! symbols). Its first variation, per node j,
//!
//! ```text
//! d nu    = R^T (d l + [l]x theta)            d kappa = T^T d psi' + S d psi
//! S       = d(T^T psi')/d psi
//! ```
//!
//! is `B` times the variations of the nodes, and gives the strain rate when these are velocities.
//! They are relative to the model's frame: a rigid motion causes no strain, and a turning frame
//! adds no rate. With a dot for rates,
//!
//! ```text
//! psi._j = A_j (omega_j - omega_2)            w = omega_2 + A T psi.
//! l.     = N'_j / J0 (v_j + omega_j x f_j)    a = l. + l x w
//! nu.    = R^T a                              kappa. = T^T psi'. + S psi.
//! ```
//!
//! and their variation at fixed v_j, omega_j:
//!
//! ```text
//! d psi._j = D(T^-1.; b) A_j (theta_j - theta_2) + A_j [omega_j - omega_2]x theta_2
//!            b = A^T (omega_j - omega_2)
//! d w      = theta_2 x (A T psi.) + A [ D(T.; psi.) d psi + T d psi. ]
//! d l.     = -N'_j / J0 [omega_j]x [f_j]x theta_j
//! d nu.    = R^T ( d l. - [w]x d l + [l]x d w + [a]x theta )
//! d kappa. = D(T^T.; psi'.) d psi + T^T d psi'. + S d psi. + d(S psi.)/d psi d psi
//!            + d(S psi.)/d psi' d psi'
//! ```
//!
//! with row i of `d(S r)/d psi` being `r^T H(psi, psi', e_i)` and of `d(S r)/d psi'`
//! `(D(T.; e_i) r)^T` (see [`shared_geom::rotation::parameters`]).
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};
use shared_geom::rotation::{product, skew, skew_times};

use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::model::NodeMotion;

/// Derivatives of a generalized strain, or of its rate: by displacement and rotation of each
/// node.
pub(super) type Variation = SMatrix<f64, 6, 18>;

/// A point of a beam, with the rotation of its section.
pub(super) struct SectionPoint<'a> {
    pub nodal: &'a NodalKinematics,
    pub shape: &'a Shape,
    /// Undeformed length per unit of xi [m].
    pub j0: f64,
    pub point: PointKinematics,
    /// Rotation of the section by the rotation of each node, `T_j`.
    pub theta: [Matrix3<f64>; 3],
}

/// A point of a beam, with the variation of its strain.
pub(super) struct StrainPoint<'a> {
    pub section: SectionPoint<'a>,
    /// S.
    bent: Matrix3<f64>,
    /// B.
    pub variation: Variation,
}

/// The rates at a point and at the nodes.
struct Rates<'a> {
    nodes: &'a [NodeMotion],
    /// Rates of psi and psi' [1/s, 1/(m s)].
    psi: Vector3<f64>,
    psi_prime: Vector3<f64>,
    /// Angular velocity of the section [rad/s].
    w: Vector3<f64>,
    /// `a` of the equations [1/s].
    a: Vector3<f64>,
}

/// Variations of psi and psi' and of their rates by the rotation of one node.
struct Relative {
    psi: Matrix3<f64>,
    psi_prime: Matrix3<f64>,
    psi_rate: Matrix3<f64>,
    psi_prime_rate: Matrix3<f64>,
}

impl<'a> SectionPoint<'a> {
    pub fn new(nodal: &'a NodalKinematics, shape: &'a Shape, j0: f64) -> Self {
        let point = nodal.at(shape, j0);
        Self {
            theta: nodal.rotation_variation(shape, &point),
            nodal,
            shape,
            j0,
            point,
        }
    }

    /// `N'_j / J0`.
    pub fn slope(&self, j: usize) -> f64 {
        self.shape.d[j] / self.j0
    }
}

impl<'a> StrainPoint<'a> {
    pub fn new(nodal: &'a NodalKinematics, shape: &'a Shape, j0: f64) -> Self {
        let section = SectionPoint::new(nodal, shape, j0);
        let PointKinematics { map, psi_prime, .. } = &section.point;
        let bent = map.tangent_transpose_derivative(psi_prime);
        Self {
            variation: variation(&section, &bent),
            section,
            bent,
        }
    }

    /// Undeformed length per unit of xi [m].
    pub fn j0(&self) -> f64 {
        self.section.j0
    }

    /// The strain rate for the velocities of the nodes.
    pub fn rate(&self, nodes: &[NodeMotion]) -> Vector6<f64> {
        self.along(|j| [nodes[j].velocity, nodes[j].angular_velocity])
    }

    /// The change of the strain with a motion of each node.
    pub fn along(&self, motion: impl Fn(usize) -> [Vector3<f64>; 2]) -> Vector6<f64> {
        let of_node = |j: usize| {
            let [displacement, rotation] = motion(j);
            self.variation.fixed_columns::<3>(6 * j) * displacement
                + self.variation.fixed_columns::<3>(6 * j + 3) * rotation
        };
        (0..3).map(of_node).sum()
    }

    /// Variation of the strain rate at fixed velocities of the nodes.
    pub fn rate_variation(&self, nodes: &[NodeMotion]) -> Variation {
        let rates = self.rates(nodes);
        let section = &self.section;
        let rt = section.point.r.transpose();
        let offset = section.nodal.offset_skew();
        let (w, l, a) = (skew(&rates.w), skew(&section.point.l), skew(&rates.a));
        let mut out = Variation::zeros();
        for m in 0..3 {
            let relative = self.relative_rates(m, &rates);
            let turning = self.turning_variation(m, &relative, &rates);
            let omega = skew(&nodes[m].angular_velocity);
            let points = (w - omega) * offset[m] * section.slope(m);
            let nu = rt * (points + l * turning + a * section.theta[m]);
            let kappa = self.curvature_rate_variation(&relative, &rates);
            set(&mut out, m, &(-rt * w * section.slope(m)), &nu, &kappa);
        }
        out
    }

    /// Angular velocity of an outer node relative to the mid one [rad/s].
    fn against_middle(nodes: &[NodeMotion], k: usize) -> Vector3<f64> {
        nodes[2 * k].angular_velocity - nodes[1].angular_velocity
    }

    fn rates<'n>(&self, nodes: &'n [NodeMotion]) -> Rates<'n> {
        let section = &self.section;
        let SectionPoint { nodal, shape, .. } = section;
        let outer = [0, 1].map(|k| section.nodal.relative[k] * Self::against_middle(nodes, k));
        let psi = shape.n[0] * outer[0] + shape.n[2] * outer[1];
        let psi_prime = section.slope(0) * outer[0] + section.slope(2) * outer[1];
        let w = nodes[1].angular_velocity + nodal.a * section.point.tangent * psi;
        let point_velocity = |j: usize| {
            let turned = nodes[j].angular_velocity.cross(&nodal.f[j]);
            section.slope(j) * (nodes[j].velocity + turned)
        };
        let l_rate: Vector3<f64> = (0..3).map(point_velocity).sum();
        Rates {
            nodes,
            psi,
            psi_prime,
            w,
            a: l_rate + section.point.l.cross(&w),
        }
    }

    /// Variations by the rotation of node `m`.
    fn relative_rates(&self, m: usize, rates: &Rates<'_>) -> Relative {
        let section = &self.section;
        let mut sum = Relative {
            psi: Matrix3::zeros(),
            psi_prime: Matrix3::zeros(),
            psi_rate: Matrix3::zeros(),
            psi_prime_rate: Matrix3::zeros(),
        };
        for k in 0..2 {
            let j = 2 * k;
            let sign = match m {
                1 => -1.0,
                _ if m == j => 1.0,
                _ => continue,
            };
            let against = Self::against_middle(rates.nodes, k);
            let by = sign * section.nodal.relative[k];
            let b = section.nodal.a.transpose() * against;
            let mut by_rate = section.nodal.outer[k].tangent_inverse_derivative(&b) * by;
            if m == 1 {
                by_rate += section.nodal.relative[k] * skew(&against);
            }
            sum.psi += section.shape.n[j] * by;
            sum.psi_prime += section.slope(j) * by;
            sum.psi_rate += section.shape.n[j] * by_rate;
            sum.psi_prime_rate += section.slope(j) * by_rate;
        }
        sum
    }

    /// `d w` by the rotation of node `m`.
    fn turning_variation(&self, m: usize, by: &Relative, rates: &Rates<'_>) -> Matrix3<f64> {
        let PointKinematics { map, tangent, .. } = &self.section.point;
        let a = &self.section.nodal.a;
        let inner = map.tangent_derivative(&rates.psi) * by.psi + tangent * by.psi_rate;
        match m {
            1 => a * inner - skew(&(a * tangent * rates.psi)),
            _ => a * inner,
        }
    }

    /// `d kappa.` by the rotation of one node.
    fn curvature_rate_variation(&self, by: &Relative, rates: &Rates<'_>) -> Matrix3<f64> {
        let PointKinematics {
            map,
            tangent,
            psi_prime,
            ..
        } = &self.section.point;
        let mut by_psi = map.tangent_transpose_derivative(&rates.psi_prime);
        let mut by_psi_prime = Matrix3::zeros();
        for i in 0..3 {
            let unit = Vector3::ith(i, 1.0);
            let second = map.second_derivative(psi_prime, &unit) * rates.psi;
            let first = map.tangent_derivative(&unit) * rates.psi;
            by_psi.set_row(i, &(by_psi.row(i) + second.transpose()));
            by_psi_prime.set_row(i, &first.transpose());
        }
        by_psi * by.psi
            + by_psi_prime * by.psi_prime
            + tangent.transpose() * by.psi_prime_rate
            + self.bent * by.psi_rate
    }
}

/// B, the first variation of the strain.
fn variation(section: &SectionPoint<'_>, bent: &Matrix3<f64>) -> Variation {
    let PointKinematics { r, l, tangent, .. } = &section.point;
    let tangent = tangent.transpose();
    let outer = [0, 1].map(|k| {
        let j = 2 * k;
        let along = tangent * section.slope(j) + bent * section.shape.n[j];
        product(&along, &section.nodal.relative[k])
    });
    let kappa = [outer[0], -outer[0] - outer[1], outer[1]];
    let rt = r.transpose();
    let offset = section.nodal.offset_skew();
    let mut out = Variation::zeros();
    for j in 0..3 {
        let of_line = skew_times(l, &section.theta[j]) - offset[j] * section.slope(j);
        let nu = product(&rt, &of_line);
        set(&mut out, j, &(rt * section.slope(j)), &nu, &kappa[j]);
    }
    out
}

/// Writes the columns of node `j`: displacement to nu, rotation to nu and kappa.
fn set(
    out: &mut Variation,
    j: usize,
    position: &Matrix3<f64>,
    nu: &Matrix3<f64>,
    kappa: &Matrix3<f64>,
) {
    out.fixed_view_mut::<3, 3>(0, 6 * j).copy_from(position);
    out.fixed_view_mut::<3, 3>(0, 6 * j + 3).copy_from(nu);
    out.fixed_view_mut::<3, 3>(3, 6 * j + 3).copy_from(kappa);
}
