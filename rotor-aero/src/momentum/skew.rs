//! Skew of the wake under yaw and tilt: a factor on the induced velocity.
//!
//! ```text
//! chi = (1 + .6 a) chi0,  factor = 1 + K F (r/R) tan(chi/2) cos(psi - psi_d),  K = 15 pi / 32
//! ```
//!
//! Pitt and Peters, Vertica 5 (1981) 21, for `K`; Burton et al., Wind Energy Handbook, for `chi`.
//! The factor multiplies `u` after the solution: blades that point downwind have more induction.
//! Above 30 degrees of yaw its error exceeds 10 %.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::real::Real;

/// Angle of the wake to the shaft at the angle `chi0` of the wind to the shaft and the induction
/// factor of the rotor (of turbines, positive if the air slows down), between -pi/2 and pi/2.
pub fn wake_skew<T: Real>(wind_skew: T, induction: T) -> T {
    let skew = wind_skew * (induction * 0.6 + 1.0);
    if skew.re().abs() > FRAC_PI_2 {
        return T::from(FRAC_PI_2.copysign(skew.re()));
    }
    skew
}

/// Factor on the induced velocity of a blade at `azimuth` from the direction in which the wake
/// leaves (`psi - psi_d`), at the radius over the tip radius. With `loss` absent the factor does
/// not contain the loss at the ends.
pub fn skew_factor<T: Real>(skew: T, radius_ratio: f64, azimuth: T, loss: Option<T>) -> T {
    let loss = loss.unwrap_or_else(|| T::from(1.0));
    let amplitude = (skew * 0.5).tan() * (15.0 * PI / 32.0 * radius_ratio);
    loss * amplitude * azimuth.cos() + 1.0
}

#[cfg(test)]
mod tests {
    use num_dual::Dual64;

    use super::*;

    #[test]
    fn closed_values() {
        let skew = wake_skew(0.5f64, 0.3);
        assert!((skew - 0.59).abs() < 1e-15);
        assert_eq!(wake_skew(-2.0, 0.3), -FRAC_PI_2);
        let downwind = skew_factor(FRAC_PI_2, 1.0, 0.0, None);
        assert!((downwind - 1.0 - 15.0 * PI / 32.0 * (PI / 4.0).tan()).abs() < 1e-15);
        let half = skew_factor(FRAC_PI_2, 1.0, 0.0, Some(0.5));
        assert!((half - 1.0 - 0.5 * (downwind - 1.0)).abs() < 1e-15);
    }

    #[test]
    fn the_mean_over_the_azimuth_is_one() {
        let sum: f64 = (0..36)
            .map(|step| skew_factor(0.7, 0.8, PI * f64::from(step) / 18.0, None))
            .sum();
        assert!((sum / 36.0 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn derivatives_are_exact() {
        let dual = |x: f64| Dual64::from(x).derivative();
        for step in 0..200 {
            let x = -1.2 + 0.0117 * f64::from(step);
            let at =
                |x: f64| skew_factor(wake_skew(x, 0.2 * x), 0.7, 3.0 * x, Some(0.9 + 0.05 * x));
            let wake = wake_skew(dual(x), dual(x) * 0.2);
            let exact = skew_factor(wake, 0.7, dual(x) * 3.0, Some(dual(x) * 0.05 + 0.9));
            let central = (at(x + 1e-6) - at(x - 1e-6)) / 2e-6;
            assert!((exact.eps - central).abs() < 1e-8, "{x} {exact} {central}");
        }
    }
}
