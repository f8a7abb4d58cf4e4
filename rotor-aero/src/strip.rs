//! A strip of a blade: its section, and the inflow of its annulus.
//!
//! Airfoil axes: x toward the leading edge, y to the upper surface, z along the span. The section
//! moves with w0 against the air, without the induced velocity; the shaft has the components s.
//!
//! ```text
//! n = (s_x, s_y)/|(s_x, s_y)|        t = (-n_y, n_x)
//! Vx = w0 . n      Vy = - w0 . t     w = w0 + u n + v t
//! ```
//!
//! u is the induced velocity against n and v the one against t, see [`crate::momentum`]. By a model of
//! the disk there is one velocity u against the shaft, of which the section has the components:
//! `w = w0 + u (s_x, s_y)`.
//!
//! Radial drag is the friction of the flow along the span, with the drag at zero angle of attack:
//! drag of larger angles is due to pressure, which has no component along the span.
//!
//! ```text
//! F_z = - rho/2 c c_d(0) w_z |(w_x, w_y, w_z)|
//! ```
//!
//! References: [Masarati], 5.9.

use crate::airfoil::{Flow, Section};
use crate::real::Real;
use crate::unsteady::{self, Model, Polar, QuasiSteady, SectionFlow, SectionForce};
use crate::wind::Atmosphere;

#[cfg(test)]
mod flap_tests;
#[cfg(test)]
mod friction_tests;
mod induced;
mod linear;
mod mach;
mod polar;
mod report;
mod ring;
mod start;

pub use crate::unsteady::{Flap, SectionModel};
pub use induced::{AnnularInflow, StripInflow, Wake};
pub use linear::StripJacobian;
pub use mach::BeyondMach;
pub use report::{ReportNumber, StripReport};

use linear::Numbers;
use polar::StripPolar;
use ring::{Ring, RingFlow};

/// Motion of a section against the air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripFlow<T> {
    /// Velocity of the quarter chord against the air without induction, airfoil axes [m/s].
    pub velocity: [T; 3],
    /// Angular velocity about the span, nose up positive [rad/s].
    pub pitch_rate: T,
    /// Direction of the shaft, airfoil axes \[-\].
    pub shaft: [T; 3],
    /// Distance of the quarter chord from the axis of the shaft \[m\].
    pub radius: T,
    /// Radius of the tip of the blade \[m\].
    pub tip_radius: T,
    /// Deflection of the flap, trailing edge down positive \[rad\].
    pub flap: T,
}

/// Numbers of a [`StripFlow`], in its order.
pub const FLOW: usize = 10;
/// Most unknowns of a strip.
pub const STATES: usize = 16;
/// Loads of a strip: force along x, y, z and moment.
pub const LOADS: usize = 4;
/// Most outputs of a strip: its loads, then a row for each of its unknowns.
pub const OUTPUTS: usize = LOADS + STATES;
/// Most inputs of a strip: flow, unknowns, and their rates.
pub const INPUTS: usize = FLOW + 2 * STATES;

/// An unknown of a strip, and its equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripState {
    /// Name.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Unit of its equation.
    pub row_unit: &'static str,
    /// Whether its rate appears.
    pub has_rate: bool,
}

/// The air at a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActingAir<'a> {
    /// Its properties.
    pub still: &'a Atmosphere,
    /// Part of its forces that acts: one, except on the way to an equilibrium \[-\].
    pub part: f64,
}

impl<T: Real> StripFlow<T> {
    /// The flow from its numbers.
    pub fn from_numbers(of: &[T; FLOW]) -> Self {
        Self {
            velocity: [of[0], of[1], of[2]],
            pitch_rate: of[3],
            shaft: [of[4], of[5], of[6]],
            radius: of[7],
            tip_radius: of[8],
            flap: of[9],
        }
    }
}

/// The velocity of a section against the air with the induced velocities of an annulus.
fn annular<T: Real>(flow: &StripFlow<T>, axes: &[[T; 2]; 2], [u, v]: [T; 2]) -> [T; 2] {
    [0, 1].map(|i| flow.velocity[i] + u * axes[0][i] + v * axes[1][i])
}

/// In-plane axes of the annulus in the airfoil axes: n and t, see the module.
pub(crate) fn plane<T: Real>(shaft: &[T; 3]) -> [[T; 2]; 2] {
    let length = (shaft[0] * shaft[0] + shaft[1] * shaft[1]).sqrt();
    let n = [shaft[0] / length, shaft[1] / length];
    [n, [-n[1], n[0]]]
}

/// A strip before it is built.
#[derive(Debug, Clone)]
pub struct StripDesign {
    /// Chord \[m\].
    pub chord: f64,
    /// Airfoil.
    pub section: Section,
    /// Model of the section.
    pub model: SectionModel,
    /// Inflow; none without.
    pub inflow: Option<StripInflow>,
    /// Whether the flow along the span has friction.
    pub radial_drag: bool,
}

/// A strip of a blade.
#[derive(Debug, Clone)]
pub struct Strip {
    chord: f64,
    polar: StripPolar,
    /// Largest Mach number for which its airfoils have values \[-\].
    largest_mach: f64,
    model: SectionModel,
    inflow: Option<StripInflow>,
    radial_drag: bool,
    flap: Option<Flap>,
    states: Vec<StripState>,
    /// Number of unknowns of the inflow, the first ones.
    of_inflow: usize,
}

/// Words in the names of induced velocities.
pub const INDUCED_VELOCITY: &str = "induced velocity";

/// Unknowns of the inflow: induced velocities, the first stage of the dynamic wake, and the velocities
/// of the steady state that it may follow.
const INDUCED: [&str; 6] = [
    "induced velocity along the shaft",
    "induced velocity around the shaft",
    "first lag of the velocity along the shaft",
    "first lag of the velocity around the shaft",
    "steady velocity along the shaft",
    "steady velocity around the shaft",
];

/// Unknowns of a dynamic wake with rates.
const LAGGED: usize = 4;

/// The velocity at a strip that a model of the disk gives.
const AT_STRIP: StripState = StripState {
    name: INDUCED[0],
    unit: "m/s",
    row_unit: "m/s",
    has_rate: false,
};

/// The unknowns of an annulus, the first with its name.
fn of_annulus(inflow: &AnnularInflow, first: &'static str) -> Vec<StripState> {
    let count = inflow.wake.unknowns();
    let names = std::iter::once(&first).chain(&INDUCED[1..count]);
    let names = names.enumerate();
    names
        .map(|(number, name)| StripState {
            name,
            unit: "m/s",
            row_unit: "m^2/s^2",
            has_rate: count >= LAGGED && number < LAGGED,
        })
        .collect()
}

impl Strip {
    /// The strip of a design.
    pub fn new(design: StripDesign) -> Self {
        let of_inflow = match design.inflow {
            None => Vec::new(),
            Some(StripInflow::Disk) => vec![AT_STRIP],
            Some(StripInflow::Annular(inflow)) => of_annulus(&inflow, INDUCED[0]),
            Some(StripInflow::Distributed(inflow)) => {
                let mut states = of_annulus(&inflow, "mean induced velocity of the annulus");
                states.insert(0, AT_STRIP);
                states
            }
        };
        let own = design.model.states().iter().map(|state| StripState {
            name: state.name,
            unit: state.unit,
            row_unit: state.row_unit,
            has_rate: true,
        });
        Self {
            of_inflow: of_inflow.len(),
            states: of_inflow.into_iter().chain(own).collect(),
            chord: design.chord,
            largest_mach: mach::largest(&design.section),
            model: design.model.of_section(&design.section),
            polar: StripPolar::new(design.section, &design.model),
            inflow: design.inflow,
            radial_drag: design.radial_drag,
            flap: None,
        }
    }

    /// The same with a part of its lift \[-\]: none near the tip in a disk without its losses.
    #[must_use]
    pub fn with_lift(mut self, part: f64) -> Self {
        self.polar = self.polar.with_lift(part);
        self
    }

    /// The same with a flap.
    #[must_use]
    pub fn with_flap(mut self, flap: Flap) -> Self {
        self.flap = Some(flap);
        self
    }

    /// Its unknowns.
    pub fn states(&self) -> &[StripState] {
        &self.states
    }

    /// Sum of the absolute values of the terms of each row, by which its error is judged [unit of
    /// each row].
    pub fn sizes(&self, flow: &[f64; FLOW], states: &[f64], rates: &[f64]) -> [f64; STATES] {
        let mut sizes = [0.0; STATES];
        let speed = (flow[0] * flow[0] + flow[1] * flow[1]).sqrt();
        let along = (flow[0] * flow[4] + flow[1] * flow[5]).abs();
        let pairs = states.iter().zip(rates).zip(&self.states);
        for (number, (size, ((value, rate), state))) in sizes.iter_mut().zip(pairs).enumerate() {
            // Velocities times a mass flow, momenta as they are, and lags over a semichord.
            let factor = match number < self.of_inflow {
                _ if state.row_unit == state.unit => 1.0,
                true => along + value.abs(),
                false => 2.0 * speed / self.chord,
            };
            // The terms of a row cancel: they are twice one of their sides.
            *size = 2.0 * (factor * value.abs() + rate.abs());
        }
        sizes
    }

    /// Loads and rows for the numbers of a flow, the unknowns and their rates.
    pub fn evaluate(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        states: &[f64],
        rates: &[f64],
    ) -> [f64; OUTPUTS] {
        self.outputs(air, &StripFlow::from_numbers(flow), states, rates)
    }

    /// The same with derivatives.
    pub fn linearize(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        states: &[f64],
        rates: &[f64],
    ) -> StripJacobian {
        let at = Numbers {
            flow,
            states,
            rates,
        };
        self.by_parts(air, &at)
    }

    /// Loads and rows.
    fn outputs<T: Real>(
        &self,
        air: ActingAir<'_>,
        flow: &StripFlow<T>,
        states: &[T],
        rates: &[T],
    ) -> [T; OUTPUTS] {
        let mut out = [T::from(0.0); OUTPUTS];
        let (induced, own) = states.split_at(self.of_inflow);
        let (induced_rates, own_rates) = rates.split_at(self.of_inflow);
        let axes = plane(&flow.shaft);
        let velocity = self.velocity(flow, &axes, induced);
        let rows = LOADS + self.of_inflow..LOADS + states.len();
        let force = self.section(
            air,
            (velocity, flow.pitch_rate, flow.flap),
            (own, own_rates),
            &mut out[rows],
        );
        out[0] = force.along;
        out[1] = force.normal;
        if self.radial_drag {
            out[2] = self.friction(air, &[velocity[0], velocity[1], flow.velocity[2]]);
        }
        out[3] = force.moment;
        let (annulus, first) = self.annulus();
        out[LOADS..LOADS + first].copy_from_slice(&induced[..first]);
        if let Some(inflow) = annulus {
            let loads = [force.along, force.normal];
            let ring = |loads: [T; 2], local: T| {
                let flow = RingFlow::of(flow, &axes, &loads, local);
                Ring::new(inflow, air.still.density, flow)
            };
            let rows = &mut out[LOADS + first..LOADS + self.of_inflow];
            let (own, steady) = rows.split_at_mut(rows.len().min(LAGGED));
            ring(loads, induced[0]).rows((&induced[first..], &induced_rates[first..]), own);
            if let [_, _, _, _, u, v] = induced[first..] {
                let velocity = annular(flow, &axes, [u, v]);
                let force = self.static_section(air, (velocity, flow.pitch_rate, flow.flap));
                ring([force.along, force.normal], u).equilibrium([u, v], steady);
            }
        }
        out
    }

    /// Forces of the section by its static coefficients in the velocity against the air.
    fn static_section<T: Real>(
        &self,
        air: ActingAir<'_>,
        (velocity, pitch_rate, deflection): ([T; 2], T, T),
    ) -> SectionForce<T> {
        let rigid = self.rigid(air, velocity, pitch_rate);
        let flow = self.deflected(rigid, deflection);
        let strip = self.constants(air);
        // The model without states has no rows.
        let force = QuasiSteady.evaluate(&strip, &self.polar, &flow, &[], &[], &mut []);
        SectionForce::part_of(force, air.part)
    }

    /// Friction of the flow along the span, per length [N/m].
    fn friction<T: Real>(&self, air: ActingAir<'_>, &[x, y, z]: &[T; 3]) -> T {
        let in_plane = (x * x + y * y + SLOW * SLOW).sqrt();
        let drag = self.polar.drag(&Flow {
            mach: in_plane / air.still.sound_speed,
            reynolds: in_plane * (self.chord * air.still.density / air.still.viscosity),
            alpha: T::from(0.0),
            flap: T::from(0.0),
        });
        let speed = (x * x + y * y + z * z + SLOW * SLOW).sqrt();
        drag * z * speed * (-0.5 * air.still.density * self.chord * air.part)
    }

    /// Velocity of the section against the air, without the velocity along the span.
    fn velocity<T: Real>(&self, flow: &StripFlow<T>, axes: &[[T; 2]; 2], induced: &[T]) -> [T; 2] {
        let own = [flow.velocity[0], flow.velocity[1]];
        match (&self.inflow, induced) {
            (Some(StripInflow::Disk), [u]) => [0, 1].map(|i| own[i] + *u * flow.shaft[i]),
            (Some(StripInflow::Annular(_)), [u, v, ..]) => annular(flow, axes, [*u, *v]),
            (Some(StripInflow::Distributed(_)), [u, _, v, ..]) => annular(flow, axes, [*u, *v]),
            _ => own,
        }
    }

    /// The flow at the section without a flap, of its velocity against the air.
    fn rigid<T: Real>(&self, air: ActingAir<'_>, [x, y]: [T; 2], pitch_rate: T) -> SectionFlow<T> {
        let speed = (x * x + y * y + SLOW * SLOW).sqrt();
        SectionFlow {
            mach: speed / air.still.sound_speed,
            reynolds: speed * (self.chord * air.still.density / air.still.viscosity),
            ..SectionFlow::rigid(-y, x, pitch_rate, self.chord)
        }
    }

    /// The same with the flap deflected, if there is one.
    fn deflected<T: Real>(&self, flow: SectionFlow<T>, deflection: T) -> SectionFlow<T> {
        let flap = self.flap.as_ref();
        flap.map_or(flow, |flap| flap.deflected(&flow, deflection))
    }

    fn constants(&self, air: ActingAir<'_>) -> unsteady::Strip {
        unsteady::Strip {
            chord: self.chord,
            density: air.still.density,
        }
    }

    /// Whether Newton's method needs [`Strip::settle`] to find a steady flow.
    pub fn needs_start(&self) -> bool {
        self.model.needs_start()
    }

    /// Replaces the states of the section by the ones of a steady flow, in the flow and the induced
    /// velocities given.
    pub fn settle(&self, air: ActingAir<'_>, flow: &[f64; FLOW], states: &mut [f64]) {
        let flow = StripFlow::from_numbers(flow);
        let (induced, own) = states.split_at_mut(self.of_inflow);
        if air.part == 0.0 {
            return own.fill(0.0);
        }
        let velocity = self.velocity(&flow, &plane(&flow.shaft), induced);
        let rigid = self.rigid(air, velocity, flow.pitch_rate);
        let flow = self.deflected(rigid, flow.flap);
        // The states have the length of the model's list.
        let _written = self
            .model
            .start(&self.constants(air), &self.polar, &flow, own);
    }

    /// Forces of the section in the velocity against the air, and the rows of its states.
    fn section<T: Real>(
        &self,
        air: ActingAir<'_>,
        (velocity, pitch_rate, deflection): ([T; 2], T, T),
        (states, rates): (&[T], &[T]),
        rows: &mut [T],
    ) -> SectionForce<T> {
        let rigid = self.rigid(air, velocity, pitch_rate);
        let strip = self.constants(air);
        if air.part == 0.0 {
            // Without forces there is nothing that the states could lag behind.
            for ((row, state), rate) in rows.iter_mut().zip(states).zip(rates) {
                *row = *state + *rate;
            }
            return SectionForce::part_of(None, air.part);
        }
        let flow = self.deflected(rigid, deflection);
        let of_flap = self.flap.as_ref();
        let of_flap = of_flap.map(|flap| flap.moment(&strip, &rigid, deflection) * air.part);
        let force = self
            .model
            .evaluate(&strip, &self.polar, &flow, states, rates, rows);
        let force = SectionForce::part_of(force, air.part);
        SectionForce {
            moment: force.moment + of_flap.unwrap_or_else(T::zero),
            ..force
        }
    }
}

/// Speed by which the derivative of a speed is smooth at zero [m/s].
const SLOW: f64 = 1e-3;
