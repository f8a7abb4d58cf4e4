//! A failed step, as text: the worst equation, the likely cause, and the history of the iteration.

use std::fmt;

use shared_geom::error::joined;

use crate::integrator::StepFailure;

/// Largest number of names that are listed.
const NAMED: usize = 3;

/// A failed step, and its likely cause.
#[derive(Debug, Clone, PartialEq)]
pub struct StepTrouble {
    /// The failure of the integrator.
    pub failure: StepFailure,
    /// Names of the elements that act on the node of the worst equation.
    pub acting: Vec<String>,
    /// The likely cause, as text.
    pub cause: String,
    /// Remedies, the most likely first.
    pub remedies: Vec<String>,
    /// The iterations as text, by their worst equations.
    pub history: String,
}

impl StepTrouble {
    /// The remedies.
    pub(super) fn remedy(&self) -> String {
        self.remedies.join("; ")
    }
}

impl fmt::Display for StepTrouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.failure)?;
        if !self.acting.is_empty() {
            write!(f, "; on the node act {}", quoted(&self.acting))?;
        }
        write!(f, "\n  likely cause: {}", self.cause)?;
        if self.history.is_empty() {
            Ok(())
        } else {
            write!(
                f,
                "\n  iterations, each with residual by scale and correction: {}",
                self.history
            )
        }
    }
}

impl std::error::Error for StepTrouble {}

/// Names in quotes, the first of many.
pub(in crate::analysis::transient) fn quoted(names: &[String]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    match quoted.len().saturating_sub(NAMED) {
        0 => joined(&quoted),
        more => format!("{} and {more} more", quoted[..NAMED].join(", ")),
    }
}
