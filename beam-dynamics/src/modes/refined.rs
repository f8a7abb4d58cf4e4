//! A mode of a system, from its shape in a similar one, by inverse iteration with a changing shift
//!
//! ```text
//! y = (F_y + sigma F_y')^-1 F_y' x        mu = <x, y> / <x, x>        s = sigma - 1 / mu
//! ```
//!
//! which keeps the shape while the value converges.

use faer::c64;

use super::copies::{CONFIRMED, orthonormalize, product};
use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;

/// Corrections of one value.
const CORRECTIONS: usize = 12;
/// Corrections at the shift of the start, so that the shape determines the mode.
const HELD: usize = 2;
/// Change of a value, relative, at which its correction ends.
const CONVERGED: f64 = 1e-10;
/// Parts of a value between which its shift is, so that the matrix is never singular.
const BESIDE: f64 = 1e-7;

impl EigenProblem<'_> {
    /// The pair of the system that has the shape of `pair`, from a first value, with an overlap
    /// of at least `least`, which may not oscillate; `None` if the iteration leaves this shape.
    pub(super) fn refined(
        &self,
        (pair, first): (&Eigenpair, c64),
        least: f64,
    ) -> Option<Eigenpair> {
        let size = self.size();
        let all = self.tangent().by_rates.pattern().size();
        let mut start = pair.vector();
        start.resize(all, c64::new(0.0, 0.0));
        orthonormalize(std::slice::from_mut(&mut start), size);
        let mut vector = start.clone();
        let mut value = first;
        for step in 0..CORRECTIONS {
            let near = if step < HELD { first } else { value };
            let shift = near * (1.0 + BESIDE);
            let mut next = self.rates_times(&vector);
            self.factorized(shift)?.solve(&mut next)?;
            let factor = product(&vector, &next, size);
            orthonormalize(std::slice::from_mut(&mut next), size);
            let found = shift - factor.inv();
            vector = next;
            if !found.is_finite() {
                return None;
            }
            let change = (found - value).norm();
            value = found;
            if step > HELD && change <= CONVERGED * value.norm() {
                break;
            }
        }
        if product(&start, &vector, size).norm() < least {
            return None;
        }
        let residual = self.inverse().residual(value, &vector);
        let corrected = Eigenpair::new(value, &vector[..size], residual);
        (residual <= CONFIRMED).then_some(corrected)
    }
}
