//! Damping of modes that is round-off.
//!
//! A change of the stiffness by its round-off moves `s^2` by at most omega_0^2 of (D-284), in any
//! direction of the complex plane, and thereby s by `omega_0^2 / (2 |s|)`. The pair of the inverted
//! problem with the residual r is an exact one of a matrix that differs by r of its value, which moves
//! s by `r |s - sigma|`. Growth below the sum of both,
//!
//! ```text
//! |Re s| <= omega_0^2 / (2 |s|) + r |s - sigma|                                  (D-340)
//! ```
//!
//! is not distinguished from zero.

use faer::{Mat, c64};

use super::eigen::EigenProblem;
use super::eigenpair::Eigenpair;
use super::round_off::RoundOff;

/// Residual up to which round-off explains it. A larger one is reported as a loss of digits or is of
/// another vector, and does not hide damping.
const EXPLAINED: f64 = 1e-7;

impl EigenProblem<'_> {
    /// Takes growth that is round-off for zero.
    pub(super) fn clear_round_off(&self, pairs: &mut [Eigenpair]) {
        let round_off = RoundOff::new(self.tangent(), self.size());
        let shift = c64::new(self.inverse().shift(), 0.0);
        for pair in pairs {
            let s = pair.value();
            let vector = Mat::from_fn(self.size(), 2, |i, part| match part {
                0 => pair.real[i],
                _ => pair.imaginary[i],
            });
            let of_stiffness = round_off.frequency(&vector).powi(2) / (2.0 * s.norm());
            let of_vector = pair.residual.min(EXPLAINED) * (s - shift).norm();
            if pair.growth.abs() <= of_stiffness + of_vector {
                pair.growth = 0.0;
            }
        }
    }
}
