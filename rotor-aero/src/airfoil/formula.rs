//! Airfoils of closed form.
//!
//! Flat plate, at all angles, with normal force and center of pressure (from the leading edge)
//!
//! ```text
//! c_n = c_d90 sin a / (0.56 + 0.44 |sin a|),   x/c = 1/2 - (3/4) cos a / (4 + pi |sin a|)
//! c_l = c_n cos a,   c_d = c_n sin a + c_d0,   c_m = c_n (1/4 - x/c)
//! ```
//!
//! The normal force is a fit to measured plates, the center of pressure is the one of Rayleigh's
//! separated flow.
//!
//! Linear lift, with the Prandtl-Glauert factor on request,
//!
//! ```text
//! c_l = w(a) s (a - a_0) / sqrt(1 - M^2),   c_d = c_d0 + c_d2 (a - a_0)^2 w(a),   c_m = c_m0
//! ```
//!
//! where w is one up to 60 deg and fades to zero at 90 deg, so that there is no lift in reverse
//! flow. M is limited smoothly to a given number.
//!
//! # References
//! - C. Lindenburg, "Investigation into rotor blade aerodynamics", ECN-C--03-025, 2003.
//! - Lord Rayleigh, "On the resistance of fluids", Philosophical Magazine 2, 1876.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

use super::data::{Coefficients, Flow};
use super::surface::wrapped;
use crate::real::Real;

/// A flat plate at all angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatPlate {
    /// Drag coefficient at 90 deg \[-\].
    pub drag_90: f64,
    /// Drag coefficient of friction, at all angles \[-\].
    pub drag_0: f64,
}

impl Default for FlatPlate {
    /// A long plate: 1.98 at 90 deg; friction of both sides in turbulent flow at a Reynolds
    /// number of 10^6, 0.009.
    fn default() -> Self {
        Self {
            drag_90: 1.98,
            drag_0: 0.009,
        }
    }
}

impl FlatPlate {
    /// Coefficients in a flow.
    pub(super) fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let (sin, cos) = (flow.alpha.sin(), flow.alpha.cos());
        let normal = sin * self.drag_90 / (magnitude(sin) * 0.44 + 0.56);
        Coefficients {
            lift: normal * cos,
            drag: normal * sin + self.drag_0,
            moment: normal * plate_arm(sin, cos),
        }
    }
}

/// Distance of the quarter chord behind the center of pressure of a plate, over chord.
pub(super) fn plate_arm<T: Real>(sin: T, cos: T) -> T {
    cos * 0.75 / (magnitude(sin) * PI + 4.0) - 0.25
}

/// The absolute value.
fn magnitude<T: Real>(x: T) -> T {
    if x.re() < 0.0 { -x } else { x }
}

/// Lift without stall, for closed forms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLift {
    /// Slope of lift at Mach zero \[1/rad\].
    pub slope: f64,
    /// Angle of attack without lift \[rad\].
    pub zero_lift: f64,
    /// Drag coefficient without lift \[-\].
    pub drag_0: f64,
    /// Drag coefficient over the square of the angle from zero lift \[1/rad^2\].
    pub drag_2: f64,
    /// Moment coefficient \[-\].
    pub moment: f64,
    /// Mach number from which the Prandtl-Glauert factor is constant; absent without this
    /// factor \[-\].
    pub mach_limit: Option<f64>,
}

impl Default for LinearLift {
    /// A thin airfoil: slope 2 pi, no drag, no moment, no effect of the Mach number.
    fn default() -> Self {
        Self {
            slope: TAU,
            zero_lift: 0.0,
            drag_0: 0.0,
            drag_2: 0.0,
            moment: 0.0,
            mach_limit: None,
        }
    }
}

/// Half the width of the transition to the limited Mach number.
const MACH_ROUNDING: f64 = 0.02;

/// Largest Mach number of the Prandtl-Glauert factor.
pub(super) const MACH_LARGEST: f64 = 0.95;

impl LinearLift {
    /// Coefficients in a flow.
    pub(super) fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let alpha = wrapped(flow.alpha);
        let share = faded(alpha, FRAC_PI_3, FRAC_PI_2);
        let incidence = alpha - self.zero_lift;
        let factor = match self.mach_limit {
            Some(limit) => glauert(flow.mach, limit),
            None => T::from(1.0),
        };
        Coefficients {
            lift: share * incidence * factor * self.slope,
            drag: share * incidence * incidence * self.drag_2 + self.drag_0,
            moment: T::from(self.moment),
        }
    }
}

/// The Prandtl-Glauert factor; the Mach number is limited with a continuous derivative.
pub(super) fn glauert<T: Real>(mach: T, limit: f64) -> T {
    let limit = limit.clamp(0.0, MACH_LARGEST);
    let (start, end) = (limit - MACH_ROUNDING, limit + MACH_ROUNDING);
    let limited = if mach.re() >= end {
        T::from(limit)
    } else if mach.re() > start {
        let rest = -mach + end;
        -(rest * rest) / (4.0 * MACH_ROUNDING) + limit
    } else {
        mach
    };
    (-(limited * limited) + 1.0).sqrt().recip()
}

/// One up to the angle `from` on both sides of zero, zero from the angle `to`, and between
/// them a polynomial with continuous second derivatives.
pub(super) fn faded<T: Real>(alpha: T, from: f64, to: f64) -> T {
    let size = magnitude(alpha);
    if size.re() <= from {
        return T::from(1.0);
    }
    if size.re() >= to {
        return T::from(0.0);
    }
    let t = (size - from) / (to - from);
    -(t * t * t * (t * (t * 6.0 - 15.0) + 10.0)) + 1.0
}
