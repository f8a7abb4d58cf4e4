//! Runs in time: processor time per beam and Newton iteration, by phase, and how it
//! grows with the number of beams: a swinging cantilever of 20, 100 and 400 beams, and a
//! rotor of four blades of 20 beams. Ratios within the run are what counts.
//!
//! `cargo bench -p beam-dynamics --bench time`

mod models;

use beam_dynamics::analysis::transient::transient;
use beam_dynamics::case::{Model, TransientQuestion};
use beam_dynamics::result::{Effort, Moment, Recorder};
use cpu_time::ThreadTime;

/// Repetitions; the fastest counts, as on a machine that does other things as well.
const REPETITIONS: usize = 3;

/// Keeps nothing.
struct Silent;

impl Recorder for Silent {
    fn record(&mut self, _: &Moment<'_>) -> bool {
        true
    }
}

fn run(model: &Model, question: &TransientQuestion) -> Option<Effort> {
    let begin = ThreadTime::now();
    let clock = || begin.elapsed().as_secs_f64();
    let outcome = transient(model, question, None, &mut Silent, &clock);
    if let Some(failure) = &outcome.failure {
        println!("{failure}");
    }
    outcome.failure.is_none().then_some(outcome.effort)
}

/// Microseconds per beam and iteration: residual, Jacobian, factorization, solution, the
/// whole run.
fn measure(model: &Model, beams: usize, question: &TransientQuestion) -> Option<[f64; 5]> {
    let mut least = [f64::INFINITY; 5];
    let mut last = Effort::default();
    for _ in 0..REPETITIONS {
        let effort = run(model, question)?;
        let times = [
            effort.residual_time,
            effort.jacobian_time,
            effort.factorization_time,
            effort.solution_time,
            effort.total_time,
        ];
        for (least, time) in least.iter_mut().zip(times) {
            *least = least.min(1e6 * time / (beams * effort.iterations) as f64);
        }
        last = effort;
    }
    let [residual, jacobian, factorization, solution, total] = least;
    println!(
        "{:<12} {beams:>5} {:>5} {:>5} {:>4} {residual:>8.2} {jacobian:>8.2} \
         {factorization:>13.2} {solution:>8.2} {total:>8.2}",
        model.name, last.steps, last.iterations, last.pivotings,
    );
    Some(least)
}

fn main() {
    println!("processor time per beam and Newton iteration [us]");
    println!(
        "{:<12} {:>5} {:>5} {:>5} {:>4} {:>8} {:>8} {:>13} {:>8} {:>8}",
        "model",
        "beams",
        "steps",
        "iter.",
        "piv.",
        "residual",
        "Jacobian",
        "factorization",
        "solution",
        "total"
    );
    let question = TransientQuestion::new(0.1, 1e-3);
    let mut totals = Vec::new();
    for beams in [20, 100, 400] {
        if let Some(least) = measure(&models::cantilever(beams), beams, &question) {
            totals.push((beams as f64, beams as f64 * least[4]));
        }
    }
    if let [(few, short), .., (many, long)] = totals[..] {
        let exponent = (long / short).ln() / (many / few).ln();
        println!("growth exponent with the number of beams: {exponent:.2}");
    }
    let revolution = std::f64::consts::TAU / models::SPEED;
    let question = TransientQuestion::new(revolution, revolution / 256.0);
    measure(&models::rotor(), 4 * models::BEAMS_OF_A_BLADE, &question);
}
