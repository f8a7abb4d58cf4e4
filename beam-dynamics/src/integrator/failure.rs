//! Reasons of a failed step.

use std::fmt;

use shared_geom::units::rounded;

use super::limits::MOST_CROWDED;
use crate::model::Name;
use crate::solver::{Iteration, Worst};

/// Failure of the shortest step that was tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The iteration did not converge in the iterations allowed.
    NotConverged,
    /// The corrections grew.
    Diverged,
    /// The Jacobian is singular.
    Singular,
    /// A residual or a derivative is not a finite number.
    NotFinite,
    /// The local error stayed too large.
    LocalError,
    /// The drives have too many corners in succession.
    Corners,
}

impl Reason {
    /// The reason as text.
    pub fn words(self) -> &'static str {
        match self {
            Self::NotConverged => "the iteration did not converge",
            Self::Diverged => "the iteration diverged",
            Self::Singular => "the Jacobian is singular",
            Self::NotFinite => "a residual or a derivative is not a finite number",
            Self::LocalError => "the local error is too large",
            Self::Corners => "the drives have too many corners in succession",
        }
    }

    /// Remedies, the likeliest first.
    pub fn remedies(self) -> &'static [&'static str] {
        match self {
            Self::NotConverged => &[
                "allow shorter steps",
                "use the exact Jacobian in every iteration",
                "lower the asymptotic radius: motion too fast for the time step is then damped",
            ],
            Self::Diverged => &[
                "allow shorter steps",
                "look for a position at which the mechanism is locked or branches",
                "lower the asymptotic radius",
            ],
            Self::Singular => &[
                "look for redundant constraints, and for parts without mass",
                "look for a position at which the mechanism is locked or branches",
            ],
            Self::NotFinite => &[
                "look for drives and laws that are not defined at this time or strain",
                "allow shorter steps",
            ],
            Self::Corners => &[
                "use a drive with fewer corners: longer intervals, or a random drive with a \
                 \"band\", which has none",
                "use shorter steps, if the corners are intended",
            ],
            Self::LocalError => &[
                "allow a larger local error or shorter steps",
                "look for a jump that no drive reports as a corner",
            ],
        }
    }
}

/// A step that failed at the least length.
#[derive(Debug, Clone, PartialEq)]
pub struct StepFailure {
    /// Reason of the failure.
    pub reason: Reason,
    /// Time of the latest accepted state [s].
    pub time: f64,
    /// The step that was tried last [s].
    pub length: f64,
    /// The least step allowed [s].
    pub least: f64,
    /// The worst equation of the last iteration.
    pub worst: Worst,
    /// Its name.
    pub equation: Box<Name>,
    /// The local error of the step that was tried last, if it was too large.
    pub local_error: Option<Box<LocalError>>,
    /// Iterations of the step that was tried last.
    pub history: Vec<Iteration>,
}

/// A local error that is too large.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalError {
    /// The error, relative to the size of the model and in radians [-].
    pub error: f64,
    /// The tolerance [-].
    pub tolerance: f64,
    /// The unknown with the largest error as text: quantity, owner, error, and the reference of the
    /// error.
    pub unknown: String,
}

impl fmt::Display for StepFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (time, length, least) = (rounded(self.time), self.length, self.least);
        let (reason, equation) = (self.reason.words(), &self.equation);
        write!(
            f,
            "no step from {time} s: {reason} at a step of {length:.3e} s (least {least:.3e} s); "
        )?;
        if self.reason == Reason::Corners {
            return write!(f, "each of the last {MOST_CROWDED} steps ended at a corner");
        }
        match &self.local_error {
            Some(local) => write!(
                f,
                "largest error: {}, tolerance {:.3e}",
                local.unknown, local.tolerance
            ),
            None => {
                let off = equation.off_by(self.worst.relative, self.worst.scale);
                write!(f, "worst equation: {off}")
            }
        }
    }
}

impl std::error::Error for StepFailure {}
