//! Uniform inflow by momentum theory, with the lag of the air that it accelerates.
//!
//! ```text
//! (8 / 3 pi) l' + Omega (2 l m(l) - CT) = 0
//! ```
//!
//! after [Glauert1926] and [Carpenter1953]: the lag is the apparent mass of a disk; in hover its
//! time constant is `(8 / 3 pi) / (4 l Omega)`.

use std::f64::consts::PI;

use crate::real::Real;
use crate::unsteady::{StateName, state};

use super::mass_flow::{MassFlow, steady_uniform};
use super::rotor::{Inflow, RotorFlow, RotorLoads};

/// Apparent mass of the uniform inflow \[-\].
pub(super) const MASS: f64 = 8.0 / (3.0 * PI);

/// Uniform inflow.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Uniform;

/// The list of states of all models with one state.
pub(super) const MEAN: [StateName; 1] = [state(
    "mean induced velocity over the tip speed",
    "-",
    "1/s",
)];

/// The start of all models with one state.
pub(super) fn start(flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()> {
    let states: &mut [f64; 1] = states.try_into().ok()?;
    *states = [steady_uniform(thrust, flow.advance, flow.axial)];
    Some(())
}

/// The row of all models with one state.
pub(super) fn row<T: Real>(
    flow: &RotorFlow<T>,
    loads: &RotorLoads<T>,
    states: &[T],
    rates: &[T],
    rows: &mut [T],
) -> Option<()> {
    let &[mean]: &[T; 1] = states.try_into().ok()?;
    let &[rate]: &[T; 1] = rates.try_into().ok()?;
    let rows: &mut [T; 1] = rows.try_into().ok()?;
    let air = MassFlow::of(flow.advance, flow.axial, mean);
    *rows = [rate * MASS + flow.speed * (mean * air.total * 2.0 - loads.thrust)];
    Some(())
}

/// The mean and the mass flow of all models with one state.
pub(super) fn mean<T: Real>(flow: &RotorFlow<T>, states: &[T]) -> Option<(T, MassFlow<T>)> {
    let &[mean]: &[T; 1] = states.try_into().ok()?;
    Some((mean, MassFlow::of(flow.advance, flow.axial, mean)))
}

impl Inflow for Uniform {
    fn states(&self) -> &'static [StateName] {
        &MEAN
    }

    fn start(&self, flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()> {
        start(flow, thrust, states)
    }

    fn rows<T: Real>(
        &self,
        flow: &RotorFlow<T>,
        loads: &RotorLoads<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<()> {
        row(flow, loads, states, rates, rows)
    }

    fn induced<T: Real>(
        &self,
        _flow: &RotorFlow<T>,
        states: &[T],
        _radius: T,
        _azimuth: T,
    ) -> Option<T> {
        let &[mean]: &[T; 1] = states.try_into().ok()?;
        Some(mean)
    }
}
