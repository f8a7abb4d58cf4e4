//! Coefficients of a section whose separation lags behind its static value.
//!
//! ```text
//! cl = cl_st + g (f - f_st) (slope (alpha - alpha_0) - cl_fs)
//! cd = cd_st + g (cd_st - cd(alpha_0)) [(sqrt f_st - sqrt f)/2 - (f_st - f)/4]
//! ```
//!
//! after [Hansen2004]. The lift is `f cl_inv + (1 - f) cl_fs`, written as a difference from the
//! static value: it is exact in steady flow at every Mach number, Reynolds number and angle. The
//! gate g closes at large angles, where a section is quasi-steady.

use crate::airfoil::Coefficients;
use crate::real::Real;

use super::local::{Local, part_root};
use super::polar::Polar;
use super::section::SectionFlow;

/// The lift of attached flow beyond the lift of separated flow.
fn gain<T: Real, P: Polar>(polar: &P, alpha: T) -> T {
    (alpha - polar.zero_lift()) * polar.slope() - polar.separated_lift(alpha)
}

/// Slope below which a section has no attached flow, such as a cylinder \[1/rad\].
const NO_SLOPE: f64 = 1e-6;

/// The static attached part of the chord at the angle where attached flow has a lift coefficient.
pub(super) fn part_of<T: Real, P: Polar>(polar: &P, lift: T) -> T {
    let slope = polar.slope();
    if slope.abs() < NO_SLOPE {
        return polar.attached(T::from(polar.zero_lift()));
    }
    polar.attached(lift / slope + polar.zero_lift())
}

/// Static coefficients, and lift for an attached part of the chord instead of its static value.
pub(super) fn lift_of<T: Real, P: Polar>(
    polar: &P,
    flow: &SectionFlow<T>,
    local: &Local<T>,
    alpha: T,
    [part, fixed_part]: [T; 2],
) -> Coefficients<T> {
    let fixed = polar.coefficients(&flow.at(alpha));
    let lift = fixed.lift + local.gate * (part - fixed_part) * gain(polar, alpha);
    Coefficients { lift, ..fixed }
}

/// The same, with the drag of delayed separation.
pub(super) fn lift_and_drag_of<T: Real, P: Polar>(
    polar: &P,
    flow: &SectionFlow<T>,
    local: &Local<T>,
    alpha: T,
    [part, fixed_part]: [T; 2],
) -> Coefficients<T> {
    let it = lift_of(polar, flow, local, alpha, [part, fixed_part]);
    let least = polar.drag(&flow.at(T::from(polar.zero_lift())));
    let roots = part_root(fixed_part) - part_root(part);
    let delay = roots * 0.5 - (fixed_part - part) * 0.25;
    Coefficients {
        drag: it.drag + local.gate * (it.drag - least) * delay,
        ..it
    }
}
