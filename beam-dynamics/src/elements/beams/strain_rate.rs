//! Generalized strain of a three-node beam, differentiated once and twice.
//!
//! The strain hangs on position and rotation of the nodes (see [`super::interpolation`]
//! for the symbols). Its first variation, per node j,
//!
//! ```text
//! d nu    = R^T (d l + [l]x theta)            d kappa = G^T d g~' + S d g~
//! S       = d(G^T g~')/d g~
//! ```
//!
//! gives the strain rate when the variations are velocities. These are relative to the
//! model's frame: a rigid motion strains nothing, so that a turning frame adds nothing.
//! With a dot for rates,
//!
//! ```text
//! g~._j = A_j (omega_j - omega_2)             w = omega_2 + A G g~.
//! l.    = N'_j / J0 (v_j + omega_j x f_j)     a = l. + l x w
//! nu.   = R^T a                               kappa. = G^T g~'. + S g~.
//! ```
//!
//! and their variation at fixed v_j, omega_j:
//!
//! ```text
//! d g~._j = d(G^-1 b)/d g~_j A_j (theta_j - theta_2) + A_j [omega_j - omega_2]x theta_2
//!           b = A^T (omega_j - omega_2)
//! d w     = theta_2 x (A G g~.) + A [ d(G g~.)/d g~ d g~ + G d g~. ]
//! d l.    = -N'_j / J0 [omega_j]x [f_j]x theta_j
//! d nu.   = R^T ( d l. - [w]x d l + [l]x d w + [a]x theta )
//! d kappa. = d(G^T g~'.)/d g~ d g~ + G^T d g~'. + S d g~. + d(S g~.)/d g~ d g~
//!           + d(S g~.)/d g~' d g~'
//! ```
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix3, Matrix6x3, Vector3, Vector6};
use shared_geom::rotation::{gibbs, skew};

use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::model::NodeMotion;

/// Derivatives of a generalized strain, or of its rate, by position and rotation of each
/// node.
pub(super) type ByNodes = [[Matrix6x3<f64>; 2]; 3];

/// A point of a beam, with what its strain hangs on.
pub(super) struct StrainPoint<'a> {
    nodal: &'a NodalKinematics,
    shape: &'a Shape,
    /// Undeformed length per unit of xi [m].
    j0: f64,
    pub point: PointKinematics,
    /// `A_j` of the outer nodes.
    relative: [Matrix3<f64>; 2],
    /// Rotation of the section by that of each node.
    pub theta: [Matrix3<f64>; 3],
}

/// The rates at a point, and those of the nodes.
struct Rates<'a> {
    nodes: &'a [NodeMotion],
    /// Rates of `g~` and `g~'` [1/s, 1/(m s)].
    g: Vector3<f64>,
    g_prime: Vector3<f64>,
    /// Angular velocity of the section [rad/s].
    w: Vector3<f64>,
    /// `a` of the equations [1/s].
    a: Vector3<f64>,
}

/// Variations of `g~` and `g~'` and of their rates by the rotation of one node.
struct Relative {
    g: Matrix3<f64>,
    g_prime: Matrix3<f64>,
    g_rate: Matrix3<f64>,
    g_prime_rate: Matrix3<f64>,
}

impl<'a> StrainPoint<'a> {
    pub fn new(nodal: &'a NodalKinematics, shape: &'a Shape, j0: f64) -> Self {
        let point = nodal.at(shape, j0);
        let relative = nodal.relative_variation();
        Self {
            theta: nodal.rotation_variation(shape, &point, &relative),
            nodal,
            shape,
            j0,
            point,
            relative,
        }
    }

    /// `N'_j / J0`.
    fn slope(&self, j: usize) -> f64 {
        self.shape.d[j] / self.j0
    }

    /// `S = d(G^T g~')/d g~`.
    fn bent(&self) -> Matrix3<f64> {
        gibbs::tangent_transpose_derivative(&self.point.g, &self.point.g_prime)
    }

    /// First variation of the strain.
    pub fn variation(&self) -> ByNodes {
        let tangent = gibbs::tangent(&self.point.g).transpose();
        let bent = self.bent();
        let outer = [0, 1].map(|k| {
            let j = 2 * k;
            (tangent * self.slope(j) + bent * self.shape.n[j]) * self.relative[k]
        });
        let kappa = [outer[0], -outer[0] - outer[1], outer[1]];
        let rt = self.point.r.transpose();
        let l = skew(&self.point.l);
        let offset = self.nodal.offset_skew();
        std::array::from_fn(|j| {
            let nu = rt * (l * self.theta[j] - offset[j] * self.slope(j));
            [
                stacked(&(rt * self.slope(j)), &Matrix3::zeros()),
                stacked(&nu, &kappa[j]),
            ]
        })
    }

    /// The strain rate for the velocities of the nodes, `variation` being the first
    /// variation.
    pub fn rate(variation: &ByNodes, nodes: &[NodeMotion]) -> Vector6<f64> {
        let of_node = |(by, node): (&[Matrix6x3<f64>; 2], &NodeMotion)| {
            by[0] * node.velocity + by[1] * node.angular_velocity
        };
        variation.iter().zip(nodes).map(of_node).sum()
    }

    /// Variation of the strain rate at fixed velocities of the nodes.
    pub fn rate_variation(&self, nodes: &[NodeMotion]) -> ByNodes {
        let rates = self.rates(nodes);
        let point = &self.point;
        let rt = point.r.transpose();
        let offset = self.nodal.offset_skew();
        let (w, l, a) = (skew(&rates.w), skew(&point.l), skew(&rates.a));
        std::array::from_fn(|m| {
            let relative = self.relative_rates(m, &rates);
            let turning = self.turning_variation(m, &relative, &rates);
            let omega = skew(&nodes[m].angular_velocity);
            let points = (w - omega) * offset[m] * self.slope(m);
            let nu = rt * (points + l * turning + a * self.theta[m]);
            [
                stacked(&(-rt * w * self.slope(m)), &Matrix3::zeros()),
                stacked(&nu, &self.curvature_rate_variation(&relative, &rates)),
            ]
        })
    }

    /// Angular velocity of an outer node against the mid one [rad/s].
    fn against_middle(nodes: &[NodeMotion], k: usize) -> Vector3<f64> {
        nodes[2 * k].angular_velocity - nodes[1].angular_velocity
    }

    fn rates<'n>(&self, nodes: &'n [NodeMotion]) -> Rates<'n> {
        let outer = [0, 1].map(|k| self.relative[k] * Self::against_middle(nodes, k));
        let g = self.shape.n[0] * outer[0] + self.shape.n[2] * outer[1];
        let g_prime = self.slope(0) * outer[0] + self.slope(2) * outer[1];
        let w = nodes[1].angular_velocity + self.nodal.a * gibbs::tangent(&self.point.g) * g;
        let point_velocity = |j: usize| {
            let turned = nodes[j].angular_velocity.cross(&self.nodal.f[j]);
            self.slope(j) * (nodes[j].velocity + turned)
        };
        let l_rate: Vector3<f64> = (0..3).map(point_velocity).sum();
        Rates {
            nodes,
            g,
            g_prime,
            w,
            a: l_rate + self.point.l.cross(&w),
        }
    }

    /// Variations by the rotation of node `m`.
    fn relative_rates(&self, m: usize, rates: &Rates<'_>) -> Relative {
        let mut sum = Relative {
            g: Matrix3::zeros(),
            g_prime: Matrix3::zeros(),
            g_rate: Matrix3::zeros(),
            g_prime_rate: Matrix3::zeros(),
        };
        for k in 0..2 {
            let j = 2 * k;
            let sign = match m {
                1 => -1.0,
                _ if m == j => 1.0,
                _ => continue,
            };
            let against = Self::against_middle(rates.nodes, k);
            let by = sign * self.relative[k];
            let b = self.nodal.a.transpose() * against;
            let mut by_rate = inverse_tangent_derivative(&self.nodal.g[j], &b) * by;
            if m == 1 {
                by_rate += self.relative[k] * skew(&against);
            }
            sum.g += self.shape.n[j] * by;
            sum.g_prime += self.slope(j) * by;
            sum.g_rate += self.shape.n[j] * by_rate;
            sum.g_prime_rate += self.slope(j) * by_rate;
        }
        sum
    }

    /// `d w` by the rotation of node `m`.
    fn turning_variation(&self, m: usize, by: &Relative, rates: &Rates<'_>) -> Matrix3<f64> {
        let g = &self.point.g;
        let a = &self.nodal.a;
        let tangent = gibbs::tangent(g);
        let inner = gibbs::tangent_derivative(g, &rates.g) * by.g + tangent * by.g_rate;
        match m {
            1 => a * inner - skew(&(a * tangent * rates.g)),
            _ => a * inner,
        }
    }

    /// `d kappa.` by the rotation of one node.
    fn curvature_rate_variation(&self, by: &Relative, rates: &Rates<'_>) -> Matrix3<f64> {
        let PointKinematics { g, g_prime, .. } = &self.point;
        let [by_g, by_g_prime] = bent_rate_derivatives(g, g_prime, &rates.g);
        let straight = gibbs::tangent_transpose_derivative(g, &rates.g_prime);
        (straight + by_g) * by.g
            + by_g_prime * by.g_prime
            + gibbs::tangent(g).transpose() * by.g_prime_rate
            + self.bent() * by.g_rate
    }
}

/// `d(G^-1 b)/d g = 1/2 [b]x + 1/4 ((g . b) I + g b^T)`, b constant.
fn inverse_tangent_derivative(g: &Vector3<f64>, b: &Vector3<f64>) -> Matrix3<f64> {
    0.5 * skew(b) + 0.25 * (g.dot(b) * Matrix3::identity() + g * b.transpose())
}

/// Derivatives by `g` and by `c` of `S r`, `S = d(G^T c)/d g`, `r` constant: with
/// `lambda = 4/(4 + g.g)`, `m = c - 1/2 g x c`,
///
/// ```text
/// S r         = 1/2 lambda c x r - 1/2 lambda^2 (g . r) m
/// by g        = -1/4 lambda^2 (c x r) g^T + 1/2 lambda^3 (g . r) m g^T
///               - 1/4 lambda^2 (g . r) [c]x - 1/2 lambda^2 m r^T
/// by c        = -1/2 lambda [r]x - 1/2 lambda^2 (g . r) (I - 1/2 [g]x)
/// ```
fn bent_rate_derivatives(
    g: &Vector3<f64>,
    c: &Vector3<f64>,
    r: &Vector3<f64>,
) -> [Matrix3<f64>; 2] {
    let lambda = 4.0 / (4.0 + g.norm_squared());
    let square = lambda * lambda;
    let m = c - 0.5 * g.cross(c);
    let along = g.dot(r);
    let by_g = (0.5 * lambda * square * along * m - 0.25 * square * c.cross(r)) * g.transpose()
        - 0.25 * square * along * skew(c)
        - 0.5 * square * m * r.transpose();
    let by_c =
        -0.5 * lambda * skew(r) - 0.5 * square * along * (Matrix3::identity() - 0.5 * skew(g));
    [by_g, by_c]
}

fn stacked(nu: &Matrix3<f64>, kappa: &Matrix3<f64>) -> Matrix6x3<f64> {
    let mut both = Matrix6x3::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(nu);
    both.fixed_view_mut::<3, 3>(3, 0).copy_from(kappa);
    both
}
