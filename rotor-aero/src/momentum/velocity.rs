//! Annular momentum as a relation of velocities: the form for differential equations.
//!
//! ```text
//! u m = (sigma / 4 F) W^2 cn,  v m = (sigma / 4 F) W^2 ct
//! m = sqrt((Vx + u)^2 + Vt^2 + e^2)
//! m = max(m, |Vx| CT(a) / (4 F a))  if a = -u / Vx > .4  (turbulent wake, Buhl)
//! m = sqrt((Vx CT(a) / (4 F a))^2 + Vt^2 + e^2)  if a < 1  (polynomial)
//! ```
//!
//! Momentum of a ring after Glauert (1935), with the velocity `Vt` of the wind in the plane of the
//! disk; `CT(a)` is the law of high induction. `u m(u)` is monotone: windmill, turbulent wake,
//! descent, hover and climb are one branch. A system of equations either contains [`balance`] as
//! residuals, or lets the induced velocities follow [`quasi_steady`] by the filter of the wake,
//! which needs no solution in a step. Where `a < .4` the steady state is the state of
//! [`solve`](crate::momentum::solve); above it the swirl differs, since it uses `m` too.
//!
//! [`HighInduction::BuhlOutside`] is continuous at `Vx = 0`, while [`HighInduction::Buhl`], with the
//! factor of loss inside, is not where `F < .69`: it is for comparisons in axial flow.

use crate::airfoil::Coefficients;
use crate::momentum::annulus::{Annulus, SectionFlow};
use crate::momentum::induction::{HighInduction, SWITCH};
use crate::momentum::loss::{LOSS_FLOOR, loss};
use crate::real::Real;

/// Smallest mass-flow speed in still air \[m/s\].
const LEAST_SPEED: f64 = 1e-3;

/// Smallest mass-flow speed over the speed of rotation \[-\].
const LEAST_RATIO: f64 = 0.01;

/// The air at a section, without induction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ambient<T> {
    /// Velocity through the disk relative to the section, positive in climb (Vx) \[m/s\].
    pub axial: T,
    /// Velocity against the motion of the section (Vy) \[m/s\].
    pub rotation: T,
    /// Velocity of the wind in the plane of the disk (Vt) \[m/s\].
    pub skew: T,
}

/// The flow at a section with the induced velocities `u` through the disk and `v` of the swirl.
pub fn induced_flow<T: Real>(ambient: &Ambient<T>, u: T, v: T) -> SectionFlow<T> {
    SectionFlow::of(ambient.axial + u, ambient.rotation - v)
}

/// Mass-flow speed `m` of a ring with the induced velocity `u` and the factor of loss: positive,
/// and continuous for any input.
pub fn mass_flow<T: Real>(annulus: &Annulus, ambient: &Ambient<T>, u: T, loss: T) -> T {
    mass_flow_by(annulus.options.high_induction, ambient, u, loss)
}

/// [`mass_flow`] by a law of high induction.
pub fn mass_flow_by<T: Real>(law: HighInduction, ambient: &Ambient<T>, u: T, loss: T) -> T {
    let through = match law {
        HighInduction::Polynomial => by_polynomial(ambient.axial, u),
        _ => ambient.axial + u,
    };
    let square = through * through + ambient.skew * ambient.skew + LEAST_SPEED * LEAST_SPEED;
    let momentum = square.sqrt();
    let loaded = turbulent(law, ambient.axial, u, loss);
    let least = absolute(ambient.rotation) * LEAST_RATIO;
    larger(loaded.map_or(momentum, |it| larger(momentum, it)), least)
}

/// Induced velocities (u, v) that balance the loads of a section, at the present induced velocities
/// and the coefficients there. Finite for any finite input.
///
/// The loads use the flow with `u` and `v`, and so do the factor of loss and the mass flow: a fixed
/// point is a steady state. Multiply the results by no factor of loss: they are the velocities at
/// the blade.
pub fn quasi_steady<T: Real>(
    annulus: &Annulus,
    ambient: &Ambient<T>,
    u: T,
    v: T,
    coefficients: Coefficients<T>,
) -> (T, T) {
    let (mass, axial, swirl) = terms(annulus, ambient, u, v, coefficients);
    (axial / mass, swirl / mass)
}

/// Residuals of momentum, `u m - (sigma / 4 F) W^2 cn` and the same of the swirl \[m^2/s^2\].
pub fn balance<T: Real>(
    annulus: &Annulus,
    ambient: &Ambient<T>,
    u: T,
    v: T,
    coefficients: Coefficients<T>,
) -> (T, T) {
    let (mass, axial, swirl) = terms(annulus, ambient, u, v, coefficients);
    (u * mass - axial, v * mass - swirl)
}

/// The mass-flow speed, and the loads over 4 F: (m, (sigma / 4 F) W^2 cn, (sigma / 4 F) W^2 ct).
fn terms<T: Real>(
    annulus: &Annulus,
    ambient: &Ambient<T>,
    u: T,
    v: T,
    coefficients: Coefficients<T>,
) -> (T, T, T) {
    let flow = induced_flow(ambient, u, v);
    let loss = larger(loss(annulus, flow.sin), T::from(LOSS_FLOOR));
    let mass = mass_flow(annulus, ambient, u, loss);
    let (normal, tangential) = annulus.induction_coefficients(flow.sin, flow.cos, coefficients);
    let load = flow.speed * flow.speed * (0.25 * annulus.solidity()) / loss;
    (mass, load * normal, load * tangential)
}

/// Mass-flow speed by the polynomial; beyond `a = 1` of the flow itself where this is larger.
fn by_polynomial<T: Real>(axial: T, u: T) -> T {
    let through = absolute(axial + u);
    if axial.re() == 0.0 {
        return through;
    }
    let a = -u / axial;
    let speed = absolute(axial) * HighInduction::Polynomial.slope(a, T::from(1.0));
    if !speed.re().is_finite() {
        through
    } else if a.re() < 1.0 {
        speed
    } else {
        larger(through, speed)
    }
}

/// Mass-flow speed in the turbulent wake by Buhl's law, where it holds.
fn turbulent<T: Real>(law: HighInduction, axial: T, u: T, loss: T) -> Option<T> {
    let is_buhl = matches!(law, HighInduction::Buhl | HighInduction::BuhlOutside);
    // a > SWITCH without a division by zero
    let against = -u.re() * axial.re().signum();
    if !(is_buhl && against > SWITCH * axial.re().abs() && axial.re() != 0.0) {
        return None;
    }
    let size = absolute(axial);
    Some(size * law.slope(-u / axial, loss)).filter(|it| it.re().is_finite())
}

fn absolute<T: Real>(value: T) -> T {
    if value.re() < 0.0 { -value } else { value }
}

fn larger<T: Real>(one: T, other: T) -> T {
    if one.re() < other.re() { other } else { one }
}

#[cfg(test)]
#[path = "velocity_tests.rs"]
mod tests;
