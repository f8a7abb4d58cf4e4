//! Modes of a system, continued from the known ones of a similar system by inverse iteration.
//!
//! A pair of oscillations that becomes overdamped is continued by one of its two real values, and a real
//! value by an oscillation: the iteration begins beside the real axis, from which it could not leave it.

use faer::c64;

use super::copies::is_new;
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use super::shift::SHIFT;
use crate::assembly::{MasslessMotions, Tangent};
use crate::solver::LinearSolver;

/// Imaginary part beside a real value from which an iteration begins, as a part of the value.
const ASIDE: f64 = 0.1;
/// Imaginary part of a real value, as a part of its magnitude: round-off.
const REAL: f64 = 1e-6;
/// Largest change of a value as a part of it. Slow states of the air move a blade as a load does, in shapes
/// of bending, at other values.
const NEAR: f64 = 0.25;

impl<'a> EigenProblem<'a> {
    /// Prepares the modes near a `size` [1/s] that are known of a similar system; `None` as of [`Self::new`].
    pub fn near(
        solver: &'a LinearSolver,
        tangent: &'a Tangent,
        massless: &'a MasslessMotions,
        copies: usize,
        size: f64,
    ) -> Option<Self> {
        Self::shifted(solver, tangent, massless, copies, SHIFT * size)
    }

    /// The pairs of this system that continue `pairs` of a similar one, in their order: `None` if the
    /// overlap of the shapes is less than `least`, if the value is not near, or if a pair before has the
    /// same continuation.
    pub fn continued(&self, pairs: &[Eigenpair], least: f64) -> Vec<Option<Eigenpair>> {
        let mut known: Vec<Eigenpair> = Vec::new();
        let next = |pair: &Eigenpair| {
            let found = self.continuation(pair, least)?;
            let is_other = is_new(&found, &known);
            is_other.then(|| {
                known.push(found.clone());
                found
            })
        };
        pairs.iter().map(next).collect()
    }

    fn continuation(&self, pair: &Eigenpair, least: f64) -> Option<Eigenpair> {
        let value = pair.value();
        let first = match value.im == 0.0 {
            true => value + c64::new(0.0, ASIDE * value.norm()),
            false => value,
        };
        let found = self.refined((pair, first), least)?;
        let is_near = |s: c64| (s - value).norm() <= NEAR * value.norm();
        let is_near = is_near(found.value()) || is_near(found.value().conj());
        let mut found = Some(found).filter(|_| is_near)?;
        // The conjugate pair has the other sign.
        if found.angular_frequency < 0.0 {
            found.angular_frequency = -found.angular_frequency;
            found.imaginary.iter_mut().for_each(|part| *part = -*part);
        }
        if found.angular_frequency <= REAL * found.value().norm() {
            found.angular_frequency = 0.0;
        }
        Some(found)
    }
}
