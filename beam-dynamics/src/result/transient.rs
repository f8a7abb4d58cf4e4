//! A run in time: records of every step, and of the run.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::integrator::Progress;
use crate::model::{Conditions, State};

/// An accepted step.
#[derive(Debug, Clone, Copy)]
pub struct AcceptedStep<'a> {
    /// Number of the step; zero is the start.
    pub step: usize,
    /// Time [s].
    pub time: f64,
    /// Length of the step that led to the state; zero at the start [s].
    pub length: f64,
    /// Iterations of the step.
    pub iterations: usize,
    /// The state.
    pub state: &'a State,
    /// Loads and frame.
    pub conditions: &'a Conditions,
}

/// Receiver of every accepted step, in order.
pub trait Recorder {
    /// Takes a step; `false` ends the run, for example if nothing more can be written.
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool;

    /// Whether a snapshot for a restart is needed after this step.
    fn wants_snapshot(&self, _accepted: &AcceptedStep<'_>) -> bool {
        false
    }

    /// Takes a snapshot for a restart; `false` ends the run.
    fn keep(&mut self, _snapshot: &Snapshot) -> bool {
        true
    }

    /// Takes the last accepted step, which was recorded already, of a run that cannot
    /// continue, and its snapshot for a restart; `false` if it cannot be written.
    fn stopped(&mut self, _accepted: &AcceptedStep<'_>, snapshot: &Snapshot) -> bool {
        self.keep(snapshot)
    }
}

/// The data for a restart, exact to the last bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Fingerprint of the model (see [`crate::case::Model::fingerprint`]); empty in a
    /// snapshot that has not been in a file.
    pub model: String,
    /// Names of the nodes, by which the model is recognized.
    pub nodes: Vec<String>,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Number of the last step.
    pub step: usize,
    /// The integrator's data of the steps so far.
    pub progress: Progress,
    /// Time spent by the recorder so far [s].
    pub output_time: f64,
    /// Time of the run so far [s].
    pub total_time: f64,
    /// The latest states, the last one first: thirty numbers per node, then the
    /// multipliers, then the scalars, their rates, and the memory [unit of each].
    pub states: Vec<Vec<f64>>,
    /// The angles of the followed joints with their full turns, by name [rad].
    pub angles: BTreeMap<String, f64>,
}

/// The effort of a run, for its last lines.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Effort {
    /// Accepted steps.
    pub steps: usize,
    /// Steps that were repeated with a shorter length.
    pub rejected: usize,
    /// Newton iterations, including rejected steps.
    pub iterations: usize,
    /// Jacobians that were assembled and factorized.
    pub jacobians: usize,
    /// Factorizations that chose new pivots.
    pub pivotings: usize,
    /// Shortest accepted step [s].
    pub least_step: f64,
    /// Longest accepted step [s].
    pub most_step: f64,
    /// Time spent in predictions, including the distribution of loads among constraints
    /// [s].
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
