//! Inertia of the three-node finite-volume beam: momenta of its portions.
//!
//! Portion k reaches between the evaluation points around node k. *Lumped*: it moves
//! rigidly with its node ([`lumped_bodies`]; second order). *Consistent*
//! ([`BeamInertia`]; fourth order): it moves with the interpolated velocities
//!
//! ```text
//! p' = N_j (v_j + omega_j x f_j)          omega = N_j omega_j
//! h  = m p' + omega x S                   k = S x p' + J omega       (about p)
//! momentum          - int_k h ds
//! angular momentum  - int_k [(p - x_k) x h + k] ds
//! force balance       int_k m a_g ds                       a_g: acceleration of gravity
//! moment balance      int_k [(p - x_k) x m a_g + S x a_g] ds
//! kinetic energy    1/2 int (p' . h + omega . k) ds
//! potential           - int (m p + S) . a_g ds         (zero at the origin)
//! ```
//!
//! with mass m, first moment S and inertia J per length, turned with the section.
//! The rate of these momenta in the balance of the node is the exact balance of the
//! portion about the moving node. Variations:
//!
//! ```text
//! d p'    = N_j (d v_j - [f_j]x d omega_j - [omega_j]x [f_j]x theta_j)
//! d h     = m d p' - [S]x d omega - [omega]x [S]x theta
//! d k     = [p']x [S]x theta + [S]x d p' + (J [omega]x - [J omega]x) theta + J d omega
//! d[(p - x_k) x m a_g + S x a_g] = -[m a_g]x (d p - d x_k) + [a_g]x [S]x theta
//! ```
//!
//! The Jacobian takes them from sums over a portion, in [`sums`].
//!
//! References: [Masarati], consistent and lumped inertia of the finite-volume beam.

use nalgebra::{Matrix3, Matrix6, Vector3};
use shared_geom::quadrature;
use shared_geom::rotation::skew;

use super::elastic::ElasticBeam;
use super::geometry::BeamGeometry;
use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::elements::bodies::RigidInertia;
use crate::elements::{Element, Energy, Local, LocalJacobian, LocalResidual};
use crate::model::Equation::{AngularMomentum, Force, Moment, Momentum};
use crate::model::{Node, NodeMotion, TurningFrame};

mod sums;

use sums::Sums;

/// Gauss points a portion: products of two quadratic shape functions, an arm and a
/// varying property are integrated exactly on straight beams.
const POINTS: usize = 4;

/// Mass, first moment and inertia per length at a point of the undeformed beam.
#[derive(Debug, Clone)]
struct MassPoint {
    /// Portion, hence node, to which the point belongs.
    portion: usize,
    shape: Shape,
    /// Undeformed length per unit of xi [m].
    j0: f64,
    /// Length that the point stands for [m].
    length: f64,
    /// Mass per length [kg/m].
    mass: f64,
    /// First moment per length, section axes [kg].
    first_moment: Vector3<f64>,
    /// Moment of inertia per length about the reference line, section axes [kg m].
    inertia: Matrix3<f64>,
}

/// Consistent inertia of a three-node beam.
#[derive(Debug, Clone)]
pub struct BeamInertia {
    label: String,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: Vec<MassPoint>,
}

/// Mass per length along a beam.
#[derive(Clone, Copy)]
pub struct MassAlong<'a> {
    /// 6x6 mass per length at xi, section axes [kg/m, kg, kg m].
    pub at: &'a dyn Fn(f64) -> Matrix6<f64>,
    /// Places xi between -1 and 1, ascending, where the mass has a kink or a jump: the
    /// integrals are taken between them [-].
    pub breaks: &'a [f64],
    /// Length of the line for which the beam stands, evenly along xi; `None` for that
    /// of the curve through the nodes [m].
    pub length: Option<f64>,
}

impl std::fmt::Debug for MassAlong<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MassAlong")
            .field("breaks", &self.breaks)
            .field("length", &self.length)
            .finish_non_exhaustive()
    }
}

impl<'a> MassAlong<'a> {
    /// A mass that is smooth in xi, on the curve through the nodes.
    pub fn smooth(at: &'a dyn Fn(f64) -> Matrix6<f64>) -> Self {
        Self {
            at,
            breaks: &[],
            length: None,
        }
    }
}

impl BeamInertia {
    /// Inertia of a beam on nodes number `nodes`, undeformed at `undeformed`, with
    /// the 6x6 mass per length as a smooth function of xi, section axes
    /// [kg/m, kg, kg m].
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        mass: impl Fn(f64) -> Matrix6<f64>,
    ) -> Self {
        Self::along(
            label,
            nodes,
            geometry,
            undeformed,
            &MassAlong::smooth(&mass),
        )
    }

    /// As [`BeamInertia::new`], for any mass along the beam.
    pub fn along(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        mass: &MassAlong<'_>,
    ) -> Self {
        Self {
            label: label.into(),
            nodes,
            geometry,
            points: mass_points(&geometry, &undeformed, mass),
        }
    }
}

/// The pieces of the three portions between the breaks of the mass: number of the
/// portion, and both ends in xi.
fn intervals(breaks: &[f64]) -> Vec<(usize, [f64; 2])> {
    let [first, second] = ElasticBeam::evaluation_points();
    let limits = [-1.0, first, second, 1.0];
    let mut found = Vec::with_capacity(3 + breaks.len());
    for portion in 0..3 {
        let [mut from, to] = [limits[portion], limits[portion + 1]];
        for &place in breaks.iter().filter(|xi| **xi < to) {
            if place > from {
                found.push((portion, [from, place]));
                from = place;
            }
        }
        found.push((portion, [from, to]));
    }
    found
}

/// Points and weights of the three portions.
fn mass_points(
    geometry: &BeamGeometry,
    undeformed: &[&Node; 3],
    mass: &MassAlong<'_>,
) -> Vec<MassPoint> {
    let intervals = intervals(mass.breaks);
    let mut points = Vec::with_capacity(intervals.len() * POINTS);
    for (portion, [from, to]) in intervals {
        let half = 0.5 * (to - from);
        let middle = 0.5 * (to + from);
        for (abscissa, weight) in quadrature::line(POINTS) {
            let xi = middle + half * abscissa;
            let j0 = geometry.reference_point(undeformed, xi).j0;
            let m = (mass.at)(xi);
            points.push(MassPoint {
                portion,
                shape: Shape::at(xi),
                j0,
                length: weight * half * mass.length.map_or(j0, |length| 0.5 * length),
                mass: m[(0, 0)],
                // The momentum of a rotation is omega x S = -[S]x omega.
                first_moment: Vector3::new(0.5 * (m[(1, 5)] - m[(2, 4)]), -m[(0, 5)], m[(0, 4)]),
                inertia: m.fixed_view::<3, 3>(3, 3).into_owned(),
            });
        }
    }
    points
}

/// Lumped inertia: for each of the three nodes the rigid inertia of its portion,
/// about the node and in its axes.
pub fn lumped_bodies(
    geometry: &BeamGeometry,
    undeformed: [&Node; 3],
    mass: &MassAlong<'_>,
) -> [RigidInertia; 3] {
    let mut bodies = [RigidInertia::zero(); 3];
    let motion = undeformed.map(NodeMotion::at_rest);
    let nodal = NodalKinematics::new(geometry, &motion);
    for point in mass_points(geometry, &undeformed, mass) {
        let node = undeformed[point.portion];
        let place = nodal.at(&point.shape, point.j0);
        let into_node = node.rotation.transpose();
        let r = into_node * place.r;
        let b = into_node * (place.p - node.position);
        let s = r * point.first_moment;
        let j = r * point.inertia * r.transpose();
        let (arm, moment) = (skew(&b), skew(&s));
        let body = &mut bodies[point.portion];
        body.mass += point.length * point.mass;
        body.first_moment += point.length * (point.mass * b + s);
        // int -[b + r]x [b + r]x dm, with int r dm = S and -int [r]x [r]x dm = J.
        let about_node = j - point.mass * arm * arm - arm * moment - moment * arm;
        body.inertia += point.length * about_node;
    }
    bodies
}

/// Section momenta at a mass point, in model axes, and what they hang on.
struct Motion {
    point: PointKinematics,
    /// Velocity of the reference line in space [m/s].
    velocity: Vector3<f64>,
    /// Angular velocity in space [rad/s].
    omega: Vector3<f64>,
    /// First moment per length [kg].
    s: Vector3<f64>,
    /// Inertia per length [kg m].
    j: Matrix3<f64>,
    /// Momentum per length [kg/s].
    h: Vector3<f64>,
    /// Angular momentum per length about the reference line [kg m/s].
    k: Vector3<f64>,
}

/// Velocities of the nodes in space.
struct Velocities {
    /// Of the beam points, `v_j + omega_j x f_j` [m/s].
    line: [Vector3<f64>; 3],
    /// Angular velocities [rad/s].
    omega: [Vector3<f64>; 3],
}

impl Velocities {
    fn new(nodal: &NodalKinematics, nodes: &[NodeMotion], frame: &TurningFrame) -> Self {
        let omega = std::array::from_fn(|j| nodes[j].angular_velocity_in_space(frame));
        let line =
            |j: usize| nodes[j].velocity_in_space(frame) + Vector3::cross(&omega[j], &nodal.f[j]);
        Self {
            line: std::array::from_fn(line),
            omega,
        }
    }
}

impl MassPoint {
    fn motion(&self, nodal: &NodalKinematics, nodes: &Velocities) -> Motion {
        let point = nodal.at(&self.shape, self.j0);
        let velocity = self.shape.sum(&nodes.line);
        let omega = self.shape.sum(&nodes.omega);
        let s = point.r * self.first_moment;
        let j = point.r * self.inertia * point.r.transpose();
        Motion {
            point,
            velocity,
            omega,
            s,
            j,
            h: self.mass * velocity + omega.cross(&s),
            k: s.cross(&velocity) + j * omega,
        }
    }
}

impl Element for BeamInertia {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let velocities = Velocities::new(&nodal, at.nodes, at.frame);
        let mut sum = Energy::default();
        for mass in &self.points {
            let motion = mass.motion(&nodal, &velocities);
            let twice = motion.velocity.dot(&motion.h) + motion.omega.dot(&motion.k);
            let moment_of_mass = mass.mass * motion.point.p + motion.s;
            sum.kinetic += 0.5 * mass.length * twice;
            sum.gravity -= mass.length * moment_of_mass.dot(&at.loading.gravity);
        }
        sum
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let velocities = Velocities::new(&nodal, at.nodes, at.frame);
        for mass in &self.points {
            let motion = mass.motion(&nodal, &velocities);
            let arm = motion.point.p - nodal.x[mass.portion];
            let angular = arm.cross(&motion.h) + motion.k;
            out.add(mass.portion, Momentum, &(-mass.length * motion.h));
            out.add(mass.portion, AngularMomentum, &(-mass.length * angular));
            let weight = mass.length * mass.mass * at.loading.gravity;
            let turning = mass.length * motion.s.cross(&at.loading.gravity);
            out.add(mass.portion, Force, &weight);
            out.add(mass.portion, Moment, &(arm.cross(&weight) + turning));
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let velocities = Velocities::new(&nodal, at.nodes, at.frame);
        let relative = nodal.relative_variation();
        for portion in 0..3 {
            let mut sums = Sums::default();
            for mass in self.points.iter().filter(|mass| mass.portion == portion) {
                sums.add(mass, &nodal, &mass.motion(&nodal, &velocities));
            }
            sums.add_momenta(portion, at, &nodal, &velocities, &relative, out);
            sums.add_weight(portion, at, &nodal, &relative, out);
        }
    }
}
