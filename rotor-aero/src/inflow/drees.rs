//! Linear distribution over the disk after Drees, on uniform inflow.
//!
//! ```text
//! l(r, psi) = l_0 [1 + r (k_x cos psi + k_y sin psi)]
//! k_x = (4/3) (1 - cos chi - 1.8 mu^2) / sin chi = (4/3) (tan(chi/2) - 1.8 mu m) ,  k_y = -2 mu
//! ```
//!
//! with the angle chi of the wake from the shaft and sin chi = mu/m ([Drees1949]). Inflow is
//! larger aft, and smaller on the advancing side.

use crate::real::Real;
use crate::unsteady::StateName;

use super::mass_flow::MassFlow;
use super::rotor::{Inflow, RotorFlow, RotorLoads};
use super::uniform;

/// Linear distribution of Drees.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Drees;

impl Drees {
    /// The gradients k_x aft and k_y toward the advancing side, over the mean.
    pub fn gradients<T: Real>(flow: &RotorFlow<T>, air: &MassFlow<T>) -> [T; 2] {
        let aft = (air.half_tangent() - flow.advance * air.total * 1.8) * (4.0 / 3.0);
        [aft, flow.advance * (-2.0)]
    }
}

impl Inflow for Drees {
    fn states(&self) -> &'static [StateName] {
        &uniform::MEAN
    }

    fn start(&self, flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()> {
        uniform::start(flow, thrust, states)
    }

    fn rows<T: Real>(
        &self,
        flow: &RotorFlow<T>,
        loads: &RotorLoads<T>,
        states: &[T],
        rates: &[T],
        rows: &mut [T],
    ) -> Option<()> {
        uniform::row(flow, loads, states, rates, rows)
    }

    fn induced<T: Real>(
        &self,
        flow: &RotorFlow<T>,
        states: &[T],
        radius: T,
        azimuth: T,
    ) -> Option<T> {
        let (mean, air) = uniform::mean(flow, states)?;
        let [aft, advancing] = Self::gradients(flow, &air);
        let (sin, cos) = azimuth.sin_cos();
        Some(mean * (radius * (aft * cos + advancing * sin) + 1.0))
    }
}
