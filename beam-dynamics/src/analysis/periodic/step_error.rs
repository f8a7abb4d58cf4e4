//! Error of the exponents by the steps, from the rule of the steps alone.
//!
//! A motion `exp(i w t)` is multiplied by R(z), z = i w h, in a step h of Radau IIA with s stages, so that its exponent
//! has the error
//!
//! ```text
//! | ln R(z) - z | / h                                                               (D-451)
//! R = (1 + z/3) / (1 - 2 z/3 + z^2/6)                                       two stages
//! R = (1 + 2 z/5 + z^2/20) / (1 - 3 z/5 + 3 z^2/20 - z^3/60)                three stages
//! ```
//!
//! A period with half the steps resolves fast motions as little as the one with all: their difference states no error.

use std::f64::consts::TAU;

use nalgebra::Complex;

/// Error of the exponent of a motion of an angular frequency \[rad/s\] in steps \[s\] of two or three stages \[1/s\].
pub(super) fn step_error(frequency: f64, step: f64, stages: usize) -> f64 {
    let z = Complex::new(0.0, frequency * step);
    let polynomial = |factors: &[f64]| {
        let sum = |sum: Complex<f64>, factor: &f64| sum * z + factor;
        factors.iter().rev().fold(Complex::new(0.0, 0.0), sum)
    };
    let ratio = match stages {
        2 => polynomial(&[1.0, 1.0 / 3.0]) / polynomial(&[1.0, -2.0 / 3.0, 1.0 / 6.0]),
        _ => {
            let below = polynomial(&[1.0, -0.6, 0.15, -1.0 / 60.0]);
            polynomial(&[1.0, 0.4, 0.05]) / below
        }
    };
    // The branch of the logarithm next to z.
    let turn = ((z.im - ratio.arg()) / TAU).round() * TAU;
    (ratio.ln() + Complex::new(0.0, turn) - z).norm() / step
}

#[cfg(test)]
mod tests {
    use super::*;

    // The leading terms: z^4/72 with two stages and z^6/7200 with three, of a frequency 1 (Hairer and Wanner, Solving
    // Ordinary Differential Equations II, table IV.5.6: orders 3 and 5); the rest is of the relative size (w h)^1. A
    // motion that is not resolved has an error of the size of its frequency.
    #[test]
    fn errors_have_the_order_of_the_rule() {
        for (stages, power, constant) in [(2, 4, 72.0), (3, 6, 7200.0)] {
            for step in [0.2, 0.1, 0.05] {
                let expected = f64::powi(step, power) / constant / step;
                let found = step_error(1.0, step, stages);
                assert!(
                    (found / expected - 1.0).abs() < step,
                    "{stages} {step}: {found}"
                );
                let faster = step_error(3.0, step / 3.0, stages);
                assert!((faster / found - 3.0).abs() < 1e-6);
            }
            let lost = step_error(1.0, 6.0, stages);
            assert!(lost > 0.1 && lost < 2.0, "{lost}");
        }
    }
}
