//! Growing oscillations, also beyond the requested modes.
//!
//! The tangent of elements with an energy is symmetric at rest, and these elements feed no energy
//! into an oscillation. If it is not symmetric, as for beams of finite volumes, high modes may have
//! negative damping without any drive, and a run that resolves them in time gains energy.

use crate::assembly::System;
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, Variable};
use crate::modes::{EigenProblem, Eigenpair};

/// Damping ratios above this are treated as zero, because of round-off.
const NO_DAMPING: f64 = -1e-8;
/// The possible cause.
const UNSYMMETRIC: &str = "the tangent of the model is not symmetric at rest, as with beams of \
                           formulation = \"finite-volume\" or with springs that are not relaxed \
                           in the undeformed model";
/// A tangent is symmetric up to this part of its largest entry.
const SYMMETRIC: f64 = 1e-9;

/// Remarks on oscillations that grow `at` a speed, among the listed `pairs` and, if the tangent is
/// not symmetric at rest, beyond them.
pub(super) fn remarks(
    problem: &EigenProblem<'_>,
    pairs: &[Eigenpair],
    is_symmetric: bool,
    at: &str,
) -> Vec<String> {
    let listed = pairs.iter().map(|pair| Growing {
        growth: pair.growth,
        angular_frequency: pair.angular_frequency,
    });
    let listed: Vec<_> = listed.collect();
    let highest = listed.last().map_or(0.0, |last| last.angular_frequency);
    let others = if is_symmetric {
        None
    } else {
        beyond(problem, highest, at)
    };
    let own = Growing::remark(&listed, at, "").map(|remark| {
        if is_symmetric {
            remark
        } else {
            format!("{remark}; {UNSYMMETRIC}")
        }
    });
    own.into_iter().chain(others).collect()
}

/// An oscillation, growing or not.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Growing {
    /// Real part of its eigenvalue [1/s].
    growth: f64,
    /// Imaginary part [rad/s].
    angular_frequency: f64,
}

impl Growing {
    fn damping_ratio(&self) -> f64 {
        -self.growth / self.growth.hypot(self.angular_frequency)
    }

    /// A remark on the growing ones of `found`, `at` a speed; `when` describes their range.
    fn remark(found: &[Self], at: &str, when: &str) -> Option<String> {
        let growing = found.iter().filter(|one| one.damping_ratio() < NO_DAMPING);
        let all: Vec<_> = growing.collect();
        let worst = all
            .iter()
            .min_by(|a, b| a.damping_ratio().total_cmp(&b.damping_ratio()))?;
        let hertz = worst.angular_frequency / (2.0 * std::f64::consts::PI);
        let ratio = worst.damping_ratio();
        let count = match all.len() {
            1 => "1 mode has".to_owned(),
            n => format!("{n} modes have"),
        };
        Some(format!(
            "{at} {count} negative damping{when}: the damping ratio is {ratio:.2e} at {hertz:.5} \
             Hz, and the oscillation grows"
        ))
    }
}

/// Whether the derivatives of the forces by the motions are symmetric in the undeformed model.
pub(super) fn is_symmetric_at_rest(system: &System) -> bool {
    let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
    let force = Equation::Force.row();
    let end = Variable::Rotation.column() + 3;
    let nodes = NODE_UNKNOWNS * system.nodes().len();
    let of_forces = tangent.by_unknowns.triplets().filter(|&(row, column, _)| {
        row.max(column) < nodes && row % NODE_UNKNOWNS >= force && column % NODE_UNKNOWNS < end
    });
    let pairs: Vec<_> = of_forces
        .map(|(row, column, value)| {
            let other = tangent.by_unknowns.entry(column + force, row - force);
            (value, value - other)
        })
        .collect();
    let largest = pairs
        .iter()
        .fold(0.0_f64, |most, pair| most.max(pair.0.abs()));
    pairs.iter().all(|pair| pair.1.abs() <= SYMMETRIC * largest)
}

/// A remark on oscillations that grow beyond the `known` angular frequencies, in a model
/// whose tangent is not symmetric.
fn beyond(problem: &EigenProblem<'_>, known: f64, at: &str) -> Option<String> {
    let Some(growing) = problem.growing(NO_DAMPING) else {
        return Some(format!(
            "{at} whether modes beyond the listed ones have negative damping is unknown for a \
             model of this size: {UNSYMMETRIC}"
        ));
    };
    let above = growing.into_iter().filter(|s| s.im > known);
    let found = above.map(|s| Growing {
        growth: s.re,
        angular_frequency: s.im,
    });
    let found: Vec<_> = found.collect();
    let remark = Growing::remark(&found, at, " beyond the listed ones")?;
    Some(format!("{remark}; {UNSYMMETRIC}"))
}
