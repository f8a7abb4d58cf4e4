//! Motion in time: start-up, then step after step, every one told to a recorder.

use crate::case::{Model, TransientQuestion};
use crate::result::{Effort, Recorder, Snapshot};

/// Why a run in time ended before its last instant.
#[derive(Debug, Clone, thiserror::Error)]
pub enum TransientFailure {
    /// The recorder took no more.
    #[error("output ended the run at {time} s")]
    Recorder {
        /// Time reached [s].
        time: f64,
    },
}

impl TransientFailure {
    /// What to do about it.
    pub fn remedy(&self) -> String {
        match self {
            Self::Recorder { .. } => "look at what output says".to_owned(),
        }
    }
}

/// What a run in time came to; its steps are with the recorder.
#[derive(Debug)]
pub struct TransientOutcome {
    /// Steps, iterations, and where the time went.
    pub effort: Effort,
    /// Time reached [s].
    pub time: f64,
    /// What the reader must know: what start-up changed, doubtful choices.
    pub remarks: Vec<String>,
    /// Why the run ended early, if it did.
    pub failure: Option<TransientFailure>,
}

/// Runs `model` in time as `question` asks, from its start or from where `resumed` was
/// kept, and tells `recorder` every accepted step; `clock` gives seconds \[s\].
pub fn transient(
    _model: &Model,
    question: &TransientQuestion,
    _resumed: Option<&Snapshot>,
    _recorder: &mut dyn Recorder,
    _clock: &dyn Fn() -> f64,
) -> TransientOutcome {
    TransientOutcome {
        effort: Effort::default(),
        time: question.from,
        remarks: Vec::new(),
        failure: None,
    }
}
