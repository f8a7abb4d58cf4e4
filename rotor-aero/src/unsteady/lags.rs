//! The lag of circulation behind the normal velocity, from the wake of shed vortices.
//!
//! ```text
//! y_i' = (2 V / c) b_i (1 - M^2) (A_i w_34 - y_i) ,   i = 1, 2
//! w_E  = w_34 + g (y_1 + y_2 - (A_1 + A_2) w_34)
//! ```
//!
//! in two exponentials after [Jones1940]; the gate g switches the lag off at large angles and in
//! reverse flow. The lag acts on a velocity, so that it holds in a speed that varies.

use crate::real::Real;

use super::local::Local;
use super::section::{Constant, Strip};

/// Mach number from which the factor `1 - M^2` decays exponentially, and stays positive.
const TRANSONIC: f64 = 0.9;

/// Coefficients of the two exponentials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lags {
    /// Parts of the lift that lag, A \[-\].
    pub parts: [f64; 2],
    /// Rates per semichord travelled, b \[-\].
    pub rates: [f64; 2],
}

impl Lags {
    /// R. T. Jones's fit of Wagner's function: within .015 of Theodorsen's function up to a
    /// reduced frequency of 1.
    pub const JONES: Self = Self {
        parts: [0.165, 0.335],
        rates: [0.0455, 0.3],
    };
    /// W. P. Jones's fit of Wagner's function.
    pub const JONES_W: Self = Self {
        parts: [0.2048, 0.2952],
        rates: [0.0557, 0.333],
    };
    /// The fit of compressible indicial lift by Beddoes and Leishman. Its parts add up to 1: all
    /// lift lags, as impulsive lift is separate there. For comparison with other programs.
    pub const BEDDOES: Self = Self {
        parts: [0.3, 0.7],
        rates: [0.14, 0.53],
    };

    /// Its constants by their names in files.
    pub(super) fn constants(&mut self) -> [Constant<'_>; 4] {
        let ([a1, a2], [b1, b2]) = (&mut self.parts, &mut self.rates);
        [("A1", a1), ("A2", a2), ("b1", b1), ("b2", b2)]
    }

    /// The effective normal velocity.
    pub(super) fn effective<T: Real>(&self, local: &Local<T>, lags: [T; 2]) -> T {
        let delay = lags[0] + lags[1] - local.rear * (self.parts[0] + self.parts[1]);
        local.rear + local.gate * delay
    }

    /// The rates of the two states.
    pub(super) fn rates<T: Real>(
        &self,
        strip: &Strip,
        local: &Local<T>,
        mach: T,
        lags: [T; 2],
    ) -> [T; 2] {
        let scale = local.decay * compressible(mach) / strip.semichord();
        let rate = |i: usize| scale * (local.rear * self.parts[i] - lags[i]) * self.rates[i];
        [rate(0), rate(1)]
    }

    /// The states of a steady flow.
    pub(super) fn steady(&self, normal: f64) -> [f64; 2] {
        self.parts.map(|part| part * normal)
    }
}

/// `1 - M^2`, continued to a positive value beyond a Mach number near 1.
fn compressible<T: Real>(mach: T) -> T {
    if mach.re() < TRANSONIC {
        return -mach * mach + 1.0;
    }
    let end = 1.0 - TRANSONIC * TRANSONIC;
    ((mach - TRANSONIC) * (-2.0 * TRANSONIC / end)).exp() * end
}
