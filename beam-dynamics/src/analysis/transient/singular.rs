//! Singular positions that a run passes.
//!
//! If the derivatives of the constraints lose rank at one instant, as at a dead point, the motion
//! continues but reactions are undetermined. Round-off of positions, `e` of the size of the model,
//! changes the multipliers by
//!
//! ```text
//! dlambda = - (J^-1)_(lambda lambda) e                                           (D-155)
//! ```
//!
//! J being the Jacobian of the step: about e m / h^2 in a regular position, and unbounded in a
//! singular one.

use shared_geom::units::rounded;

use crate::assembly::System;
use crate::integrator::Integrator;
use crate::model::{NODE_UNKNOWNS, State};

/// Round-off of a constraint, in sizes of the model and radians.
const ROUND_OFF: f64 = 1e-15;
/// Fraction of the largest reaction that round-off may change.
const UNSURE: f64 = 1e-3;
/// Number of positions that are reported individually.
const MOST_REPORTED: usize = 3;

/// Singular positions that a run has passed.
#[derive(Debug, Clone, Default)]
pub(super) struct Passed {
    /// The least accurate reaction, its change by round-off, and the time \[s\].
    reported: Vec<(String, f64)>,
    count: usize,
    right: Vec<f64>,
}

impl Passed {
    /// Checks the latest step of `integrator`, given the accepted states, the latest first.
    pub fn watch(&mut self, system: &System, states: &[State], integrator: &mut Integrator) {
        let [state, before, ..] = states else {
            return;
        };
        let first = NODE_UNKNOWNS * state.nodes.len();
        if state.multipliers.is_empty() || !integrator.is_doubtful() {
            return;
        }
        self.right.clear();
        self.right.resize(first + state.multipliers.len(), 0.0);
        let off = ROUND_OFF * system.size().min(1.0);
        for (i, value) in self.right[first..].iter_mut().enumerate() {
            // Signs without a pattern, unlike the constraints of a mechanism.
            let sign = (i.wrapping_mul(2_654_435_761) >> 7) & 1;
            *value = if sign == 0 { off } else { -off };
        }
        if integrator.response(&mut self.right).is_none() {
            return;
        }
        // The latest multipliers may be only the error.
        let before = before.multipliers.iter();
        let largest = before.fold(0.0_f64, |most, one| most.max(one.abs()));
        let changes = self.right[first..].iter().map(|change| change.abs());
        let most = changes.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((constraint, change)) = most else {
            return;
        };
        if change <= UNSURE * largest || largest == 0.0 {
            return;
        }
        self.count += 1;
        if self.reported.len() < MOST_REPORTED {
            let reaction = system.unknown(first + constraint);
            let text = format!("{reaction}, by {change:.1e} {}", reaction.unit);
            self.reported.push((text, integrator.time()));
        }
    }

    /// Remarks for the user.
    pub fn remarks(&self) -> Vec<String> {
        let remark = |(reaction, time): &(String, f64)| {
            let time = rounded(*time);
            format!(
                "at t = {time} s the constraints are in a singular position, or nearly so: \
                 reactions of this step are not determined (round-off changes most: {reaction}); \
                 choose time steps that do not end there"
            )
        };
        let mut remarks: Vec<_> = self.reported.iter().map(remark).collect();
        if self.count > self.reported.len() {
            let more = self.count - self.reported.len();
            remarks.push(format!("{more} more steps end in singular positions"));
        }
        remarks
    }
}
