//! Runs in time: processor time per beam and Newton iteration, by phase, and how it grows
//! with the number of beams: a swinging cantilever of 20, 100 and 400 beams (model M), and
//! a rotor of four blades of 20 beams (model T), with lumped and with consistent inertia.
//!
//! The models take turns, and of each the fastest of many runs counts. Only ratios
//! within the run are comparable between machines.
//!
//! `cargo bench -p beam-dynamics --bench time`, with another number of rounds behind `--`

#[path = "../common/cantilever.rs"]
mod cantilever;
#[path = "../common/line.rs"]
mod line;
#[path = "../common/one_thread.rs"]
mod one_thread;
mod rotor;

use beam_dynamics::analysis::transient::transient;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::result::{AcceptedStep, Effort, Recorder};
use cpu_time::ThreadTime;

use cantilever::cantilever;
use line::Inertia;
use rotor::rotor;

/// Default number of rounds, in each of which every model runs once.
const ROUNDS: usize = 7;
/// Numbers of beams of the cantilever.
const BEAMS: [usize; 3] = [20, 100, 400];
/// Phases of a run, and all of it.
const PHASES: usize = 5;

/// Keeps nothing.
struct Silent;

impl Recorder for Silent {
    fn record(&mut self, _: &AcceptedStep<'_>) -> bool {
        true
    }
}

/// A model, its settings, and the least times so far.
struct Candidate {
    name: String,
    beams: usize,
    model: Model,
    settings: TransientSettings,
    effort: Effort,
    /// Microseconds per beam and iteration: residual, Jacobian, factorization, solution,
    /// all of the run.
    least: [f64; PHASES],
}

impl Candidate {
    fn new(name: &str, beams: usize, model: Model, settings: TransientSettings) -> Self {
        Self {
            name: name.to_owned(),
            beams,
            model,
            settings,
            effort: Effort::default(),
            least: [f64::INFINITY; PHASES],
        }
    }

    fn run(&mut self) {
        let begin = ThreadTime::now();
        let clock = || begin.elapsed().as_secs_f64();
        let outcome = transient(&self.model, &self.settings, None, &mut Silent, &clock);
        if let Some(failure) = &outcome.failure {
            println!("{}: {failure}", self.name);
            return;
        }
        let effort = outcome.effort;
        let times = [
            effort.residual_time,
            effort.jacobian_time,
            effort.factorization_time,
            effort.solution_time,
            effort.total_time,
        ];
        let count = (self.beams * effort.iterations) as f64;
        for (least, time) in self.least.iter_mut().zip(times) {
            *least = least.min(1e6 * time / count);
        }
        self.effort = effort;
    }

    fn print(&self) {
        let [residual, jacobian, factorization, solution, total] = self.least;
        let share = 100.0 * (factorization + solution) / total;
        println!(
            "{:<22} {:>5} {:>5} {:>5} {:>4} {residual:>8.2} {jacobian:>8.2} \
             {factorization:>13.2} {solution:>8.2} {total:>8.2} {share:>5.0} %",
            self.name, self.beams, self.effort.steps, self.effort.iterations, self.effort.pivotings,
        );
    }
}

/// The cantilevers, then the rotor.
fn candidates(inertia: Inertia) -> Vec<Candidate> {
    let word = match inertia {
        Inertia::Lumped => "lumped",
        Inertia::Consistent => "consistent",
    };
    let settings = TransientSettings::new(0.1, 1e-3);
    let swinging = |beams: usize| {
        let name = format!("cantilever, {word}");
        Candidate::new(&name, beams, cantilever(beams, inertia), settings)
    };
    let mut all: Vec<_> = BEAMS.into_iter().map(swinging).collect();
    let revolution = std::f64::consts::TAU / rotor::SPEED;
    let settings = TransientSettings::new(revolution, revolution / 256.0);
    let beams = 4 * rotor::BEAMS_OF_A_BLADE;
    let name = format!("rotor, {word}");
    all.push(Candidate::new(&name, beams, rotor(inertia), settings));
    all
}

/// Exponent by which the whole time grows from the fewest beams to the most.
fn exponent(of: &[Candidate]) -> f64 {
    let (few, many) = (&of[0], &of[BEAMS.len() - 1]);
    let ratio = many.beams as f64 / few.beams as f64;
    1.0 + (many.least[PHASES - 1] / few.least[PHASES - 1]).ln() / ratio.ln()
}

fn main() {
    one_thread::on_one_thread();
    let rounds = std::env::args().find_map(|word| word.parse().ok());
    let mut all = [Inertia::Lumped, Inertia::Consistent].map(candidates);
    for _ in 0..rounds.unwrap_or(ROUNDS) {
        all.iter_mut().flatten().for_each(Candidate::run);
    }
    println!("processor time per beam and Newton iteration [us]");
    println!(
        "{:<22} {:>5} {:>5} {:>5} {:>4} {:>8} {:>8} {:>13} {:>8} {:>8} {:>7}",
        "model",
        "beams",
        "steps",
        "iter.",
        "piv.",
        "residual",
        "Jacobian",
        "factorization",
        "solution",
        "total",
        "LU"
    );
    for of in &all {
        of.iter().for_each(Candidate::print);
        println!(
            "growth exponent with the number of beams: {:.2}",
            exponent(of)
        );
    }
}
