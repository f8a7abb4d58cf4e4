//! Constraints without known rates: dummy steps, differences, and corners without new rates.

use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};
use shared_geom::expression::{Expression, Names};

use super::models::{body, moving, node, pendulum, run, states};
use crate::analysis::transient::TransientFailure;
use crate::assembly::System;
use crate::case::{Model, Start, StartAccelerations, TransientSettings};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, Turning, axes_along};
use crate::elements::{
    Charges, ConstraintRates, ConstraintWords, Constraints, Element, Level, Local, LocalJacobian,
    LocalResidual, Observations, PositionJump, Queries, Reading, ReadingRow, Reports, Signal, has,
};
use crate::model::{
    Drive, DriveTable, Extrapolation, Formula, Harmonic, Interpolation, Loading, Node, NodeMotion,
    Scalars, State, Step,
};

/// A joint without derivatives of its constraints.
#[derive(Debug)]
struct Unknowing(ConstraintJoint);

impl Element for Unknowing {
    fn label(&self) -> &str {
        self.0.label()
    }

    fn nodes(&self) -> &[usize] {
        self.0.nodes()
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.0.each_signal(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        self.0.evaluate(at, out, jacobian);
    }

    has!(constraints: Constraints, reports: Reports);
}

impl Constraints for Unknowing {
    fn count(&self) -> usize {
        self.0.multipliers()
    }

    fn level_of(&self, constraint: usize) -> Level {
        self.0.level(constraint)
    }

    fn words_of(&self, constraint: usize) -> ConstraintWords {
        ConstraintWords::numbered(constraint)
    }

    fn add_rates(&self, _at: &Local<'_>, _out: &mut ConstraintRates<'_>) -> bool {
        false
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

    fn axes_of_ends(&self, _at: &Local<'_>) -> Option<[Matrix3<f64>; 2]> {
        None
    }
}

impl Reports for Unknowing {
    fn report(&self, at: &Local<'_>, out: &mut Observations) {
        self.0.observe(at, out);
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

/// A mass of one at (1, 0) on a joint about z at the origin.
fn on_pivot(turning: Option<Turning>, is_known: bool) -> Model {
    let nodes: Vec<Node> = vec![node("bob", Vector3::x(), Matrix3::identity())];
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let placing = Placing::at(&Vector3::zeros(), &axes_along(&Vector3::z()));
    let pivot = ConstraintJoint::revolute("pivot", &ends, &placing, turning);
    let pivot: Box<dyn Element> = if is_known {
        Box::new(pivot)
    } else {
        Box::new(Unknowing(pivot))
    };
    let elements = vec![body(0, 1.0, Vector3::zeros(), [0.0; 3]), pivot];
    let mut model = Model::new("pendulum", System::new(nodes, elements));
    model.gravity = -Vector3::y();
    model
}

/// Force of the joint along the arm.
fn tension(state: &State) -> f64 {
    let lambda = Vector3::from_column_slice(&state.multipliers[..3]);
    let force = axes_along(&Vector3::z()) * lambda;
    force.dot(&state.nodes[0].position).abs()
}

// Reactions as after requested dummy steps: 1 at the start within the error of these, and 1 + 3 sin
// p after the first step.
#[test]
fn a_start_without_derivatives_makes_dummy_steps() {
    let mut model = on_pivot(None, false);
    model.initial[0] = moving(-Vector3::y(), -Vector3::z());
    let (kept, outcome) = run(&model, &TransientSettings::new(0.05, 0.01));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let [remark] = &outcome.remarks[..] else {
        panic!("{:?}", outcome.remarks)
    };
    assert!(remark.contains("second derivative"), "{remark}");
    assert!(remark.contains("dummy steps"), "{remark}");
    let [start, step] = [0, 1].map(|i| tension(&kept.states[i]));
    assert!((start - 1.0).abs() < 1e-3, "{start}");
    assert!((step - 1.02).abs() < 2e-4, "{step}");
}

// 0.3 sin(2 pi t) starts with the rate 0.6 pi. The error of differences over 1e-5 s is (2 pi
// 1e-5)^2/6 of it, and round-off of 1e-16/1e-5.
#[test]
fn velocities_follow_from_differences_of_constraints() {
    let swing = Drive::Harmonic(Harmonic {
        mean: 0.0,
        amplitude: 0.3,
        frequency: 1.0,
        phase: 0.0,
        start: -1.0,
        cycles: f64::INFINITY,
    });
    let found = [true, false].map(|is_known| {
        let model = on_pivot(Some(Turning::Angle(swing.clone().into())), is_known);
        let found = states(&model, &TransientSettings::new(0.01, 0.01));
        found[0].nodes[0].angular_velocity.z
    });
    let expected = 0.6 * std::f64::consts::PI;
    assert!((found[0] - expected).abs() < 1e-12, "{found:?}");
    assert!((found[1] - expected).abs() < 1e-8, "{found:?}");
    assert!(found[0] != found[1]);
}

// Weight that begins to act at a jump: both runs find the same motion. After the jump one has the
// rates, the other makes one step by implicit Euler, with the error h^2/2 of the acceleration.
#[test]
fn a_corner_is_passed_without_derivatives() {
    let step = 0.01;
    let [known, unknown] = [true, false].map(|is_known| {
        let mut model = on_pivot(None, is_known);
        model.gravity_drive = Drive::Step(Step {
            from: 0.0,
            to: 1.0,
            time: 0.105,
        });
        let found = states(&model, &TransientSettings::new(0.3, step));
        found.last().unwrap().nodes[0].position
    });
    // It falls for 0.195 s under a gravity of one.
    let fall = 0.5 * 0.195_f64.powi(2);
    assert!((known.y + fall).abs() < 2e-5, "{known}");
    assert!((unknown - known).amax() < 0.2 * step, "{unknown} {known}");
    assert!((unknown.y + fall).abs() < 0.2 * step);
    assert!(known != unknown);
}

/// A value that exists in the first instants only.
fn brief() -> Drive {
    let rows = [[0.0, 1.0], [1e-9, 1.0]];
    let table = DriveTable::new(&rows, Interpolation::Linear, Extrapolation::Error);
    Drive::Table(Arc::new(table.unwrap()))
}

#[test]
fn dummy_steps_that_cannot_be_made_are_reported() {
    let mut model = pendulum();
    model.gravity_drive = brief();
    let settings = TransientSettings {
        start_accelerations: StartAccelerations::Dummy,
        ..TransientSettings::new(0.05, 0.01)
    };
    let failure = run(&model, &settings).1.failure.unwrap();
    assert!(matches!(failure, TransientFailure::Dummy(_)), "{failure}");
    let text = failure.to_string();
    assert!(
        text.starts_with("start: dummy steps: no step from"),
        "{text}"
    );
    assert!(failure.remedy().contains("drives"), "{}", failure.remedy());
}

// The square root of time rises infinitely fast at the start.
#[test]
fn velocities_that_do_not_exist_are_reported() {
    let names = Names {
        variables: &["t"],
        constants: &[],
    };
    let root = Formula::new(Expression::parse("sqrt(t)", &names).unwrap(), 1.0);
    let angle = Turning::Angle(Drive::Formula(Arc::new(root)).into());
    let model = on_pivot(Some(angle), true);
    let failure = run(&model, &TransientSettings::new(0.1, 0.01))
        .1
        .failure
        .unwrap();
    assert!(
        matches!(failure, TransientFailure::Velocities { .. }),
        "{failure}"
    );
    let text = failure.to_string();
    assert!(text.contains("\"pivot\""), "{text}");
}

// A free body carries no load.
#[test]
fn a_start_without_equilibrium_is_reported() {
    let nodes = vec![node("free", Vector3::x(), Matrix3::identity())];
    let elements = vec![body(0, 1.0, Vector3::zeros(), [1.0; 3])];
    let mut model = Model::new("free", System::new(nodes, elements));
    model.gravity = -Vector3::z();
    let settings = TransientSettings {
        start: Start::Equilibrium,
        ..TransientSettings::new(0.1, 0.01)
    };
    let failure = run(&model, &settings).1.failure.unwrap();
    assert!(
        matches!(failure, TransientFailure::Equilibrium(_)),
        "{failure}"
    );
    let text = failure.to_string();
    assert!(
        text.starts_with("start: no steady equilibrium at 0 rpm"),
        "{text}"
    );
    assert!(text.contains("\"free\""), "{text}");
}
