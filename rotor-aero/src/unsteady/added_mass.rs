//! The added mass of a section, by two momenta of the air.
//!
//! ```text
//! p - pi rho b^2 w_12 = 0 ,         L_nc = p'   at the mid chord
//! h - (pi rho b^4 / 8) theta' = 0 , M_nc = -h' - (pi rho b^3 / 2) v_x theta'
//! ```
//!
//! with b = c/2 and M_nc a couple, nose up ([Theodorsen1935]). The rates of the momenta are
//! unknowns of the scheme, so that no acceleration is needed.

use std::f64::consts::PI;

use crate::real::Real;

use super::section::{SectionFlow, SectionForce, Strip};

/// The momenta of a flow: along the normal per length \[kg/s\], and angular per length
/// \[kg m/s\].
pub(super) fn momenta<T: Real>(strip: &Strip, flow: &SectionFlow<T>) -> [T; 2] {
    let b = strip.semichord();
    let mass = PI * strip.density * b * b;
    [
        flow.normal_mid * mass,
        flow.pitch_rate * (mass * b * b / 8.0),
    ]
}

/// Adds the forces of the added mass to those at the quarter chord.
pub(super) fn add<T: Real>(
    force: SectionForce<T>,
    strip: &Strip,
    flow: &SectionFlow<T>,
    momentum_rates: [T; 2],
) -> SectionForce<T> {
    let b = strip.semichord();
    let [lift, couple] = momentum_rates;
    let damping = flow.tangential * flow.pitch_rate * (0.5 * PI * strip.density * b * b * b);
    SectionForce {
        along: force.along,
        normal: force.normal + lift,
        moment: force.moment - lift * (0.5 * b) - couple - damping,
    }
}
