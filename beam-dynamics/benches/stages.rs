//! Time of each stage of the modes of a rotating blade: 20 three-node elements with
//! consistent inertia, 492 unknowns of nodes.

use std::hint::black_box;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::steady::equilibrium;
use beam_dynamics::assembly::{MasslessMotions, System};
use beam_dynamics::case::{Model, ModesQuestion};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::model::{Conditions, Node};
use beam_dynamics::modes::EigenProblem;
use beam_dynamics::solver::LinearSolver;
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

const ELEMENTS: usize = 20;
const SPEED: f64 = 6.0;

/// Uniform blade of unit length, mass and bending stiffness.
fn system() -> System {
    let place = |i: usize| Vector3::new(i as f64 / (2 * ELEMENTS) as f64, 0.0, 0.0);
    let node = |i: usize| Node {
        label: format!("n{i}"),
        position: place(i),
        rotation: Matrix3::identity(),
    };
    let nodes: Vec<_> = (0..=2 * ELEMENTS).map(node).collect();
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let stiffness = Matrix6::from_diagonal(&Vector6::new(1e6, 1e5, 1e5, 0.5, 1.0, 20.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 1e-4, 1e-5, 9e-5));
    let mut elements: Vec<Box<dyn Element>> = vec![Box::new(clamped("root", 0, &nodes[0]))];
    for e in 0..ELEMENTS {
        let on = [2 * e, 2 * e + 1, 2 * e + 2];
        let at = on.map(|i| &nodes[i]);
        elements.push(Box::new(Beam::elastic(
            "beam",
            on,
            geometry,
            at,
            [stiffness; 2],
        )));
        elements.push(Box::new(BeamInertia::new(
            "beam",
            on,
            geometry,
            at,
            &MassAlong::smooth(&|_| mass),
        )));
    }
    System::new(nodes, elements)
}

fn stages(criterion: &mut Criterion) {
    let model = Model::new("blade", system());
    let system = &model.system;
    let at_rest = Conditions::at_rest();
    let turning = model.conditions(SPEED, 1.0, 0.0);
    let rest = system.rest();
    let tangent = system.tangent(&rest, &turning);
    let solver = LinearSolver::new(tangent.by_unknowns.pattern());
    let Ok(steady) = equilibrium(&model, &solver, (&at_rest, &rest), &turning) else {
        return;
    };
    let tangent = system.tangent(&steady.state, &turning);

    let mut group = criterion.benchmark_group("modes");
    group.bench_function("residual", |b| {
        b.iter(|| black_box(system.residual(&rest, &turning)))
    });
    group.bench_function("tangent", |b| {
        b.iter(|| black_box(system.tangent(&rest, &turning)))
    });
    group.bench_function("factorization", |b| {
        b.iter(|| black_box(solver.factorize(tangent.by_unknowns.clone())));
    });
    group.bench_function("equilibrium", |b| {
        b.iter(|| black_box(equilibrium(&model, &solver, (&at_rest, &rest), &turning).is_ok()));
    });
    group.bench_function("eigenvalues", |b| {
        b.iter(|| {
            let massless = MasslessMotions::new(system, &tangent);
            let problem = EigenProblem::new(&solver, &tangent, &massless, 4);
            black_box(problem.map(|problem| problem.lowest(10)))
        });
    });
    group.finish();
}

fn whole(criterion: &mut Criterion) {
    let model = Model::new("blade", system());
    let question = ModesQuestion::new(vec![0.0, SPEED], 10);
    criterion.bench_function("modes at two speeds", |b| {
        b.iter(|| black_box(modes(&model, &question)))
    });
}

criterion_group!(benches, stages, whole);
criterion_main!(benches);
