//! The four-state model of Hansen, Gaunaa and Madsen.
//!
//! ```text
//! x1, x2 : lags of w_34 ;  T_u = c / 2V
//! cl_p   = slope (alpha_E - alpha_0) + pi T_u theta' ;  x3' = (cl_p - x3) / (T_p T_u)
//! alpha_F = x3 / slope + alpha_0 ;                      x4' = (f_st(alpha_F) - x4) / (T_f T_u)
//! cl = x4 slope (alpha_E - alpha_0) + (1 - x4) cl_fs(alpha_E) + pi T_u theta'
//! ```
//!
//! after [Hansen2004], with lags of the velocity instead of the angle, and the force normal to
//! the flow at the bound vortex, which contains the induced drag. The added mass is its part
//! `pi rho b^2 v_x theta'` alone: there are no accelerations.

use std::f64::consts::PI;

use crate::real::Real;

use super::lags::Lags;
use super::local::Local;
use super::polar::Polar;
use super::section::{
    Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip, state,
};
use super::separated::{lift_and_drag_of, part_of};

/// Lags of circulation, of pressure and of separation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hgm {
    /// Coefficients of the lag of circulation.
    pub lags: Lags,
    /// Time constant of pressure, in semichords travelled \[-\].
    pub pressure_time: f64,
    /// Time constant of separation, in semichords travelled \[-\].
    pub separation_time: f64,
}

impl Default for Hgm {
    fn default() -> Self {
        Self {
            lags: Lags::JONES,
            pressure_time: 1.7,
            separation_time: 6.0,
        }
    }
}

impl Hgm {
    /// The constants of other programs: all lift lags ([`Lags::BEDDOES`]), T_f = 3.
    pub const COMMON: Self = Self {
        lags: Lags::BEDDOES,
        pressure_time: 1.7,
        separation_time: 3.0,
    };

    /// The lift coefficient that pressure follows.
    fn pressure<T: Real, P: Polar>(
        strip: &Strip,
        polar: &P,
        local: &Local<T>,
        alpha: T,
        pitch_rate: T,
    ) -> T {
        let turning = pitch_rate / local.decay * (PI * strip.semichord());
        local.gate * ((alpha - polar.zero_lift()) * polar.slope() + turning)
    }
}

const STATES: [StateName; 4] = [
    state("slow lag of the normal velocity", "m/s", "m/s^2"),
    state("fast lag of the normal velocity", "m/s", "m/s^2"),
    state("lift coefficient of delayed pressure", "-", "1/s"),
    state("attached part of the chord", "-", "1/s"),
];

/// The force of a turning section in its own speed, at the mid chord.
fn add_turning<T: Real>(
    force: SectionForce<T>,
    strip: &Strip,
    flow: &SectionFlow<T>,
) -> SectionForce<T> {
    let b = strip.semichord();
    let lift = flow.tangential * flow.pitch_rate * (PI * strip.density * b * b);
    SectionForce {
        along: force.along,
        normal: force.normal + lift,
        moment: force.moment - lift * b,
    }
}

impl Adjustable for Hgm {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        let mut all: Vec<_> = self.lags.constants().into();
        all.push(("T_p", &mut self.pressure_time));
        all.push(("T_f0", &mut self.separation_time));
        all
    }
}

impl Model for Hgm {
    fn states(&self) -> &'static [StateName] {
        &STATES
    }

    fn start<P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()> {
        let states: &mut [f64; 4] = states.try_into().ok()?;
        let local = Local::of(flow);
        let [y1, y2] = self.lags.steady(local.rear);
        let alpha = local.angle(local.rear);
        let lift = Self::pressure(strip, polar, &local, alpha, flow.pitch_rate);
        let part = part_of(polar, lift);
        *states = [y1, y2, lift, part];
        Some(())
    }

    fn evaluate<T: Real, P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        flow: &SectionFlow<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<SectionForce<T>> {
        let &[y1, y2, lift, part]: &[T; 4] = states.try_into().ok()?;
        let &[dy1, dy2, dlift, dpart]: &[T; 4] = rates.try_into().ok()?;
        let rows: &mut [T; 4] = rows.try_into().ok()?;
        let local = Local::of(flow);
        let [f1, f2] = self.lags.rates(strip, &local, flow.mach, [y1, y2]);
        let effective = self.lags.effective(&local, [y1, y2]);
        let alpha = local.angle(effective);
        let source = Self::pressure(strip, polar, &local, alpha, flow.pitch_rate);
        let f3 = local.follow(strip, self.pressure_time, lift, source, 0.0);
        let target = part_of(polar, lift);
        let f4 = local.follow(strip, self.separation_time, part, target, 1.0);
        *rows = [dy1 - f1, dy2 - f2, dlift - f3, dpart - f4];
        // The static part belongs to the same source without turning and without delay.
        let still = Self::pressure(strip, polar, &local, alpha, T::zero());
        let fixed = part_of(polar, still);
        let coefficients = lift_and_drag_of(polar, flow, &local, alpha, [part, fixed]);
        let force = local.force(strip, local.bound(effective), &coefficients);
        Some(add_turning(force, strip, flow))
    }
}
