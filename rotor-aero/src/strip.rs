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
//! u is the induced velocity against n and v the one against t, see [`crate::momentum`].

use num_dual::DualSVec64;

use crate::airfoil::Section;
use crate::momentum::Options;
use crate::real::Real;
use crate::unsteady::{self, Model, SectionFlow, SectionForce};
use crate::wake::TimeScale;
use crate::wind::Atmosphere;

mod polar;
mod report;
mod ring;

pub use crate::unsteady::SectionModel;
pub use report::StripReport;

use polar::StripPolar;
use ring::Ring;

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
}

/// Numbers of a [`StripFlow`], in its order.
pub const FLOW: usize = 9;
/// Most unknowns of a strip.
pub const STATES: usize = 14;
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

/// Wake of an annulus.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Wake {
    /// In equilibrium with the loads at all times.
    #[default]
    Equilibrium,
    /// With the two lags of Oye and the given time constants, by the velocities of the annulus.
    Dynamic(TimeScale),
}

/// Inflow by the momentum of an annulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnularInflow {
    /// Number of blades.
    pub blades: usize,
    /// Radius at which the blades begin [m].
    pub hub_radius: f64,
    /// Switches.
    pub options: Options,
    /// Wake.
    pub wake: Wake,
}

/// Outputs of a strip and their derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct StripJacobian {
    /// Loads, then rows [N/m, N, unit of each row].
    pub values: [f64; OUTPUTS],
    /// Derivatives: row of an output; columns: the flow, the unknowns, and from `FLOW + STATES` on
    /// the rates.
    pub by: [[f64; INPUTS]; OUTPUTS],
}

impl StripJacobian {
    /// Outputs without derivatives.
    pub fn of_values(values: [f64; OUTPUTS]) -> Self {
        Self {
            values,
            by: [[0.0; INPUTS]; OUTPUTS],
        }
    }
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
        }
    }
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
    /// Inflow of its annulus; none without.
    pub inflow: Option<AnnularInflow>,
}

/// A strip of a blade.
#[derive(Debug, Clone)]
pub struct Strip {
    chord: f64,
    polar: StripPolar,
    model: SectionModel,
    inflow: Option<AnnularInflow>,
    states: Vec<StripState>,
    /// Number of unknowns of the inflow, the first ones.
    of_inflow: usize,
}

/// Unknowns of the inflow: induced velocities, and the first stage of the dynamic wake.
const INDUCED: [&str; 4] = [
    "induced velocity along the shaft",
    "induced velocity around the shaft",
    "first lag of the velocity along the shaft",
    "first lag of the velocity around the shaft",
];

impl Strip {
    /// The strip of a design.
    pub fn new(design: StripDesign) -> Self {
        let count = match design.inflow.map(|inflow| inflow.wake) {
            None => 0,
            Some(Wake::Equilibrium) => 2,
            Some(Wake::Dynamic(_)) => 4,
        };
        let induced = INDUCED[..count].iter().map(|name| StripState {
            name,
            unit: "m/s",
            row_unit: "m^2/s^2",
            has_rate: count == 4,
        });
        let own = design.model.states().iter().map(|state| StripState {
            name: state.name,
            unit: state.unit,
            row_unit: state.row_unit,
            has_rate: true,
        });
        Self {
            states: induced.chain(own).collect(),
            of_inflow: count,
            chord: design.chord,
            polar: StripPolar::new(design.section),
            model: design.model,
            inflow: design.inflow,
        }
    }

    /// Its unknowns.
    pub fn states(&self) -> &[StripState] {
        &self.states
    }

    /// Sum of the absolute values of the terms of each row, by which its error is judged [unit of
    /// each row].
    pub fn sizes(&self, flow: &[f64; FLOW], states: &[f64], rates: &[f64]) -> [f64; STATES] {
        let mut sizes = [0.0; STATES];
        let speed = flow[0].hypot(flow[1]);
        let along = (flow[0] * flow[4] + flow[1] * flow[5]).abs();
        let pairs = states.iter().zip(rates).zip(&self.states);
        for (number, (size, ((value, rate), state))) in sizes.iter_mut().zip(pairs).enumerate() {
            // Velocities times a mass flow, momenta as they are, and lags over a semichord.
            let factor = match number < self.of_inflow {
                true => along + value.abs(),
                false if state.row_unit == state.unit => 1.0,
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
        // Dual numbers of the smallest size that holds all inputs: quasi-steady sections in their
        // annulus, and the default section with its five states there.
        match FLOW + 2 * states.len() {
            0..=13 => self.dual::<13>(air, flow, states, rates),
            14..=23 => self.dual::<23>(air, flow, states, rates),
            _ => self.dual::<INPUTS>(air, flow, states, rates),
        }
    }

    fn dual<const N: usize>(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        states: &[f64],
        rates: &[f64],
    ) -> StripJacobian {
        let count = states.len();
        let variable = |value: f64, index: usize| DualSVec64::<N>::from_re(value).derivative(index);
        let numbers: [_; FLOW] = std::array::from_fn(|i| variable(flow[i], i));
        let mut unknowns = [DualSVec64::<N>::from_re(0.0); STATES];
        let mut speeds = unknowns;
        for k in 0..count {
            unknowns[k] = variable(states[k], FLOW + k);
            speeds[k] = variable(rates[k], FLOW + count + k);
        }
        let flow = StripFlow::from_numbers(&numbers);
        let outputs = self.outputs(air, &flow, &unknowns[..count], &speeds[..count]);
        let mut jacobian = StripJacobian::of_values(outputs.map(|output| output.re));
        for (row, output) in jacobian.by.iter_mut().zip(&outputs) {
            let Some(slopes) = &output.eps.0 else {
                continue;
            };
            row[..FLOW + count].copy_from_slice(&slopes.as_slice()[..FLOW + count]);
            row[FLOW + STATES..FLOW + STATES + count]
                .copy_from_slice(&slopes.as_slice()[FLOW + count..FLOW + 2 * count]);
        }
        jacobian
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
        // The velocity along the span is left out.
        let velocity = [0, 1].map(|i| match induced {
            [u, v, ..] => flow.velocity[i] + *u * axes[0][i] + *v * axes[1][i],
            _ => flow.velocity[i],
        });
        let rows = LOADS + self.of_inflow..LOADS + states.len();
        let force = self.section(
            air,
            (velocity, flow.pitch_rate),
            (own, own_rates),
            &mut out[rows],
        );
        out[0] = force.along;
        out[1] = force.normal;
        out[3] = force.moment;
        if let Some(inflow) = &self.inflow {
            let loads = [force.along, force.normal];
            let ring = Ring::new(inflow, flow, &axes, (air.still.density, &loads));
            ring.rows(
                (induced, induced_rates),
                &mut out[LOADS..LOADS + self.of_inflow],
            );
        }
        out
    }

    /// Forces of the section in the velocity against the air, and the rows of its states.
    fn section<T: Real>(
        &self,
        air: ActingAir<'_>,
        (velocity, pitch_rate): ([T; 2], T),
        (states, rates): (&[T], &[T]),
        rows: &mut [T],
    ) -> SectionForce<T> {
        let [x, y] = velocity;
        let mut flow = SectionFlow::rigid(-y, x, pitch_rate, self.chord);
        let speed = (x * x + y * y + SLOW * SLOW).sqrt();
        flow.mach = speed / air.still.sound_speed;
        flow.reynolds = speed * (self.chord * air.still.density / air.still.viscosity);
        let strip = unsteady::Strip {
            chord: self.chord,
            density: air.still.density,
        };
        if air.part == 0.0 {
            // Without forces there is nothing that the states could lag behind.
            for ((row, state), rate) in rows.iter_mut().zip(states).zip(rates) {
                *row = *state + *rate;
            }
            return SectionForce {
                along: T::from(0.0),
                normal: T::from(0.0),
                moment: T::from(0.0),
            };
        }
        let force = self
            .model
            .evaluate(&strip, &self.polar, &flow, states, rates, rows);
        let scaled = |of: fn(&SectionForce<T>) -> T| match &force {
            Some(force) => of(force) * air.part,
            None => T::from(0.0),
        };
        SectionForce {
            along: scaled(|force| force.along),
            normal: scaled(|force| force.normal),
            moment: scaled(|force| force.moment),
        }
    }
}

/// Speed by which the derivative of a speed is smooth at zero [m/s].
const SLOW: f64 = 1e-3;
