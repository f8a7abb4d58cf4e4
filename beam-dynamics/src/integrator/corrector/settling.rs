//! The end of the iteration of a step.

use super::{Corrector, Iteration, Jacobians, OF_KEPT, StepLimits};

/// Ratio of successive residuals above which the residual has reached round-off.
const STAGNATION: f64 = 0.5;

/// Ratio to the limit below which a residual or correction is only round-off.
const ROUND_OFF: f64 = 1e-3;

/// Part of the limits below which the residual and the error after a correction, estimated by the
/// decrease of the last two, need no further evaluation, if the Jacobian is kept over steps.
const ESTIMATED: f64 = 0.1;

impl Corrector {
    /// Ratio of the last correction to the one before it.
    pub(super) fn shrinking(&self) -> Option<f64> {
        match &self.history[self.first..] {
            [.., before, last] => Some(last.correction / before.correction),
            _ => None,
        }
    }

    /// Estimate of the remaining error with corrections that decrease by theta: theta / (1 -
    /// theta) times the last one; with full Newton steps it is smaller.
    fn left(&self, last: &Iteration) -> f64 {
        match self.shrinking() {
            Some(theta) if theta < 1.0 => theta / (1.0 - theta) * last.correction,
            Some(_) => f64::INFINITY,
            None => last.correction,
        }
    }

    /// Whether the last correction was found with the Jacobian of another iterate of the step.
    pub(super) fn is_with_kept(&self, limits: &StepLimits) -> bool {
        limits.jacobians == Jacobians::Full && self.kept.is_some_and(|kept| kept.uses > 1)
    }

    /// Whether the last correction, or over steps the error that it leaves, is so small that its
    /// residual need not be checked.
    pub(super) fn is_last(&self, size: f64, limits: &StepLimits) -> bool {
        if limits.jacobians == Jacobians::Modified && self.is_estimated_small(limits) {
            return true;
        }
        let (part, left) = match limits.jacobians {
            Jacobians::Full if self.is_with_kept(limits) => (OF_KEPT, size),
            Jacobians::Full => (ROUND_OFF, size),
            Jacobians::Modified => {
                let last = self.history[self.first..].last();
                (
                    ROUND_OFF,
                    last.map_or(size, |last| self.left(last).min(size)),
                )
            }
        };
        left <= part * limits.correction
    }

    /// Whether the residual and the error after the last correction are small if both decrease as
    /// they did before it: `r_2 (r_2/r_1)` and [`Self::left`].
    fn is_estimated_small(&self, limits: &StepLimits) -> bool {
        let [.., before, last] = &self.history[self.first..] else {
            return false;
        };
        let [before, now] = [before, last].map(|iteration| iteration.worst.relative);
        let residual = now * (now / before);
        residual <= ESTIMATED * limits.residual && self.left(last) <= ESTIMATED * limits.correction
    }

    /// Whether no further correction is needed.
    ///
    /// With high stiffness the round-off of the residual is above its limit: then a small
    /// correction is sufficient.
    pub(super) fn is_settled(&self, limits: &StepLimits) -> bool {
        let Some(last) = self.history[self.first..].last() else {
            return false;
        };
        let worst = self.worst.relative;
        let is_at_floor = worst >= STAGNATION * last.worst.relative;
        worst <= ROUND_OFF * limits.residual
            || !self.is_with_kept(limits)
                && worst <= limits.residual
                && self.left(last) <= limits.correction
            || is_at_floor && last.correction <= limits.correction
    }
}
