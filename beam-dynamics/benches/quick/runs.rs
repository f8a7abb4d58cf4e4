//! Runs in time, and their processor time.

use beam_dynamics::analysis::transient::transient;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::model::State;
use beam_dynamics::result::{AcceptedStep, Effort, Recorder};
use cpu_time::ThreadTime;

/// Results of a run: its last state, and the start of its first step.
#[derive(Default)]
struct Last {
    began: Option<ThreadTime>,
    /// Number of steps between two kept states.
    every: usize,
    states: Vec<(f64, State)>,
}

impl Recorder for Last {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        if accepted.step == 0 {
            self.began = Some(ThreadTime::now());
        }
        if accepted.step.is_multiple_of(self.every) {
            self.states.push((accepted.time, accepted.state.clone()));
        }
        true
    }
}

/// A run in time that reached its end.
pub struct Run {
    pub effort: Effort,
    /// Processor time of the start and of the steps [s].
    pub start: f64,
    pub steps: f64,
    /// States that were kept, with their times [s].
    pub states: Vec<(f64, State)>,
}

/// Runs a model, and keeps a state at every multiple of `every` steps; `None` if the run fails.
pub fn run(model: &Model, settings: &TransientSettings, every: usize) -> Option<Run> {
    let mut last = Last {
        every,
        ..Last::default()
    };
    let begin = ThreadTime::now();
    let outcome = transient(model, settings, None, &mut last, &|| 0.0);
    let all = begin.elapsed().as_secs_f64();
    if let Some(failure) = &outcome.failure {
        println!("{}: {failure}", model.name);
        return None;
    }
    let steps = last.began?.elapsed().as_secs_f64();
    Some(Run {
        effort: outcome.effort,
        start: all - steps,
        steps,
        states: last.states,
    })
}
