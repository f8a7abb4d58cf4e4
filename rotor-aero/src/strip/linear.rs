//! Derivatives of the loads and rows of a strip, by parts with few variables each.
//!
//! The section depends on its velocity w against the air, its pitch rate and its own states and
//! rates; the annulus on the velocities and forces along n and t, on the radii and on its own
//! unknowns and rates. Each part is differentiated by dual numbers of its own variables, and these
//! vary with the numbers of the strip (see the module of the strip), `ds_t = t . (ds_x, ds_y)`:
//!
//! ```text
//! dn = t ds_t / |s|                  dt = -n ds_t / |s|
//! dw = dw0 + n du + t dv + (u t - v n) ds_t / |s|             in a disk dw0 + (s_x, s_y) du + u ds
//! d(w0 . n) = n . dw0 + w0 . t ds_t / |s|                     d(f . n) = n . df + f . t ds_t / |s|
//! d(w0 . t) = t . dw0 - w0 . n ds_t / |s|                     d(f . t) = t . df - f . n ds_t / |s|
//! ```

use num_dual::{Dual64, DualSVec64};

use super::ring::{Ring, RingFlow};
use super::{
    ActingAir, AnnularInflow, FLOW, INPUTS, LAGGED, LOADS, OUTPUTS, STATES, Strip, StripFlow,
    StripInflow, annular, plane,
};
use crate::momentum::Ambient;

/// Column of the first component of the shaft.
const SHAFT: usize = 4;
/// Column of the radius of the quarter chord; the radius of the tip is next.
const RADIUS: usize = 7;
/// Column of the deflection of the flap.
const FLAP: usize = 9;
/// Variables of an annulus before its own unknowns: velocities along n and against t, radii, forces, and the
/// velocity that is induced at the section.
const OF_RING: usize = 7;
/// Variables of a section before its own states: velocity and pitch rate.
const OF_SECTION: usize = 3;

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

/// The flow, the unknowns and their rates, as numbers.
pub(super) struct Numbers<'a> {
    pub flow: &'a [f64; FLOW],
    pub states: &'a [f64],
    pub rates: &'a [f64],
}

/// The velocity of a section against the air, and its derivatives.
struct Velocity {
    /// w along x and y [m/s].
    values: [f64; 2],
    /// By the components of the shaft along x and y; row of a component of w.
    by_shaft: [[f64; 2]; 2],
    /// By unknowns of the inflow, from the one with this number on.
    by_induced: [[f64; 2]; 3],
    first: usize,
}

impl Velocity {
    /// Adds a slope by w to the slopes by the numbers of a strip.
    fn add(&self, [x, y]: [f64; 2], count: usize, row: &mut [f64; INPUTS]) {
        row[0] += x;
        row[1] += y;
        for j in 0..2 {
            row[SHAFT + j] += x * self.by_shaft[0][j] + y * self.by_shaft[1][j];
        }
        let unknowns = row[FLOW + self.first..].iter_mut().zip(&self.by_induced);
        for (slope, by) in unknowns.take(count) {
            *slope += x * by[0] + y * by[1];
        }
    }
}

/// Derivatives of the velocity of a section by the components of the shaft along x and y, with the
/// induced velocities of an annulus.
fn by_shaft(flow: &StripFlow<f64>, [n, t]: &[[f64; 2]; 2], [u, v]: [f64; 2]) -> [[f64; 2]; 2] {
    let length = flow.shaft[0].hypot(flow.shaft[1]);
    [0, 1].map(|i| [0, 1].map(|j| (u * t[i] - v * n[i]) * t[j] / length))
}

/// Forces of a section along x and y, and their derivatives by the inputs of the strip.
struct Forces {
    values: [f64; 2],
    by: [[f64; INPUTS]; 2],
}

impl Forces {
    /// The forces that act.
    fn of(out: &StripJacobian) -> Self {
        Self {
            values: [out.values[0], out.values[1]],
            by: [out.by[0], out.by[1]],
        }
    }
}

/// Adds the derivatives of a row of an annulus by the velocity, the shaft and the radii of its flow, by its
/// slopes by the velocities and forces along n and t and the radii.
fn add_flow<const N: usize>(
    row: &mut [f64; INPUTS],
    by: &[f64; N],
    ([axial, rotation], force): ([f64; 2], [f64; 2]),
    (flow, [n, t]): (&[f64; FLOW], [&[f64; 2]; 2]),
) {
    let length = flow[SHAFT].hypot(flow[SHAFT + 1]);
    let turned = by[1] * axial - by[0] * rotation + by[4] * force[1] - by[5] * force[0];
    for i in 0..2 {
        row[i] += by[0] * n[i] - by[1] * t[i];
        row[SHAFT + i] += turned * t[i] / length;
        row[RADIUS + i] += by[2 + i];
    }
}

/// Values and derivatives of dual numbers with the given numbers as variables.
fn variables<const N: usize>(numbers: [f64; N]) -> [DualSVec64<N>; N] {
    std::array::from_fn(|i| DualSVec64::from_re(numbers[i]).derivative(i))
}

/// The derivatives of a dual number.
fn slopes<const N: usize>(of: &DualSVec64<N>) -> [f64; N] {
    of.eps.0.map_or([0.0; N], Into::into)
}

/// The flow of an annulus of its variables.
fn ring_flow<const N: usize>(of: &[DualSVec64<N>; N]) -> RingFlow<DualSVec64<N>> {
    RingFlow {
        ambient: Ambient {
            axial: of[0],
            rotation: of[1],
            skew: DualSVec64::from_re(0.0),
        },
        radii: [of[2], of[3]],
        force: [of[4], of[5]],
        local: of[6],
    }
}

impl Strip {
    /// Loads and rows with derivatives.
    pub(super) fn by_parts(&self, air: ActingAir<'_>, at: &Numbers<'_>) -> StripJacobian {
        let flow = StripFlow::from_numbers(at.flow);
        let axes = plane(&flow.shaft);
        let velocity = self.velocity_slopes(&flow, &axes, at.states);
        let mut out = StripJacobian::of_values([0.0; OUTPUTS]);
        // Sections without states, with the five of the default, and with all.
        match at.states.len() - self.of_inflow {
            0 => self.add_section::<OF_SECTION>(air, &velocity, at, &mut out),
            1..=5 => self.add_section::<{ OF_SECTION + 2 * 5 }>(air, &velocity, at, &mut out),
            _ => self.add_section::<{ OF_SECTION + 2 * 9 }>(air, &velocity, at, &mut out),
        }
        if self.radial_drag {
            let [x, y] = velocity.values;
            let friction = self.friction(air, &variables([x, y, flow.velocity[2]]));
            let [x, y, z] = slopes(&friction);
            out.values[2] = friction.re;
            out.by[2][2] = z;
            velocity.add([x, y], self.of_inflow, &mut out.by[2]);
        }
        let (annulus, first) = self.annulus();
        for k in 0..first {
            out.values[LOADS + k] = at.states[k];
            out.by[LOADS + k][FLOW + k] = 1.0;
        }
        if let Some(inflow) = annulus {
            let of = (inflow, &axes);
            let forces = Forces::of(&out);
            match self.of_inflow - first {
                2 => self.add_ring::<{ OF_RING + 2 }>(air, of, at, (&forces, first), &mut out),
                4 => self.add_ring::<{ OF_RING + 8 }>(air, of, at, (&forces, first), &mut out),
                _ => {
                    self.add_ring::<{ OF_RING + 10 }>(air, of, at, (&forces, first), &mut out);
                    let steady = first + LAGGED;
                    let forces = self.static_forces(air, (&flow, &axes), at, steady);
                    self.add_ring::<{ OF_RING + 2 }>(air, of, at, (&forces, steady), &mut out);
                }
            }
        }
        if self.flap.is_some() {
            self.add_flap(air, at, &mut out);
        }
        out
    }

    /// Writes the derivatives by the deflection of the flap, through the whole strip.
    fn add_flap(&self, air: ActingAir<'_>, at: &Numbers<'_>, out: &mut StripJacobian) {
        let mut flow = StripFlow::from_numbers(&at.flow.map(Dual64::from_re));
        flow.flap.eps = 1.0;
        let numbers = |of: &[f64]| {
            let mut all = [Dual64::from_re(0.0); STATES];
            for (to, from) in all.iter_mut().zip(of) {
                *to = Dual64::from_re(*from);
            }
            all
        };
        let (states, rates) = (numbers(at.states), numbers(at.rates));
        let count = at.states.len();
        let outputs = self.outputs(air, &flow, &states[..count], &rates[..count]);
        for (row, output) in out.by.iter_mut().zip(&outputs) {
            row[FLAP] = output.eps;
        }
    }

    /// The velocity of the section with its derivatives.
    fn velocity_slopes(
        &self,
        flow: &StripFlow<f64>,
        axes: &[[f64; 2]; 2],
        states: &[f64],
    ) -> Velocity {
        let induced = &states[..self.of_inflow];
        let [n, t] = axes;
        let turned = |u: f64, v: f64| by_shaft(flow, axes, [u, v]);
        let shaft = [flow.shaft[0], flow.shaft[1]];
        let (by_shaft, by_induced) = match (&self.inflow, induced) {
            (Some(StripInflow::Disk), [u]) => ([[*u, 0.0], [0.0, *u]], [shaft, [0.0; 2], [0.0; 2]]),
            (Some(StripInflow::Annular(_)), [u, v, ..]) => (turned(*u, *v), [*n, *t, [0.0; 2]]),
            (Some(StripInflow::Distributed(_)), [u, _, v, ..]) => {
                (turned(*u, *v), [*n, [0.0; 2], *t])
            }
            _ => ([[0.0; 2]; 2], [[0.0; 2]; 3]),
        };
        Velocity {
            values: self.velocity(flow, axes, induced),
            by_shaft,
            by_induced,
            first: 0,
        }
    }

    /// Writes the forces of the section and the rows of its states, in N variables.
    fn add_section<const N: usize>(
        &self,
        air: ActingAir<'_>,
        velocity: &Velocity,
        at: &Numbers<'_>,
        out: &mut StripJacobian,
    ) {
        let first = self.of_inflow;
        let (states, rates) = (&at.states[first..], &at.rates[first..]);
        let count = states.len();
        let mut numbers = [0.0; N];
        numbers[..2].copy_from_slice(&velocity.values);
        numbers[2] = at.flow[3];
        numbers[OF_SECTION..OF_SECTION + count].copy_from_slice(states);
        numbers[OF_SECTION + count..OF_SECTION + 2 * count].copy_from_slice(rates);
        let of = variables(numbers);
        let mut rows = [DualSVec64::<N>::from_re(0.0); STATES];
        let (states, rates) = of[OF_SECTION..].split_at(count);
        let force = self.section(
            air,
            ([of[0], of[1]], of[2], DualSVec64::from_re(at.flow[FLAP])),
            (states, &rates[..count]),
            &mut rows[..count],
        );
        let forces = [(0, force.along), (1, force.normal), (3, force.moment)];
        let rows = rows.iter().take(count).enumerate();
        let rows = rows.map(|(k, row)| (LOADS + first + k, *row));
        for (index, output) in forces.into_iter().chain(rows) {
            out.values[index] = output.re;
            let (slopes, row) = (slopes(&output), &mut out.by[index]);
            velocity.add([slopes[0], slopes[1]], first, row);
            row[3] = slopes[2];
            let (own, rates) = slopes[OF_SECTION..].split_at(count);
            row[FLOW + first..FLOW + first + count].copy_from_slice(own);
            row[FLOW + STATES + first..FLOW + STATES + first + count]
                .copy_from_slice(&rates[..count]);
        }
    }

    /// The forces of the static section in the velocities of the steady state, which are the unknowns of
    /// the inflow from `first` on.
    fn static_forces(
        &self,
        air: ActingAir<'_>,
        (flow, axes): (&StripFlow<f64>, &[[f64; 2]; 2]),
        at: &Numbers<'_>,
        first: usize,
    ) -> Forces {
        let [u, v] = [at.states[first], at.states[first + 1]];
        let velocity = Velocity {
            values: annular(flow, axes, [u, v]),
            by_shaft: by_shaft(flow, axes, [u, v]),
            by_induced: [axes[0], axes[1], [0.0; 2]],
            first,
        };
        let [x, y] = velocity.values;
        let of = variables([x, y, flow.pitch_rate]);
        let deflection = DualSVec64::from_re(flow.flap);
        let force = self.static_section(air, ([of[0], of[1]], of[2], deflection));
        let mut found = Forces {
            values: [0.0; 2],
            by: [[0.0; INPUTS]; 2],
        };
        for (i, output) in [force.along, force.normal].iter().enumerate() {
            found.values[i] = output.re;
            let [x, y, turn] = slopes(output);
            velocity.add([x, y], 2, &mut found.by[i]);
            found.by[i][3] = turn;
        }
        found
    }

    /// Writes the rows of the annulus in N variables: of its lagged velocities with their rates, or of
    /// two velocities in equilibrium with forces; its unknowns begin at `first`.
    fn add_ring<const N: usize>(
        &self,
        air: ActingAir<'_>,
        (inflow, [n, t]): (&AnnularInflow, &[[f64; 2]; 2]),
        at: &Numbers<'_>,
        (forces, first): (&Forces, usize),
        out: &mut StripJacobian,
    ) {
        // Rates enter the dynamic wake alone, of its first unknowns.
        let of_rates = if N == OF_RING + 2 { 0 } else { LAGGED };
        let count = N - OF_RING - of_rates;
        let along = |axis: &[f64; 2], of: &[f64]| axis[0] * of[0] + axis[1] * of[1];
        let (axial, rotation) = (along(n, at.flow), -along(t, at.flow));
        let force = [along(n, &forces.values), along(t, &forces.values)];
        let mut numbers = [0.0; N];
        let radii = [at.flow[RADIUS], at.flow[RADIUS + 1]];
        // The steady state has its own velocity, and all others the first unknown of the strip.
        let local = if first < LAGGED { 0 } else { first };
        let [radius, tip] = radii;
        let of_flow = [
            axial,
            rotation,
            radius,
            tip,
            force[0],
            force[1],
            at.states[local],
        ];
        numbers[..OF_RING].copy_from_slice(&of_flow);
        numbers[OF_RING..OF_RING + count].copy_from_slice(&at.states[first..first + count]);
        numbers[OF_RING + count..].copy_from_slice(&at.rates[first..first + of_rates]);
        let of = variables(numbers);
        let ring = Ring::new(inflow, air.still.density, ring_flow(&of));
        let (induced, rates) = of[OF_RING..].split_at(count);
        let mut rows = [DualSVec64::<N>::from_re(0.0); LAGGED];
        let written = count.min(LAGGED);
        if of_rates == 0 {
            ring.equilibrium([induced[0], induced[1]], &mut rows[..written]);
        } else {
            ring.rows((induced, rates), &mut rows[..written]);
        }
        for (k, output) in rows.iter().take(written).enumerate() {
            out.values[LOADS + first + k] = output.re;
            let (by, row) = (slopes(output), &mut out.by[LOADS + first + k]);
            let [x, y] = [0, 1].map(|i| by[4] * n[i] + by[5] * t[i]);
            for (slope, (of_x, of_y)) in row.iter_mut().zip(forces.by[0].iter().zip(&forces.by[1]))
            {
                *slope = x * of_x + y * of_y;
            }
            add_flow(row, &by, ([axial, rotation], force), (at.flow, [n, t]));
            row[FLOW + local] += by[OF_RING - 1];
            let (own, rates) = by[OF_RING..].split_at(count);
            for (i, slope) in own.iter().enumerate() {
                row[FLOW + first + i] += slope;
            }
            for (i, slope) in rates.iter().enumerate() {
                row[FLOW + STATES + first + i] += slope;
            }
        }
    }

    /// The annulus, if there is one, and the number of unknowns before its own.
    pub(super) fn annulus(&self) -> (Option<&AnnularInflow>, usize) {
        match &self.inflow {
            None => (None, 0),
            Some(StripInflow::Disk) => (None, 1),
            Some(StripInflow::Annular(inflow)) => (Some(inflow), 0),
            Some(StripInflow::Distributed(inflow)) => (Some(inflow), 1),
        }
    }
}

#[cfg(test)]
#[path = "linear_tests.rs"]
mod tests;
