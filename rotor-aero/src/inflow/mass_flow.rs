//! The speed of the mass flow through a disk, in climb, hover, descent and forward flight.
//!
//! ```text
//! 2 l m = CT ,  m = sqrt(mu^2 + m_z^2 + e^2)                       [Glauert1926]
//! m_z = |mu_z + l|                    climb, hover, and a = -l/mu_z <= .4
//! m_z = max(|mu_z + l|, |mu_z| CT_b / (4 a)) ,  CT_b = 8/9 - 4/9 a + 14/9 a^2    a > .4
//! ```
//!
//! CT_b is the empirical thrust of the turbulent wake state ([Buhl2005], without loss), tangent to
//! momentum theory at a = .4. The maximum is rounded, so that m has a continuous derivative. The
//! product l m rises with l: there is one induced velocity for each thrust, in vortex ring state
//! as well. There it is a mean that belongs to wind turbines: tests of helicopters have 15 to 35 %
//! more induced velocity, and thrust that fluctuates.

use crate::real::Real;
use crate::unsteady::smooth_step;

/// Speed that rounds the mass flow at no flow, over the tip speed \[-\].
const REST: f64 = 1e-5;
/// Induction at which the turbulent wake state begins \[-\].
const TURBULENT: f64 = 0.4;
/// Range of induction in which the rounding of the maximum grows \[-\].
const RANGE: f64 = 0.6;
/// Rounding of the maximum, over the axial speed \[-\].
const ROUNDING: f64 = 0.1;

/// The mass flow of a disk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassFlow<T> {
    /// Speed of the mass flow over the tip speed, m \[-\].
    pub total: T,
    /// Derivative of `l m` by the induced velocity l, the speed that convects changes of the
    /// inflow \[-\].
    pub change: T,
    /// Cosine of the angle of the wake from the shaft \[-\].
    pub cosine: T,
    /// Sine of the angle of the wake from the shaft \[-\].
    pub sine: T,
}

impl<T: Real> MassFlow<T> {
    /// For an advance ratio, an axial speed and an induced velocity, all over the tip speed.
    pub fn of(advance: T, axial: T, induced: T) -> Self {
        let [through, slope] = through(axial, induced);
        let square = through * through + REST * REST;
        let total = (advance * advance + square).sqrt();
        Self {
            total,
            change: total + induced * through * slope / total,
            cosine: square.sqrt() / total,
            sine: advance / total,
        }
    }

    /// The tangent of half of the angle of the wake from the shaft.
    pub fn half_tangent(&self) -> T {
        self.sine / (self.cosine + 1.0)
    }
}

/// The axial speed of the mass flow, and its derivative by the induced velocity.
fn through<T: Real>(axial: T, induced: T) -> [T; 2] {
    let sum = axial + induced;
    let sign = |it: T| if it.re() < 0.0 { -T::one() } else { T::one() };
    let against = axial.re() * induced.re() < 0.0;
    if !against || induced.re().abs() <= TURBULENT * axial.re().abs() {
        return [sum * sign(sum), sign(sum)];
    }
    let [speed, slope] = turbulent(axial * sign(axial), induced * sign(induced));
    [speed, slope * sign(induced)]
}

/// The same for a speed V against an induced velocity u, both positive, beyond u = .4 V.
fn turbulent<T: Real>(axial: T, induced: T) -> [T; 2] {
    let [b0, b1, b2] = [8.0 / 9.0, -4.0 / 9.0, 14.0 / 9.0];
    let ratio = axial / induced;
    let wake = (axial * ratio * b0 + axial * b1 + induced * b2) * 0.25;
    let wake_slope = (-ratio * ratio * b0 + b2) * 0.25;
    let beyond = induced - axial;
    // The rounding grows from zero, where the wake is tangent to momentum theory.
    let at = (induced / axial - TURBULENT) / RANGE;
    let width = axial * smooth_step(at) * ROUNDING;
    let width_slope = step_slope(at) * (ROUNDING / RANGE);
    let difference = beyond - wake;
    let root = (difference * difference + width * width).sqrt();
    let root_slope = (difference * (-wake_slope + 1.0) + width * width_slope) / root;
    let speed = (beyond + wake + root) * 0.5;
    [speed, (wake_slope + root_slope + 1.0) * 0.5]
}

/// The derivative of [`smooth_step`].
fn step_slope<T: Real>(x: T) -> T {
    if x.re() <= 0.0 || x.re() >= 1.0 {
        return T::zero();
    }
    let product = x * (-x + 1.0);
    product * product * 30.0
}

/// The steady uniform induced velocity over the tip speed for a thrust coefficient.
///
/// It solves `2 l m = CT` by bisection to rounding; not a number for input that is none.
pub fn steady_uniform(thrust: f64, advance: f64, axial: f64) -> f64 {
    let excess =
        |induced: f64| 2.0 * induced * MassFlow::of(advance, axial, induced).total - thrust;
    let reach = 2.0 * (thrust.abs().sqrt() + axial.abs());
    if !(reach.is_finite() && advance.is_finite()) {
        return f64::NAN;
    }
    let [mut low, mut high] = if thrust >= 0.0 {
        [0.0, reach]
    } else {
        [-reach, 0.0]
    };
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if excess(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}
