//! Three-state inflow of Pitt and Peters.
//!
//! ```text
//! l(r, psi) = l_0 + r (l_s sin psi + l_c cos psi)
//! M l' + Omega (V L^-1 l - C) = 0 ,  C = (CT, CL, CM)
//! M = diag(8/(3 pi), 16/(45 pi), 16/(45 pi)) ,  V = diag(m, d(l_0 m)/dl_0, d(l_0 m)/dl_0)
//!     | 1/2      0       -k X     |
//! L = |  0    4/(1+s)     0       | ,  s = cos chi ,  X = tan(chi/2) ,  k = 15 pi/64
//!     | k X      0     4 s/(1+s)  |
//! ```
//!
//! ([Pitt1981], [Peters1988]). The mass flow m and the angle chi of the wake from the shaft are
//! from [`MassFlow`], in descent too: `d(l_0 m)/dl_0 = (mu^2 + lt (lt + l_0))/m` in climb,
//! hover and forward flight, with `lt = mu_z + l_0`.

use std::f64::consts::PI;

use crate::real::Real;
use crate::unsteady::{StateName, state};

use super::mass_flow::{MassFlow, steady_uniform};
use super::rotor::{Inflow, RotorFlow, RotorLoads};
use super::uniform::MASS;

/// Apparent mass of the gradients \[-\].
const GRADIENT_MASS: f64 = 16.0 / (45.0 * PI);
/// Coupling of thrust and pitch moment, k \[-\].
const COUPLING: f64 = 15.0 * PI / 64.0;

/// Three-state inflow.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PittPeters;

const STATES: [StateName; 3] = [
    state("mean induced velocity over the tip speed", "-", "1/s"),
    state(
        "gradient of the induced velocity toward the advancing side",
        "-",
        "1/s",
    ),
    state(
        "gradient of the induced velocity toward the tail",
        "-",
        "1/s",
    ),
];

/// The product `V L^-1 l`.
fn convected<T: Real>(air: &MassFlow<T>, [mean, sine, cosine]: [T; 3]) -> [T; 3] {
    let [s, coupling] = [air.cosine, air.sine * COUPLING];
    // The determinant of the block of thrust and pitch moment, times 1 + s.
    let determinant = s * 2.0 + (-s + 1.0) * (COUPLING * COUPLING);
    let thrust = (s * mean * 4.0 + coupling * cosine) / determinant;
    let roll = (s + 1.0) * sine * 0.25;
    let pitch = ((s + 1.0) * cosine * 0.5 - coupling * mean) / determinant;
    [air.total * thrust, air.change * roll, air.change * pitch]
}

impl Inflow for PittPeters {
    fn states(&self) -> &'static [StateName] {
        &STATES
    }

    fn gradients(&self) -> Option<[usize; 2]> {
        Some([1, 2])
    }

    fn start(&self, flow: &RotorFlow<f64>, thrust: f64, states: &mut [f64]) -> Option<()> {
        let states: &mut [f64; 3] = states.try_into().ok()?;
        let mean = steady_uniform(thrust, flow.advance, flow.axial);
        let air = MassFlow::of(flow.advance, flow.axial, mean);
        *states = [mean, 0.0, 2.0 * COUPLING * air.half_tangent() * mean];
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
        let &[mean, sine, cosine]: &[T; 3] = states.try_into().ok()?;
        let &[r0, r1, r2]: &[T; 3] = rates.try_into().ok()?;
        let rows: &mut [T; 3] = rows.try_into().ok()?;
        let air = MassFlow::of(flow.advance, flow.axial, mean);
        let [c0, c1, c2] = convected(&air, [mean, sine, cosine]);
        *rows = [
            r0 * MASS + flow.speed * (c0 - loads.thrust),
            r1 * GRADIENT_MASS + flow.speed * (c1 - loads.sine),
            r2 * GRADIENT_MASS + flow.speed * (c2 - loads.cosine),
        ];
        Some(())
    }
}
