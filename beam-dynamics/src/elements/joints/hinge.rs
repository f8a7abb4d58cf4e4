//! Hinge: two nodes that share a point and an axis, with a spring and a damper about it.
//!
//! Axes E (columns h, u, v: the hinge and two directions across it) are attached to
//! both nodes and coincide in the undeformed state.
//!
//! ```text
//! (x_b + f_b) - (x_a + f_a) = 0                                 multipliers: force
//! u_a . h_b = 0,   v_a . h_b = 0                                multipliers: moment
//!
//! phi  = atan2(v_a . u_b, u_a . u_b)          phi' = h_a . (omega_b - omega_a)
//! M    = k (phi - phi_0(t)) + c phi'          on b: -M h_a,   on a: +M h_a
//! ```
//!
//! phi - phi_0 is reduced to between minus and plus half a turn: phi_0 may be driven over full
//! turns. If a constant phi_0 is far from the undeformed state ([`FAR`]), the full turn is centered
//! between the two, at `phi - phi_0 = -phi_0 / 2`, so that phi_0 may be half a turn and more.
//!
//! Variations, with s = v_a . u_b and c = u_a . u_b:
//!
//! ```text
//! d phi  = w . (theta_b - theta_a),   w = [s (u_a x u_b) - c (v_a x u_b)] / (s^2 + c^2)
//! d phi' = h_a . (d omega_b - d omega_a) + (h_a x (omega_b - omega_a)) . theta_a
//! d h_a  = -[h_a]x theta_a
//! ```
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | f_a, f_b | offset of the hinge from each node | m |
//! | phi, phi_0 | angle of b relative to a, and of the relaxed spring | rad |
//! | k, c | stiffness of the spring, coefficient of the damper | N m, N m s |
//!
//! w is h if the constraints are fulfilled.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

use super::joint::{ConstraintJoint, JointEnds};
use super::kinds::{Placing, axes_along};
use crate::elements::{
    Charges, ConstraintRates, ConstraintWords, Constraints, Element, Energetic, Energy,
    EnergySlope, Exchange, FixedAxes, FixedVector, Growth, Instant, Level, Local, LocalJacobian,
    LocalResidual, Motion, Observations, PositionJump, Queries, Reading, ReadingRow, Reports,
    Signal, SmallMotion, Structure, has, prestress_of_multipliers,
};
use crate::model::Equation::Moment;
use crate::model::{Loading, Node, NodeMotion, Scalar, Scalars, Variable};

/// Constant relaxed angle from which on the range of the angle is centered between the undeformed
/// and the relaxed state \[rad\]: 150 deg.
const FAR: f64 = 5.0 * TAU / 12.0;

/// Spring and damper of a hinge.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct HingeSpring {
    /// Moment per angle; zero for a free hinge [N m].
    pub stiffness: f64,
    /// Moment per rate of the angle [N m s].
    pub damping: f64,
    /// Angle at which the spring is relaxed, zero in the undeformed state, less than a full turn
    /// [rad].
    pub angle: f64,
}

/// Lets a node turn relative to another about one axis.
#[derive(Debug, Clone)]
pub struct Hinge {
    joint: ConstraintJoint,
    /// The axis in the undeformed model.
    axis: Vector3<f64>,
    spring: HingeSpring,
    /// Signal of the relaxed angle, if it changes [rad].
    relaxed: Option<Signal>,
    /// The scalars that it reads.
    scalars: Vec<Scalar>,
}

/// The hinge at a state.
struct State {
    /// Axes h, u, v on each node.
    axes: [Matrix3<f64>; 2],
    /// Angular velocity of b relative to a [rad/s].
    rate: Vector3<f64>,
}

impl Hinge {
    /// A hinge at `position` along `axis` (of any length but zero), in the model's frame, between
    /// the nodes `nodes`, undeformed at `undeformed`.
    ///
    /// A positive angle is a right-hand rotation of the second node about the axis.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 2],
        undeformed: [&Node; 2],
        position: &Vector3<f64>,
        axis: &Vector3<f64>,
        spring: HingeSpring,
    ) -> Self {
        let axes = axes_along(axis);
        let [a, b] = [0, 1].map(|i| (nodes[i], undeformed[i]));
        let ends = JointEnds { a: Some(a), b };
        let at = Placing::at(position, &axes);
        Self {
            joint: ConstraintJoint::revolute(label, &ends, &at, None),
            axis: axes.column(0).into_owned(),
            spring,
            relaxed: None,
            scalars: Vec::new(),
        }
    }

    /// The same with a spring whose relaxed angle follows a signal [rad].
    #[must_use]
    pub fn relaxed_by(mut self, angle: impl Into<Signal>) -> Self {
        self.scalars.clear();
        self.relaxed = Some(angle.into().bound(&mut self.scalars));
        self
    }

    /// Angle relative to the relaxed spring, at most half a turn from its mean.
    fn turned(&self, state: &State, now: &Instant<'_>) -> f64 {
        let driven = self.relaxed.as_ref().map(|signal| signal.value(now));
        let mean = match driven {
            None if self.spring.angle.abs() > FAR => -0.5 * self.spring.angle,
            _ => 0.0,
        };
        let apart = state.angle() - driven.unwrap_or(self.spring.angle);
        apart - TAU * ((apart - mean) / TAU).round()
    }

    fn state(&self, nodes: &[NodeMotion]) -> State {
        let ends = self.joint.ends(nodes);
        State {
            axes: [ends.a.axes, ends.b.axes],
            rate: ends.b.omega - ends.a.omega,
        }
    }

    /// Angle of the second node relative to the first, from -pi to pi \[rad\].
    pub fn angle(&self, nodes: &[NodeMotion]) -> f64 {
        self.state(nodes).angle()
    }

    /// Moment of spring and damper, positive if it reduces the angle \[N m\].
    fn moment(&self, state: &State, now: &Instant<'_>) -> f64 {
        let HingeSpring {
            stiffness, damping, ..
        } = self.spring;
        let mut moment = 0.0;
        // A free hinge may have any angle, also an undefined one.
        if stiffness != 0.0 {
            moment += stiffness * self.turned(state, now);
        }
        moment + damping * state.axis().dot(&state.rate)
    }

    /// Energy of the spring \[J\]. If the constraints are violated, the moment about the axis is
    /// not its derivative.
    fn elastic_energy(&self, at: &Local<'_>, row: Option<&mut ReadingRow<'_>>) -> f64 {
        // The angle of a free hinge may be undefined.
        if self.spring.stiffness == 0.0 {
            return 0.0;
        }
        let (state, now) = (self.state(at.nodes), at.instant());
        let turned = self.turned(&state, &now);
        let moment = self.spring.stiffness * turned;
        if let Some(row) = row {
            let slope = moment * state.angle_gradient();
            row.by_node(0, Variable::Rotation, &-slope);
            row.by_node(1, Variable::Rotation, &slope);
            if let Some(relaxed) = &self.relaxed {
                relaxed.gradient(&now, |scalar, slope| {
                    row.by_scalar((scalar, false), -moment * slope);
                });
            }
        }
        0.5 * moment * turned
    }

    fn is_free(&self) -> bool {
        self.spring.stiffness == 0.0 && self.spring.damping == 0.0
    }

    fn spring_jacobian(&self, state: &State, now: &Instant<'_>, out: &mut LocalJacobian) {
        let HingeSpring {
            stiffness, damping, ..
        } = self.spring;
        let h = state.axis();
        let gradient = if stiffness == 0.0 {
            Vector3::zeros()
        } else {
            stiffness * state.angle_gradient()
        };
        let turning = damping * h.cross(&state.rate);
        // Derivatives of M h_a by the rotations of a and b, and by the velocity of b.
        let by_a = h * (turning - gradient).transpose() - self.moment(state, now) * skew(&h);
        let by_b = h * gradient.transpose();
        let by_velocity = damping * h * h.transpose();
        for (node, sign) in [(0, 1.0), (1, -1.0)] {
            out.add((node, Moment), (0, Variable::Rotation), &(sign * by_a));
            out.add((node, Moment), (1, Variable::Rotation), &(sign * by_b));
            if damping != 0.0 {
                let [a, b] = [-sign, sign].map(|sign| sign * by_velocity);
                out.add((node, Moment), (0, Variable::AngularVelocity), &a);
                out.add((node, Moment), (1, Variable::AngularVelocity), &b);
            }
        }
        if let Some(relaxed) = self.relaxed.as_ref().filter(|_| stiffness != 0.0) {
            relaxed.gradient(now, |scalar, slope| {
                let moment = stiffness * slope * h;
                out.add_by_scalar((0, Moment), (scalar, false), &-moment);
                out.add_by_scalar((1, Moment), (scalar, false), &moment);
            });
        }
    }
}

impl State {
    /// The axis `h_a`.
    fn axis(&self) -> Vector3<f64> {
        self.axes[0].column(0).into_owned()
    }

    /// `s = v_a . u_b` and `c = u_a . u_b`.
    fn sine_and_cosine(&self) -> (f64, f64) {
        let [a, b] = &self.axes;
        (a.column(2).dot(&b.column(1)), a.column(1).dot(&b.column(1)))
    }

    fn angle(&self) -> f64 {
        let (s, c) = self.sine_and_cosine();
        s.atan2(c)
    }

    /// `w` of `d phi = w . (theta_b - theta_a)`.
    fn angle_gradient(&self) -> Vector3<f64> {
        let [a, b] = &self.axes;
        let (s, c) = self.sine_and_cosine();
        (s * a.column(1) - c * a.column(2)).cross(&b.column(1)) / (s * s + c * c)
    }
}

impl Element for Hinge {
    fn label(&self) -> &str {
        self.joint.label()
    }

    fn nodes(&self) -> &[usize] {
        self.joint.nodes()
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.relaxed.iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let mut jacobian = jacobian;
        self.joint.evaluate(at, out, jacobian.as_deref_mut());
        let state = self.state(at.nodes);
        let moment = self.moment(&state, &at.instant()) * state.axis();
        out.add(0, Moment, &moment);
        out.add(1, Moment, &-moment);
        if let Some(out) = jacobian.filter(|_| !self.is_free()) {
            self.spring_jacobian(&state, &at.instant(), out);
        }
    }

    has!(constraints: Constraints, fixed_axes: FixedAxes, energetic: Energetic, growth: Growth, structure: Structure, reports: Reports);
}

impl Constraints for Hinge {
    fn count(&self) -> usize {
        self.joint.multipliers()
    }

    fn level_of(&self, _constraint: usize) -> Level {
        Level::Position
    }

    fn words_of(&self, constraint: usize) -> ConstraintWords {
        self.joint.constraint_words(constraint)
    }

    fn add_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        self.joint.constraint_rates(at, out)
    }

    fn position_jump(
        &self,
        _between: [&Loading; 2],
        _scalars: Scalars<'_>,
    ) -> Option<PositionJump> {
        None
    }

    fn held_in_place(&self, _undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        None
    }

    fn turned_over(&self, _at: &Local<'_>) -> bool {
        false
    }

    fn axes_of_ends(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        self.joint.end_axes(at)
    }
}

impl FixedAxes for Hinge {
    fn vectors(&self) -> Vec<FixedVector> {
        self.joint.fixed_vectors()
    }
}

impl Energetic for Hinge {
    fn stored(&self, at: &Local<'_>) -> Energy {
        Energy {
            elastic: self.elastic_energy(at, None),
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        let is_driven = self.relaxed.iter().any(|angle| angle.constant().is_none());
        Exchange::of(self.spring.damping != 0.0, is_driven)
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        EnergySlope::Read
    }
}

impl Growth for Hinge {
    fn add_by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        prestress_of_multipliers(self, at, motion, out);
        if self.spring.stiffness == 0.0 {
            return;
        }
        // The spring's moment M h_a grows by k d phi; h_a turns with the first node.
        let state = self.state(at.nodes);
        let against = motion.nodes[1][1] - motion.nodes[0][1];
        let growth = self.spring.stiffness * state.angle_gradient().dot(&against);
        let by_a = -growth * skew(&state.axis());
        for (node, sign) in [(0, 1.0), (1, -1.0)] {
            out.add((node, Moment), (0, Variable::Rotation), &(sign * by_a));
        }
    }
}

impl Structure for Hinge {
    fn arm(&self) -> f64 {
        self.joint.reach()
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        let zero = Vector3::zeros();
        vec![Motion {
            form: vec![[zero, -self.axis], [zero, self.axis]],
            is_resisted: self.spring.stiffness > 0.0,
        }]
    }

    fn loaded_turn(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        let is_loaded = self.spring.stiffness != 0.0;
        is_loaded.then(|| {
            let turned = self.turned(&self.state(at.nodes), &at.instant());
            turned * Vector3::x()
        })
    }

    fn undefined(&self, _at: &Local<'_>) -> Option<String> {
        None
    }
}

impl Reports for Hinge {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        let state = self.state(at.nodes);
        let moment = self.moment(&state, &at.instant()) * state.axis();
        self.joint.observe_with(at, &moment, out);
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        match reading {
            Reading::Energy(_) => Some(self.elastic_energy(at, row)),
            _ => self.joint.read(reading, at, row),
        }
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}
