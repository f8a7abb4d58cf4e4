//! Steps of a run in time allocate nothing: allocations of this thread are counted.

// A test that cannot continue panics.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::sync::Arc;

use allocation_counter::measure;
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::assembly::{Combination, Residual, Sparse, System, Variation};
use beam_dynamics::case::{Model, OutputSettings, Redundant, TransientSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use beam_dynamics::elements::bodies::{RigidBody, RigidInertia};
use beam_dynamics::elements::joints::{Hinge, HingeSpring, clamped};
use beam_dynamics::integrator::{Jacobians, Scheme, StepControl, Stepping};
use beam_dynamics::model::Node;
use beam_dynamics::output::{ResultLocation, RunFiles};
use beam_dynamics::result::{AcceptedStep, Effort, Recorder};
use beam_dynamics::solver::StepSolver;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Two beams with consistent inertia, and a body that swings on a hinge at their end; or
/// all of it in free fall, without a clamp and a hinge.
fn model(is_held: bool) -> Model {
    let node = |i: usize| Node {
        label: format!("n{i}"),
        position: Vector3::new(0.25 * i as f64, 0.0, 0.0),
        rotation: Matrix3::identity(),
    };
    let nodes: Vec<_> = (0..6).map(node).collect();
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let stiffness = Matrix6::from_diagonal(&Vector6::new(1e5, 4e4, 4e4, 1.2, 1.0, 3.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(0.6, 0.6, 0.6, 2e-3, 1e-3, 1e-3));
    let mut elements: Vec<Box<dyn Element>> = Vec::new();
    for first in [0, 2] {
        let on = [first, first + 1, first + 2];
        let at = on.map(|i| &nodes[i]);
        let beam = Beam::elastic("beam", on, geometry, at, [stiffness; 2]);
        elements.push(Box::new(beam));
        let inertia = BeamInertia::new("beam", on, geometry, at, &MassAlong::smooth(&|_| mass));
        elements.push(Box::new(inertia));
    }
    let inertia = RigidInertia::about_node(0.1, &Vector3::zeros(), &(1e-3 * Matrix3::identity()));
    elements.push(Box::new(RigidBody::new("body", 5, inertia)));
    if is_held {
        elements.push(Box::new(clamped("root", 0, &nodes[0])));
        elements.push(Box::new(Hinge::new(
            "hinge",
            [4, 5],
            [&nodes[4], &nodes[5]],
            &nodes[4].position,
            &Vector3::y(),
            HingeSpring::default(),
        )));
    }
    let mut model = Model::new("swing", System::new(nodes, elements));
    model.gravity = Vector3::new(0.0, 0.0, -9.81);
    model
}

#[test]
fn an_iteration_allocates_nothing() {
    let model = model(true);
    let system = &model.system;
    let (state, conditions) = (system.rest(), model.conditions_at(0.0));
    let variations = vec![
        Variation {
            turn: Matrix3::identity(),
            rate_by_turn: Matrix3::zeros(),
            axes: None,
        };
        system.nodes().len()
    ];
    let mut matrix = Sparse::zero(Arc::clone(system.pattern()));
    let mut solver = StepSolver::new(system.pattern());
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
        let out = (&mut [sum][..], Some(&mut residual));
        system.combine(&state, &conditions, &variations, out, &mut work);
        solver.factorize(&matrix).unwrap();
        solver.solve(&mut residual.values).unwrap();
    };
    let first = measure(&mut iterate).count_total;
    assert!(first > 0, "the count counts");
    assert_eq!(measure(&mut iterate).count_total, 0);
}

/// Records nothing.
struct Silent;

impl Recorder for Silent {
    fn record(&mut self, _: &AcceptedStep<'_>) -> bool {
        true
    }
}

/// Schemes of one, two and three stages. Cubic interpolation at Gauss' points is not for
/// systems with constraints: the matrix of its weights is singular, so that opposite
/// multipliers at the two inner stages have no effect.
const SCHEMES: [Scheme; 8] = [
    Scheme::ImplicitEuler,
    Scheme::CrankNicolson,
    Scheme::Bdf2,
    Scheme::TwoStep { radius: 0.6 },
    Scheme::Cubic { radius: 0.6 },
    Scheme::Cubic { radius: 0.0 },
    Scheme::Parabolic { zeta: -2.0 / 3.0 },
    Scheme::Parabolic { zeta: -0.5 },
];

/// Number of allocations of a run, and its effort.
fn allocations(model: &Model, settings: &TransientSettings) -> (u64, Effort) {
    let mut effort = Effort::default();
    let count = measure(|| {
        let outcome = transient(model, settings, None, &mut Silent, &|| 0.0);
        if let Some(failure) = &outcome.failure {
            panic!("{settings:?}: {failure}");
        }
        effort = outcome.effort;
    });
    (count.count_total, effort)
}

/// A run of three times as many steps allocates no more than the shorter one.
fn check(model: &Model, settings: &TransientSettings) {
    let of = |to: f64| allocations(model, &TransientSettings { to, ..*settings });
    let (few, short) = of(0.01);
    let (many, long) = of(0.03);
    assert!(few > 0 && long.steps >= 3 * short.steps);
    // A new choice of pivots allocates: none is needed in these runs.
    assert_eq!([short.pivotings, long.pivotings], [1; 2], "{settings:?}");
    assert_eq!(many, few, "{settings:?}");
}

#[test]
fn a_step_allocates_nothing() {
    let settings = TransientSettings::new(1.0, 1e-3);
    let (held, falling) = (model(true), model(false));
    for scheme in SCHEMES {
        check(&held, &TransientSettings { scheme, ..settings });
    }
    let scheme = Scheme::CubicGauss;
    check(&falling, &TransientSettings { scheme, ..settings });
}

/// The model of a file in this folder.
fn read(name: &str) -> Model {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/allocations");
    match beam_dynamics::input::read(&folder.join(name)) {
        Ok(input) => input.model,
        Err(problems) => panic!("{problems}"),
    }
}

/// Every kind of element, law and signal, with drives that have corners.
#[test]
fn a_step_of_any_element_allocates_nothing() {
    let model = read("everything.dynamics.toml");
    for scheme in SCHEMES {
        for (jacobians, is_simplified) in [(Jacobians::Full, false), (Jacobians::Modified, true)] {
            let mut settings = TransientSettings::new(1.0, 1e-3);
            settings.scheme = scheme;
            settings.newton.jacobians = jacobians;
            settings.simplified_jacobian = is_simplified;
            check(&model, &settings);
        }
    }
}

/// Redundant constraints that share their loads: a plane four-bar on four revolutes.
#[test]
fn a_step_of_shared_loads_allocates_nothing() {
    let model = read("four-bar.dynamics.toml");
    let mut settings = TransientSettings::new(1.0, 1e-3);
    settings.redundant = Redundant::Remove;
    let outcome = transient(&model, &settings, None, &mut Silent, &|| 0.0);
    let mut reported = outcome.remarks.iter();
    assert!(reported.any(|remark| remark.ends_with("they share its load")));
    for scheme in SCHEMES {
        check(&model, &TransientSettings { scheme, ..settings });
    }
}

/// Variable steps, some of which are rejected: a body hits a stiff stop.
#[test]
fn a_step_that_is_tried_in_vain_allocates_nothing() {
    let model = read("stop.dynamics.toml");
    for scheme in SCHEMES {
        let control = StepControl {
            first: 1e-3,
            least: 1e-9,
            most: 1e-2,
            tolerance: 1e-5,
        };
        let mut settings = TransientSettings::new(1.0, 1e-3);
        settings.scheme = scheme;
        settings.stepping = Stepping::Variable(control);
        let of = |to: f64| allocations(&model, &TransientSettings { to, ..settings });
        let ((few, short), (many, long)) = (of(0.02), of(0.4));
        assert_eq!(short.rejected, 0);
        assert!(long.rejected > 0, "{settings:?}");
        // A trial that diverges may need one factorization with new pivots, which allocates; if
        // accepted steps did, there would be an allocation for each of them at least.
        let accepted = (long.steps - short.steps) as u64;
        let more = many.abs_diff(few);
        assert!(
            more < accepted,
            "{more} in {accepted} steps: {settings:?} {long:?}"
        );
    }
}

/// Recording of the internal forces along the beams: files are written at every step.
#[test]
fn a_row_of_forces_allocates_nothing() {
    let mut model = model(true);
    model.beams = vec![[0, 1, 2], [2, 3, 4]];
    let output = OutputSettings {
        csv: false,
        netcdf: false,
        span_forces: true,
        ..OutputSettings::default()
    };
    let folder = tempfile::tempdir().unwrap();
    let location = ResultLocation::new(folder.path(), "run").with_figures(false);
    let of = |to: f64| {
        let settings = TransientSettings::new(to, 1e-3);
        let mut files = RunFiles::new(&model, &output, &location, None).unwrap();
        let mut steps = 0;
        let count = measure(|| {
            let outcome = transient(&model, &settings, None, &mut files, &|| 0.0);
            steps = outcome.effort.steps;
        });
        (count.count_total, steps)
    };
    let ((few, short), (many, long)) = (of(0.01), of(0.03));
    assert!(few > 0 && long >= 3 * short);
    assert_eq!(many, few);
    let table = std::fs::read_to_string(folder.path().join("run.transient.n0_to_n4.forces.csv"));
    // the start and each step at four points, below the names of the columns
    assert_eq!(table.unwrap().lines().count(), 1 + 4 * (1 + long));
}
