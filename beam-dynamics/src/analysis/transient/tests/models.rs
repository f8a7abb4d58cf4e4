//! Models of the tests, and a recorder of their motion.

use nalgebra::{Matrix3, Vector3};

use crate::analysis::transient::{TransientOutcome, transient};
use crate::assembly::System;
use crate::case::{InitialMotion, Model, TransientSettings};
use crate::elements::Element;
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};
use crate::model::{Node, State};
use crate::result::{AcceptedStep, Recorder, Snapshot};

/// Keeps every state.
#[derive(Debug, Default)]
pub struct Kept {
    pub times: Vec<f64>,
    /// Times at which the conditions are recorded.
    pub seen: Vec<f64>,
    pub states: Vec<State>,
    /// Step at which a snapshot is requested, and the snapshot.
    pub wanted: Option<usize>,
    pub snapshot: Option<Snapshot>,
    /// Number of steps after which the run is ended.
    pub most: Option<usize>,
}

impl Recorder for Kept {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.times.push(accepted.time);
        self.seen.push(accepted.conditions.loading.time);
        self.states.push(accepted.state.clone());
        self.most != Some(accepted.step)
    }

    fn wants_snapshot(&self, accepted: &AcceptedStep<'_>) -> bool {
        self.wanted == Some(accepted.step)
    }

    fn keep(&mut self, snapshot: &Snapshot) -> bool {
        self.snapshot = Some(snapshot.clone());
        true
    }
}

/// Runs a model; all its states, and the outcome.
pub fn run(model: &Model, settings: &TransientSettings) -> (Kept, TransientOutcome) {
    let mut kept = Kept::default();
    let outcome = transient(model, settings, None, &mut kept, &|| 0.0);
    (kept, outcome)
}

/// As [`run`], of a run that reaches its end.
pub fn states(model: &Model, settings: &TransientSettings) -> Vec<State> {
    let (kept, outcome) = run(model, settings);
    if let Some(failure) = outcome.failure {
        panic!("{failure}");
    }
    kept.states
}

pub fn node(label: &str, position: Vector3<f64>, rotation: Matrix3<f64>) -> Node {
    Node {
        label: label.to_owned(),
        position,
        rotation,
    }
}

pub fn body(node: usize, mass: f64, offset: Vector3<f64>, moments: [f64; 3]) -> Box<dyn Element> {
    let central = Matrix3::from_diagonal(&moments.into());
    let inertia = RigidInertia::about_node(mass, &offset, &central);
    Box::new(RigidBody::new("body", node, inertia))
}

/// A spherical joint at `point` of node `node` with another one, or the frame.
pub fn spherical(
    nodes: &[Node],
    a: Option<usize>,
    b: usize,
    point: Vector3<f64>,
) -> Box<dyn Element> {
    let ends = JointEnds {
        a: a.map(|a| (a, &nodes[a])),
        b: (b, &nodes[b]),
    };
    let placing = Placing::at(&point, &Matrix3::identity());
    Box::new(ConstraintJoint::spherical(
        format!("joint {b}"),
        &ends,
        &placing,
    ))
}

/// A joint about z at the origin of the frame with node `node`.
pub fn revolute_about_z(nodes: &[Node], node: usize) -> Box<dyn Element> {
    let ends = JointEnds {
        a: None,
        b: (node, &nodes[node]),
    };
    let placing = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::z()));
    Box::new(ConstraintJoint::revolute("pivot", &ends, &placing, None))
}

pub fn moving(velocity: Vector3<f64>, angular_velocity: Vector3<f64>) -> InitialMotion {
    InitialMotion {
        velocity: Some(velocity),
        angular_velocity: Some(angular_velocity),
        ..InitialMotion::default()
    }
}

/// A mass of one at (1, 0) that swings about the origin, gravity one along -y and the
/// velocity one along -y.
pub fn pendulum() -> Model {
    let nodes = vec![node("bob", Vector3::x(), Matrix3::identity())];
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [0.0; 3]),
        revolute_about_z(&nodes, 0),
    ];
    let mut model = Model::new("pendulum", System::new(nodes, elements));
    model.gravity = -Vector3::y();
    model.initial[0] = moving(-Vector3::y(), -Vector3::z());
    model
}

/// Two links of length one on spherical joints, along -y, turning about z as one line;
/// nodes at the middle of each.
pub fn bipendulum() -> Model {
    let middle = |i: usize| Vector3::new(0.0, -0.5 - i as f64, 0.0);
    let nodes: Vec<_> = (0..2)
        .map(|i| node(&format!("link {i}"), middle(i), Matrix3::identity()))
        .collect();
    let link = |i: usize| body(i, 0.4565, Vector3::zeros(), [0.0308, 1e-4, 0.0308]);
    let elements = vec![
        link(0),
        link(1),
        spherical(&nodes, None, 0, Vector3::zeros()),
        spherical(&nodes, Some(0), 1, -Vector3::y()),
    ];
    let mut model = Model::new("bipendulum", System::new(nodes, elements));
    model.gravity = Vector3::new(0.0, 0.0, -32.175);
    let spin: Vector3<f64> = 4.0 * Vector3::z();
    for i in 0..2 {
        model.initial[i] = moving(spin.cross(&middle(i)), spin);
    }
    model
}

/// A body of mass one that spins about a fixed point (models.md, B): its center is 0.2 above the
/// point, tilted by 10 degrees about x; `spin` in its own axes.
pub fn top(spin: Vector3<f64>) -> Model {
    let tilt = shared_geom::rotation::vector::to_rotation(&(10_f64.to_radians() * Vector3::x()));
    let center = tilt * (0.2 * Vector3::z());
    let nodes = vec![node("center", center, tilt)];
    let elements = vec![
        body(0, 1.0, Vector3::zeros(), [0.75, 0.75, 0.40]),
        spherical(&nodes, None, 0, Vector3::zeros()),
    ];
    let mut model = Model::new("top", System::new(nodes, elements));
    model.gravity = -3.0 * Vector3::z();
    let spin = tilt * spin;
    model.initial[0] = moving(spin.cross(&center), spin);
    model
}

/// Numbers from -1 to 1 by a linear congruence.
pub struct Random(pub u64);

impl Random {
    pub fn number(&mut self) -> f64 {
        self.0 = (self.0).wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.number())
    }
}
