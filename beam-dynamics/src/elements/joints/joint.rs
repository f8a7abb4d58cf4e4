//! A joint: constraints between two ends.
//!
//! The rows of the algebra, with their data: the ends with their points and axes, the rotation
//! vector by which a drive turns the axes of a, and the factors of the targets. The constructor of
//! each joint lists its rows.
//!
//! References: [Masarati], appendix D: coincidence and orthogonality.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;
use shared_geom::units::rounded;

use super::algebra::{Attachment, Carrier, End, Ends, Held, Row, Seen, Turned};
use super::relative;
use crate::elements::loads::LoadFactor;
use crate::elements::{
    Charges, ConstraintRates, ConstraintWords, Constraints, Element, FixedAxes, FixedVector,
    Growth, Instant, Level, Local, LocalJacobian, LocalResidual, Motion, Observations,
    PositionJump, Reaction, Reading, ReadingRow, Reports, Signal, SmallMotion, Structure, has,
    prestress_of_multipliers,
};
use crate::model::{DriveValue, Loading, Node, NodeMotion, Scalar, Scalars};

mod held;
mod jump;

/// Constraints between two nodes, or between the frame of the model and a node.
#[derive(Debug, Clone)]
pub struct ConstraintJoint {
    label: String,
    nodes: Vec<usize>,
    /// The attachments of end a (the first node, or the frame) and of end b.
    attachments: [Attachment; 2],
    /// The undeformed axes of a, fixed in the frame.
    axes: Matrix3<f64>,
    rows: Vec<Row>,
    /// Components of the rotation vector that turns the axes of a.
    turn: Option<[Signal; 3]>,
    /// The load factor of the targets and of that rotation.
    factor: Option<LoadFactor>,
    /// The multiplier of both.
    scale: Option<Signal>,
    /// The scalars that the targets, the rotation and the scale read.
    scalars: Vec<Scalar>,
    /// The axis about which b turns relative to a, if there is one.
    angle_about: Option<usize>,
    /// Motions that are free on purpose.
    motions: Vec<Motion>,
    /// The longest undeformed arm from a node to its point, or distance of the points [m].
    reach: f64,
}

/// The ends of a joint in the undeformed model.
#[derive(Debug, Clone, Copy)]
pub struct JointEnds<'a> {
    /// Index of the node of a, and the node; `None` for the frame.
    pub a: Option<(usize, &'a Node)>,
    /// Index of the node of b, and the node.
    pub b: (usize, &'a Node),
}

impl JointEnds<'_> {
    /// Indices of the nodes.
    fn nodes(&self) -> Vec<usize> {
        let a = self.a.iter().map(|a| a.0);
        a.chain([self.b.0]).collect()
    }

    /// The longest arm from a node to its point, or distance of the points \[m\].
    fn reach(&self, [at_a, at_b]: [&Vector3<f64>; 2]) -> f64 {
        let on_a = self.a.map_or(0.0, |a| (at_a - a.1.position).norm());
        let on_b = (at_b - self.b.1.position).norm();
        on_a.max(on_b).max((at_b - at_a).norm())
    }
}

/// A point and axes (columns) in the undeformed model.
pub(super) type Pose = (Vector3<f64>, Matrix3<f64>);

impl ConstraintJoint {
    /// All given signals.
    fn given(&self) -> impl Iterator<Item = &Signal> {
        let targets = self.rows.iter().filter_map(|row| row.target.as_ref());
        targets.chain(self.turn.iter().flatten()).chain(&self.scale)
    }

    /// A joint of `rows` with the given points and axes of a and of b.
    pub(super) fn of_rows(
        label: impl Into<String>,
        ends: &JointEnds<'_>,
        poses: [Pose; 2],
        mut rows: Vec<Row>,
    ) -> Self {
        let [(at_a, axes_a), (at_b, axes_b)] = &poses;
        let a = match ends.a {
            Some((_, node)) => Attachment::to(node, at_a, axes_a),
            None => Attachment::to_frame(at_a, axes_a),
        };
        let mut scalars = Vec::new();
        let targets = rows.iter_mut().filter_map(|row| row.target.as_mut());
        targets.for_each(|target| target.bind(&mut scalars));
        let mut joint = Self {
            label: label.into(),
            nodes: ends.nodes(),
            attachments: [a, Attachment::to(ends.b.1, at_b, axes_b)],
            axes: *axes_a,
            rows,
            turn: None,
            factor: None,
            scale: None,
            scalars,
            angle_about: None,
            motions: Vec::new(),
            reach: ends.reach([at_a, at_b]),
        };
        let undeformed: Vec<_> = ends.a.iter().map(|a| a.1).chain([ends.b.1]).collect();
        let undeformed: Vec<_> = undeformed.into_iter().map(NodeMotion::at_rest).collect();
        let seen = joint.seen(&undeformed, &Loading::none(), Scalars::NONE);
        joint.motions = relative::free_motions(&joint.rows, &seen);
        joint
    }

    /// Turns the axes of a by a rotation vector.
    pub(super) fn turned_by(mut self, turn: [Signal; 3]) -> Self {
        self.turn = Some(turn.map(|signal| signal.bound(&mut self.scalars)));
        self
    }

    /// Makes targets and rotation grow with the loads.
    pub(in crate::elements) fn growing_with(mut self, factor: LoadFactor) -> Self {
        self.factor = Some(factor);
        self
    }

    /// Multiplies targets and rotation by a signal.
    #[must_use]
    pub fn scaled_by(mut self, scale: impl Into<Signal>) -> Self {
        self.scale = Some(scale.into().bound(&mut self.scalars));
        self
    }

    /// Adds an angle of b relative to a about an axis.
    pub(super) fn with_angle_about(mut self, axis: usize) -> Self {
        self.angle_about = Some(axis);
        self
    }

    /// Both ends at a state.
    pub(super) fn ends(&self, nodes: &[NodeMotion]) -> Ends {
        let [on_a, on_b] = &self.attachments;
        let b = nodes.len() - 1;
        Ends {
            a: End::at(on_a, (b > 0).then_some(0), nodes),
            b: End::at(on_b, Some(b), nodes),
        }
    }

    /// The present multiplier of the targets.
    fn scale(&self, loading: &Loading, now: &Instant<'_>) -> DriveValue {
        let one = DriveValue::constant(1.0);
        let scale = self.scale.as_ref().map_or(one, |s| s.at(now));
        match self.factor {
            None => scale,
            Some(factor) => scale.scaled(factor.value(loading)),
        }
    }

    /// The data of a state for the rows.
    pub(super) fn seen<'a>(
        &'a self,
        nodes: &[NodeMotion],
        loading: &Loading,
        scalars: Scalars<'a>,
    ) -> Seen<'a> {
        let ends = self.ends(nodes);
        let now = Instant {
            time: loading.time,
            scalars,
        };
        let scale = self.scale(loading, &now);
        let turned = match &self.turn {
            None => Turned::fixed(&ends.a.axes),
            Some(turn) => {
                let mut by = by_axis(turn, &now, &scale);
                if loading.turns != 1.0 {
                    let shortest = vector::from_rotation(&vector::to_rotation(&by[0]));
                    by = [loading.turns * shortest, Vector3::zeros(), Vector3::zeros()];
                }
                Turned::by(&ends.a.axes, &by)
            }
        };
        Seen {
            ends,
            frame: &self.axes,
            turned,
            now,
            scale,
        }
    }

    fn seen_at<'a>(&'a self, at: &Local<'a>) -> Seen<'a> {
        self.seen(at.nodes, at.loading, at.scalars)
    }

    /// Force and moment on each node about the node, model axes.
    pub(super) fn reactions(&self, at: &Local<'_>) -> [[Vector3<f64>; 2]; 2] {
        let seen = self.seen_at(at);
        let mut sums = [[Vector3::zeros(); 2]; 2];
        for (row, lambda) in self.rows.iter().zip(at.multipliers) {
            let [force_a, moment_a, force_b, moment_b] = row.at(&seen).reaction();
            sums[0][0] += *lambda * force_a;
            sums[0][1] += *lambda * moment_a;
            sums[1][0] += *lambda * force_b;
            sums[1][1] += *lambda * moment_b;
        }
        sums
    }

    /// Writes observations of a state, with a further moment on a, and its opposite on b.
    pub(super) fn observe_with(&self, at: &Local<'_>, on_a: &Vector3<f64>, out: &mut Observations) {
        let mut reactions = self.reactions(at);
        reactions[0][1] += on_a;
        reactions[1][1] -= on_a;
        let first = 2 - self.nodes.len();
        for (node, [force, moment]) in self.nodes.iter().zip(&reactions[first..]) {
            out.reactions.push(Reaction {
                joint: self.label.clone(),
                node: *node,
                force: *force,
                moment: *moment,
            });
        }
        let ends = (&self.ends(at.nodes), self.angle_about);
        let state = relative::state((&self.label, &self.nodes), ends, &reactions[1]);
        out.joints.push(state);
    }
}

impl ConstraintJoint {
    /// w of the axes of a if the components of the rotation vector grow by `growth`.
    fn turn_by(&self, seen: &Seen<'_>, growth: impl Fn(&Signal) -> f64) -> Vector3<f64> {
        let turn = |turn: &[Signal; 3]| {
            let phi = by_axis(turn, &seen.now, &seen.scale)[0];
            let growth = Vector3::from(turn.each_ref().map(growth));
            Turned::by(&seen.ends.a.axes, &[phi, growth, Vector3::zeros()]).omega
        };
        self.turn.as_ref().map_or_else(Vector3::zeros, turn)
    }

    /// Derivatives of the constraints and of the reactions by the scalars that are read.
    fn jacobian_by_scalars(&self, seen: &Seen<'_>, at: &Local<'_>, out: &mut LocalJacobian) {
        let factor = self.factor.map_or(1.0, |factor| factor.value(at.loading));
        let reads = |signal: Option<&Signal>, k: usize| signal.is_some_and(|one| one.reads(k));
        for k in 0..self.scalars.len() {
            let scale = self.scale.as_ref();
            let by_scale = scale.map_or(0.0, |scale| factor * scale.slope(&seen.now, k));
            let growth = |signal: &Signal| {
                seen.scale.value * signal.slope(&seen.now, k) + by_scale * signal.value(&seen.now)
            };
            let turn = self.turn_by(seen, growth);
            let turns = self.turn.iter().flatten().any(|signal| signal.reads(k));
            for (i, row) in self.rows.iter().enumerate() {
                let is_moved = reads(row.target.as_ref(), k) || reads(scale, k);
                if !(is_moved || turns && row.is_turned()) {
                    continue;
                }
                let rate = row.target.as_ref().map_or(0.0, growth);
                let change = row.at(seen).by_target(
                    at.multipliers[i],
                    (rate, &turn),
                    |node, equation, force| {
                        if row.is_turned() {
                            out.add_by_scalar((node, equation), (k, false), force);
                        }
                    },
                );
                out.add_constraint_by_scalar(i, k, change);
            }
        }
    }
}

/// A rotation vector and its derivatives.
fn by_axis(turn: &[Signal; 3], at: &Instant<'_>, scale: &DriveValue) -> [Vector3<f64>; 3] {
    let mut found = [Vector3::zeros(); 3];
    for (axis, signal) in turn.iter().enumerate() {
        let now = signal.at(at).times(*scale);
        found[0][axis] = now.value;
        found[1][axis] = now.rate;
        found[2][axis] = now.acceleration;
    }
    found
}

impl Element for ConstraintJoint {
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
        self.given().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let seen = self.seen_at(at);
        let mut jacobian = jacobian;
        for (i, row) in self.rows.iter().enumerate() {
            let placed = row.at(&seen);
            placed.evaluate(i, at.multipliers[i], out, jacobian.as_deref_mut());
        }
        if let Some(out) = jacobian {
            self.jacobian_by_scalars(&seen, at, out);
        }
    }

    has!(constraints: Constraints, fixed_axes: FixedAxes, growth: Growth, structure: Structure, reports: Reports);
}

impl Constraints for ConstraintJoint {
    fn count(&self) -> usize {
        self.rows.len()
    }

    fn level_of(&self, constraint: usize) -> Level {
        self.rows
            .get(constraint)
            .map_or(Level::Position, Row::level)
    }

    fn words_of(&self, constraint: usize) -> ConstraintWords {
        match self.rows.get(constraint) {
            Some(row) => row.held.words(),
            None => ConstraintWords::numbered(constraint),
        }
    }

    fn add_rates(&self, at: &Local<'_>, out: &mut ConstraintRates<'_>) -> bool {
        let seen = self.seen_at(at);
        for (i, row) in self.rows.iter().enumerate() {
            (out.by_time[i], out.convective[i]) = row.at(&seen).rates();
        }
        true
    }

    fn position_jump(&self, between: [&Loading; 2], scalars: Scalars<'_>) -> Option<PositionJump> {
        self.position_jump(between, scalars)
    }

    fn held_in_place(&self, undeformed: &[NodeMotion]) -> Option<Box<dyn Element>> {
        let held = self.without_velocities(undeformed)?;
        Some(Box::new(held))
    }

    fn turned_over(&self, at: &Local<'_>) -> bool {
        if self.turn.is_none() {
            return false;
        }
        let seen = self.seen_at(at);
        let against = seen.turned.axes.transpose() * seen.ends.b.axes;
        let angles = self.rows.iter();
        let angles = angles.filter(|row| matches!(row.held, Held::Across(..)));
        match (angles.count(), self.angle_about) {
            (3, _) => against.diagonal().min() < 0.0,
            (2, Some(axis)) => against[(axis, axis)] < 0.0,
            // Another joint constrains the axis.
            (1, Some(axis)) => {
                let across = (axis + 1) % 3;
                against[(axis, axis)] > 0.5 && against[(across, across)] < 0.0
            }
            _ => false,
        }
    }

    fn axes_of_ends(&self, at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        let ends = self.ends(at.nodes);
        Some([ends.a.axes, ends.b.axes])
    }
}

impl FixedAxes for ConstraintJoint {
    fn vectors(&self) -> Vec<FixedVector> {
        let in_frame = |rows: &[Row]| {
            let mut axes = 0..3;
            rows.iter().all(|row| match row.held {
                Held::Along(Carrier::Frame, axis)
                | Held::Velocity(Carrier::Frame, axis)
                | Held::AngularVelocity(Carrier::Frame, axis) => axes.next() == Some(axis),
                _ => false,
            })
        };
        let windows = self.rows.windows(3).enumerate();
        let found = windows.filter(|(_, rows)| in_frame(rows));
        let vector = |(first, _)| FixedVector::Constraints {
            first,
            axes: self.axes,
        };
        found.map(vector).collect()
    }
}

impl Growth for ConstraintJoint {
    fn add_by_factor(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let Some(factor) = self.factor else {
            return;
        };
        let seen = self.seen_at(at);
        // The targets for a factor of one, times its slope: their growth.
        let whole = self.scale.as_ref().map_or(1.0, |s| s.value(&seen.now));
        let slope = factor.derivative() * whole;
        let growth = |signal: &Signal| slope * signal.value(&seen.now);
        let turn = self.turn_by(&seen, growth);
        for (i, row) in self.rows.iter().enumerate() {
            let rate = row.target.as_ref().map_or(0.0, growth);
            let change = (row.at(&seen)).by_target(
                at.multipliers[i],
                (rate, &turn),
                |node, equation, force| out.add(node, equation, force),
            );
            out.add_constraint(i, change);
        }
    }

    fn add_prestress(&self, at: &Local<'_>, motion: &SmallMotion<'_>, out: &mut LocalJacobian) {
        prestress_of_multipliers(self, at, motion, out);
    }
}

impl Structure for ConstraintJoint {
    fn arm(&self) -> f64 {
        self.reach
    }

    fn is_joining(&self) -> bool {
        false
    }

    fn free_motions(&self) -> Vec<Motion> {
        self.motions.clone()
    }

    fn loaded_turn(&self, _at: &Local<'_>) -> Option<Vector3<f64>> {
        None
    }

    fn undefined(&self, at: &Local<'_>) -> Option<String> {
        let seen = self.seen_at(at);
        let distances = self.rows.iter().filter(|row| row.held == Held::Distance);
        let mut lengths = distances.filter_map(|row| row.target.as_ref());
        let length = lengths.find_map(|target| {
            let length = seen.scale.value * target.value(&seen.now);
            (length <= 0.0).then_some(length)
        })?;
        let time = rounded(at.loading.time);
        Some(format!(
            "its length is zero or less: {length:.3e} m at {time} s"
        ))
    }
}

impl Reports for ConstraintJoint {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        self.observe_with(at, &Vector3::zeros(), out);
    }

    fn reading(
        &self,
        reading: &Reading,
        at: &Local<'_>,
        row: Option<&mut ReadingRow<'_>>,
    ) -> Option<f64> {
        let Reading::Joint { motion, part } = *reading else {
            return None;
        };
        let ends = (&self.ends(at.nodes), self.angle_about);
        relative::read(ends, (motion, part), row)
    }

    fn report_charges(&self, _at: &Local<'_>, _out: &mut Charges) {}
}

/// Rows that constrain all three distances of the points along the axes of `carrier`.
pub(super) fn same_point(carrier: Carrier) -> [Row; 3] {
    [0, 1, 2].map(|axis| Row::zero(Held::Along(carrier, axis)))
}
