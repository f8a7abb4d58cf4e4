//! Models of the tests, and what records their motion.

use nalgebra::{Matrix3, Vector3};

use crate::analysis::transient::{TransientOutcome, transient};
use crate::assembly::System;
use crate::case::{InitialMotion, Model, TransientQuestion};
use crate::elements::Element;
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing};
use crate::model::{Node, State};
use crate::result::{Moment, Recorder, Snapshot};

/// Keeps every state.
#[derive(Debug, Default)]
pub struct Kept {
    pub times: Vec<f64>,
    pub states: Vec<State>,
    /// Step at which a snapshot is wanted, and the snapshot.
    pub wanted: Option<usize>,
    pub snapshot: Option<Snapshot>,
    /// Steps after which the run is ended.
    pub most: Option<usize>,
}

impl Recorder for Kept {
    fn record(&mut self, moment: &Moment<'_>) -> bool {
        self.times.push(moment.time);
        self.states.push(moment.state.clone());
        self.most != Some(moment.step)
    }

    fn wants_snapshot(&self, moment: &Moment<'_>) -> bool {
        self.wanted == Some(moment.step)
    }

    fn keep(&mut self, snapshot: &Snapshot) -> bool {
        self.snapshot = Some(snapshot.clone());
        true
    }
}

/// Runs a model; all its states, and the outcome.
pub fn run(model: &Model, question: &TransientQuestion) -> (Kept, TransientOutcome) {
    let mut kept = Kept::default();
    let outcome = transient(model, question, None, &mut kept, &|| 0.0);
    (kept, outcome)
}

/// As [`run`], of a run that reaches its end.
pub fn states(model: &Model, question: &TransientQuestion) -> Vec<State> {
    let (kept, outcome) = run(model, question);
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

/// A spherical joint at `point` of node number `node` with another one, or the frame.
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

/// A joint about z at the origin of the frame with node number `node`.
pub fn revolute_about_z(nodes: &[Node], node: usize) -> Box<dyn Element> {
    let ends = JointEnds {
        a: None,
        b: (node, &nodes[node]),
    };
    let axes = crate::elements::joints::axes_along(&Vector3::z());
    let placing = Placing::at(&Vector3::zeros(), &axes);
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
