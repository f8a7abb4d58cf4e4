//! Limits of the iteration of a step, and of the steps that end at corners.

/// Steps in a row that corners may make far shorter than wanted, at most.
pub(super) const MOST_CROWDED: usize = 20_000;

/// When the Jacobian is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Jacobians {
    /// In every step, and again where the iteration slows down; in every iteration where the
    /// limits are near round-off.
    #[default]
    Full,
    /// When the iteration slows down or the step changes; else the last one is kept.
    Modified,
}

/// Limits of the Newton iteration of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimits {
    /// When the Jacobian is computed.
    pub jacobians: Jacobians,
    /// Iterations at most.
    pub iterations: usize,
    /// What the iteration leaves of the correction, in sizes of the system [-].
    pub correction: f64,
    /// What it leaves of the residual, relative to the largest term of its kind [-].
    pub residual: f64,
}

impl Default for StepLimits {
    fn default() -> Self {
        Self {
            jacobians: Jacobians::Full,
            iterations: 15,
            correction: 1e-9,
            residual: 1e-10,
        }
    }
}
