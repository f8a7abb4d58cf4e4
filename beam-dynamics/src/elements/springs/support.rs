//! Support: a spring and a damper from a node to the turning frame or to the world.
//!
//! With u the displacement of the node from its undeformed position and psi the rotation vector of
//! `R R_0^T`, both in the axes of the frame,
//!
//! ```text
//! F = - K_u u - C_u (u' + W u)
//! M = - T(psi)^-T [ K_psi psi + C_psi (psi' + W psi) ]        psi' = T(psi)^-1 omega
//! ```
//!
//! with omega relative to the frame. W = 0 for a support that turns with the frame. For a support
//! fixed in the world the frame turns: the rates of u and psi in its axes are `u' + Omega x u` and
//! `psi' + Omega x psi`, `W = [Omega]x`. It is the same at every angle of the frame only if the
//! node lies on the axis and K and C are isotropic about it; then K and C are constant in the frame
//! as well.
//!
//! M is the moment of the energy `1/2 psi . K psi`; about a single axis it is k psi at
//! every angle. Variations:
//!
//! ```text
//! d psi        = T^-1 theta
//! d psi'       = d(T^-1 omega)/d psi d psi + T^-1 d omega
//! d (T^-T q)   = d(T^-T q)/d psi d psi + T^-T d q
//! ```
//!
//! References: [Bauchau2003] for T and its inverse.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::spring::{is_other, other_way};
use crate::elements::{
    Charges, Element, Energetic, Energy, EnergySlope, Exchange, Growth, Local, LocalJacobian,
    LocalResidual, Motion, Observations, Reaction, Reading, ReadingRow, Reports, SmallMotion,
    Structure, has,
};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, TurningFrame, Variable};

/// Frame to which a support is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SupportFrame {
    /// In the turning frame, as clamps do.
    Frame,
    /// In the world, relative to which the frame turns.
    World,
}

/// Stiffness and damping of a support, symmetric, in the axes of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportLaw {
    /// Force per displacement [N/m].
    pub stiffness: Matrix3<f64>,
    /// Force per velocity [N s/m].
    pub damping: Matrix3<f64>,
    /// Moment per angle [N m].
    pub turning_stiffness: Matrix3<f64>,
    /// Moment per angular velocity [N m s].
    pub turning_damping: Matrix3<f64>,
}

impl SupportLaw {
    /// Stiffnesses and dampings along and about `axes` (columns): three along [N/m,
    /// N s/m], three about [N m, N m s].
    pub fn along(axes: &Matrix3<f64>, stiffness: &[f64; 6], damping: &[f64; 6]) -> Self {
        let part = |values: &[f64; 6], first: usize| {
            let diagonal = Vector3::new(values[first], values[first + 1], values[first + 2]);
            axes * Matrix3::from_diagonal(&diagonal) * axes.transpose()
        };
        Self {
            stiffness: part(stiffness, 0),
            damping: part(damping, 0),
            turning_stiffness: part(stiffness, 3),
            turning_damping: part(damping, 3),
        }
    }
}

/// Spring and damper of a node.
#[derive(Debug, Clone)]
pub struct SupportSpring {
    label: String,
    nodes: [usize; 1],
    position: Vector3<f64>,
    rotation: Matrix3<f64>,
    law: SupportLaw,
    support_frame: SupportFrame,
}

/// The support at a state.
struct State {
    /// `W` of the equations [rad/s].
    turning: Matrix3<f64>,
    /// Displacement [m] and its rate in the axes of the support [m/s].
    u: Vector3<f64>,
    u_rate: Vector3<f64>,
    /// Rotation vector [rad], `T^-1`, and the elastic and viscous moment q [N m].
    psi: Vector3<f64>,
    inverse: Matrix3<f64>,
    q: Vector3<f64>,
}

impl SupportSpring {
    /// Supports node `index`, relaxed at its undeformed position and attitude.
    pub fn new(
        label: impl Into<String>,
        index: usize,
        node: &Node,
        law: SupportLaw,
        support_frame: SupportFrame,
    ) -> Self {
        Self {
            label: label.into(),
            nodes: [index],
            position: node.position,
            rotation: node.rotation,
            law,
            support_frame,
        }
    }

    fn state(&self, node: &NodeMotion, frame: &TurningFrame) -> State {
        let turning = match self.support_frame {
            SupportFrame::Frame => Matrix3::zeros(),
            SupportFrame::World => frame.skew(),
        };
        let u = node.position - self.position;
        let psi = vector::from_rotation(&(node.rotation * self.rotation.transpose()));
        let inverse = vector::tangent_inverse(&psi);
        let psi_rate = inverse * node.angular_velocity + turning * psi;
        State {
            turning,
            u,
            u_rate: node.velocity + turning * u,
            psi,
            inverse,
            q: self.law.turning_stiffness * psi + self.law.turning_damping * psi_rate,
        }
    }

    /// Force and moment on the node.
    fn wrench(&self, state: &State) -> (Vector3<f64>, Vector3<f64>) {
        let force = self.law.stiffness * state.u + self.law.damping * state.u_rate;
        (-force, -(state.inverse.transpose() * state.q))
    }
}

/// Columns of a symmetric matrix that are not zero.
fn columns(matrix: &Matrix3<f64>) -> impl Iterator<Item = Vector3<f64>> + '_ {
    let columns = matrix.column_iter().map(|column| column.into_owned());
    columns.filter(|column| column.amax() > 0.0)
}

impl Element for SupportSpring {
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
        let (force, moment) = self.wrench(&self.state(&at.nodes[0], at.frame));
        out.add(0, Force, &force);
        out.add(0, Moment, &moment);
        let Some(out) = jacobian else { return };
        let node = &at.nodes[0];
        let law = &self.law;
        let state = self.state(node, at.frame);
        let by_position = law.stiffness + law.damping * state.turning;
        out.add((0, Force), (0, Variable::Position), &-by_position);

        let transposed = state.inverse.transpose();
        let rate = vector::tangent_inverse_derivative(&state.psi, &node.angular_velocity);
        let q = law.turning_stiffness + law.turning_damping * (rate + state.turning);
        let by_psi = transposed * q - vector::tangent_inverse_derivative(&-state.psi, &state.q);
        let by_rotation = by_psi * state.inverse;
        out.add((0, Moment), (0, Variable::Rotation), &-by_rotation);

        if law.damping != Matrix3::zeros() {
            out.add((0, Force), (0, Variable::Velocity), &-law.damping);
        }
        if law.turning_damping != Matrix3::zeros() {
            let by_velocity = transposed * law.turning_damping * state.inverse;
            out.add((0, Moment), (0, Variable::AngularVelocity), &-by_velocity);
        }
    }

    has!(energetic: Energetic, growth: Growth, structure: Structure, reports: Reports);
}

impl Energetic for SupportSpring {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let State { u, psi, .. } = self.state(&at.nodes[0], at.frame);
        let along = u.dot(&(self.law.stiffness * u));
        let about = psi.dot(&(self.law.turning_stiffness * psi));
        Energy {
            elastic: 0.5 * (along + about),
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        let zero = Matrix3::zeros();
        let is_viscous = self.law.damping != zero || self.law.turning_damping != zero;
        Exchange::of(is_viscous, false)
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Forces
    }
}

impl Growth for SupportSpring {
    fn add_by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    /// `d(T^-T q)/d psi d psi` with the growth of q, `K_psi d psi` along the motion.
    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        let state = self.state(&at.nodes[0], at.frame);
        let growth = self.law.turning_stiffness * state.inverse * motion.nodes[0][1];
        let by_psi = vector::tangent_inverse_derivative(&-state.psi, &growth);
        let by_rotation = by_psi * state.inverse;
        out.add((0, Moment), (0, Variable::Rotation), &by_rotation);
    }
}

impl Structure for SupportSpring {
    fn arm(&self) -> f64 {
        0.0
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        let zero = Vector3::zeros();
        let along = columns(&self.law.stiffness).map(|row| [row, zero]);
        let about = columns(&self.law.turning_stiffness).map(|row| [zero, row]);
        let motion = |form| Motion {
            form: vec![form],
            is_resisted: true,
        };
        along.chain(about).map(motion).collect()
    }

    fn loaded_turn(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        let stiffness = &self.law.turning_stiffness;
        let psi = self.state(&at.nodes[0], at.frame).psi;
        let [one, other] = [psi, other_way(&psi)].map(|psi| stiffness * psi);
        is_other([&one, &other], stiffness, &psi).then_some(psi)
    }

    fn undefined(&self, _at: &Local<'_>) -> Option<String> {
        None
    }
}

impl Reports for SupportSpring {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        let (force, moment) = self.wrench(&self.state(&at.nodes[0], at.frame));
        out.reactions.push(Reaction {
            joint: self.label.clone(),
            node: self.nodes[0],
            force,
            moment,
        });
    }

    fn reading(
        &self,
        _reading: &Reading,
        _at: &Local<'_>,
        _row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        None
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}
