//! Attached unsteady flow and a lag of separation: the default of sections that stall.
//!
//! ```text
//! f' = (2 V / c) (f_st(alpha_E) - f) / (T_p + T_f) ,   alpha_E = atan2(w_E, v_x)
//! cl = f slope (alpha_E - alpha_0) + (1 - f) cl_fs(alpha_E)
//! ```
//!
//! with the rows of lags and of added mass. It is smooth, and has no vortex: the moment in deep
//! stall is static, and damping of stall flutter is not predicted.

use crate::real::Real;

use super::added_mass;
use super::lags::Lags;
use super::local::Local;
use super::polar::Polar;
use super::section::{
    Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip, state,
};
use super::separated::lift_and_drag_of;

/// Lag of circulation, added mass and lag of separation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeparationLag {
    /// Coefficients of the lag of circulation.
    pub lags: Lags,
    /// Time constant of pressure, in semichords travelled \[-\].
    pub pressure_time: f64,
    /// Time constant of separation, in semichords travelled; the one lag has the sum of both \[-\].
    pub separation_time: f64,
}

impl Default for SeparationLag {
    fn default() -> Self {
        Self {
            lags: Lags::JONES,
            pressure_time: 1.7,
            separation_time: 6.0,
        }
    }
}

const STATES: [StateName; 5] = [
    state("slow lag of the normal velocity", "m/s", "m/s^2"),
    state("fast lag of the normal velocity", "m/s", "m/s^2"),
    state("attached part of the chord", "-", "1/s"),
    state("momentum of the added mass", "kg/s", "kg/s"),
    state("angular momentum of the added mass", "kg m/s", "kg m/s"),
];

impl Adjustable for SeparationLag {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        let mut all: Vec<_> = self.lags.constants().into();
        all.push(("T_p", &mut self.pressure_time));
        all.push(("T_f0", &mut self.separation_time));
        all
    }
}

impl Model for SeparationLag {
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
        let states: &mut [f64; 5] = states.try_into().ok()?;
        let local = Local::of(flow);
        let [y1, y2] = self.lags.steady(local.rear);
        let part = polar.attached(local.angle(local.rear));
        let [p, h] = added_mass::momenta(strip, flow);
        *states = [y1, y2, part, p, h];
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
        let &[y1, y2, part, p, h]: &[T; 5] = states.try_into().ok()?;
        let &[dy1, dy2, dpart, dp, dh]: &[T; 5] = rates.try_into().ok()?;
        let rows: &mut [T; 5] = rows.try_into().ok()?;
        let local = Local::of(flow);
        let [f1, f2] = self.lags.rates(strip, &local, flow.mach, [y1, y2]);
        let [p0, h0] = added_mass::momenta(strip, flow);
        let effective = self.lags.effective(&local, [y1, y2]);
        let alpha = local.angle(effective);
        let target = polar.attached(alpha);
        let time = self.pressure_time + self.separation_time;
        let separation = local.follow(strip, time, part, target, 1.0);
        *rows = [dy1 - f1, dy2 - f2, dpart - separation, p - p0, h - h0];
        let coefficients = lift_and_drag_of(polar, flow, &local, alpha, [part, target]);
        let force = local.force(strip, local.bound(effective), &coefficients);
        Some(added_mass::add(force, strip, flow, [dp, dh]))
    }
}
