//! Integration scheme and its time steps.

use super::Formula;

/// An integration scheme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// Implicit Euler: first order, largest damping.
    ImplicitEuler,
    /// Crank-Nicolson: second order, no damping.
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
    /// second; -1/2 is the parabola at Gauss' point.
    Parabolic {
        /// Position of the inner stage in the step, between -1 and 0 [-].
        zeta: f64,
    },
    /// Three stages, cubic interpolation at Gauss' two points: fourth order, no damping.
    CubicGauss,
}

impl Default for Scheme {
    /// Two steps with the radius 0.6.
    fn default() -> Self {
        Self::TwoStep { radius: 0.6 }
    }
}

/// Errors of multipliers are multiplied by the radius in each step: above this radius they need
/// more than forty steps to decrease by one digit.
const HARDLY_DAMPED: f64 = 0.95;

/// Largest growth of the step of one-step schemes: the prediction is a polynomial through two
/// steps, which is inaccurate beyond.
const GROWTH: f64 = 2.0;

/// Growth of steps of the two-step scheme: at most this, and this fraction of the way to the bound
/// of zero-stability.
const TWO_STEP_GROWTH: f64 = 1.5;
const PART_OF_BOUND: f64 = 0.8;

/// Growth of steps that are made by Crank-Nicolson when the two-step scheme is at its bound.
const LEAST_GROWTH: f64 = 1.2;

impl Scheme {
    /// Reason why the scheme is a poor choice for a system; `None` if it is not. A system with
    /// multipliers has algebraic unknowns.
    pub fn warning(&self, has_algebraic: bool) -> Option<&'static str> {
        let does_not_damp = "this scheme does not damp the errors of multipliers: reactions of \
             constraints oscillate from step to step and do not converge";
        let hardly_damps = "at this radius the errors of multipliers hardly decay: reactions of \
             constraints oscillate from step to step";
        let off_center = "at this radius the multipliers do not converge when steps shrink: \
             reactions of constraints stay wrong";
        let diverges = "this scheme is for systems without constraints: its stages do not \
             determine the multipliers, or these grow from step to step";
        let warning = match *self {
            Self::CubicGauss => diverges,
            Self::CrankNicolson => does_not_damp,
            Self::TwoStep { radius } if radius >= 1.0 => does_not_damp,
            Self::Cubic { radius } if radius >= 1.0 => off_center,
            Self::TwoStep { radius } | Self::Cubic { radius } if radius > HARDLY_DAMPED => {
                hardly_damps
            }
            _ => return None,
        };
        has_algebraic.then_some(warning)
    }

    /// The formula of a step of the given ratio to the previous one, if the previous states permit it.
    pub fn formula(&self, ratio: f64) -> Formula {
        match *self {
            Self::ImplicitEuler => Formula::implicit_euler(),
            Self::CrankNicolson => Formula::crank_nicolson(),
            Self::Bdf2 => Formula::two_step(0.0, ratio),
            // At this radius the formula has the factor z + 1 in all its terms; without it,
            // Crank-Nicolson remains. With the factor, errors that alternate from step to step are
            // not damped, and rotations feed energy into them.
            Self::TwoStep { radius } if radius >= 1.0 => Formula::crank_nicolson(),
            Self::TwoStep { radius } => Formula::two_step(radius.max(0.0), ratio),
            Self::Cubic { radius } => Formula::cubic(radius.clamp(0.0, 1.0)),
            Self::Parabolic { zeta } => Formula::parabolic(zeta),
            Self::CubicGauss => Formula::cubic_gauss(),
        }
    }

    /// The formula of the first step, which uses the latest state alone: two-step schemes start
    /// with Crank-Nicolson. If the rates of the state are not reliable, formulas without them are
    /// used: implicit Euler, which keeps second order because it makes a single step, or Radau IIA
    /// with the same number of stages.
    pub fn first_formula(&self, has_rates: bool) -> Formula {
        match (self, has_rates) {
            (Self::ImplicitEuler, _) => Formula::implicit_euler(),
            (Self::CrankNicolson | Self::Bdf2 | Self::TwoStep { .. }, true) => {
                Formula::crank_nicolson()
            }
            (Self::CrankNicolson | Self::Bdf2 | Self::TwoStep { .. }, false) => {
                Formula::implicit_euler()
            }
            (Self::Cubic { .. }, false) => Formula::parabolic(-2.0 / 3.0),
            (Self::CubicGauss, false) => Formula::radau_three(),
            _ => self.formula(1.0),
        }
    }

    /// The largest ratio of a step to the previous one at which the scheme is zero-stable.
    pub fn largest_ratio(&self) -> f64 {
        match *self {
            Self::Bdf2 => Formula::largest_ratio(0.0),
            Self::TwoStep { radius } if radius < 1.0 => Formula::largest_ratio(radius.max(0.0)),
            _ => f64::INFINITY,
        }
    }

    /// Largest ratio of the next step to this one.
    pub(super) fn growth(&self) -> f64 {
        let bound = self.largest_ratio();
        if bound.is_infinite() && !matches!(self, Self::TwoStep { .. }) {
            return GROWTH;
        }
        let growth = TWO_STEP_GROWTH.min(1.0 + PART_OF_BOUND * (bound - 1.0));
        // Crank-Nicolson makes a step for which the scheme is not zero-stable.
        if growth < 1.0 + 0.5 * (LEAST_GROWTH - 1.0) {
            LEAST_GROWTH
        } else {
            growth
        }
    }
}

/// Choice of the time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepping {
    /// Constant; reduced if the iteration fails, to a thousandth at least.
    Constant {
        /// The step [s].
        step: f64,
    },
    /// Chosen from the local error and the iterations.
    Variable(StepControl),
}

impl Stepping {
    /// The step wanted after a corner, if nothing limits it \[s\].
    pub(super) fn wanted(&self) -> f64 {
        match self {
            Self::Constant { step } => *step,
            Self::Variable(control) => control.first,
        }
    }
}

/// Limits of variable steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepControl {
    /// First step, also after a corner [s].
    pub first: f64,
    /// Smallest step; if it fails, the run fails [s].
    pub least: f64,
    /// Largest step [s].
    pub most: f64,
    /// Local error of a step, relative to the size of the model and in radians [-].
    pub tolerance: f64,
}
