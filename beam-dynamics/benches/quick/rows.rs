//! Measurements: groups of rows of the table.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use beam_dynamics::assembly::Sparse;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::integrator::{Scheme, Stepping};
use faer::sparse::linalg::SupernodalThreshold;
use nalgebra::Vector3;

use crate::cantilever::cantilever;
use crate::chain;
use crate::elements::Elements;
use crate::factors::{Comparison, Times};
use crate::line::Inertia;
use crate::operations;
use crate::runs::{Run, run};
use crate::table::Row;
use crate::yardstick::Yardstick;

/// A figure of a factorization: its name, and its time.
type Figure = (&'static str, fn(&Times) -> Duration);

/// Rows that belong together; `None` if a run failed.
pub type Group = fn(&mut Yardstick) -> Option<Vec<Row>>;

/// Step of the cantilevers [s].
const STEP: f64 = 1e-3;
/// Weights of unknowns and rates in a step of that length.
const WEIGHTS: [f64; 2] = [0.5 * STEP, 1.0];
/// Least duration of the repetitions of each measurement, with at least three repetitions.
pub const SPAN: Duration = Duration::from_secs(1);
/// A microsecond [s].
pub const US: f64 = 1e-6;
/// A millisecond [s].
pub const MS: f64 = 1e-3;

/// A cantilever, and its run of some steps, with the last state.
fn swung(beams: usize, inertia: Inertia, steps: usize) -> Option<(Model, Run)> {
    let model = cantilever(beams, inertia);
    let settings = TransientSettings::new(STEP * steps as f64, STEP);
    let run = run(&model, &settings, steps)?;
    Some((model, run))
}

/// Residual and Jacobian of one beam with its share of bodies, in a bent and moving cantilever of
/// twenty.
pub fn element(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    const BEAMS: usize = 20;
    let mut rows = Vec::new();
    for (word, inertia, limit) in [
        ("lumped", Inertia::Lumped, 1.3),
        ("consistent", Inertia::Consistent, 3.7),
    ] {
        let (model, run) = swung(BEAMS, inertia, 100)?;
        let elements = Elements::new(&model, run.states.last()?);
        let time = yardstick.beside(SPAN, || Some(elements.evaluate(WEIGHTS, 20).1))?;
        let time = time / BEAMS as f64;
        rows.push(Row {
            name: format!("element, {word} inertia"),
            ratio: time / yardstick.time(),
            limit,
            meaning: "residual and Jacobian / yardstick",
            time: format!("{:.2} us a beam", time / US),
            accuracy: format!("{:.0e} from central differences", elements.error()),
        });
    }
    Some(rows)
}

/// Our factorization compared with faer's, for the matrices of swinging cantilevers.
pub fn factorization(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    let (mut rows, mut of_a_beam, mut operations) = (Vec::new(), Vec::new(), 0.0);
    for (beams, limits) in [(20, [0.5, 1.5]), (400, [0.45, 1.6]), (2000, [0.5, 4.0])] {
        let (model, run) = swung(beams, Inertia::Lumped, 3)?;
        let (matrix, _) = Elements::new(&model, run.states.last()?).evaluate(WEIGHTS, 1);
        if beams == 20 {
            operations = operations::of(&matrix) / beams as f64;
        }
        let of_this = beside_faer(beams, limits, &matrix)?;
        of_a_beam.push(of_this.1 / beams as f64);
        rows.extend(of_this.0);
    }
    rows.push(growth(
        "LU",
        [20.0, 2000.0],
        [of_a_beam[0], of_a_beam[2]],
        1.4,
    ));
    let rate = operations / of_a_beam[0];
    rows.push(Row {
        name: "LU, time of an operation".into(),
        ratio: yardstick.rate() / rate,
        limit: 5.3,
        meaning: "20 beams / yardstick",
        time: format!(
            "{:.1} kflop a beam, {:.2} Gflop/s",
            1e-3 * operations,
            1e-9 * rate
        ),
        accuracy: "fewest operations counted".into(),
    });
    Some(rows)
}

/// Rows of one matrix, and our time of its factorization \[s\]. faer has two kinds, and the faster
/// one of each figure is used: separate columns solve faster, dense blocks factorize faster or
/// equally fast.
fn beside_faer(beams: usize, limits: [f64; 2], matrix: &Sparse) -> Option<(Vec<Row>, f64)> {
    let found = [
        ("blocks", SupernodalThreshold::FORCE_SUPERNODAL),
        ("columns", SupernodalThreshold::FORCE_SIMPLICIAL),
    ]
    .map(|(word, kind)| Some((word, Comparison::of(matrix, 1e-6, kind, SPAN)?)));
    let found: Vec<_> = found.into_iter().flatten().collect();
    let (mut rows, mut own_times) = (Vec::new(), Vec::new());
    let of: [Figure; 2] = [
        ("LU", |times| times.factorization),
        ("solution", |times| times.solution),
    ];
    for ((what, time), limit) in of.into_iter().zip(limits) {
        let (word, best) = found.iter().min_by_key(|(_, one)| time(&one.peer))?;
        let own = found.iter().map(|(_, one)| time(&one.own)).min()?;
        let [own, peer] = [own, time(&best.peer)].map(|time| time.as_secs_f64());
        own_times.push(own);
        rows.push(Row {
            name: format!("{what}, {beams} beams"),
            ratio: own / peer,
            limit,
            meaning: "kept pivots / faer, analysis kept",
            time: format!("{:.3} ms, faer {:.3} ({word})", own / MS, peer / MS),
            accuracy: format!(
                "residual {:.0e}, faer {:.0e}",
                best.own.error, best.peer.error
            ),
        });
    }
    Some((rows, own_times[0]))
}

/// Exponent of the total time as a power of the size.
fn growth(of: &str, sizes: [f64; 2], parts: [f64; 2], limit: f64) -> Row {
    let exponent = 1.0 + (parts[1] / parts[0]).ln() / (sizes[1] / sizes[0]).ln();
    Row {
        name: format!("{of}, growth"),
        ratio: exponent,
        limit,
        meaning: "exponent of the time by the size",
        time: format!("{} to {}", sizes[0], sizes[1]),
        accuracy: "-".into(),
    }
}

/// Steps of swinging cantilevers.
pub fn swinging(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    // At 1 s: the stored end; finer meshes and steps of ours end 2e-4 away from it. At 0.2 s: the
    // limit of fine meshes at this step, to 2e-6.
    let cases = [
        (20, 1000, Vector3::new(0.767_28, 0.540_19, 0.167_97), 2e-4),
        (
            400,
            200,
            Vector3::new(0.839_367, 0.412_995, -0.266_567),
            2e-6,
        ),
    ];
    let (mut rows, mut of_steps) = (Vec::new(), Vec::new());
    for (beams, steps, expected, known) in cases {
        let (mut tip, mut iterations) = (Vector3::zeros(), 0);
        let time = yardstick.beside(SPAN, || {
            let (_, run) = swung(beams, Inertia::Lumped, steps)?;
            tip = run.states.last()?.1.nodes.last()?.position;
            iterations = run.effort.iterations;
            Some(run.steps)
        })?;
        let off = (tip - expected).norm();
        // Both: iterations may become slower while steps do not, and vice versa.
        for (word, meaning, count, limit) in [
            (
                "iteration",
                "beam and iteration / yardstick",
                iterations,
                1.0,
            ),
            ("step", "beam and step / yardstick", steps, 4.0),
        ] {
            let time = time / (beams * count) as f64;
            rows.push(Row {
                name: format!("{word}, cantilever of {beams} beams"),
                ratio: time / yardstick.time(),
                limit,
                meaning,
                time: format!("{:.2} us, {count} in the run", time / US),
                accuracy: format!("tip {off:.1e} m off, known to {known:.0e}"),
            });
        }
        of_steps.push(time / (beams * steps) as f64);
    }
    rows.push(growth(
        "step",
        [20.0, 400.0],
        [of_steps[0], of_steps[1]],
        1.25,
    ));
    Some(rows)
}

/// A file next to this package.
fn beside(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// Largest distance of the links from their paths in the table of the case [m].
fn distance_from_table(run: &Run) -> Option<f64> {
    let table = fs::read_to_string(beside("tests/reference/dynamics/bipendulum.csv")).ok()?;
    let mut largest = 0.0_f64;
    for line in table.lines().filter(|line| !line.starts_with(['t', '#'])) {
        let numbers: Vec<f64> = line.split(',').flat_map(str::parse).collect();
        let state = run
            .states
            .iter()
            .find(|(time, _)| (time - numbers[0]).abs() < 1e-9);
        let Some((_, state)) = state else { continue };
        for (node, first) in state.nodes.iter().zip([1, 4]) {
            let position = Vector3::from_column_slice(&numbers[first..first + 3]);
            largest = largest.max((node.position - position).norm());
        }
    }
    Some(largest)
}

/// Steps of rigid bodies.
pub fn mechanisms(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    let meaning = "body and step / yardstick";
    let path = beside("cases/dynamics/bipendulum/bipendulum.dynamics.toml");
    let (input, _) = chain::read(&path)?;
    let mut settings = input.transient?;
    settings.scheme = Scheme::TwoStep { radius: 0.6 };
    settings.stepping = Stepping::Constant { step: 5e-4 };
    let mut error = None;
    let time = yardstick.beside(SPAN, || {
        let run = run(&input.model, &settings, 50)?;
        error = distance_from_table(&run);
        Some(run.steps / run.effort.steps as f64)
    })? / 2.0;
    let links = Row {
        name: "step, two links".into(),
        ratio: time / yardstick.time(),
        limit: 1.5,
        meaning,
        time: format!("{:.2} us a body and step", time / US),
        accuracy: format!("{:.1e} m off in 5 s", error?),
    };
    let folder = tempfile::tempdir().ok()?;
    let (model, _) = chain_of(folder.path(), 10)?;
    let settings = TransientSettings::new(0.5, 5e-4);
    let fine = run(&model, &TransientSettings::new(0.5, 5e-5), 10_000)?;
    let mut apart = f64::INFINITY;
    let time = yardstick.beside(SPAN, || {
        let run = run(&model, &settings, 1000)?;
        let ends = [&run, &fine].map(|run| run.states.last().map(|(_, state)| state));
        let pairs = ends[0]?.nodes.iter().zip(&ends[1]?.nodes);
        let distances = pairs.map(|(a, b)| (a.position - b.position).norm());
        apart = distances.fold(0.0, f64::max);
        Some(run.steps / run.effort.steps as f64)
    })? / 10.0;
    let chain = Row {
        name: "step, chain of 10 bodies".into(),
        ratio: time / yardstick.time(),
        limit: 1.5,
        meaning,
        time: format!("{:.2} us a body and step", time / US),
        accuracy: format!("{apart:.1e} m from a tenth of the step"),
    };
    Some(vec![links, chain])
}

/// The model of a chain, and the processor time of reading its file [s].
fn chain_of(folder: &Path, bodies: usize) -> Option<(Model, f64)> {
    let path = folder.join(format!("chain_{bodies}.dynamics.toml"));
    fs::write(&path, chain::text(bodies)).ok()?;
    let (input, time) = chain::read(&path)?;
    Some((input.model, time))
}

/// Reading of chains of bodies, and the start of their runs.
pub fn starting(yardstick: &mut Yardstick) -> Option<Vec<Row>> {
    const BODIES: [usize; 2] = [1000, 4000];
    let folder = tempfile::tempdir().ok()?;
    let mut times = [[0.0; 2]; 2];
    let mut gap = 0.0;
    for (bodies, times) in BODIES.into_iter().zip(&mut times) {
        let (model, _) = chain_of(folder.path(), bodies)?;
        let reading = || Some(chain_of(folder.path(), bodies)?.1);
        times[0] = yardstick.beside(SPAN, reading)?;
        let settings = TransientSettings::new(STEP, STEP);
        times[1] = yardstick.beside(SPAN, || {
            let run = run(&model, &settings, 1)?;
            gap = chain::gap(&run.states.last()?.1);
            Some(run.start)
        })?;
    }
    let row = |at: usize, what: &str, accuracy: String| Row {
        name: format!("start-up, {what} a chain"),
        ratio: times[1][at] / times[0][at],
        limit: 8.0,
        meaning: "4000 bodies / 1000 bodies",
        time: format!("{:.1} ms, {:.1} ms", times[0][at] / MS, times[1][at] / MS),
        accuracy,
    };
    Some(vec![
        row(0, "reading", "-".into()),
        row(
            1,
            "starting",
            format!("joints {gap:.0e} m open after a step"),
        ),
    ])
}
