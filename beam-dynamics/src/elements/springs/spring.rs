//! Spring between two nodes, or between the frame and a node: laws of the displacement and of the
//! rotation of the second relative to the first.
//!
//! Axes E (columns) are attached to both nodes and coincide in the undeformed state; the frame may
//! replace the first node, with `x_a` any fixed point. At the point `p = x_b + f_b` of the second
//! node,
//!
//! ```text
//! r   = p - x_a                                  w = v_b + omega_b x f_b - v_a - omega_a x r
//! u   = E_a^T r - (E_a^T r)_0                    u'   = E_a^T w
//! psi = vector(E_a^T E_b)                        psi' = T(psi)^-1 Omega,  Omega = E_a^T (omega_b - omega_a)
//! [f~; m~] = law([u; psi], [u'; psi'], t)        F = E_a f~,  M = E_a T(psi)^-T m~
//! ```
//!
//! The force acts on both nodes at the point p, so that the moments balance exactly, and M is the
//! moment of the energy of the law:
//!
//! ```text
//! on a:    F      r x F + M                      on b:  - F    - f_b x F - M
//! ```
//!
//! psi is less than half a turn. Variations, with `d r = d x_b - [f_b]x theta_b - d x_a`:
//!
//! ```text
//! d u    = E_a^T (d r + [r]x theta_a)            d psi = T^-1 E_a^T (theta_b - theta_a)
//! d u'   = E_a^T (d w + [w]x theta_a)
//! d w    = - [omega_b]x [f_b]x theta_b - [omega_a]x d r        (at fixed velocities)
//! d psi' = d(T^-1 Omega)/d psi d psi + T^-1 E_a^T [omega_b - omega_a]x theta_a
//! d F    = E_a d f~ - [F]x theta_a
//! d M    = E_a ( T^-T d m~ + d(T^-T m~)/d psi d psi ) - [M]x theta_a
//! ```
//!
//! References: [Bauchau2003] for T and its inverse; [Masarati], springs in the axes of a
//! node.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::spring_law::SpringLaw;
use super::spring_state::{State, Wrench, six};
use crate::elements::laws::Response;
use crate::elements::{
    Charges, Element, Energetic, Energy, EnergySlope, Exchange, Growth, Local, LocalJacobian,
    LocalResidual, Motion, Observations, Reaction, Reading, ReadingRow, Reports, Signal,
    SmallMotion, SpringState, SpringVector, Structure, has,
};
use crate::model::Equation::{Force, Moment};
use crate::model::{Equation, Node, NodeMotion, Scalar, Variable};

const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
const RATES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];

/// A law between two nodes, or between the frame and a node.
#[derive(Debug, Clone)]
pub struct Spring {
    label: String,
    /// One node, or two.
    nodes: Vec<usize>,
    undeformed: Vec<NodeMotion>,
    /// The axes E on the first end and on the second, in their axes.
    axes: [Matrix3<f64>; 2],
    /// The point on the second node, in its axes [m].
    offset: Vector3<f64>,
    /// `x_a` if the frame is the first end [m].
    fixed: Vector3<f64>,
    /// `(E_a^T r)_0` [m].
    relaxed: Vector3<f64>,
    law: SpringLaw,
    /// The scalars that the law reads.
    scalars: Vec<Scalar>,
}

impl Spring {
    /// A spring between the nodes `nodes` of the model, or with one node between the frame and it,
    /// at the position `position` and along `axes`, both in the model's frame and undeformed.
    pub fn new(
        label: impl Into<String>,
        (nodes, all): (&[usize], &[Node]),
        position: &Vector3<f64>,
        axes: &Matrix3<f64>,
        law: impl Into<SpringLaw>,
    ) -> Self {
        let rest = nodes.iter().map(|&node| NodeMotion::at_rest(&all[node]));
        let mut spring = Self {
            label: label.into(),
            nodes: nodes.to_vec(),
            undeformed: rest.collect(),
            axes: [*axes; 2],
            offset: Vector3::zeros(),
            fixed: *position,
            relaxed: Vector3::zeros(),
            law: law.into(),
            scalars: Vec::new(),
        };
        spring.law.bind(&mut spring.scalars);
        let [a, b] = spring.ends(&spring.undeformed);
        spring.axes = [a, b].map(|end| end.rotation.transpose() * axes);
        spring.offset = b.rotation.transpose() * (position - b.position);
        spring.relaxed = axes.transpose() * (position - a.position);
        spring
    }

    /// Motion of the ends.
    fn ends(&self, nodes: &[NodeMotion]) -> [NodeMotion; 2] {
        match nodes {
            [a, b] => [*a, *b],
            _ => {
                let frame = Node {
                    label: String::new(),
                    position: self.fixed,
                    rotation: Matrix3::identity(),
                };
                [NodeMotion::at_rest(&frame), nodes[0]]
            }
        }
    }

    fn state(&self, nodes: &[NodeMotion]) -> State {
        let [a, b] = self.ends(nodes);
        let g = a.rotation * self.axes[0];
        let f = b.rotation * self.offset;
        let r = b.position + f - a.position;
        let arm_rate = b.angular_velocity.cross(&f) - a.angular_velocity.cross(&r);
        let w = b.velocity - a.velocity + arm_rate;
        let psi = vector::from_rotation(&(g.transpose() * b.rotation * self.axes[1]));
        let omega = g.transpose() * (b.angular_velocity - a.angular_velocity);
        let inverse = vector::tangent_inverse(&psi);
        let u = g.transpose() * r - self.relaxed;
        State {
            strain: six(&u, &psi),
            rate: six(&(g.transpose() * w), &(inverse * omega)),
            a,
            b,
            g,
            r,
            f,
            w,
            omega,
            inverse,
        }
    }

    fn response(&self, state: &State, at: &Local<'_>) -> Response<6> {
        self.law.at(&state.strain, &state.rate, &at.instant())
    }

    /// Index of an end among the nodes of the element; `None` for the frame.
    fn local(&self, end: usize) -> Option<usize> {
        (end + self.nodes.len()).checked_sub(2)
    }

    /// Calls `add` with the forces and moments on the nodes.
    fn each_wrench(
        &self,
        state: &State,
        wrench: &Wrench,
        mut add: impl FnMut(usize, Equation, &Vector3<f64>),
    ) {
        let Wrench { force, moment, .. } = wrench;
        let arms = [(state.r, 1.0), (state.f, -1.0)];
        for (end, (arm, sign)) in arms.into_iter().enumerate() {
            if let Some(row) = self.local(end) {
                add(row, Force, &(sign * force));
                add(row, Moment, &(sign * arm.cross(force)));
                add(row, Moment, &(sign * moment));
            }
        }
    }

    /// Adds the variation of forces and moments, when the law's forces vary by `stiffness` and
    /// `viscosity` and the present force and moment are `wrench`.
    fn add_variation(
        &self,
        state: &State,
        wrench: &Wrench,
        [stiffness, viscosity]: [&Matrix6<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        let by = state.variation();
        let rate_by = state.rate_variation();
        let columns = (0..2).filter_map(|j| Some((j, self.local(j)?)));
        for (j, column) in columns {
            for k in 0..2 {
                let section = stiffness * by[j][k] + viscosity * rate_by[j][k];
                let moved = (j, k, &by[j][k]);
                let rows = state.varied(wrench, &section, Some(moved));
                self.add_rows(&rows, (column, UNKNOWNS[k]), out);
                if self.law.is_viscous() {
                    let rows = state.varied(wrench, &(viscosity * by[j][k]), None);
                    self.add_rows(&rows, (column, RATES[k]), out);
                }
            }
        }
    }

    /// Adds force and moment rows of both ends in a column, if they can be nonzero.
    fn add_rows(
        &self,
        rows: &[[Matrix3<f64>; 2]; 2],
        column: (usize, Variable),
        out: &mut LocalJacobian,
    ) {
        let of_position = matches!(column.1, Variable::Position | Variable::Velocity);
        let has_force = self.law.has_force();
        if of_position && !has_force {
            return;
        }
        for (end, [force, moment]) in rows.iter().enumerate() {
            let Some(row) = self.local(end) else { continue };
            if has_force {
                out.add((row, Force), column, force);
            }
            out.add((row, Moment), column, moment);
        }
    }
}

/// Part of a rotation about the free axis of a spring below which a rotation across the axis is
/// treated as round-off.
const ACROSS: f64 = 1e-6;

/// The same rotation as psi, in the opposite sense.
pub(super) fn other_way(psi: &Vector3<f64>) -> Vector3<f64> {
    psi * (1.0 - TAU / psi.norm())
}

/// Whether the force or moment of a rotation psi, the sum of `rest` and of a `stiffness` times psi,
/// differs by more than round-off from its value (`other`) for the same rotation in the opposite
/// sense.
pub(super) fn is_other(
    [one, other]: [&Vector3<f64>; 2],
    stiffness: &Matrix3<f64>,
    psi: &Vector3<f64>,
) -> bool {
    let apart = (one - other).norm();
    let round_off = ACROSS * (stiffness.norm() * psi.norm() + one.norm());
    // A law that is undefined there has no other sense.
    apart > round_off || apart.is_nan()
}

impl Spring {
    /// Adds the derivatives of a vector along `e`, in the axes of the spring. The force F and the
    /// moment M of the spring follow from the residual at b, `F_b = -F` and `M_b = -f x F - M`, so
    /// that with `m = g e`, which turns with a,
    ///
    /// ```text
    /// d( e . F ) = -m . dF_b + (m x F) . theta_a
    /// d( e . M ) = -m . dM_b + (m x f) . dF_b + ( f x (m x F) ) . theta_b + (m x M) . theta_a
    /// ```
    fn add_reading(
        &self,
        (state, wrench): (&State, &Wrench),
        (vector, e): (SpringVector, &Vector3<f64>),
        row: &mut ReadingRow<'_>,
    ) {
        let m = state.g * e;
        let (a, b) = (self.local(0), self.local(1));
        let mut turn = |end: Option<usize>, slope: Vector3<f64>| {
            if let Some(node) = end {
                row.by_node(node, Variable::Rotation, &slope);
            }
        };
        let of_strain = match vector {
            SpringVector::Displacement => 0,
            SpringVector::Rotation => 3,
            SpringVector::Force => {
                turn(a, m.cross(&wrench.force));
                b.into_iter().for_each(|b| row.by_equation(b, Force, &-m));
                return;
            }
            SpringVector::Moment => {
                turn(a, m.cross(&wrench.moment));
                turn(b, state.f.cross(&m.cross(&wrench.force)));
                if let Some(b) = b {
                    row.by_equation(b, Moment, &-m);
                    row.by_equation(b, Force, &m.cross(&state.f));
                }
                return;
            }
        };
        for (end, by) in state.variation().iter().enumerate() {
            let Some(node) = self.local(end) else {
                continue;
            };
            for (by, variable) in by.iter().zip(UNKNOWNS) {
                let slope = by.fixed_rows::<3>(of_strain).tr_mul(e);
                row.by_node(node, variable, &slope);
            }
        }
    }
}

impl Element for Spring {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.law.each_signal(visit);
    }

    fn has_kinks(&self) -> bool {
        self.law.has_kinks()
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let state = self.state(at.nodes);
        let response = self.response(&state, at);
        let wrench = state.wrench(&response.force);
        self.each_wrench(&state, &wrench, |row, equation, value| {
            out.add(row, equation, value);
        });
        let Some(out) = jacobian else { return };
        let slopes = [&response.by_strain, &response.by_rate];
        self.add_variation(&state, &wrench, slopes, out);
        let (strain, rate) = (&state.strain, &state.rate);
        let now = at.instant();
        (self.law).by_scalars(strain, rate, &now, |scalar, force, of_rate| {
            self.each_wrench(&state, &state.wrench(force), |row, equation, value| {
                out.add_by_scalar((row, equation), (scalar, of_rate), value);
            });
        });
    }

    has!(energetic: Energetic, growth: Growth, structure: Structure, reports: Reports);
}

impl Energetic for Spring {
    fn stored(&self, at: &Local<'_>) -> Energy {
        let strain = self.state(at.nodes).strain;
        Energy {
            elastic: self.law.energy(&strain, &at.instant()),
            ..Energy::default()
        }
    }

    fn exchanged(&self) -> Exchange {
        Exchange::of(self.law.is_viscous(), !self.law.keeps_energy())
    }

    fn is_conservative(&self) -> bool {
        true
    }

    fn slope(&self) -> EnergySlope {
        if self.law.keeps_energy() {
            EnergySlope::Forces
        } else {
            EnergySlope::Unknown
        }
    }
}

impl Growth for Spring {
    fn add_by_factor(&self, _at: &Local<'_>, _out: &mut LocalResidual) {}

    /// The part proportional to force and moment, for their growth along the motion.
    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        let state = self.state(at.nodes);
        let mut strain = Vector6::zeros();
        for (end, by) in state.variation().iter().enumerate() {
            if let Some(local) = self.local(end) {
                let [displacement, rotation] = &motion.nodes[local];
                strain += by[0] * displacement + by[1] * rotation;
            }
        }
        let growth = self.response(&state, at).by_strain * strain;
        let none = Matrix6::zeros();
        self.add_variation(&state, &state.wrench(&growth), [&none, &none], out);
    }
}

impl Structure for Spring {
    fn arm(&self) -> f64 {
        let on_a = match self.nodes.len() {
            1 => 0.0,
            _ => self.relaxed.norm(),
        };
        on_a.max(self.offset.norm())
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        let by = self.state(&self.undeformed).variation();
        let stiffness = self.law.stiffness_at_rest();
        let resisted = stiffness.row_iter().filter(|row| row.amax() > 0.0);
        let motion = |row: nalgebra::RowVector6<f64>| {
            let ends = (0..2).filter(|&end| self.local(end).is_some());
            let form = |end: usize| [0, 1].map(|k| (row * by[end][k]).transpose());
            Motion {
                form: ends.map(form).collect(),
                is_resisted: true,
            }
        };
        resisted.map(|row| motion(row.into_owned())).collect()
    }

    fn loaded_turn(&self, at: &Local<'_>) -> Option<Vector3<f64>> {
        let state = self.state(at.nodes);
        let psi = state.psi();
        let of = |psi: &Vector3<f64>| {
            let u = state.strain.fixed_rows::<3>(0).into_owned();
            let law = self.law.at(&six(&u, psi), &Vector6::zeros(), &at.instant());
            let [force, inner] = [0, 3].map(|k| law.force.fixed_rows::<3>(k).into_owned());
            let moment = vector::tangent_inverse(psi).transpose() * inner;
            ([force, moment], law.by_strain)
        };
        let ((one, slopes), (other, _)) = (of(&psi), of(&other_way(&psi)));
        let is_loaded = [0, 1].into_iter().any(|k| {
            let stiffness = slopes.fixed_view::<3, 3>(3 * k, 3).into_owned();
            is_other([&one[k], &other[k]], &stiffness, &psi)
        });
        is_loaded.then_some(psi)
    }

    fn undefined(&self, _at: &Local<'_>) -> Option<String> {
        None
    }
}

impl Reports for Spring {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        let state = self.state(at.nodes);
        let section = self.response(&state, at).force;
        let Wrench { force, moment, .. } = state.wrench(&section);
        out.springs.push(SpringState {
            spring: self.label.clone(),
            axes: state.g,
            displacement: state.strain.fixed_rows::<3>(0).into_owned(),
            rotation: state.psi(),
            force: section.fixed_rows::<3>(0).into_owned(),
            moment: state.g.transpose() * moment,
        });
        if self.nodes.len() == 1 {
            out.reactions.push(Reaction {
                joint: self.label.clone(),
                node: self.nodes[0],
                force: -force,
                moment: -(state.f.cross(&force) + moment),
            });
        }
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        let Reading::Spring { vector, part } = *reading else {
            return None;
        };
        let state = self.state(at.nodes);
        let section = self.response(&state, at).force;
        let wrench = state.wrench(&section);
        let w = match vector {
            SpringVector::Displacement => state.strain.fixed_rows::<3>(0).into_owned(),
            SpringVector::Rotation => state.psi(),
            SpringVector::Force => state.g.tr_mul(&wrench.force),
            SpringVector::Moment => state.g.tr_mul(&wrench.moment),
        };
        if let Some(row) = row {
            self.add_reading((&state, &wrench), (vector, &part.slope(&w)), row);
        }
        Some(part.of(&w))
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}
