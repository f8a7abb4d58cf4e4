//! Consistent inertia of a variational beam: mass that moves with the interpolated velocities.
//!
//! With the velocities in space of the points of the line at the nodes,
//! `V_j = v_j + omega_j x f_j`, the momenta per length at a point are
//!
//! ```text
//! V = N_j V_j          omega = N_j omega_j
//! h = m V + omega x S  k = S x V + J omega
//! ```
//!
//! and the momenta of the nodes and the moments that these carry with them
//!
//! ```text
//! beta_j  = int N_j h ds
//! gamma_j = int N_j (f_j x h + k) ds
//! z_j     = int [ N_j (V_j x h + omega_j x k) - T_j^T (V x h + omega x k) ] ds ,  sum z_j = 0
//! d beta_j/dt = forces                d gamma_j/dt + v_j x beta_j = moments + z_j
//! ```
//!
//! the Lagrange-Poincare equations of `1/2 int (V . h + omega . k) ds`. Gravity a_g acts on the
//! line with the force `m a_g` and the moment `S x a_g`. Variations:
//!
//! ```text
//! d V = N_j (d v_j - [f_j]x d omega_j - [omega_j]x [f_j]x theta_j)
//! d h = m d V - [S]x d omega - [omega]x [S]x theta
//! d k = [V]x [S]x theta + [S]x d V + (J [omega]x - [J omega]x) theta + J d omega
//! d(T_j^T sigma): see [`super::variational`]
//! ```
//!
//! Frequencies are of fourth order, with about twice the error of bodies by nodal
//! weights ([`super::lumped_bodies`]).

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{product, skew, skew_skew, skew_times, times_skew};

use super::attachment::BeamGeometry;
use super::forces::LineForce;
use super::interpolation::NodalKinematics;
use super::mass::{MassAlong, MassPoint, mass_points};
use super::strain::SectionPoint;
use super::variational::{add_on_line, add_on_line_variation, moment_variation};
use crate::elements::{
    Element, Energetic, Energy, EnergySlope, Exchange, Local, LocalJacobian, LocalResidual, has,
};
use crate::model::Equation::{AngularMomentum, Moment, Momentum};
use crate::model::{Node, NodeMotion, TurningFrame, Variable};

/// Gauss points between two breaks of the mass: exact for a linear mass times two quadratic
/// shape functions, on straight beams.
const POINTS: usize = 3;

/// Consistent inertia of a three-node variational beam.
#[derive(Debug, Clone)]
pub struct BeamInertia {
    label: String,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: Vec<MassPoint>,
}

impl BeamInertia {
    /// Inertia of a beam on nodes number `nodes`, undeformed at `undeformed`. It is always the
    /// inertia of a variational beam, for any formulation of `geometry`.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        mass: &MassAlong<'_>,
    ) -> Self {
        let geometry = BeamGeometry::new(geometry.nodes);
        Self {
            label: label.into(),
            nodes,
            geometry,
            points: mass_points(&geometry, &undeformed, mass, POINTS),
        }
    }
}

/// Velocities of the nodes in space.
struct Velocities {
    /// Velocities of the beam points, `v_j + omega_j x f_j` [m/s].
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

/// Momenta at a mass point, model axes, with their arguments.
struct Motion<'a> {
    section: SectionPoint<'a>,
    mass: f64,
    /// Velocity of the reference line in space [m/s].
    velocity: Vector3<f64>,
    /// Angular velocity in space [rad/s].
    omega: Vector3<f64>,
    /// First moment [kg m].
    s: Vector3<f64>,
    /// Inertia [kg m^2].
    j: Matrix3<f64>,
    /// Momentum [kg m/s].
    h: Vector3<f64>,
    /// Angular momentum about the reference line [kg m^2/s].
    k: Vector3<f64>,
}

/// Variations by one variable of one node.
struct Change {
    velocity: Matrix3<f64>,
    omega: Matrix3<f64>,
    h: Matrix3<f64>,
    k: Matrix3<f64>,
}

impl<'a> Motion<'a> {
    fn new(mass: &'a MassPoint, nodal: &'a NodalKinematics, nodes: &Velocities) -> Self {
        let section = SectionPoint::new(nodal, &mass.shape, mass.j0);
        let velocity = mass.shape.sum(&nodes.line);
        let omega = mass.shape.sum(&nodes.omega);
        let r = &section.point.r;
        let s = r * mass.first_moment;
        let j = product(&product(r, &mass.inertia), &r.transpose());
        Self {
            section,
            mass: mass.mass,
            velocity,
            omega,
            s,
            j,
            h: mass.mass * velocity + omega.cross(&s),
            k: s.cross(&velocity) + j * omega,
        }
    }

    /// `V x h + omega x k`.
    fn sigma(&self) -> Vector3<f64> {
        self.velocity.cross(&self.h) + self.omega.cross(&self.k)
    }

    fn weight(&self, gravity: &Vector3<f64>) -> LineForce {
        let turned = |theta: &Matrix3<f64>| skew_times(gravity, &skew_times(&self.s, theta));
        LineForce {
            force: self.mass * gravity,
            moment: self.s.cross(gravity),
            by_rotation: Some([
                [Matrix3::zeros(); 3],
                self.section.theta.each_ref().map(turned),
            ]),
        }
    }

    /// Changes of V and omega at a node with one of its variables.
    fn of_node(
        at: &Local<'_>,
        nodal: &NodalKinematics,
        velocities: &Velocities,
        (node, variable): (usize, Variable),
    ) -> [Matrix3<f64>; 2] {
        let zero = Matrix3::zeros();
        let f = &nodal.f[node];
        match variable {
            Variable::Position => [at.frame.skew(), zero],
            Variable::Rotation => [-skew_skew(&velocities.omega[node], f), zero],
            Variable::Velocity => [Matrix3::identity(), zero],
            _ => [-skew(f), Matrix3::identity()],
        }
    }

    /// Changes at the point with a variable of a node, `of_node` gives the changes at the node.
    fn change(&self, (node, variable): (usize, Variable), of_node: &[Matrix3<f64>; 2]) -> Change {
        let [velocity, omega] = of_node.map(|by| self.section.shape.n[node] * by);
        let mut h = self.mass * velocity - skew_times(&self.s, &omega);
        let mut k = skew_times(&self.s, &velocity) + product(&self.j, &omega);
        if variable == Variable::Rotation {
            let s = skew_times(&self.s, &self.section.theta[node]);
            let turned = times_skew(&self.j, &self.omega) - skew(&(self.j * self.omega));
            h -= skew_times(&self.omega, &s);
            k += skew_times(&self.velocity, &s) + product(&turned, &self.section.theta[node]);
        }
        Change {
            velocity,
            omega,
            h,
            k,
        }
    }

    fn add_residual(&self, velocities: &Velocities, out: &mut LocalResidual) {
        let sigma = self.sigma();
        for j in 0..3 {
            let n = self.section.shape.n[j];
            let angular = self.section.nodal.f[j].cross(&self.h) + self.k;
            out.add(j, Momentum, &(-n * self.h));
            out.add(j, AngularMomentum, &(-n * angular));
            let own = velocities.line[j].cross(&self.h) + velocities.omega[j].cross(&self.k);
            out.add(j, Moment, &(n * own));
            out.add(j, Moment, &-self.section.theta[j].tr_mul(&sigma));
        }
    }

    /// Adds the variations by a variable of a node. Adds the derivatives of its contributions, and
    /// of its weight, to the equations of the nodes.
    fn add_jacobian(
        &self,
        velocities: &Velocities,
        (columns, weight): (&Columns, &LineForce),
        out: &mut LocalJacobian,
    ) {
        for (column, of_node) in columns {
            self.add_variation(velocities, *column, of_node, out);
        }
        let by_rotation = moment_variation(&self.section, &self.sigma(), &Vector3::zeros());
        for (j, row) in by_rotation.iter().enumerate() {
            for (k, block) in row.iter().enumerate() {
                out.add((j, Moment), (k, Variable::Rotation), &-block);
            }
        }
        add_on_line_variation(&self.section, weight, out);
    }

    fn add_variation(
        &self,
        velocities: &Velocities,
        (node, variable): (usize, Variable),
        of_node: &[Matrix3<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        let by = self.change((node, variable), of_node);
        let sigma = skew_times(&self.velocity, &by.h) - skew_times(&self.h, &by.velocity)
            + skew_times(&self.omega, &by.k)
            - skew_times(&self.k, &by.omega);
        for j in 0..3 {
            let n = self.section.shape.n[j];
            let f = &self.section.nodal.f[j];
            let mut angular = skew_times(f, &by.h) + by.k;
            let mut own =
                skew_times(&velocities.line[j], &by.h) + skew_times(&velocities.omega[j], &by.k);
            if j == node {
                own -= skew_times(&self.h, &of_node[0]) + skew_times(&self.k, &of_node[1]);
                if variable == Variable::Rotation {
                    angular += skew_skew(&self.h, f);
                }
            }
            let moment = n * own - product(&self.section.theta[j].transpose(), &sigma);
            out.add((j, Momentum), (node, variable), &(-n * by.h));
            out.add((j, AngularMomentum), (node, variable), &(-n * angular));
            out.add((j, Moment), (node, variable), &moment);
        }
    }
}

/// Node and variable, with the variation of line velocity and angular velocity by it.
type Columns = [((usize, Variable), [Matrix3<f64>; 2]); 12];

/// Variables of a node that affect the point's motion.
const VARIABLES: [Variable; 4] = [
    Variable::Position,
    Variable::Rotation,
    Variable::Velocity,
    Variable::AngularVelocity,
];

/// Variables of the nodes, with the variation of the motion of each by it.
fn columns(at: &Local<'_>, nodal: &NodalKinematics, velocities: &Velocities) -> Columns {
    std::array::from_fn(|i| {
        let column = (i / 4, VARIABLES[i % 4]);
        (column, Motion::of_node(at, nodal, velocities, column))
    })
}

impl Element for BeamInertia {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let velocities = Velocities::new(&nodal, at.nodes, at.frame);
        let columns = jacobian.is_some().then(|| columns(at, &nodal, &velocities));
        let mut jacobian = jacobian.zip(columns);
        for mass in &self.points {
            let motion = Motion::new(mass, &nodal, &velocities);
            motion.add_residual(&velocities, out);
            let weight = motion.weight(&at.loading.gravity);
            add_on_line(&motion.section, &weight, |node, equation, value| {
                out.add(node, equation, value);
            });
            if let Some((out, columns)) = &mut jacobian {
                motion.add_jacobian(&velocities, (columns, &weight), out);
            }
        }
    }

    has!(energetic: Energetic);
}

impl Energetic for BeamInertia {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let velocities = Velocities::new(&nodal, at.nodes, at.frame);
        let mut sum = Energy::default();
        for mass in &self.points {
            let motion = Motion::new(mass, &nodal, &velocities);
            let twice = motion.velocity.dot(&motion.h) + motion.omega.dot(&motion.k);
            let moment_of_mass = mass.mass * motion.section.point.p + motion.s;
            sum.kinetic += 0.5 * twice;
            sum.gravity -= moment_of_mass.dot(&at.loading.gravity);
        }
        sum
    }

    fn exchanged(&self) -> Exchange {
        Exchange::by_signals(self)
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Momenta
    }
}
