//! Steps of a run in time allocate nothing: allocations of this thread are counted.

// A test that cannot go on panics.
#![allow(clippy::unwrap_used)]

use std::sync::Arc;

use allocation_counter::measure;
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::assembly::{Combination, Residual, Sparse, System, Variation};
use beam_dynamics::case::{Model, TransientQuestion};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{BeamGeometry, BeamInertia, BeamNode, ElasticBeam};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{Clamp, Hinge, HingeSpring};
use beam_dynamics::integrator::Scheme;
use beam_dynamics::model::Node;
use beam_dynamics::result::{Moment, Recorder};
use beam_dynamics::solver::StepSolver;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Two beams with consistent inertia, and a body that swings on a hinge at their end.
fn model() -> Model {
    let node = |i: usize| Node {
        label: format!("n{i}"),
        position: Vector3::new(0.25 * i as f64, 0.0, 0.0),
        rotation: Matrix3::identity(),
    };
    let nodes: Vec<_> = (0..6).map(node).collect();
    let geometry = BeamGeometry {
        nodes: [BeamNode::aligned(); 3],
    };
    let stiffness = Matrix6::from_diagonal(&Vector6::new(1e5, 4e4, 4e4, 1.2, 1.0, 3.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(0.6, 0.6, 0.6, 2e-3, 1e-3, 1e-3));
    let mut elements: Vec<Box<dyn Element>> = vec![Box::new(Clamp::new("root", 0, &nodes[0]))];
    for first in [0, 2] {
        let on = [first, first + 1, first + 2];
        let at = on.map(|i| &nodes[i]);
        let beam = ElasticBeam::new("beam", on, geometry, at, [stiffness; 2]);
        elements.push(Box::new(beam));
        let inertia = BeamInertia::new("beam", on, geometry, at, |_| mass);
        elements.push(Box::new(inertia));
    }
    let inertia = RigidInertia::about_node(0.1, &Vector3::zeros(), &(1e-3 * Matrix3::identity()));
    elements.push(Box::new(RigidBody::new("body", 5, inertia)));
    elements.push(Box::new(Hinge::new(
        "hinge",
        [4, 5],
        [&nodes[4], &nodes[5]],
        &nodes[4].position,
        &Vector3::y(),
        HingeSpring::default(),
    )));
    let mut model = Model::new("swing", System::new(nodes, elements));
    model.gravity = Vector3::new(0.0, 0.0, -9.81);
    model
}

#[test]
fn an_iteration_allocates_nothing() {
    let model = model();
    let system = &model.system;
    let (state, conditions) = (system.rest(), model.conditions_at(0.0));
    let variations = vec![
        Variation {
            turn: Matrix3::identity(),
            spin: Matrix3::zeros(),
        };
        system.nodes().len()
    ];
    let mut matrix = Sparse::zero(Arc::clone(system.pattern()));
    let mut solver = StepSolver::new(system.pattern()).unwrap();
    let mut work = system.workspace();
    let mut residual = Residual::default();
    let mut iterate = || {
        system.residual_into(&state, &conditions, &mut residual, &mut work);
        let sum = Combination {
            by_unknowns: 1e-3,
            by_rates: 1.0,
            by_algebraic: 1.0,
            matrix: &mut matrix,
        };
        system.combine(&state, &conditions, &variations, &mut [sum], &mut work);
        solver.factorize(&matrix).unwrap();
        solver.solve(&mut residual.values).unwrap();
    };
    let first = measure(&mut iterate).count_total;
    assert!(first > 0, "the count counts");
    assert_eq!(measure(&mut iterate).count_total, 0);
}

/// Keeps nothing.
struct Silent;

impl Recorder for Silent {
    fn record(&mut self, _: &Moment<'_>) -> bool {
        true
    }
}

/// A run of three times as many steps allocates no more than the shorter one.
#[test]
fn a_step_allocates_nothing() {
    let model = model();
    for scheme in [Scheme::default(), Scheme::Cubic { radius: 0.6 }] {
        let allocations = |steps: u32| {
            let question = TransientQuestion {
                scheme,
                ..TransientQuestion::new(1e-3 * f64::from(steps), 1e-3)
            };
            let count = measure(|| {
                let outcome = transient(&model, &question, None, &mut Silent, &|| 0.0);
                assert!(outcome.failure.is_none());
                assert_eq!(outcome.effort.pivotings, 1);
                assert_eq!(outcome.effort.steps, steps as usize);
            });
            count.count_total
        };
        let (few, many) = (allocations(20), allocations(60));
        assert!(few > 0);
        assert_eq!(many, few, "{scheme:?}");
    }
}
