//! Data of a failed step: the elements at the worst equation, the likely cause, and the history of
//! the iteration.

use std::fmt::Write;

use super::energy::Finding;
use super::failure::StepTrouble;
use super::multibody::Multibody;
use crate::assembly::System;
use crate::case::{Model, TransientSettings};
use crate::integrator::{Reason, StepFailure};
use crate::model::NODE_UNKNOWNS;
use crate::solver::Iteration;

mod cause;

pub(in crate::analysis) use cause::in_wake;
use cause::{Cause, FailureContext};

/// Iterations of the history that are shown.
const MOST_REPORTED: usize = 12;

/// The failure of a step of `model`, with its likely cause.
pub(super) fn trouble(
    failure: StepFailure,
    (model, settings): (&Model, &TransientSettings),
    (dae, gained): (&Multibody<'_>, Option<Finding>),
) -> StepTrouble {
    let context = FailureContext::new(&failure, (model, settings), (dae, gained));
    let Cause { words, remedies } = context.cause();
    let is_inexact = failure.local_error.is_some() || failure.reason == Reason::Corners;
    StepTrouble {
        acting: if is_inexact {
            Vec::new()
        } else {
            acting(&model.system, failure.worst.index)
        },
        // Converged iterations are omitted.
        history: if is_inexact {
            String::new()
        } else {
            history(&model.system, &failure.history)
        },
        failure,
        cause: words,
        remedies,
    }
}

/// Names of the elements that act on the node to which an equation belongs, each once.
fn acting(system: &System, index: usize) -> Vec<String> {
    let node = index / NODE_UNKNOWNS;
    let mut names: Vec<String> = Vec::new();
    // The balances of the nodes come first.
    for element in system.elements().skip(system.nodes().len()) {
        let is_new = names.last().is_none_or(|last| last != element.label());
        let acts = element.acts() && element.nodes().contains(&node);
        if is_new && node < system.nodes().len() && acts {
            names.push(element.label().to_owned());
        }
    }
    names
}

/// The iterations: consecutive ones with the same worst equation are listed after its name.
fn history(system: &System, iterations: &[Iteration]) -> String {
    let mut text = String::new();
    let mut index = None;
    for (i, iteration) in iterations.iter().take(MOST_REPORTED).enumerate() {
        let (worst, correction) = (&iteration.worst, iteration.correction);
        let is_same = index.replace(worst.index) == Some(worst.index);
        // Writing to a string cannot fail.
        let _ = if is_same {
            write!(text, ", ")
        } else {
            let semicolon = if i > 0 { "; " } else { "" };
            write!(text, "{semicolon}{}: ", system.equation(worst.index))
        };
        let _ = write!(text, "{:.1e} {correction:.1e}", worst.relative);
    }
    if iterations.len() > MOST_REPORTED {
        let _ = write!(text, " and {} more", iterations.len() - MOST_REPORTED);
    }
    text
}
