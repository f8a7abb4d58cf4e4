//! Rigid bodies: start-up, closed forms, order, restart.

use std::cell::Cell;

use nalgebra::{Matrix3, Vector3};

use super::models::{Kept, body, moving, node, pendulum, run, states, top};
use beam_dynamics::analysis::transient::{TransientFailure, transient};
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, StartAccelerations, TransientSettings};
use beam_dynamics::elements::joints::axes_along;
use beam_dynamics::integrator::Scheme;
use beam_dynamics::model::State;
use beam_dynamics::result::Effort;

/// A free body, its center off the node.
pub(super) fn free_body() -> Model {
    let nodes = vec![node("body", Vector3::zeros(), Matrix3::identity())];
    let elements = vec![body(0, 2.0, Vector3::new(0.3, -0.2, 0.5), [1.0, 1.4, 0.7])];
    let mut model = Model::new("free body", System::new(nodes, elements));
    let (velocity, spin) = (Vector3::new(0.7, 1.2, -0.4), Vector3::new(1.0, 2.0, 0.2));
    model.initial[0] = moving(velocity, spin);
    model
}

/// Tension of the rod of the pendulum: the pivot pulls the bob by the multipliers, which
/// are along the axes of the joint.
fn tension(state: &State) -> f64 {
    let lambda = Vector3::from_column_slice(&state.multipliers[..3]);
    let force = axes_along(&Vector3::z()) * lambda;
    force.dot(&state.nodes[0].position).abs()
}

// The tension of a point that falls by the angle p from the horizontal is 1 + 3 sin p.
// Prototype, dynamics theory 4.5, h = 0.01: first tension 1.0200 from the consistent start,
// 1.0199 after dummy steps, and an oscillation that begins with 2.02 without them.
#[test]
fn a_pendulum_starts_without_oscillation() {
    let settings = TransientSettings::new(0.05, 0.01);
    let first = |how: StartAccelerations| {
        let settings = TransientSettings {
            start_accelerations: how,
            ..settings
        };
        let found = states(&pendulum(), &settings);
        [tension(&found[0]), tension(&found[1])]
    };
    let [start, step] = first(StartAccelerations::Consistent);
    assert!((start - 1.0).abs() < 1e-12, "{start}");
    assert!((step - 1.02).abs() < 1e-4, "{step}");
    let [start, step] = first(StartAccelerations::Dummy);
    assert!((start - 1.0).abs() < 1e-3, "{start}");
    assert!((step - 1.02).abs() < 2e-4, "{step}");
    // Without the centripetal term gravity, across the rod, makes the tension zero.
    let [start, step] = first(StartAccelerations::AtRest);
    assert!(start < 1e-12, "{start}");
    assert!((step - 2.02).abs() < 1e-3, "{step}");
    let [start, step] = first(StartAccelerations::Zero);
    assert!(start == 0.0 && (step - 1.02).abs() > 0.5, "{start} {step}");
}

// models.md B against the rotation-matrix ODE (1e-11) of spinning_top.json; x, y, z of the
// center at t = 0.5, 1, 2, 5, 10.
const TOPS: [([f64; 3], [[f64; 3]; 5]); 3] = [
    (
        [0.0, 0.9888, 7.5167],
        [
            [0.049671657, 0.034675511, 0.190605182],
            [-0.034167977, 0.062739345, 0.186805578],
            [0.043033642, -0.001740195, 0.195307648],
            [-0.022787039, -0.042765485, 0.194040883],
            [-0.031452718, -0.058996677, 0.188494346],
        ],
    ),
    (
        [0.0, 0.20905, 6.2964],
        [
            [0.015085005, -0.023589793, 0.198030211],
            [0.008243898, -0.009886288, 0.199585319],
            [0.006265496, -0.030826801, 0.197510637],
            [0.032036395, 0.000229671, 0.197417367],
            [0.001028974, 0.024556076, 0.198484106],
        ],
    ),
    (
        [0.0, 0.0, 6.3794],
        [
            [0.001586786, -0.037363737, 0.196472475],
            [0.009037829, -0.039839709, 0.195783337],
            [0.019511194, -0.030045381, 0.196765313],
            [0.033997939, -0.013395619, 0.196633409],
            [0.024427984, 0.031426174, 0.195999156],
        ],
    ),
];

fn top_error(number: usize, h: f64) -> f64 {
    let (spin, expected) = TOPS[number];
    let found = states(&top(spin.into()), &TransientSettings::new(10.0, h));
    let times = [0.5, 1.0, 2.0, 5.0, 10.0].iter().zip(expected);
    let errors = times.map(|(t, expected)| {
        let state = &found[(t / h).round() as usize];
        (state.nodes[0].position - Vector3::from(expected)).norm()
    });
    errors.fold(0.0, f64::max)
}

// 1e-5 at 1 ms (models.md); prototype, case 3: 1.93e-5 at 10 ms. The other two nutate, by 0.04 rad
// per step of 10 ms: 0.13 * 0.04^2 of a path of 38 rad and 0.03 m is 3e-4 m.
#[test]
fn a_spinning_top_stays_on_its_path() {
    for (number, coarse) in [(0, 1e-3), (1, 1e-3), (2, 1e-4)] {
        let errors = [0.01, 0.005, 0.001].map(|h| top_error(number, h));
        assert!(errors[0] < coarse, "{errors:?}");
        assert!(errors[2] < 1e-5, "{errors:?}");
        let order = (errors[0] / errors[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }
}

// Momenta of a free body are constant in space: beta, and gamma + x x beta about the origin, gamma
// being the angular momentum about the node. The scheme is linear in them: the error is round-off
// of terms of order ten over 1000 steps.
#[test]
fn a_free_body_keeps_its_momenta() {
    let found = states(&free_body(), &TransientSettings::new(10.0, 0.01));
    let momenta = |state: &State| {
        let node = &state.nodes[0];
        let about_origin = node.angular_momentum + node.position.cross(&node.momentum);
        (node.momentum, about_origin)
    };
    let (linear, angular) = momenta(&found[0]);
    assert!(angular.norm() > 1.0);
    let (mut off_linear, mut off_angular) = (0.0_f64, 0.0_f64);
    for state in &found {
        let (now, now_angular) = momenta(state);
        off_linear = off_linear.max((now - linear).norm());
        off_angular = off_angular.max((now_angular - angular).norm());
    }
    assert!(off_linear < 1e-10, "{off_linear:e}");
    assert!(off_angular < 1e-10, "{off_angular:e}");
}

// A run that is continued from a snapshot has identical states, with any scheme.
#[test]
fn a_continued_run_is_the_same_to_the_last_bit() {
    let model = top(Vector3::new(0.0, 0.9888, 7.5167));
    for scheme in [Scheme::default(), Scheme::Cubic { radius: 0.3 }] {
        let settings = TransientSettings {
            scheme,
            ..TransientSettings::new(0.5, 0.01)
        };
        let mut whole = Kept {
            wanted: Some(17),
            ..Kept::default()
        };
        assert!(
            transient(&model, &settings, None, &mut whole, &|| 0.0)
                .failure
                .is_none()
        );
        let snapshot = whole.snapshot.take().unwrap();
        let mut rest = Kept::default();
        let outcome = transient(&model, &settings, Some(&snapshot), &mut rest, &|| 0.0);
        assert!(outcome.failure.is_none());
        assert_eq!(whole.states[18..], rest.states);
        assert_eq!(whole.times[18..], rest.times);
        // A snapshot of another model is refused.
        let refused = transient(&pendulum(), &settings, Some(&snapshot), &mut rest, &|| 0.0);
        assert!(matches!(
            refused.failure,
            Some(TransientFailure::Resume { .. })
        ));
    }
}

// The effort of a continued run is the effort of both parts: no phase lasts longer than the sum.
// The clock ticks once each time it is read.
#[test]
fn the_effort_of_a_continued_run_is_that_of_all_of_it() {
    let model = top(Vector3::new(0.0, 0.9888, 7.5167));
    let settings = TransientSettings::new(0.5, 0.01);
    let ticks = Cell::new(0.0);
    let clock = || {
        ticks.set(ticks.get() + 1.0);
        ticks.get()
    };
    let mut whole = Kept {
        wanted: Some(40),
        ..Kept::default()
    };
    let all = transient(&model, &settings, None, &mut whole, &clock).effort;
    let snapshot = whole.snapshot.take().unwrap();
    ticks.set(0.0);
    let mut rest = Kept::default();
    let continued = transient(&model, &settings, Some(&snapshot), &mut rest, &clock).effort;
    let phases = |effort: &Effort| {
        effort.residual_time
            + effort.prediction_time
            + effort.jacobian_time
            + effort.factorization_time
            + effort.solution_time
            + effort.output_time
    };
    for effort in [all, continued] {
        let (sum, total) = (phases(&effort), effort.total_time);
        assert!(sum < total, "{sum} {total}");
    }
    assert!(continued.output_time >= 50.0, "{continued:?}");
}

// Both Jacobians belong to the same equations.
#[test]
fn the_simplified_jacobian_finds_the_same_motion() {
    let model = top(Vector3::new(0.0, 0.9888, 7.5167));
    let mut settings = TransientSettings::new(1.0, 0.02);
    settings.newton.correction = 1e-12;
    let exact = run(&model, &settings);
    settings.simplified_jacobian = true;
    let simplified = run(&model, &settings);
    let ends = [&exact, &simplified].map(|run| run.0.states.last().unwrap().nodes[0]);
    let off = (ends[0].rotation - ends[1].rotation).amax();
    let iterations = [&exact, &simplified].map(|run| run.1.effort.iterations);
    assert!(off < 1e-9, "{off:e}");
    assert!(iterations[0] <= iterations[1], "{iterations:?}");
}
