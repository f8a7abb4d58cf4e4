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

use super::mass_flow::MassFlow;
use super::rotor::RotorFlow;
use super::uniform::Distribution;

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

impl Distribution for Drees {
    fn over_mean<T: Real>(&self, flow: &RotorFlow<T>, air: &MassFlow<T>, position: &[T; 2]) -> T {
        let [aft, advancing] = Self::gradients(flow, air);
        aft * position[1] + advancing * position[0] + 1.0
    }
}
