//! The end of the iteration of a step.

use super::{Corrector, FLOOR, Iteration, OF_KEPT, StepLimits};

/// Ratio of successive residuals above which the residual has reached round-off.
const STAGNATION: f64 = 0.5;

/// Ratio to the limit below which a residual or correction is only round-off.
const ROUND_OFF: f64 = 1e-3;

/// Size of corrections of full Newton below which the next one is of the size of round-off: their errors are squared
/// [sizes of the system].
const SMALL: f64 = 1e-9;

/// Ratio to the limit below which the error that a correction with a Jacobian of an earlier step leaves
/// needs no further one: a correction of [`OF_KEPT`] of the limit, of which the next is a tenth, leaves
/// as much.
const LEFT: f64 = 1e-3;

/// The same of the residual.
const RESIDUAL_LEFT: f64 = 1e-2;

impl Corrector {
    /// Ratio of the last correction to the one before it.
    pub(super) fn shrinking(&self) -> Option<f64> {
        match &self.history[self.first..] {
            [.., before, last] => Some(last.correction / before.correction),
            _ => None,
        }
    }

    /// Estimate of the remaining error with corrections that decrease by theta: theta / (1 - theta)
    /// times the last one; with full Newton steps it is smaller. With a Jacobian of an earlier step
    /// theta is the larger of the last two ratios.
    fn left(&self, last: &Iteration) -> f64 {
        let before = match &self.history[self.first..] {
            [.., first, second, _] if self.is_of_past() => second.correction / first.correction,
            _ => 0.0,
        };
        match self.shrinking().map(|theta| theta.max(before)) {
            Some(theta) if theta < 1.0 => theta / (1.0 - theta) * last.correction,
            Some(_) => f64::INFINITY,
            None => last.correction,
        }
    }

    /// Whether the last correction was found with the Jacobian of an earlier step.
    fn is_of_past(&self) -> bool {
        self.kept.is_some_and(|kept| !kept.is_of_this_step)
    }

    /// Whether the last correction was found with the Jacobian of another iterate.
    fn is_with_kept(&self) -> bool {
        self.kept.is_some_and(|kept| kept.uses > 1) || self.is_of_past()
    }

    /// Whether the last correction, or the error that it leaves, is so small that its residual need not
    /// be checked.
    pub(super) fn is_last(&self, size: f64, limits: &StepLimits) -> bool {
        if !self.is_with_kept() {
            return size <= ROUND_OFF * limits.correction;
        }
        if !self.is_of_past() {
            return size <= OF_KEPT * limits.correction;
        }
        let last = self.history[self.first..].last();
        let left = last.map_or(size, |last| self.left(last));
        left <= (LEFT * limits.correction).max(FLOOR) && self.is_residual_small(limits)
    }

    /// Whether the residual after the last correction is small if it decreases as it did before it:
    /// `r_2 (r_2/r_1)`.
    fn is_residual_small(&self, limits: &StepLimits) -> bool {
        let [.., before, last] = &self.history[self.first..] else {
            return false;
        };
        let [before, now] = [before, last].map(|iteration| iteration.worst.relative);
        now * (now / before) <= (RESIDUAL_LEFT * limits.residual).max(FLOOR)
    }

    /// Whether the last correction has not reduced the residual.
    pub(super) fn is_at_floor(&self) -> bool {
        let last = self.history[self.first..].last();
        last.is_some_and(|last| self.worst.relative >= STAGNATION * last.worst.relative)
    }

    /// Whether no further correction is needed.
    ///
    /// With high stiffness the round-off of the residual is above its limit: then a small
    /// correction is sufficient. A residual that a Jacobian of an earlier step does not reduce may be
    /// in a direction in which that Jacobian is wrong.
    pub(super) fn is_settled(&self, limits: &StepLimits) -> bool {
        let Some(last) = self.history[self.first..].last() else {
            return false;
        };
        let worst = self.worst.relative;
        let least = if self.is_of_past() {
            FLOOR
        } else {
            limits.correction
        };
        worst <= ROUND_OFF * limits.residual
            || !self.is_with_kept()
                && worst <= limits.residual
                && self.left(last) <= limits.correction
            || self.is_at_floor() && last.correction <= least
            || worst <= limits.residual && self.is_round_off()
    }

    /// Whether the last correction of full Newton is round-off: the one before it was so small that it is none of another
    /// kind, and it is as large.
    fn is_round_off(&self) -> bool {
        match &self.history[self.first..] {
            [.., before, last] if !self.is_with_kept() => {
                before.correction <= SMALL && last.correction >= STAGNATION * before.correction
            }
            _ => false,
        }
    }
}
