//! Variations of the momenta of a portion, from sums over its points.
//!
//! With the arm `a = p - x_k`, the mass m ds of a point and
//!
//! ```text
//! theta_H = - [omega]x [S]x
//! theta_K = [a]x theta_H + [p']x [S]x + J [omega]x - [J omega]x
//! Q       = m a + S                       first moment about the node
//! I       = J - [a]x [S]x
//! ```
//!
//! the variations of [`super`] are, summed over the points with weights N_j (index j),
//!
//! ```text
//! d int h            = m_j d p'_j - [S_j]x d omega_j + int theta_H theta
//! d int (a x h + k)  = [Q_j]x d p'_j + I_j d omega_j + int theta_K theta
//!                      - [h_j]x (d x_j - [f_j]x theta_j) + [h]x d x_k
//! d p'_j             = d v_j - [f_j]x d omega_j - [omega_j]x [f_j]x theta_j
//! d of weight moment = [a_g]x (m d x_k - m_j (d x_j - [f_j]x theta_j) + int [S]x theta)
//! ```
//!
//! and with `theta = T_j theta_j`, `T_j = N_j B A_j` of the outer nodes (see
//! [`crate::elements::beams`], interpolation), the integrals of `X theta` are
//!
//! ```text
//! (X B)_1 A_1 theta_1 + (X B)_3 A_3 theta_3 + [X - (X B)_1 A_1 - (X B)_3 A_3] theta_2
//! ```

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{gibbs, skew, skew_skew, skew_times, times_skew};

use super::{MassPoint, Motion, Velocities};
use crate::elements::beams::interpolation::NodalKinematics;
use crate::elements::{Local, LocalJacobian};
use crate::model::Equation::{AngularMomentum, Moment, Momentum};
use crate::model::Variable;

/// Sums over the points of a portion.
#[derive(Default)]
pub(super) struct Sums {
    /// With weight one.
    all: Whole,
    /// With the shape function of each node as weight.
    by_node: [Weighted; 3],
    /// `X B` with the shape functions of the outer nodes as weights.
    turned: [Turning; 2],
}

/// Sums of what hangs on the portion as a whole.
#[derive(Default)]
struct Whole {
    /// Mass [kg].
    mass: f64,
    /// Momentum [kg m/s].
    h: Vector3<f64>,
    turning: Turning,
}

#[derive(Default)]
struct Weighted {
    /// Mass [kg].
    mass: f64,
    /// First moments about the line and about the node [kg m].
    s: Vector3<f64>,
    q: Vector3<f64>,
    /// Momentum [kg m/s].
    h: Vector3<f64>,
    /// I of the equations [kg m^2].
    inertia: Matrix3<f64>,
}

/// What multiplies the rotation of the section, or a sum of it.
#[derive(Default)]
struct Turning {
    /// In the momentum, `theta_H`.
    h: Matrix3<f64>,
    /// In the angular momentum about the node, `theta_K`.
    k: Matrix3<f64>,
    /// In the moment of the weight, `[S]x`.
    s: Matrix3<f64>,
}

impl Turning {
    fn add(&mut self, weight: f64, other: &Self) {
        self.h += weight * other.h;
        self.k += weight * other.k;
        self.s += weight * other.s;
    }
}

impl Weighted {
    fn add(&mut self, weight: f64, mass: f64, of: [&Vector3<f64>; 3], inertia: &Matrix3<f64>) {
        self.mass += weight * mass;
        for (sum, value) in [&mut self.s, &mut self.q, &mut self.h].into_iter().zip(of) {
            *sum += weight * value;
        }
        self.inertia += weight * inertia;
    }
}

impl Sums {
    /// Adds a point of the portion.
    pub fn add(&mut self, mass: &MassPoint, nodal: &NodalKinematics, motion: &Motion) {
        let Motion {
            point,
            velocity,
            omega,
            s,
            j,
            h,
            ..
        } = motion;
        let arm = point.p - nodal.x[mass.portion];
        let theta_h = -skew_skew(omega, s);
        let turning = Turning {
            h: theta_h,
            k: skew_times(&arm, &theta_h) + skew_skew(velocity, s) + times_skew(j, omega)
                - skew(&(j * omega)),
            s: skew(s),
        };
        let b = nodal.a * gibbs::tangent(&point.g);
        let s_b = skew_times(s, &b);
        let turned = Turning {
            h: -skew_times(omega, &s_b),
            k: turning.k * b,
            s: s_b,
        };
        let q = mass.mass * arm + s;
        let inertia = j - skew_skew(&arm, s);
        let weights = mass.shape.n.map(|n| mass.length * n);
        for (sum, weight) in self.by_node.iter_mut().zip(weights) {
            sum.add(weight, mass.mass, [s, &q, h], &inertia);
        }
        self.turned[0].add(weights[0], &turned);
        self.turned[1].add(weights[2], &turned);
        self.all.mass += mass.length * mass.mass;
        self.all.h += mass.length * h;
        self.all.turning.add(mass.length, &turning);
    }

    /// `int X theta` by the rotation of each node.
    fn by_rotation(
        &self,
        relative: &[Matrix3<f64>; 2],
        of: impl Fn(&Turning) -> &Matrix3<f64>,
    ) -> [Matrix3<f64>; 3] {
        let first = of(&self.turned[0]) * relative[0];
        let last = of(&self.turned[1]) * relative[1];
        [first, of(&self.all.turning) - first - last, last]
    }

    /// Adds `-d int h` and `-d int (a x h + k)` of portion `node`.
    pub fn add_momenta(
        &self,
        node: usize,
        at: &Local<'_>,
        nodal: &NodalKinematics,
        velocities: &Velocities,
        relative: &[Matrix3<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        let frame = at.frame.skew();
        let theta_h = self.by_rotation(relative, |turning| &turning.h);
        let theta_k = self.by_rotation(relative, |turning| &turning.k);
        for (j, sum) in self.by_node.iter().enumerate() {
            let f = &nodal.f[j];
            let carried = skew_skew(&velocities.omega[j], f);
            let (m, q) = (sum.mass, &sum.q);
            let mut own = -skew(&sum.h);
            if j == node {
                own += skew(&self.all.h);
            }
            // (variable, d int h, d int (a x h + k))
            let rows = [
                (Variable::Position, m * frame, skew_times(q, &frame) + own),
                (
                    Variable::Rotation,
                    theta_h[j] - m * carried,
                    theta_k[j] - skew_times(q, &carried) + skew_skew(&sum.h, f),
                ),
                (
                    Variable::Velocity,
                    Matrix3::from_diagonal_element(m),
                    skew(q),
                ),
                (
                    Variable::AngularVelocity,
                    -skew(&(m * f + sum.s)),
                    sum.inertia - skew_skew(q, f),
                ),
            ];
            for (variable, momentum, angular) in rows {
                out.add((node, Momentum), (j, variable), &-momentum);
                out.add((node, AngularMomentum), (j, variable), &-angular);
            }
        }
    }

    /// Adds the variations of the moment of the weight of portion `node`.
    pub fn add_weight(
        &self,
        node: usize,
        at: &Local<'_>,
        nodal: &NodalKinematics,
        relative: &[Matrix3<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        let gravity = &at.loading.gravity;
        let moment = self.by_rotation(relative, |turning| &turning.s);
        for (j, sum) in self.by_node.iter().enumerate() {
            let own = if j == node { self.all.mass } else { 0.0 };
            let position = (own - sum.mass) * skew(gravity);
            let rotation = skew_times(gravity, &(moment[j] + sum.mass * skew(&nodal.f[j])));
            out.add((node, Moment), (j, Variable::Position), &position);
            out.add((node, Moment), (j, Variable::Rotation), &rotation);
        }
    }
}
