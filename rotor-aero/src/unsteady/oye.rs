//! Lag of separation alone, after Oye.
//!
//! ```text
//! f' = (2 V / c) (f_st(alpha) - f) / T_f ,   alpha = atan2(w_34, v_x)
//! cl = f slope (alpha - alpha_0) + (1 - f) cl_fs(alpha)
//! ```
//!
//! after [Oye1991]; drag and moment are static. T_f is in semichords travelled.

use crate::real::Real;

use super::local::Local;
use super::polar::Polar;
use super::section::{
    Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip, state,
};
use super::separated::lift_of;

/// Lag of separation; no lag of circulation, no added mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oye {
    /// Time constant of separation, in semichords travelled \[-\].
    pub separation_time: f64,
}

impl Default for Oye {
    fn default() -> Self {
        Self {
            separation_time: 6.0,
        }
    }
}

const STATES: [StateName; 1] = [state("attached part of the chord", "-", "1/s")];

impl Adjustable for Oye {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        vec![("T_f0", &mut self.separation_time)]
    }
}

impl Model for Oye {
    fn states(&self) -> &'static [StateName] {
        &STATES
    }

    fn start<P: Polar>(
        &self,
        _strip: &Strip,
        polar: &P,
        flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()> {
        let states: &mut [f64; 1] = states.try_into().ok()?;
        let local = Local::of(flow);
        *states = [polar.attached(local.angle(local.rear))];
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
        let &[part]: &[T; 1] = states.try_into().ok()?;
        let &[rate]: &[T; 1] = rates.try_into().ok()?;
        let rows: &mut [T; 1] = rows.try_into().ok()?;
        let local = Local::of(flow);
        let alpha = local.angle(local.rear);
        let target = polar.attached(alpha);
        *rows = [rate - local.follow(strip, self.separation_time, part, target, 1.0)];
        let coefficients = lift_of(polar, flow, &local, alpha, [part, target]);
        Some(local.force(strip, local.quarter, &coefficients))
    }
}
