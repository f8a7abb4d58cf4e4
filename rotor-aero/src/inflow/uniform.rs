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

/// Distribution over the disk of an inflow whose mean is uniform inflow: its one state.
pub trait Distribution {
    /// The induced velocity over its mean, at a position toward the advancing side and toward the tail
    /// over R.
    fn over_mean<T: Real>(&self, flow: &RotorFlow<T>, air: &MassFlow<T>, position: &[T; 2]) -> T;
}

const MEAN: [StateName; 1] = [state(
    "mean induced velocity over the tip speed",
    "-",
    "1/s",
)];

impl<D: Distribution> Inflow for D {
    fn states(&self) -> &'static [StateName] {
        &MEAN
    }

    fn start(&self, flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()> {
        let states: &mut [f64; 1] = states.try_into().ok()?;
        *states = [steady_uniform(thrust, flow.advance, flow.axial)];
        Some(())
    }

    fn rows<T: Real>(
        &self,
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

    fn induced<T: Real>(&self, flow: &RotorFlow<T>, states: &[T], position: &[T; 2]) -> Option<T> {
        let &[mean]: &[T; 1] = states.try_into().ok()?;
        let air = MassFlow::of(flow.advance, flow.axial, mean);
        Some(mean * self.over_mean(flow, &air, position))
    }
}

impl Distribution for Uniform {
    fn over_mean<T: Real>(&self, _: &RotorFlow<T>, _: &MassFlow<T>, _: &[T; 2]) -> T {
        T::one()
    }
}
