//! The effort of a run.

use crate::integrator::Counters;
use crate::result::Effort;

/// The effort of the steps, for the results.
pub(super) fn effort(counters: &Counters, output_time: f64) -> Effort {
    Effort {
        steps: counters.steps,
        rejected: counters.rejected,
        iterations: counters.iterations,
        jacobians: counters.jacobians,
        pivotings: counters.pivotings,
        least_step: counters.least_step,
        most_step: counters.most_step,
        prediction_time: counters.prediction_time,
        residual_time: counters.residual_time,
        jacobian_time: counters.jacobian_time,
        factorization_time: counters.factorization_time,
        solution_time: counters.solution_time,
        output_time,
        ..Effort::default()
    }
}
