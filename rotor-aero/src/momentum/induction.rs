//! Laws of highly loaded turbines: the induction factor where momentum alone fails.
//!
//! ```text
//! momentum       CT = 4 F a (1 - a)
//! Buhl, a > .4   CT = 8/9 + (4 F - 40/9) a + (50/9 - 4 F) a^2
//! HAWC2, a > 0   a = .0883 C^3 + .0586 C^2 + .2460 C,  C = CT / F
//!        a <= 0  C = 4 a (1.0163 - a)
//! ```
//!
//! Buhl, NREL/TP-500-36834 (2005); Ning, Wind Energy 17 (2014) 1327, for the solution by
//! `k = sigma cn / (4 F sin^2 phi)`; Madsen et al., Wind Energy Science 5 (2020) 1, for the
//! polynomial. Its slope at `a = 0` is not the one of momentum, 1 / 4: without the constant 1 / (4 * .2460)
//! for negative loads the mass flow would jump there. Here `a`, `k` and `CT` have the signs of turbines.

use crate::real::Real;

/// Law for an induction factor beyond .4.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum HighInduction {
    /// Buhl's parabola with the factor of loss inside: CT is 2 at `a = 1`, whatever the loss. For
    /// comparison with programs that use it; it jumps in hover where `F < .69`.
    Buhl,
    /// Buhl's parabola without loss, times the factor of loss: CT tends to zero with it, and the
    /// law is continuous in hover.
    #[default]
    BuhlOutside,
    /// The polynomial of HAWC2, for all positive loads; momentum with its slope for negative ones.
    Polynomial,
    /// Momentum alone, for comparison.
    Momentum,
}

/// Coefficients of the polynomial, from the cube down.
const CUBIC: [f64; 3] = [0.0883, 0.0586, 0.2460];

/// CT / (4 F a) of the polynomial at `a = 0` \[-\].
const AT_ZERO: f64 = 0.25 / CUBIC[2];

/// The induction factor above which Buhl's law holds \[-\].
pub(crate) const SWITCH: f64 = 0.4;

impl HighInduction {
    /// Thrust coefficient of a ring at the induction factor `a` and the factor of loss.
    pub fn thrust<T: Real>(self, a: T, loss: T) -> T {
        loss * a * self.slope(a, loss) * 4.0
    }

    /// CT / (4 F a), of momentum `1 - a`.
    pub(crate) fn slope<T: Real>(self, a: T, loss: T) -> T {
        match self {
            Self::Polynomial if a.re() <= 0.0 => T::from(AT_ZERO) - a,
            Self::Polynomial => {
                let c = cubic_root(a);
                ((c * CUBIC[0] + CUBIC[1]) * c + CUBIC[2]).recip() * 0.25
            }
            Self::Buhl if a.re() > SWITCH => parabola(a, loss) / (loss * a * 4.0),
            Self::BuhlOutside if a.re() > SWITCH => parabola(a, T::from(1.0)) / (a * 4.0),
            _ => T::from(1.0) - a,
        }
    }

    /// Induction factor at the thrust coefficient `ct` and the factor of loss: the inverse of
    /// [`HighInduction::thrust`]. Momentum alone has no solution above `ct = F`: there it is 1/2.
    pub fn factor(self, ct: f64, loss: f64) -> f64 {
        let local = ct / loss;
        let momentum = 2.0 * SWITCH * (1.0 - SWITCH) * 2.0;
        let below = |at_zero: f64| 0.5 * (at_zero - (at_zero * at_zero - local).max(0.0).sqrt());
        match self {
            Self::Polynomial if local > 0.0 => polynomial(local),
            Self::Polynomial => below(AT_ZERO),
            Self::Buhl if local > momentum => inverse_parabola(ct, loss),
            Self::BuhlOutside if local > momentum => inverse_parabola(local, 1.0),
            _ => below(1.0),
        }
    }

    /// Induction factor of a turbine at `k = sigma cn / (4 F sin^2 phi)`; `forward`: the air passes
    /// the disk in the direction of Vx, `a < 1`.
    pub(crate) fn factor_by(self, k: f64, loss: f64, forward: bool) -> f64 {
        match self {
            Self::Buhl if k > 2.0 / 3.0 => buhl(k, loss),
            Self::BuhlOutside if k > 2.0 / 3.0 => buhl(k, 1.0),
            Self::Polynomial if k > 0.0 && forward => polynomial_from_k(k),
            Self::Polynomial if k > -1.0 && forward => negative_from_k(k),
            _ => k / (1.0 + k),
        }
    }
}

fn parabola<T: Real>(a: T, loss: T) -> T {
    let linear = loss * 4.0 - 40.0 / 9.0;
    let square = -loss * 4.0 + 50.0 / 9.0;
    (square * a + linear) * a + 8.0 / 9.0
}

/// The larger root of the parabola.
fn inverse_parabola(ct: f64, loss: f64) -> f64 {
    let (linear, square) = (4.0 * loss - 40.0 / 9.0, 50.0 / 9.0 - 4.0 * loss);
    let root = (linear * linear - 4.0 * square * (8.0 / 9.0 - ct))
        .max(0.0)
        .sqrt();
    (root - linear) / (2.0 * square)
}

/// Buhl's factor by `k`, on the branch that contains `a = .4`.
fn buhl(k: f64, loss: f64) -> f64 {
    let double = 2.0 * loss * k;
    let g1 = double - (10.0 / 9.0 - loss);
    let g2 = (double - loss * (4.0 / 3.0 - loss)).max(0.0);
    let g3 = double - (25.0 / 9.0 - 2.0 * loss);
    if g3.abs() < 1e-6 {
        return 1.0 - 0.5 / g2.sqrt();
    }
    (g1 - g2.sqrt()) / g3
}

fn polynomial<T: Real>(c: T) -> T {
    ((c * CUBIC[0] + CUBIC[1]) * c + CUBIC[2]) * c
}

fn cubic_slope<T: Real>(c: T) -> T {
    (c * (3.0 * CUBIC[0]) + 2.0 * CUBIC[1]) * c + CUBIC[2]
}

/// The load C at which the polynomial is `a >= 0`: it is monotone. Newton's method for the value,
/// and two steps more that carry derivatives up to the third.
fn cubic_root<T: Real>(a: T) -> T {
    let target = a.re();
    let mut c = (4.0 * target).min(3.0);
    for _ in 0..40 {
        let step = (polynomial(c) - target) / cubic_slope(c);
        c -= step;
        if step.abs() < 1e-15 * (1.0 + c.abs()) {
            break;
        }
    }
    let refined = |c: T| c - (polynomial(c) - a) / cubic_slope(c);
    refined(refined(T::from(c)))
}

/// The factor at which the polynomial of `C = 4 k (1 - a)^2` is `a`, between 0 and 1.
fn polynomial_from_k(k: f64) -> f64 {
    // by the square root of C: a = 1 - sqrt(C / 4k), monotone in it
    let scale = (4.0 * k).sqrt().recip();
    let mut q = 1.0 / (scale + 1.0);
    for _ in 0..60 {
        let residual = polynomial(q * q) - 1.0 + q * scale;
        let step = residual / (2.0 * q * cubic_slope(q * q) + scale);
        q = (q - step).max(0.5 * q);
        if step.abs() < 1e-15 * (1.0 + q) {
            break;
        }
    }
    1.0 - q * scale
}

/// The root of `a (AT_ZERO - a) = k (1 - a)^2` that is zero at `k = 0`, for `-1 < k <= 0`.
fn negative_from_k(k: f64) -> f64 {
    let half = 2.0 * k + AT_ZERO;
    2.0 * k / (half + (half * half - 4.0 * k * (1.0 + k)).sqrt())
}

#[cfg(test)]
#[path = "induction_tests.rs"]
mod tests;
