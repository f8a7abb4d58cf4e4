//! Which formula integrates, with which steps.

use super::Formula;

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
    /// second; -1/2 is the parabola at Gauss' point.
    Parabolic {
        /// Place of the inner stage in the step, between -1 and 0 [-].
        zeta: f64,
    },
    /// Three stages, cubic interpolation at Gauss' two points: fourth order, damps nothing.
    CubicGauss,
}

impl Default for Scheme {
    /// Two steps with the radius 0.6.
    fn default() -> Self {
        Self::TwoStep { radius: 0.6 }
    }
}

/// An error of multipliers decays with the radius, step by step: above this one it takes
/// more than forty steps to lose one of its digits.
const HARDLY_DAMPED: f64 = 0.95;

/// Steps of a one-step formula may grow by this much at once; the prediction is a
/// polynomial through two steps, which does not reach farther.
const GROWTH: f64 = 2.0;

/// Growth of steps of the two-step formula: at most this, and this part of the way to the
/// bound of zero-stability.
const TWO_STEP_GROWTH: f64 = 1.5;
const PART_OF_BOUND: f64 = 0.8;

/// Growth of steps that are made by Crank-Nicolson, the two-step formula being at its
/// bound.
const LEAST_GROWTH: f64 = 1.2;

impl Scheme {
    /// Why the scheme is a poor choice for a system, in words; `None` when it is not.
    /// Multipliers make a system one with algebraic unknowns.
    pub fn warning(&self, has_algebraic: bool) -> Option<&'static str> {
        let does_not_damp = "this scheme does not damp the errors of multipliers: reactions of \
             constraints oscillate from step to step and do not converge";
        let hardly_damps = "at this radius the errors of multipliers hardly decay: reactions of \
             constraints oscillate from step to step";
        let off_center = "at this radius the multipliers do not converge when steps shrink: \
             reactions of constraints stay wrong";
        let diverges = "this scheme is for systems without constraints: its stages cannot \
             tell their multipliers apart, or these grow from step to step";
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

    /// The formula of a step of the given ratio to the one before, when nothing behind it
    /// is in the way.
    pub fn formula(&self, ratio: f64) -> Formula {
        match *self {
            Self::ImplicitEuler => Formula::implicit_euler(),
            Self::CrankNicolson => Formula::crank_nicolson(),
            Self::Bdf2 => Formula::two_step(0.0, ratio),
            // At this radius the formula has the factor z + 1 in all its terms: what is left
            // of it is Crank-Nicolson. With the factor, what alternates from step to step
            // is not damped, and rotations feed energy into it.
            Self::TwoStep { radius } if radius >= 1.0 => Formula::crank_nicolson(),
            Self::TwoStep { radius } => Formula::two_step(radius.max(0.0), ratio),
            Self::Cubic { radius } => Formula::cubic(radius.clamp(0.0, 1.0)),
            Self::Parabolic { zeta } => Formula::parabolic(zeta),
            Self::CubicGauss => Formula::cubic_gauss(),
        }
    }

    /// The formula of the first step, which knows the latest state alone: the two-step
    /// ones start by Crank-Nicolson. Where the rates of the state cannot be relied on,
    /// formulas that do without them take their place: implicit Euler, whose one step
    /// loses no order of second order formulas, or Radau IIA of as many stages.
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

    /// The largest ratio of a step to the one before at which the formula is zero-stable.
    pub fn largest_ratio(&self) -> f64 {
        match *self {
            Self::Bdf2 => Formula::largest_ratio(0.0),
            Self::TwoStep { radius } if radius < 1.0 => Formula::largest_ratio(radius.max(0.0)),
            _ => f64::INFINITY,
        }
    }

    /// How much longer the next step may be.
    pub(super) fn growth(&self) -> f64 {
        let bound = self.largest_ratio();
        if bound.is_infinite() && !matches!(self, Self::TwoStep { .. }) {
            return GROWTH;
        }
        let growth = TWO_STEP_GROWTH.min(1.0 + PART_OF_BOUND * (bound - 1.0));
        // Crank-Nicolson makes the step that the formula itself must not make.
        if growth < 1.0 + 0.5 * (LEAST_GROWTH - 1.0) {
            LEAST_GROWTH
        } else {
            growth
        }
    }
}

/// How the length of a step is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stepping {
    /// Always the same, cut where the iteration fails: to a thousandth at most.
    Constant {
        /// The step [s].
        step: f64,
    },
    /// By the local error and the iteration.
    Variable(StepControl),
}

impl Stepping {
    /// The step that is wanted where nothing is in its way, after a corner \[s\].
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
    /// Smallest step: below it the run fails [s].
    pub least: f64,
    /// Largest step [s].
    pub most: f64,
    /// Local error of a step, in sizes of the model and radians [-].
    pub tolerance: f64,
}
