//! The momentum of the annulus of a strip, as rows of its induced velocities.
//!
//! With the force f per length on each of B blades at the radius r, and the mass-flow speed m and
//! the loss F of [`crate::momentum`]:
//!
//! ```text
//! u_qs m = B f . n / (4 pi r rho F)              v_qs m = B f . t / (4 pi r rho F)
//! equilibrium    u m - u_qs m = 0                v m - v_qs m = 0
//! dynamic        m tau2 (u' - w') = 0            m tau1 (y' - y'_f) = 0
//! steady         u_s m(u_s) - u_qs(u_s, v_s) m(u_s) = 0          the same of v_s
//! ```
//!
//! A drag that is switched off has no part in f: with the velocity w of the section against the air,
//!
//! ```text
//! f - (f . w) w/|w|^2
//! ```
//!
//! The lagged velocities follow (u_qs, v_qs), or the steady state (u_s, v_s), whose forces are by static
//! coefficients,
//! with the rates w' and y'_f of the two stages of the filter ([`crate::wake::rates`]), times the
//! mass flow, so that the rows are smooth where it is small.

use std::f64::consts::PI;

use super::{AnnularInflow, StripFlow, Wake};
use crate::momentum::{Ambient, LOSS_FLOOR, hub_loss, mass_flow_by, tip_loss};
use crate::real::Real;
use crate::wake::{FilterState, TimeScale, rates};

/// Smallest part of the tip radius at which an annulus is evaluated \[-\].
const INNERMOST: f64 = 1e-3;

/// The annulus of a strip.
pub(super) struct Ring<'a, T> {
    inflow: &'a AnnularInflow,
    ambient: Ambient<T>,
    radius: T,
    tip_radius: T,
    /// `B f / (4 pi r rho)` along n and t \[m^2/s^2\].
    load: [T; 2],
    /// Velocity induced at the section along n \[m/s\].
    local: T,
}

/// Flow and forces of the section in an annulus.
pub(super) struct RingFlow<T> {
    /// Velocities along n, and against t, without induction [m/s].
    pub ambient: Ambient<T>,
    /// Distances of the quarter chord and of the tip from the axis [m].
    pub radii: [T; 2],
    /// Force per length along n and t [N/m].
    pub force: [T; 2],
    /// Velocity induced at the section along n: of the annulus, or of its distribution [m/s].
    pub local: T,
}

impl<T: Real> RingFlow<T> {
    /// Of a strip with the in-plane axes n and t, the force per length in the airfoil axes [N/m], and the
    /// velocity along n that is induced at it [m/s].
    pub fn of(flow: &StripFlow<T>, axes: &[[T; 2]; 2], force: &[T; 2], local: T) -> Self {
        let along = |axis: &[T; 2], of: [T; 2]| axis[0] * of[0] + axis[1] * of[1];
        let velocity = [flow.velocity[0], flow.velocity[1]];
        Self {
            ambient: Ambient {
                axial: along(&axes[0], velocity),
                rotation: -along(&axes[1], velocity),
                skew: T::from(0.0),
            },
            radii: [flow.radius, flow.tip_radius],
            force: [0, 1].map(|i| along(&axes[i], *force)),
            local,
        }
    }
}

impl<'a, T: Real> Ring<'a, T> {
    /// The annulus of a flow, with the density of the air [kg/m^3].
    pub fn new(inflow: &'a AnnularInflow, density: f64, flow: RingFlow<T>) -> Self {
        let [radius, tip_radius] = flow.radii;
        let least = tip_radius * INNERMOST;
        let radius = if radius.re() > least.re() {
            radius
        } else {
            least
        };
        let scale = radius.recip() * (inflow.blades as f64 / (4.0 * PI * density));
        Self {
            inflow,
            ambient: flow.ambient,
            radius,
            tip_radius,
            load: flow.force.map(|force| scale * force),
            local: flow.local,
        }
    }

    /// The load without the drag that is switched off, at a velocity v around the shaft \[m^2/s^2\].
    fn inducing(&self, v: T) -> [T; 2] {
        let options = &self.inflow.options;
        let [normal, tangential] = self.load;
        if options.axial_drag && options.tangential_drag {
            return self.load;
        }
        let [x, y] = [self.ambient.axial + self.local, self.ambient.rotation - v];
        // Smooth where the section is at rest.
        let drag = (normal * x - tangential * y) / (x * x + y * y + 1e-12);
        let kept = |on: bool, load: T, drag: T| if on { load } else { load - drag };
        [
            kept(options.axial_drag, normal, drag * x),
            kept(options.tangential_drag, tangential, -drag * y),
        ]
    }

    /// Factor of loss at the induced velocities.
    fn loss(&self, u: T, v: T) -> T {
        let [x, y] = [self.ambient.axial + u, self.ambient.rotation - v];
        // Smooth where the section is at rest.
        let speed = (x * x + y * y + 1e-12).sqrt();
        let sine = x / speed;
        let options = &self.inflow.options;
        let mut loss = T::from(1.0);
        if options.tip_loss {
            loss *= tip_loss(self.inflow.blades, self.radius, self.tip_radius, sine);
        }
        if options.hub_loss {
            loss *= hub_loss(
                self.inflow.blades,
                self.radius,
                self.inflow.hub_radius,
                sine,
            );
        }
        if loss.re() < LOSS_FLOOR {
            T::from(LOSS_FLOOR)
        } else {
            loss
        }
    }

    /// Writes the two rows of velocities in equilibrium with the loads.
    pub fn equilibrium(&self, [u, v]: [T; 2], rows: &mut [T]) {
        let (mass, [axial, swirl]) = self.momentum([u, v]);
        if let [row_u, row_v] = rows {
            *row_u = u * mass - axial;
            *row_v = v * mass - swirl;
        }
    }

    /// The mass flow, and the loads over 4 F.
    fn momentum(&self, [u, v]: [T; 2]) -> (T, [T; 2]) {
        let loss = self.loss(u, v);
        let options = &self.inflow.options;
        let mass = mass_flow_by(options.high_induction, &self.ambient, u, loss);
        let [axial, swirl] = self.inducing(v);
        let axial = axial / loss;
        let swirl = if options.swirl {
            swirl / loss
        } else {
            T::from(0.0)
        };
        (mass, [axial, swirl])
    }

    /// Writes the rows of the induced velocities, and of a dynamic wake of their first stages.
    pub fn rows(&self, (induced, induced_rates): (&[T], &[T]), rows: &mut [T]) {
        let (Some(&u), Some(&v)) = (induced.first(), induced.get(1)) else {
            return;
        };
        let Wake::Dynamic(scale, _) = self.inflow.wake else {
            return self.equilibrium([u, v], rows);
        };
        let (mass, [axial, swirl]) = self.momentum([u, v]);
        let [axial, swirl] = match induced.get(4..) {
            Some(&[axial, swirl]) => [axial, swirl],
            _ => [axial / mass, swirl / mass],
        };
        let constants = self.time_constants(scale, u);
        if let (&[_, _, y, z, ..], &[du, dv, dy, dz, ..], [row_u, row_v, row_y, row_z]) =
            (induced, induced_rates, rows)
        {
            let filter = |first: T, induced: T, target: T| {
                rates(&FilterState { first, induced }, target, constants)
            };
            let (axial, swirl) = (filter(y, u, axial), filter(z, v, swirl));
            let [slow, fast] = [mass * constants.0, mass * constants.1];
            *row_u = fast * (du - axial.induced);
            *row_v = fast * (dv - swirl.induced);
            *row_y = slow * (dy - axial.first);
            *row_z = slow * (dz - swirl.first);
        }
    }

    /// Time constants by the velocities of the annulus.
    fn time_constants(&self, scale: TimeScale, u: T) -> (T, T) {
        let axial = self.ambient.axial;
        let speed = match scale {
            TimeScale::Turbine | TimeScale::Frozen => axial,
            TimeScale::Hover { .. } => axial + u,
        };
        let induction = if axial.re() == 0.0 {
            T::from(0.0)
        } else {
            -u / axial
        };
        // The radius of the tip is an unknown, whose first guess may be zero.
        let tip = if self.tip_radius.re() > self.radius.re() {
            self.tip_radius
        } else {
            self.radius
        };
        scale.constants(tip, self.radius / tip, speed, induction)
    }
}
