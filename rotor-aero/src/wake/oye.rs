//! The two stages of Oye's filter, and their time constants.
//!
//! ```text
//! y' = ((1 - k) w_qs - y) / tau1,  w' = (y + k w_qs - w) / tau2,  k = .6
//! tau1 = 1.1 / (1 - 1.3 min(a, .5)) R / V,  tau2 = (.39 - .26 (r/R)^2) tau1
//! ```
//!
//! `a` is the mean induction factor of the rotor, `V` its mean wind. Snel and Schepers,
//! ECN-C-94-107 (1995); in continuous form Branlard, Jonkman et al., NREL (2022).

use crate::real::Real;

/// Share k of the quasi-steady velocity that passes by the first stage \[-\].
pub const SHARE: f64 = 0.6;

/// Largest induction factor in the time constant \[-\].
const INDUCTION_CAP: f64 = 0.5;

/// Smallest wind in the time constant of turbines \[m/s\].
const LEAST_WIND: f64 = 0.1;

/// Largest time constant of turbines \[s\].
const TURBINE_CAP: f64 = 100.0;

/// Time constant of the first stage of a frozen wake \[s\].
const FROZEN: f64 = 864_000.0;

/// The time constant of the first stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TimeScale {
    /// Oye's constants, for turbines: at most 100 s, for a wind of at least .1 m/s.
    Turbine,
    /// `min(R / max(|V|, least_speed), cap)` by the velocity V through the disk with induction: in
    /// hover the wind is zero, and the wake moves at the induced velocity.
    ///
    /// An estimate of the scale alone; Oye's constants were fitted to turbines.
    Hover {
        /// Smallest velocity through the disk \[m/s\].
        least_speed: f64,
        /// Largest time constant \[s\].
        cap: f64,
    },
    /// So long that the velocities stay as they are in modes and in runs of minutes, and have the
    /// values of rest in an equilibrium: ten days.
    Frozen,
}

impl TimeScale {
    /// Time constants (tau1, tau2) \[s\] at the radius over the tip radius.
    ///
    /// Of turbines `speed` is the mean wind along the shaft \[m/s\] and `induction` the mean factor
    /// `a`, positive if the air slows down; in hover `speed` is the mean of `Vx + u`, and
    /// `induction` has no effect. Both constants are positive for any finite input.
    pub fn constants<T: Real>(
        self,
        tip_radius: T,
        radius_ratio: T,
        speed: T,
        induction: T,
    ) -> (T, T) {
        let size = if speed.re() < 0.0 { -speed } else { speed };
        let first = match self {
            Self::Turbine => {
                let capped = at_most(induction, INDUCTION_CAP);
                let scale = (-capped * 1.3 + 1.0).recip() * tip_radius * 1.1;
                at_most(scale / at_least(size, LEAST_WIND), TURBINE_CAP)
            }
            Self::Hover { least_speed, cap } => {
                at_most(at_least(size, least_speed).recip() * tip_radius, cap)
            }
            Self::Frozen => T::from(FROZEN),
        };
        let ratio = at_most(radius_ratio, 1.0);
        (first, first * (-(ratio * ratio) * 0.26 + 0.39))
    }
}

/// State of the filter of one velocity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FilterState<T> {
    /// First stage (y) \[m/s\].
    pub first: T,
    /// Second stage: the induced velocity (w) \[m/s\].
    pub induced: T,
}

impl<T: Real> FilterState<T> {
    /// The state of rest at a quasi-steady velocity.
    pub fn steady(quasi_steady: T) -> Self {
        Self {
            first: quasi_steady * (1.0 - SHARE),
            induced: quasi_steady,
        }
    }
}

/// Rates (y', w') of the filter at its quasi-steady velocity \[m/s^2\].
///
/// # Examples
///
/// ```
/// use rotor_aero::wake::{FilterState, TimeScale, rates};
///
/// let constants = TimeScale::Turbine.constants(63.0, 0.5, 8.0, 0.33);
/// let rest = rates(&FilterState::steady(2.6_f64), 2.6, constants);
/// assert!(rest.first.abs() < 1e-15 && rest.induced.abs() < 1e-15);
/// ```
pub fn rates<T: Real>(
    state: &FilterState<T>,
    quasi_steady: T,
    constants: (T, T),
) -> FilterState<T> {
    let (first, second) = constants;
    FilterState {
        first: (quasi_steady * (1.0 - SHARE) - state.first) / first,
        induced: (state.first + quasi_steady * SHARE - state.induced) / second,
    }
}

/// The response to a unit step of the quasi-steady velocity, from rest at zero \[-\].
pub fn step_response(time: f64, constants: (f64, f64)) -> f64 {
    let (first, second) = constants;
    let slow = (1.0 - SHARE) * first / (first - second);
    1.0 - slow * (-time / first).exp() - (1.0 - slow) * (-time / second).exp()
}

fn at_most<T: Real>(value: T, limit: f64) -> T {
    if value.re() > limit {
        T::from(limit)
    } else {
        value
    }
}

fn at_least<T: Real>(value: T, limit: f64) -> T {
    if value.re() < limit {
        T::from(limit)
    } else {
        value
    }
}

#[cfg(test)]
#[path = "oye_tests.rs"]
mod tests;
