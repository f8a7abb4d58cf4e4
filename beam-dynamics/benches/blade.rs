//! Twenty modes of a twisted, tapered blade over the number of its elements: the time
//! at one speed split into its stages, how it grows with the number of elements, and
//! the gain by two threads over twenty speeds. Processor times, as ratios within the run.
//!
//! `cargo bench -p beam-dynamics --bench blade`

#[path = "common/shortest.rs"]
mod shortest;

use std::hint::black_box;
use std::time::{Duration, Instant};

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::steady::equilibrium;
use beam_dynamics::assembly::{MasslessMotions, System};
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::model::{Conditions, Node};
use beam_dynamics::modes::EigenProblem;
use beam_dynamics::solver::LinearSolver;
use nalgebra::{Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use shortest::shortest;

/// Rotor speed, in units of the blade [rad/s].
const SPEED: f64 = 6.0;
const MODES: usize = 20;
const SIZES: [usize; 4] = [25, 50, 100, 200];
/// How long each stage is repeated.
const SPAN: Duration = Duration::from_secs(1);

/// A blade of unit length that tapers to half its stiffness and untwists by 20 degrees.
fn model(elements: usize) -> Model {
    let count = 2 * elements + 1;
    let part = |i: usize| i as f64 / (count - 1) as f64;
    let node = |i: usize| Node {
        label: format!("n{i}"),
        position: Vector3::new(part(i), 0.0, 0.0),
        rotation: vector::to_rotation(&Vector3::new(0.35 * (1.0 - part(i)), 0.0, 0.0)),
    };
    let nodes: Vec<_> = (0..count).map(node).collect();
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let stiffness = Matrix6::from_diagonal(&Vector6::new(1e6, 1e5, 1e5, 0.5, 1.0, 20.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 1e-4, 1e-5, 9e-5));
    let mut parts: Vec<Box<dyn Element>> = vec![Box::new(clamped("root", 0, &nodes[0]))];
    for e in 0..elements {
        let on = [2 * e, 2 * e + 1, 2 * e + 2];
        let at = on.map(|i| &nodes[i]);
        let law = Beam::evaluation_points()
            .map(|xi| (1.0 - 0.25 * (part(2 * e + 1) * 2.0 + xi / elements as f64)) * stiffness);
        parts.push(Box::new(Beam::elastic("beam", on, geometry, at, law)));
        let inertia = BeamInertia::new("beam", on, geometry, at, &MassAlong::smooth(&|_| mass));
        parts.push(Box::new(inertia));
    }
    Model::new("blade", System::new(nodes, parts))
}

/// Times of the stages at one speed.
struct Times {
    equilibrium: Duration,
    assembly: Duration,
    factorization: Duration,
    eigenvalues: Duration,
}

impl Times {
    fn of(model: &Model) -> Option<Self> {
        let system = &model.system;
        let rest = system.rest();
        let at_rest = Conditions::at_rest();
        let turning = model.conditions(SPEED, 1.0, 0.0);
        let solver = LinearSolver::new(system.pattern());
        let steady = equilibrium(model, &solver, (&at_rest, &rest), &turning).ok()?;
        let tangent = system.tangent(&steady.state, &turning);
        let massless = MasslessMotions::new(system, &tangent);
        Some(Self {
            equilibrium: shortest(SPAN, || {
                equilibrium(model, &solver, (&at_rest, &rest), &turning).is_ok()
            }),
            assembly: shortest(SPAN, || system.tangent(&steady.state, &turning)),
            factorization: shortest(SPAN, || solver.factorize(tangent.by_unknowns.clone())),
            eigenvalues: shortest(SPAN, || {
                EigenProblem::new(&solver, &tangent, &massless, 4)
                    .map(|problem| problem.lowest(MODES))
            }),
        })
    }

    fn total(&self) -> Duration {
        self.equilibrium + self.assembly + self.eigenvalues
    }
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

/// Wall time of twenty speeds on a number of threads.
fn twenty_speeds(model: &Model, threads: usize) -> Option<Duration> {
    let speeds = (0..20).map(|k| SPEED * f64::from(k) / 19.0).collect();
    let settings = ModesSettings::new(speeds, MODES);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.ok()?;
    let run = || {
        let start = Instant::now();
        black_box(pool.install(|| modes(model, &settings)));
        start.elapsed()
    };
    (0..3).map(|_| run()).min()
}

fn main() {
    println!("{MODES} modes at one speed, processor time [ms]");
    println!(
        "{:>8} {:>11} {:>8} {:>13} {:>14} {:>8}",
        "elements", "equilibrium", "assembly", "factorization", "eigen-solution", "total"
    );
    let mut totals = Vec::new();
    for elements in SIZES {
        let Some(times) = Times::of(&model(elements)) else {
            println!("{elements:>8} no equilibrium");
            continue;
        };
        println!(
            "{elements:>8} {:>11.2} {:>8.2} {:>13.2} {:>14.2} {:>8.2}",
            milliseconds(times.equilibrium),
            milliseconds(times.assembly),
            milliseconds(times.factorization),
            milliseconds(times.eigenvalues),
            milliseconds(times.total()),
        );
        totals.push((elements as f64, times.total().as_secs_f64()));
    }
    if let [(few, short), .., (many, long)] = totals[..] {
        let exponent = (long / short).ln() / (many / few).ln();
        println!("growth exponent with the number of elements: {exponent:.2}");
    }
    let blade = model(100);
    if let (Some(one), Some(two)) = (twenty_speeds(&blade, 1), twenty_speeds(&blade, 2)) {
        let gain = one.as_secs_f64() / two.as_secs_f64();
        println!(
            "20 speeds, 100 elements: {:.0} ms on one thread, {:.0} ms on two; efficiency {:.0} %",
            milliseconds(one),
            milliseconds(two),
            50.0 * gain
        );
    }
}
