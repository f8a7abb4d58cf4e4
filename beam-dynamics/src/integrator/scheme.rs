//! Which formula integrates, with which steps.

/// A formula of integration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// Implicit Euler: first order, damps most.
    ImplicitEuler,
    /// Crank-Nicolson: second order, damps nothing.
    CrankNicolson,
    /// Backward differences of second order: [`Self::TwoStep`] of radius 0.
    Bdf2,
    /// Two steps, second order.
    TwoStep {
        /// Spectral radius for infinitely large steps, 0 to 1 [-].
        radius: f64,
    },
    /// Two stages, cubic interpolation: third order (fourth at radius 1).
    Cubic {
        /// Spectral radius for infinitely large steps, 0 to 1 [-].
        radius: f64,
    },
    /// Two stages, parabolic interpolation: third order at zeta = -2/3 (Radau IIA), else
    /// second.
    Parabolic {
        /// Place of the inner stage in the step, -1 to 0 [-].
        zeta: f64,
    },
    /// Cubic interpolation, weighted at Gauss' two points: fourth order, damps nothing.
    CubicGauss,
}

impl Scheme {
    /// Why the scheme is a poor choice for a system, in words; `None` when it is not.
    /// Multipliers make a system one with algebraic unknowns.
    pub fn warning(&self, _has_algebraic: bool) -> Option<&'static str> {
        None
    }
}

impl Default for Scheme {
    /// Two steps with the radius 0.6.
    fn default() -> Self {
        Self::TwoStep { radius: 0.6 }
    }
}

/// How the length of a step is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepping {
    /// Always the same, cut where the iteration fails.
    Constant {
        /// The step [s].
        step: f64,
    },
    /// By the local error and the iteration.
    Variable(StepControl),
}

/// Limits of variable steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepControl {
    /// First step [s].
    pub first: f64,
    /// Smallest step: below it the run fails [s].
    pub least: f64,
    /// Largest step [s].
    pub most: f64,
    /// Local error of a step, in sizes of the model and radians [-].
    pub tolerance: f64,
}
