//! A run in time: what is told of every step, and of the run.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::integrator::Progress;
use crate::model::{Conditions, State};

/// An accepted step.
#[derive(Debug, Clone, Copy)]
pub struct Moment<'a> {
    /// Number of the step; zero is the start.
    pub step: usize,
    /// Time [s].
    pub time: f64,
    /// Length of the step that led here; zero at the start [s].
    pub length: f64,
    /// Iterations of the step.
    pub iterations: usize,
    /// The state.
    pub state: &'a State,
    /// What acts.
    pub conditions: &'a Conditions,
}

/// Who is told of every accepted step, in order.
pub trait Recorder {
    /// Takes a step; `false` ends the run, as when nothing more can be written.
    fn record(&mut self, moment: &Moment<'_>) -> bool;

    /// Whether what the run can be continued from is wanted after this step.
    fn wants_snapshot(&self, _moment: &Moment<'_>) -> bool {
        false
    }

    /// Takes what the run can be continued from; `false` ends the run.
    fn keep(&mut self, _snapshot: &Snapshot) -> bool {
        true
    }

    /// Takes the last accepted step, which has been told already, of a run that cannot go
    /// on, and what it can be continued from; `false` when it cannot be written.
    fn stopped(&mut self, _moment: &Moment<'_>, snapshot: &Snapshot) -> bool {
        self.keep(snapshot)
    }
}

/// All that a run needs to go on, to the last bit, as if it had never ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Fingerprint of the model (see [`crate::case::Model::fingerprint`]); empty in a
    /// snapshot that has not been in a file.
    pub model: String,
    /// Names of the nodes, by which a model is known again.
    pub nodes: Vec<String>,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Number of the last step.
    pub step: usize,
    /// What the integrator knows of the steps so far.
    pub progress: Progress,
    /// Time spent by the recorder so far [s].
    pub output_time: f64,
    /// Time of the run so far [s].
    pub total_time: f64,
    /// The latest states, the last one first: thirty numbers a node, then the
    /// multipliers, then the scalars, their rates, and the memory [unit of each].
    pub states: Vec<Vec<f64>>,
    /// The angles with their full turns of joints, by name, of those that were followed
    /// [rad].
    pub angles: BTreeMap<String, f64>,
}

/// The effort of a run, for its last lines.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Effort {
    /// Accepted steps.
    pub steps: usize,
    /// Steps that were tried again with a shorter one.
    pub rejected: usize,
    /// Newton iterations, those of rejected steps included.
    pub iterations: usize,
    /// Jacobians that were assembled and factorized.
    pub jacobians: usize,
    /// Factorizations that chose new pivots.
    pub pivotings: usize,
    /// Shortest accepted step [s].
    pub least_step: f64,
    /// Longest accepted step [s].
    pub most_step: f64,
    /// Time spent in predictions, and in how constraints share loads there [s].
    pub prediction_time: f64,
    /// Time spent in residuals [s].
    pub residual_time: f64,
    /// Time spent in Jacobians [s].
    pub jacobian_time: f64,
    /// Time spent in factorizations [s].
    pub factorization_time: f64,
    /// Time spent in solutions with factors [s].
    pub solution_time: f64,
    /// Time spent by the recorder [s].
    pub output_time: f64,
    /// Time of the whole run [s].
    pub total_time: f64,
}
