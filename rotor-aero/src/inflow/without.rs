//! No induced velocity: `l = 0`.
//!
//! For a rotor in a wind tunnel with known inflow, for comparisons with closed forms, and for
//! blades whose strips have the induced velocity of their annulus.

use crate::real::Real;
use crate::unsteady::StateName;

use super::rotor::{Inflow, RotorFlow, RotorLoads};

/// No inflow, no states.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Without;

impl Inflow for Without {
    fn states(&self) -> &'static [StateName] {
        &[]
    }

    fn start(&self, _flow: &RotorFlow<f64>, _thrust: f64, states: &mut [f64]) -> Option<()> {
        states.is_empty().then_some(())
    }

    fn rows<T: Real>(
        &self,
        _flow: &RotorFlow<T>,
        _loads: &RotorLoads<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<()> {
        (states.is_empty() && rates.is_empty() && rows.is_empty()).then_some(())
    }

    fn induced<T: Real>(
        &self,
        _flow: &RotorFlow<T>,
        states: &[T],
        _position: &[T; 2],
    ) -> Option<T> {
        states.is_empty().then(T::zero)
    }
}
