//! Limits of the iteration of a step, and of the steps that end at corners.

/// Largest number of successive steps that corners may make far shorter than wanted.
pub(super) const MOST_CROWDED: usize = 20_000;

/// Instants at which the Jacobian is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Jacobians {
    /// In every step, and again if the iteration slows down; in every iteration if the limits are
    /// near round-off.
    #[default]
    Full,
    /// If the iteration slows down or the step changes; otherwise the last one is kept and turns with
    /// the nodes.
    Modified,
}

/// Limits of the Newton iteration of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimits {
    /// Instants at which the Jacobian is computed.
    pub jacobians: Jacobians,
    /// Largest number of iterations.
    pub iterations: usize,
    /// Remaining correction at convergence, in sizes of the system [-].
    pub correction: f64,
    /// Remaining residual at convergence, relative to the largest term of its kind [-].
    pub residual: f64,
}

impl Default for StepLimits {
    fn default() -> Self {
        Self {
            jacobians: Jacobians::default(),
            iterations: 15,
            correction: 1e-9,
            residual: 1e-10,
        }
    }
}
