//! Rigid body carried by a node.
//!
//! With mass m, first moment `S = R S~` and inertia `J = R J~ R^T` about the node,
//! v and omega the velocities of the node in space:
//!
//! ```text
//! momentum           - (m v + omega x S)
//! angular momentum   - (S x v + J omega)
//! force balance        m a_g                       a_g: acceleration of gravity
//! moment balance       S x a_g
//! kinetic energy       1/2 v . (m v + omega x S) + 1/2 omega . (S x v + J omega)
//! potential          - (m x + S) . a_g             (zero at the origin)
//! ```
//!
//! References: [Masarati], momentum and momenta moment of a rigid body.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{skew, skew_skew, times_skew};

use crate::elements::{
    Element, Energetic, Energy, EnergySlope, Exchange, Local, LocalJacobian, LocalResidual, has,
};
use crate::model::Equation::{AngularMomentum, Force, Moment, Momentum};
use crate::model::{NodeMotion, TurningFrame, Variable};

/// Inertia of a rigid body about its node, in the axes of the node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidInertia {
    /// Mass [kg].
    pub mass: f64,
    /// First moment: mass times the offset of the mass center [kg m].
    pub first_moment: Vector3<f64>,
    /// Second moment about the node, 3x3 symmetric [kg m^2].
    pub inertia: Matrix3<f64>,
}

impl RigidInertia {
    /// No mass.
    pub fn zero() -> Self {
        Self {
            mass: 0.0,
            first_moment: Vector3::zeros(),
            inertia: Matrix3::zeros(),
        }
    }

    /// Body of mass `mass` with its center at `offset` from the node and the inertia
    /// `central` about that center, in the node's axes:
    /// `S = m b`, `J = J_c - m [b]x [b]x`.
    pub fn about_node(mass: f64, offset: &Vector3<f64>, central: &Matrix3<f64>) -> Self {
        let b = skew(offset);
        Self {
            mass,
            first_moment: mass * offset,
            inertia: central - mass * b * b,
        }
    }
}

/// A rigid body that moves with a node.
#[derive(Debug, Clone)]
pub struct RigidBody {
    label: String,
    nodes: [usize; 1],
    inertia: RigidInertia,
}

impl RigidBody {
    /// A body on node `node`.
    pub fn new(label: impl Into<String>, node: usize, inertia: RigidInertia) -> Self {
        Self {
            label: label.into(),
            nodes: [node],
            inertia,
        }
    }

    /// First moment [kg m] and inertia [kg m^2] in the model's axes, and the
    /// velocities of the node in space.
    fn kinematics(&self, node: &NodeMotion, frame: &TurningFrame) -> Kinematics {
        let r = &node.rotation;
        Kinematics {
            s: r * self.inertia.first_moment,
            j: r * self.inertia.inertia * r.transpose(),
            v: node.velocity_in_space(frame),
            omega: node.angular_velocity_in_space(frame),
        }
    }
}

struct Kinematics {
    s: Vector3<f64>,
    j: Matrix3<f64>,
    v: Vector3<f64>,
    omega: Vector3<f64>,
}

impl Element for RigidBody {
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
        let Kinematics { s, j, v, omega } = self.kinematics(&at.nodes[0], at.frame);
        out.add(0, Momentum, &-(self.inertia.mass * v));
        out.add(0, Momentum, &-omega.cross(&s));
        out.add(0, AngularMomentum, &-s.cross(&v));
        out.add(0, AngularMomentum, &-(j * omega));
        let gravity = &at.loading.gravity;
        out.add(0, Force, &(self.inertia.mass * gravity));
        out.add(0, Moment, &s.cross(gravity));
        let Some(out) = jacobian else { return };
        let m = self.inertia.mass;
        let turning = at.frame.skew();
        let skew_s = skew(&s);

        // d(m v + omega x S), with dv = dx' + [Omega]x dx and dS = theta x S.
        let mass = Matrix3::from_diagonal_element(-m);
        out.add((0, Momentum), (0, Variable::Velocity), &mass);
        out.add((0, Momentum), (0, Variable::Position), &(-m * turning));
        out.add((0, Momentum), (0, Variable::AngularVelocity), &skew_s);
        let by_rotation = skew_skew(&omega, &s);
        out.add((0, Momentum), (0, Variable::Rotation), &by_rotation);

        // d(S x v + J omega), with dJ omega = -[J omega]x theta + J [omega]x theta.
        let by_rotation = skew(&(j * omega)) - skew_skew(&v, &s) - times_skew(&j, &omega);
        let by_position = -skew_skew(&s, &at.frame.angular_velocity);
        out.add((0, AngularMomentum), (0, Variable::Velocity), &-skew_s);
        out.add((0, AngularMomentum), (0, Variable::Position), &by_position);
        out.add((0, AngularMomentum), (0, Variable::AngularVelocity), &-j);
        out.add((0, AngularMomentum), (0, Variable::Rotation), &by_rotation);

        // d(S x a_g) = [a_g]x [S]x theta.
        let weight = skew_skew(&at.loading.gravity, &s);
        out.add((0, Moment), (0, Variable::Rotation), &weight);
    }

    has!(energetic: Energetic);
}

impl Energetic for RigidBody {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let node = &at.nodes[0];
        let Kinematics { s, j, v, omega } = self.kinematics(node, at.frame);
        let momentum = self.inertia.mass * v + omega.cross(&s);
        let angular = s.cross(&v) + j * omega;
        let moment_of_mass = self.inertia.mass * node.position + s;
        Energy {
            kinetic: 0.5 * (v.dot(&momentum) + omega.dot(&angular)),
            gravity: -moment_of_mass.dot(&at.loading.gravity),
            ..Energy::default()
        }
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
