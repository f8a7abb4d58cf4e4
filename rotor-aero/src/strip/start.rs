//! First guess of the induced velocities of an annulus: its steady state by one bracketed unknown, the
//! angle of the flow, see [`crate::momentum::solve`].
//!
//! In the plane of the section the angle of attack is `alpha = theta - phi`, with the angle of the
//! chord `theta = atan2(n_x, n_y)` by the axis n of the annulus in airfoil axes.

use super::{ActingAir, FLOW, Strip, StripFlow, plane};
use crate::airfoil::Flow;
use crate::momentum::{Annulus, Outcome, solve};
use crate::unsteady::Polar;
use crate::wake::FilterState;

impl Strip {
    /// Whether it has an annulus of its own.
    pub fn has_annulus(&self) -> bool {
        self.annulus().0.is_some()
    }

    /// Replaces the unknowns of its annulus by the induced velocities of a steady flow, by the static
    /// coefficients at the Mach and Reynolds numbers without induction, and the states of its section by
    /// the ones in these velocities. Without an annulus, without air and where there is no steady state
    /// they remain.
    pub fn begin(&self, air: ActingAir<'_>, flow: &[f64; FLOW], states: &mut [f64]) {
        let (Some(inflow), first) = self.annulus() else {
            return;
        };
        let numbers = flow;
        let flow = StripFlow::from_numbers(numbers);
        let [n, t] = plane(&flow.shaft);
        let along = |axis: [f64; 2]| axis[0] * flow.velocity[0] + axis[1] * flow.velocity[1];
        let speed = flow.velocity[0].hypot(flow.velocity[1]);
        let annulus = Annulus {
            radius: flow.radius,
            hub_radius: inflow.hub_radius,
            tip_radius: flow.tip_radius,
            blades: inflow.blades,
            chord: self.chord,
            options: inflow.options,
        };
        let section = |alpha: f64| {
            let found = self.polar.coefficients(&Flow {
                mach: speed / air.still.sound_speed,
                reynolds: speed * (self.chord * air.still.density / air.still.viscosity),
                alpha,
                flap: 0.0,
            });
            found.scaled(air.part)
        };
        let found = solve(&annulus, n[0].atan2(n[1]), along(n), -along(t), section);
        if air.part == 0.0 || found.outcome != Outcome::Solved {
            return;
        }
        let [u, v] = [found.axial, found.swirl];
        let stage = |velocity: f64| FilterState::steady(velocity).first;
        let steady = [u, v, stage(u), stage(v), u, v];
        states[..first].fill(u);
        let own = states[first..self.of_inflow].iter_mut();
        own.zip(steady).for_each(|(state, value)| *state = value);
        self.settle(air, numbers, states);
    }
}

#[cfg(test)]
#[path = "start_tests.rs"]
mod tests;
