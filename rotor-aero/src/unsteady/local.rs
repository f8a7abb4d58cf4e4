//! Speeds, angles and gates that the models share.
//!
//! ```text
//! w_q = 2 w_12 - w_34                    normal velocity at the quarter chord
//! V^2 = v_x^2 + w_q^2 ;  V_s = sqrt(V^2 + e^2) ;  V_f = V^2 / V_s
//! ```
//!
//! `V_s` drives the decay of states, so that they return to rest without flow; `V_f` drives loads
//! and sources, which depend on an angle that does not exist without flow. Both are V, with a
//! relative error of `e^2 / 2 V^2`.

use crate::airfoil::Coefficients;
use crate::real::{Real, angle};

use super::section::{SectionFlow, SectionForce, Strip};

/// Speed below which states relax to rest \[m/s\].
const REST: f64 = 0.01;
/// Square of the speed below which an angle of attack is zero \[m^2/s^2\].
const NO_FLOW: f64 = 1e-24;
/// Cosine of the angle of attack (50 deg) from which a section is quasi-steady \[-\].
const GATE_CLOSED: f64 = 0.642_787_609_686_539_4;
/// Cosine of the angle of attack (40 deg) below which a section is unsteady \[-\].
const GATE_OPEN: f64 = 0.766_044_443_118_978;

/// The flow at a section as the models use it.
pub(super) struct Local<T> {
    /// Velocity along the chord \[m/s\].
    pub along: T,
    /// Normal velocity of the three-quarter chord, with the camber of a plain flap \[m/s\].
    pub rear: T,
    /// Normal velocity of the quarter chord \[m/s\].
    pub quarter: T,
    /// Speed that drives decay \[m/s\].
    pub decay: T,
    /// Speed that drives loads \[m/s\].
    pub speed: T,
    /// 1 if the section is unsteady, 0 above 50 deg of angle of attack and in reverse flow \[-\].
    pub gate: T,
}

impl<T: Real> Local<T> {
    /// From the flow at a section.
    pub fn of(flow: &SectionFlow<T>) -> Self {
        let along = flow.tangential;
        let rear = flow.normal + flow.camber;
        let quarter = flow.normal_mid * 2.0 - flow.normal;
        let square = along * along + quarter * quarter;
        let decay = (square + REST * REST).sqrt();
        let cosine = along / (along * along + rear * rear + REST * REST).sqrt();
        Self {
            along,
            rear,
            quarter,
            decay,
            speed: square / decay,
            gate: smooth_step((cosine - GATE_CLOSED) / (GATE_OPEN - GATE_CLOSED)),
        }
    }

    /// The angle of attack of a normal velocity, zero without flow.
    pub fn angle(&self, normal: T) -> T {
        let square = normal.re() * normal.re() + self.along.re() * self.along.re();
        if square < NO_FLOW {
            return T::zero();
        }
        angle(normal, self.along)
    }

    /// The normal velocity at the quarter chord that belongs to an effective normal velocity at
    /// the three-quarter chord: the velocity at the bound vortex, to which lift is normal.
    pub fn bound(&self, effective: T) -> T {
        effective - self.rear + self.quarter
    }

    /// The rate of a state that follows `target` within `times` semichords, and `rest` without
    /// flow.
    pub fn follow(&self, strip: &Strip, times: f64, state: T, target: T, rest: f64) -> T {
        let source = self.speed * (target - rest) - self.decay * (state - rest);
        source / (strip.semichord() * times)
    }

    /// Dynamic pressure times chord \[N/m\].
    pub fn load(&self, strip: &Strip) -> T {
        self.speed * self.speed * (0.5 * strip.density * strip.chord)
    }

    /// Forces of coefficients, lift normal to `(along, normal)` and drag along it.
    pub fn force(&self, strip: &Strip, normal: T, it: &Coefficients<T>) -> SectionForce<T> {
        let scale = self.speed * (0.5 * strip.density * strip.chord);
        SectionForce {
            along: scale * (it.lift * normal - it.drag * self.along),
            normal: scale * (it.lift * self.along + it.drag * normal),
            moment: self.load(strip) * it.moment * strip.chord,
        }
    }
}

/// 0 below 0, 1 above 1, with two continuous derivatives.
pub(crate) fn smooth_step<T: Real>(x: T) -> T {
    if x.re() <= 0.0 {
        return T::zero();
    }
    if x.re() >= 1.0 {
        return T::one();
    }
    x * x * x * (x * (x * 6.0 - 15.0) + 10.0)
}

/// The logistic function, from 0 to 1; it does not overflow.
pub(super) fn logistic<T: Real>(x: T) -> T {
    ((x * 0.5).tanh() + 1.0) * 0.5
}

/// The square root of a part of the chord, which is also defined a little below zero.
pub(super) fn part_root<T: Real>(part: T) -> T {
    /// Width of the rounded corner at zero.
    const CORNER: f64 = 1e-4;
    (((part * part + CORNER * CORNER).sqrt() + part) * 0.5).sqrt()
}

/// The factor `((1 + sqrt f) / 2)^2` of the lift of separated flow after Kirchhoff.
pub(super) fn kirchhoff<T: Real>(part: T) -> T {
    let half = (part_root(part) + 1.0) * 0.5;
    half * half
}
