//! Attached unsteady flow: lag of circulation and added mass.
//!
//! ```text
//! cl, cd, cm static at alpha_E = atan2(w_E, v_x) ;  rows of lags and of added mass
//! ```
//!
//! For a thin airfoil this is Theodorsen's theory with two exponentials for his function. Lift is
//! normal to the velocity at the bound vortex, which contains the wake: induced drag is included.

use crate::real::Real;

use super::added_mass;
use super::lags::Lags;
use super::local::Local;
use super::polar::Polar;
use super::section::{
    Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip, state,
};

/// Lag of circulation and added mass on static coefficients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lagged {
    /// Coefficients of the lag.
    pub lags: Lags,
}

impl Default for Lagged {
    fn default() -> Self {
        Self { lags: Lags::JONES }
    }
}

const STATES: [StateName; 4] = [
    state("slow lag of the normal velocity", "m/s", "m/s^2"),
    state("fast lag of the normal velocity", "m/s", "m/s^2"),
    state("momentum of the added mass", "kg/s", "kg/s"),
    state("angular momentum of the added mass", "kg m/s", "kg m/s"),
];

impl Adjustable for Lagged {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        self.lags.constants().into()
    }
}

impl Model for Lagged {
    fn states(&self) -> &'static [StateName] {
        &STATES
    }

    fn start<P: Polar>(
        &self,
        strip: &Strip,
        _polar: &P,
        flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()> {
        let states: &mut [f64; 4] = states.try_into().ok()?;
        let [y1, y2] = self.lags.steady(Local::of(flow).rear);
        let [p, h] = added_mass::momenta(strip, flow);
        *states = [y1, y2, p, h];
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
        let &[y1, y2, p, h]: &[T; 4] = states.try_into().ok()?;
        let &[dy1, dy2, dp, dh]: &[T; 4] = rates.try_into().ok()?;
        let rows: &mut [T; 4] = rows.try_into().ok()?;
        let local = Local::of(flow);
        let [f1, f2] = self.lags.rates(strip, &local, flow.mach, [y1, y2]);
        let [p0, h0] = added_mass::momenta(strip, flow);
        *rows = [dy1 - f1, dy2 - f2, p - p0, h - h0];
        let effective = self.lags.effective(&local, [y1, y2]);
        let coefficients = polar.coefficients(&flow.at(local.angle(effective)));
        let force = local.force(strip, local.bound(effective), &coefficients);
        Some(added_mass::add(force, strip, flow, [dp, dh]))
    }
}
