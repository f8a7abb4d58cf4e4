//! Dynamic stall with a vortex that is shed at the leading edge.
//!
//! ```text
//! s' = 2 V / c                          semichords travelled
//! n'   = s' (n_p - n) / T_p             n_p = g slope (alpha_E - alpha_0)
//! f'   = s' (f_st(n / slope + alpha_0) - f) / T_f
//! c    = g slope (alpha_E - alpha_0) (1 - K(f)) ,   K = ((1 + sqrt f) / 2)^2
//! v'   = G_1 G_2 c' - s' v / T_v
//! tau' = s' [G_1 G_3 - (1 - G_1) tau / T_r]
//! ```
//!
//! after [Leishman1989], with logistic gates instead of switches: G_1 opens as |n| exceeds C_N1,
//! G_2 closes as the vortex reaches the trailing edge (tau = T_vl), and
//! `G_3 = tanh((2 T_vl - tau) / width)` stops its clock at 2 T_vl. The feed c of the vortex is a state with an algebraic row, since its rate is needed.
//! On top of static coefficients at alpha_E are the normal force
//! `slope (alpha_E - alpha_0) (K(f) - K(f_st)) + v`, the suction
//! `eta slope (alpha_E - alpha_0)^2 (sqrt f - sqrt f_st)` and the moment
//! `m(f) - m(f_st) - .2 (1 - cos(pi tau / T_vl)) v`, with
//! `m = [K_0 + K_1 (1 - f) + K_2 sin(pi f^2)] slope (alpha_E - alpha_0) K(f)`: steady flow gives
//! the static coefficients. Impulsive lift is left out of n_p.

use std::f64::consts::PI;

use crate::real::Real;

use super::added_mass;
use super::constants::StallConstants;
use super::lags::Lags;
use super::local::{Local, kirchhoff, logistic, part_root};
use super::polar::Polar;
use super::section::{
    Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip, state,
};
use super::separated::part_of;

/// Width of the gate of shedding, in the normal coefficient \[-\].
const SHEDDING_WIDTH: f64 = 0.02;
/// Width of the gates of the passage of the vortex, in semichords \[-\].
const PASSAGE_WIDTH: f64 = 0.25;
/// Time constant that resets the clock of the vortex, in semichords \[-\].
const RESET_TIME: f64 = 0.5;
/// Greatest distance of the center of pressure of the vortex from the quarter chord is twice
/// this part of the chord \[-\].
const VORTEX_ARM: f64 = 0.2;
/// Width of the rounded corner of the absolute value of a normal coefficient \[-\].
const CORNER: f64 = 1e-3;

/// Lags of circulation, pressure and separation, a vortex, and added mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicStall {
    /// Coefficients of the lag of circulation.
    pub lags: Lags,
    /// Constants of the airfoil.
    pub constants: StallConstants,
}

impl Default for DynamicStall {
    fn default() -> Self {
        Self {
            lags: Lags::JONES,
            constants: StallConstants::naca0012(0.3),
        }
    }
}

const STATES: [StateName; 9] = [
    state("slow lag of the normal velocity", "m/s", "m/s^2"),
    state("fast lag of the normal velocity", "m/s", "m/s^2"),
    state("normal coefficient of delayed pressure", "-", "1/s"),
    state("attached part of the chord", "-", "1/s"),
    state("feed of the vortex", "-", "-"),
    state("normal coefficient of the vortex", "-", "1/s"),
    state("semichords travelled since shedding", "-", "1/s"),
    state("momentum of the added mass", "kg/s", "kg/s"),
    state("angular momentum of the added mass", "kg m/s", "kg m/s"),
];

/// The part of the states that belongs to separation.
struct Stall<T> {
    /// Normal coefficient of delayed pressure, n.
    pressure: T,
    /// Attached part of the chord, f.
    part: T,
    /// Feed of the vortex, c.
    feed: T,
    /// Normal coefficient of the vortex, v.
    vortex: T,
    /// Semichords travelled since shedding, tau.
    clock: T,
}

impl DynamicStall {
    /// The normal coefficient of attached flow with the gate, n_p.
    fn attached<T: Real, P: Polar>(polar: &P, local: &Local<T>, alpha: T) -> T {
        local.gate * (alpha - polar.zero_lift()) * polar.slope()
    }

    /// Pressure and attached part of steady flow at an attached normal coefficient: sources with
    /// the speed of loads over decay with its own.
    fn steady<T: Real, P: Polar>(polar: &P, local: &Local<T>, normal: T) -> [T; 2] {
        let driven = local.speed / local.decay;
        let pressure = driven * normal;
        [pressure, driven * (part_of(polar, pressure) - 1.0) + 1.0]
    }

    /// Whether the vortex is shed, from 0 to 1, G_1.
    fn shedding<T: Real>(&self, pressure: T) -> T {
        let size = (pressure * pressure + CORNER * CORNER).sqrt();
        logistic((size - self.constants.critical_normal) / SHEDDING_WIDTH)
    }

    /// Rates per semichord that drive and reset the clock of the vortex.
    fn clock<T: Real>(&self, shedding: T, clock: T) -> [T; 2] {
        let left = -clock + 2.0 * self.constants.passage_time;
        let run = shedding * (left / PASSAGE_WIDTH).tanh();
        [run, (-shedding + 1.0) * clock / RESET_TIME]
    }

    /// The clock of steady flow, between rest and 2 T_vl, where the speed that drives it is a part
    /// of the one that resets it.
    fn steady_clock(&self, pressure: f64, part: f64) -> f64 {
        let shedding = self.shedding(pressure);
        let [mut low, mut high] = [0.0, 2.0 * self.constants.passage_time];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let [run, reset] = self.clock(shedding, middle);
            if part * run > reset {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The rates of pressure, part, vortex and clock.
    fn rates<T: Real, P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        local: &Local<T>,
        it: &Stall<T>,
        [source, feed_rate]: [T; 2],
    ) -> [T; 4] {
        let k = &self.constants;
        let pressure = local.follow(strip, k.pressure_time, it.pressure, source, 0.0);
        let target = part_of(polar, it.pressure);
        let part = local.follow(strip, k.separation_time, it.part, target, 1.0);
        let shedding = self.shedding(it.pressure);
        let over = logistic((-it.clock + k.passage_time) / PASSAGE_WIDTH);
        let travel = local.decay / strip.semichord();
        let vortex = shedding * over * feed_rate - travel * it.vortex / k.vortex_time;
        let [run, reset] = self.clock(shedding, it.clock);
        let clock = local.speed / strip.semichord() * run - travel * reset;
        [pressure, part, vortex, clock]
    }

    /// The lever of the center of pressure at an attached part, times the normal coefficient.
    fn moment<T: Real>(&self, normal: T, part: T) -> T {
        let k = &self.constants;
        let lever =
            (-part + 1.0) * k.center_shift + (part * part * PI).sin() * k.moment_break + k.center;
        lever * normal * kirchhoff(part)
    }

    /// Adds the forces of delayed separation and of the vortex to the static forces.
    fn add_stall<T: Real>(
        &self,
        force: SectionForce<T>,
        strip: &Strip,
        load: T,
        it: &Stall<T>,
        [normal, angle, fixed]: [T; 3],
    ) -> SectionForce<T> {
        let k = &self.constants;
        let lift = normal * (kirchhoff(it.part) - kirchhoff(fixed)) + it.vortex;
        let suction = normal * angle * (part_root(it.part) - part_root(fixed)) * k.suction;
        let arm = (-(it.clock * (PI / k.passage_time)).cos() + 1.0) * VORTEX_ARM;
        let moment = self.moment(normal, it.part) - self.moment(normal, fixed) - arm * it.vortex;
        SectionForce {
            along: force.along + load * suction,
            normal: force.normal + load * lift,
            moment: force.moment + load * moment * strip.chord,
        }
    }
}

impl Adjustable for DynamicStall {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        let mut all: Vec<_> = self.lags.constants().into();
        all.extend(self.constants.named());
        all
    }
}

impl Model for DynamicStall {
    fn states(&self) -> &'static [StateName] {
        &STATES
    }

    fn needs_start(&self) -> bool {
        true
    }

    fn start<P: Polar>(
        &self,
        strip: &Strip,
        polar: &P,
        flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()> {
        let states: &mut [f64; 9] = states.try_into().ok()?;
        let local = Local::of(flow);
        let [y1, y2] = self.lags.steady(local.rear);
        let [p, h] = added_mass::momenta(strip, flow);
        let normal = Self::attached(polar, &local, local.angle(local.rear));
        let [pressure, part] = Self::steady(polar, &local, normal);
        let feed = normal * (1.0 - kirchhoff(part));
        let clock = self.steady_clock(pressure, local.speed / local.decay);
        *states = [y1, y2, pressure, part, feed, 0.0, clock, p, h];
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
        let &[y1, y2, pressure, part, feed, vortex, clock, p, h]: &[T; 9] =
            states.try_into().ok()?;
        let &[dy1, dy2, dpressure, dpart, dfeed, dvortex, dclock, dp, dh]: &[T; 9] =
            rates.try_into().ok()?;
        let rows: &mut [T; 9] = rows.try_into().ok()?;
        let local = Local::of(flow);
        let it = Stall {
            pressure,
            part,
            feed,
            vortex,
            clock,
        };
        let effective = self.lags.effective(&local, [y1, y2]);
        let alpha = local.angle(effective);
        let normal = Self::attached(polar, &local, alpha);
        let [f1, f2] = self.lags.rates(strip, &local, flow.mach, [y1, y2]);
        let [f3, f4, f6, f7] = self.rates(strip, polar, &local, &it, [normal, dfeed]);
        let [p0, h0] = added_mass::momenta(strip, flow);
        *rows = [
            dy1 - f1,
            dy2 - f2,
            dpressure - f3,
            dpart - f4,
            it.feed - normal * (-kirchhoff(part) + 1.0),
            dvortex - f6,
            dclock - f7,
            p - p0,
            h - h0,
        ];
        let fixed = polar.coefficients(&flow.at(alpha));
        let force = local.force(strip, local.bound(effective), &fixed);
        let angle = alpha - polar.zero_lift();
        let [_, static_part] = Self::steady(polar, &local, normal);
        let load = local.load(strip);
        let force = self.add_stall(force, strip, load, &it, [normal, angle, static_part]);
        Some(added_mass::add(force, strip, flow, [dp, dh]))
    }
}
