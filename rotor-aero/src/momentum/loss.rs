//! Loss of circulation at the ends of the blades.
//!
//! ```text
//! F = Ft Fh,  Ft = (2/pi) acos exp(-f),  f = (B/2) (R - r) / (r |sin phi|)
//!             Fh = (2/pi) acos exp(-f),  f = (B/2) (r - Rh) / (Rh |sin phi|)
//! ```
//!
//! Prandtl's form after Glauert (1935); the hub has its own radius in the denominator, as in
//! Moriarty and Hansen, NREL/TP-500-36881 (2005).

use std::f64::consts::FRAC_2_PI;

use crate::momentum::annulus::Annulus;
use crate::real::Real;

/// Smallest factor of loss: the derivative of the arc cosine is infinite at zero \[-\].
pub const LOSS_FLOOR: f64 = 1e-3;

/// Smallest |sin phi| in the exponent \[-\].
const SINE_FLOOR: f64 = 1e-6;

/// Largest exponent: `exp(-40)` does not change the factor in double precision.
const EXPONENT_CAP: f64 = 40.0;

/// Factor of loss at the tip, from [`LOSS_FLOOR`] to 1.
pub fn tip_loss<T: Real>(blades: usize, radius: T, tip_radius: T, sin_phi: T) -> T {
    factor(blades, (tip_radius - radius) / radius, sin_phi)
}

/// Factor of loss at the hub, from [`LOSS_FLOOR`] to 1; without a hub there is no loss.
pub fn hub_loss<T: Real>(blades: usize, radius: T, hub_radius: f64, sin_phi: T) -> T {
    if hub_radius <= 0.0 {
        return T::from(1.0);
    }
    factor(blades, (radius - hub_radius) / hub_radius, sin_phi)
}

/// Factor of loss of a ring, as its options require: from the square of [`LOSS_FLOOR`] to 1.
pub fn loss<T: Real>(annulus: &Annulus, sin_phi: T) -> T {
    let Annulus { blades, radius, .. } = *annulus;
    let mut result = T::from(1.0);
    if annulus.options.tip_loss {
        result *= tip_loss(
            blades,
            T::from(radius),
            T::from(annulus.tip_radius),
            sin_phi,
        );
    }
    if annulus.options.hub_loss {
        result *= hub_loss(blades, T::from(radius), annulus.hub_radius, sin_phi);
    }
    result
}

/// The factor for a distance from the end over its radius.
fn factor<T: Real>(blades: usize, distance: T, sin_phi: T) -> T {
    let size = if sin_phi.re() < 0.0 {
        -sin_phi
    } else {
        sin_phi
    };
    let size = if size.re() < SINE_FLOOR {
        T::from(SINE_FLOOR)
    } else {
        size
    };
    let exponent = size.recip() * distance * (0.5 * blades as f64);
    // acos(1 - x) is sqrt(2 x) at the end: this exponent has the smallest factor
    let least = 0.5 * (LOSS_FLOOR / FRAC_2_PI).powi(2);
    if exponent.re() < least {
        return T::from(LOSS_FLOOR);
    }
    if exponent.re() > EXPONENT_CAP {
        return T::from(1.0);
    }
    (-exponent).exp().acos() * FRAC_2_PI
}

#[cfg(test)]
mod tests {
    use num_dual::{Dual64, DualNum};

    use super::*;
    use crate::momentum::annulus::Options;

    #[test]
    fn closed_values() {
        // exponent ln 2: acos(1/2) = pi/3, F = 2/3
        let sine = 0.5 / std::f64::consts::LN_2;
        assert!((tip_loss(2, 1.0, 1.5, sine) - 2.0 / 3.0).abs() < 1e-15);
        assert!((hub_loss(2, 1.5, 1.0, sine) - 2.0 / 3.0).abs() < 1e-15);
        assert_eq!(hub_loss(2, 1.5, 0.0, sine), 1.0);
        assert_eq!(tip_loss(2, 1.0, 1.5, 0.0), 1.0);
        assert_eq!(tip_loss(2, 1.5, 1.5, 0.3), LOSS_FLOOR);
        assert_eq!(tip_loss(2, 2.5, 1.5, 0.3), LOSS_FLOOR);
    }

    #[test]
    fn not_a_number_is_no_panic() {
        assert!(tip_loss(3, f64::NAN, 1.0, 0.2f64).is_nan());
        assert!(tip_loss(3, 0.5, 1.0, f64::NAN).is_nan());
    }

    #[test]
    fn derivative_by_the_angle_is_exact() {
        let mut annulus = Annulus {
            radius: 1.0,
            hub_radius: 0.2,
            tip_radius: 1.0,
            blades: 3,
            chord: 0.1,
            options: Options::default(),
        };
        for step in 1..400 {
            annulus.radius = 0.2 + 0.8 * f64::from(step) / 401.0;
            let phi = -1.5 + 3.0 * f64::from((step * 37) % 400) / 400.0;
            let at = |phi: f64| loss(&annulus, phi.sin());
            let dual = loss(&annulus, Dual64::from(phi).derivative().sin());
            let central = (at(phi + 1e-6) - at(phi - 1e-6)) / 2e-6;
            assert!((dual.re - at(phi)).abs() < 1e-14);
            // central differences: rounding 1e-16/1e-6, truncation 1e-12 f'''
            let size = 1.0 + central.abs();
            assert!(
                (dual.eps - central).abs() < 1e-7 * size,
                "{annulus:?} {phi}"
            );
        }
    }
}
