//! Static coefficients at the angle of attack of the three-quarter chord.
//!
//! ```text
//! alpha = atan2(w_34, v_x) ;  lift normal to the flow at the quarter chord
//! ```

use crate::real::Real;

use super::local::Local;
use super::polar::Polar;
use super::section::{Adjustable, Constant, Model, SectionFlow, SectionForce, StateName, Strip};

/// The quasi-steady section, without states and without added mass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct QuasiSteady;

impl Adjustable for QuasiSteady {
    fn constants(&mut self) -> Vec<Constant<'_>> {
        Vec::new()
    }
}

impl Model for QuasiSteady {
    fn states(&self) -> &'static [StateName] {
        &[]
    }

    fn start<P: Polar>(
        &self,
        _strip: &Strip,
        _polar: &P,
        _flow: &SectionFlow<f64>,
        states: &mut [f64],
    ) -> Option<()> {
        states.is_empty().then_some(())
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
        if !(states.is_empty() && rates.is_empty() && rows.is_empty()) {
            return None;
        }
        let local = Local::of(flow);
        let coefficients = polar.coefficients(&flow.at(local.angle(local.rear)));
        Some(local.force(strip, local.quarter, &coefficients))
    }
}
