//! A step that could not be made, in words: the worst equation, the likely cause, and how
//! the iteration went.

use std::fmt::{self, Write};

use super::cause::{Cause, Scene, listed};
use crate::analysis::transient::energy::Finding;
use crate::analysis::transient::multibody::Multibody;
use crate::assembly::System;
use crate::case::{Model, TransientQuestion};
use crate::integrator::{Reason, StepFailure};
use crate::model::NODE_UNKNOWNS;
use crate::solver::Iteration;

/// Iterations of the history that are told.
const TOLD: usize = 12;

/// A step that could not be made, and what it may come from.
#[derive(Debug, Clone, PartialEq)]
pub struct StepTrouble {
    /// The failure of the integrator.
    pub failure: StepFailure,
    /// Names of the elements that act on the node of the worst equation.
    pub acting: Vec<String>,
    /// The likely cause in words.
    pub cause: String,
    /// What to try, the likeliest first.
    pub remedies: Vec<String>,
    /// The iterations in words, by their worst equations.
    pub history: String,
}

impl StepTrouble {
    /// The failure of a step of `model`, with what it likely comes from.
    pub(in crate::analysis::transient) fn new(
        failure: StepFailure,
        (model, question): (&Model, &TransientQuestion),
        (dae, gained): (&Multibody<'_>, Option<Finding>),
    ) -> Self {
        let scene = Scene::new(&failure, (model, question), (dae, gained));
        let Cause { words, remedies } = scene.cause();
        let is_inexact = failure.local_error.is_some() || failure.reason == Reason::Corners;
        Self {
            acting: match is_inexact {
                true => Vec::new(),
                false => acting(&model.system, failure.worst.place),
            },
            // Iterations that converged are of no interest.
            history: match is_inexact {
                true => String::new(),
                false => history(&model.system, &failure.history),
            },
            failure,
            cause: words,
            remedies,
        }
    }

    /// What to try.
    pub(super) fn remedy(&self) -> String {
        self.remedies.join("; ")
    }
}

impl fmt::Display for StepTrouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.failure)?;
        if !self.acting.is_empty() {
            write!(f, "; on the node act {}", listed(&self.acting))?;
        }
        write!(f, "\n  likely cause: {}", self.cause)?;
        match self.history.is_empty() {
            true => Ok(()),
            false => write!(
                f,
                "\n  iterations, each with residual by scale and correction: {}",
                self.history
            ),
        }
    }
}

impl std::error::Error for StepTrouble {}

/// Names of the elements that act on the node to which an equation belongs, each once.
fn acting(system: &System, place: usize) -> Vec<String> {
    let node = place / NODE_UNKNOWNS;
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

/// The iterations: those with the same worst equation in a row behind its name.
fn history(system: &System, iterations: &[Iteration]) -> String {
    let mut text = String::new();
    let mut place = None;
    for (i, iteration) in iterations.iter().take(TOLD).enumerate() {
        let (worst, correction) = (&iteration.worst, iteration.correction);
        let is_same = place.replace(worst.place) == Some(worst.place);
        // Writing to a string does not fail.
        let _ = match is_same {
            true => write!(text, ", "),
            false => {
                let semicolon = if i > 0 { "; " } else { "" };
                write!(text, "{semicolon}{}: ", system.equation(worst.place))
            }
        };
        let _ = write!(text, "{:.1e} {correction:.1e}", worst.relative);
    }
    if iterations.len() > TOLD {
        let _ = write!(text, " and {} more", iterations.len() - TOLD);
    }
    text
}
