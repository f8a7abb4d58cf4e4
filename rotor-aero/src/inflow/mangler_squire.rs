//! Distribution over the disk after Mangler and Squire, on uniform inflow.
//!
//! ```text
//! l(r, psi) = 4 l_0 (c_0/2 + c_1 cos psi) ,   eta = sqrt(1 - r^2) ,  X = tan(chi/2)
//! elliptic loading:  c_0 = (3/4) eta ,               c_1 = (3 pi/16) r X
//! zero at the hub:   c_0 = (15/8) eta (1 - eta^2) ,  c_1 = (15 pi/256) (5 - 9 eta^2) r X
//! ```
//!
//! from the potential of a lightly loaded disk at incidence ([Mangler1950]). The mean over the
//! disk is l_0; inflow at the aft edge is larger than at the front edge. Higher harmonics are left
//! out. The angle chi of the wake contains the induced velocity, so that the distribution becomes
//! symmetric in hover; it belongs to advance ratios above .1.

use std::f64::consts::PI;

use crate::real::Real;

use super::mass_flow::MassFlow;
use super::rotor::RotorFlow;
use super::uniform::Distribution;

/// Distribution of the load along the radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Loading {
    /// Elliptic, type 1.
    Elliptic,
    /// Zero at hub and tip, type 3.
    #[default]
    ZeroAtHub,
}

/// Distribution of Mangler and Squire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ManglerSquire {
    /// Distribution of the load.
    pub loading: Loading,
}

impl ManglerSquire {
    /// The terms c_0 and c_1 cos psi at the square of a radius and its part `aft`, for the tangent of half
    /// of the wake angle.
    fn terms<T: Real>(&self, radius_squared: T, aft: T, half_tangent: T) -> [T; 2] {
        let square = -radius_squared + 1.0;
        let eta = if square.re() > 0.0 {
            square.sqrt()
        } else {
            T::zero()
        };
        let first = aft * half_tangent;
        match self.loading {
            Loading::Elliptic => [eta * 0.75, first * (3.0 * PI / 16.0)],
            Loading::ZeroAtHub => [
                eta * radius_squared * (15.0 / 8.0),
                (-square * 9.0 + 5.0) * first * (15.0 * PI / 256.0),
            ],
        }
    }
}

impl Distribution for ManglerSquire {
    fn over_mean<T: Real>(
        &self,
        _flow: &RotorFlow<T>,
        air: &MassFlow<T>,
        &[advancing, aft]: &[T; 2],
    ) -> T {
        let radius_squared = advancing * advancing + aft * aft;
        let [c0, c1] = self.terms(radius_squared, aft, air.half_tangent());
        (c0 * 0.5 + c1) * 4.0
    }
}
