//! The local errors of a trial step.

use super::super::lengths::factor;
use super::super::prediction::error_of_value;
use super::{Dae, Formula, Integrator, Plan, Speeds, Stepping};

/// Local errors of a trial step relative to the tolerance [-].
#[derive(Debug, Clone, Copy)]
pub(super) struct Errors {
    /// Of positions and rotations.
    pub positions: f64,
    /// Of velocities.
    pub speeds: f64,
}

impl Errors {
    /// The larger; NaN if one is NaN. A force that jumps without end must not end a run: at the
    /// least step the positions alone are used.
    pub fn counted(&self, is_least: bool) -> f64 {
        if is_least || self.speeds <= self.positions || self.positions.is_nan() {
            self.positions
        } else {
            self.speeds
        }
    }

    /// Ratio of the next step to this one that both allow; `order` is the order of the formula.
    pub fn allowed(&self, order: usize) -> f64 {
        factor(self.positions, order).min(factor(self.speeds, Speeds::ORDER))
    }
}

impl Integrator {
    /// The local error of the trial step relative to the tolerance, if steps are variable and
    /// enough previous states exist: from the value y predicted by a polynomial of the same order
    /// p, with the constants C of the formula and C_p of the polynomial,
    ///
    /// ```text
    /// y(t_n) - y_n = C / (C_p - C) ( y_n - y )                                   (D-116)
    /// ```
    ///
    /// and the local error (D-119) of the velocities and scalars. Scalars are included from the
    /// first step on, with a polynomial of first order while there are too few previous states.
    pub(super) fn errors(
        &mut self,
        dae: &dyn Dae,
        formula: &Formula,
        plan: &Plan,
    ) -> Option<Errors> {
        let Stepping::Variable(control) = &self.stepping else {
            return None;
        };
        let order = formula.order.min(3);
        let states = if order == 1 { 1 } else { 2 };
        if self.progress.known == 0 {
            return None;
        }
        let is_known = self.progress.known >= states;
        let order = if is_known { order } else { 1 };
        let ratio = match order {
            1 => 1.0,
            _ => self.ratio(plan.length),
        };
        let constant = formula.counted_constant();
        let factor = constant / (error_of_value(order, ratio) - constant);
        let moved = self.corrector.moved().iter().zip(&self.end);
        self.difference.clear();
        let difference = moved.enumerate().map(|(i, (moved, predicted))| {
            if dae.algebraic()[i] {
                0.0
            } else {
                let polynomial = self.past.value(order, plan.length, ratio, i);
                factor * (moved + predicted - polynomial)
            }
        });
        self.difference.extend(difference);
        let of_speeds = (self.progress.speeds).error(dae, formula, plan.end, plan.length);
        let speeds = match of_speeds {
            Some(error) => error,
            None => dae.error_of_scalars(formula.stages - 1, &self.difference),
        };
        let positions = if is_known {
            dae.error(&self.difference)
        } else {
            0.0
        };
        let [positions, speeds] = [positions, speeds].map(|error| error / control.tolerance);
        // Steps do not grow while too few previous states are known.
        (is_known || speeds > 1.0).then_some(Errors { positions, speeds })
    }
}
