//! Flow and coefficients of a strip at a state, for output.
//!
//! ```text
//! w     = w0 + u n + v t,  in a disk w0 + u (s_x, s_y)
//! alpha = atan2(q c/2 - w_y, w_x)                phi = atan2(w . n, -w . t)
//! l = (f_y w_x - f_x w_y) / |w|                  d = -(f_x w_x + f_y w_y) / |w|
//! cl = 2 l / (rho w^2 c)       cd = 2 d / (rho w^2 c)       cm = 2 m / (rho w^2 c^2)
//! ```
//!
//! alpha is the angle at three quarters of the chord, by which the coefficients of a table are
//! taken; lift is normal to the flow at the quarter chord.

use num_dual::DualSVec64;

use super::{
    ActingAir, FLOW, INDUCED, INPUTS, LOADS, SLOW, STATES, Strip, StripFlow, StripJacobian, plane,
};
use crate::real::{Real, angle};
use crate::unsteady::Polar;

/// Flow and loads of a strip.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StripReport<T = f64> {
    /// Angle of attack at three quarters of the chord \[rad\].
    pub alpha: T,
    /// Angle of the flow at the quarter chord to the plane of the disk: positive if the air passes
    /// the disk against the shaft \[rad\].
    pub inflow_angle: T,
    /// Induced velocity against the shaft, and around it in the direction of motion \[m/s\].
    pub induced: [T; 2],
    /// Speed of the flow at the quarter chord, without the velocity along the span \[m/s\].
    pub speed: T,
    /// Mach number \[-\].
    pub mach: T,
    /// Reynolds number \[-\].
    pub reynolds: T,
    /// Coefficients of lift, drag and moment of the force that acts, about the quarter chord; zero
    /// without flow \[-\].
    pub coefficients: [T; 3],
    /// Lift and drag per length \[N/m\].
    pub lift_and_drag: [T; 2],
    /// Moment per length about the quarter chord, nose up \[N\].
    pub moment: T,
    /// Force per length in the airfoil axes \[N/m\].
    pub force: [T; 3],
    /// Force per length along the shaft \[N/m\].
    pub along_shaft: T,
}

/// Variables of a report: flow, unknowns of the inflow, and loads.
const REPORTED: usize = FLOW + INDUCED.len() + 1 + LOADS;

/// A number of a report with its derivatives.
pub type ReportNumber = DualSVec64<REPORTED>;

impl Strip {
    /// Flow and loads for the numbers of a flow, the unknowns and their rates.
    pub fn report(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        states: &[f64],
        rates: &[f64],
    ) -> StripReport {
        let outputs = self.evaluate(air, flow, states, rates);
        let loads = outputs.first_chunk().copied().unwrap_or_default();
        self.report_of(air, &StripFlow::from_numbers(flow), states, loads)
    }

    /// The part of the chord, from 0 to 1, along which static flow at an angle of attack \[rad\] is
    /// attached.
    pub fn attached(&self, alpha: f64) -> f64 {
        self.polar.attached(alpha)
    }

    /// A number of the report, and its derivatives by the inputs of the strip in the order of
    /// [`StripJacobian`], whose derivatives at the same state are `by`.
    pub fn report_slopes(
        &self,
        air: ActingAir<'_>,
        (flow, states): (&[f64; FLOW], &[f64]),
        by: &StripJacobian,
        number: impl Fn(&StripReport<ReportNumber>) -> ReportNumber,
    ) -> (f64, [f64; INPUTS]) {
        let count = self.of_inflow;
        let variable = |value: f64, index| ReportNumber::from_re(value).derivative(index);
        let numbers: [_; FLOW] = std::array::from_fn(|i| variable(flow[i], i));
        let mut induced = [ReportNumber::from_re(0.0); STATES];
        for k in 0..count {
            induced[k] = variable(states[k], FLOW + k);
        }
        let loads: [_; LOADS] =
            std::array::from_fn(|i| variable(by.values[i], REPORTED - LOADS + i));
        let flow = StripFlow::from_numbers(&numbers);
        let found = number(&self.report_of(air, &flow, &induced[..count], loads));
        let mut slopes = [0.0; INPUTS];
        let Some(own) = &found.eps.0 else {
            return (found.re, slopes);
        };
        slopes[..FLOW + count].copy_from_slice(&own.as_slice()[..FLOW + count]);
        for (slope, row) in own.as_slice()[REPORTED - LOADS..].iter().zip(&by.by) {
            for (sum, by) in slopes.iter_mut().zip(row) {
                *sum += slope * by;
            }
        }
        (found.re, slopes)
    }

    /// The report for a flow, unknowns and loads.
    fn report_of<T: Real>(
        &self,
        air: ActingAir<'_>,
        flow: &StripFlow<T>,
        states: &[T],
        [along, normal, span, moment]: [T; LOADS],
    ) -> StripReport<T> {
        let zero = T::from(0.0);
        // A strip whose shaft is along the span has no plane of the disk.
        let known = |part: T| if part.re().is_nan() { zero } else { part };
        let axes = plane(&flow.shaft).map(|axis| axis.map(known));
        let [n, t] = axes;
        let induced = [0, 1].map(|i| self.unknown(INDUCED[i], states));
        let of_inflow = states.get(..self.of_inflow).unwrap_or_default();
        let [x, y] = self.velocity(flow, &axes, of_inflow);
        let square = x * x + y * y;
        let moves = square.re() > 0.0;
        let speed = if moves { square.sqrt() } else { zero };
        let lift_and_drag = if moves {
            [
                (normal * x - along * y) / speed,
                -(along * x + normal * y) / speed,
            ]
        } else {
            [zero; 2]
        };
        let pressure = square * (0.5 * air.still.density * self.chord);
        let over = |load: T, by: T| if by.re() > 0.0 { load / by } else { zero };
        let smooth = (square + SLOW * SLOW).sqrt();
        let [s_x, s_y, s_z] = flow.shaft;
        StripReport {
            alpha: angle(flow.pitch_rate * (0.5 * self.chord) - y, x),
            inflow_angle: angle(x * n[0] + y * n[1], zero - (x * t[0] + y * t[1])),
            induced,
            speed,
            mach: smooth / air.still.sound_speed,
            reynolds: smooth * (self.chord * air.still.density / air.still.viscosity),
            coefficients: [
                over(lift_and_drag[0], pressure),
                over(lift_and_drag[1], pressure),
                over(moment, pressure * self.chord),
            ],
            lift_and_drag,
            moment,
            force: [along, normal, span],
            along_shaft: along * s_x + normal * s_y + span * s_z,
        }
    }

    /// The unknown called `name`; zero without it.
    fn unknown<T: Real>(&self, name: &str, states: &[T]) -> T {
        let index = self.states.iter().position(|state| state.name == name);
        let value = index.and_then(|index| states.get(index));
        value.copied().unwrap_or_else(|| T::from(0.0))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::airfoil::{Flow, Section, built_in};
    use crate::strip::{AnnularInflow, SectionModel, StripDesign};
    use crate::wind::Atmosphere;

    const CHORD: f64 = 0.7;

    fn strip(inflow: Option<AnnularInflow>) -> (Strip, Section) {
        let section = Section::single(Arc::new(built_in("naca0012").unwrap()));
        let design = StripDesign {
            chord: CHORD,
            section: section.clone(),
            model: SectionModel::of_word("quasi_steady").unwrap(),
            inflow: inflow.map(Into::into),
            radial_drag: false,
        };
        (Strip::new(design), section)
    }

    /// Numbers between -1 and 1 from a linear congruential generator (Knuth, MMIX).
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 7_u64;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005);
            state = state.wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    /// Without a pitch rate the coefficients are the ones of the table at the reported angle, Mach
    /// and Reynolds number: for 500 flows from 20 m/s on. The speed of the loads is smaller by a
    /// part of `0.01^2 / 2 V^2 < 2e-7`.
    #[test]
    fn coefficients_are_the_ones_of_the_table() {
        let inflow = AnnularInflow {
            blades: 3,
            hub_radius: 0.2,
            options: Default::default(),
            wake: Default::default(),
        };
        let (strip, section) = strip(Some(inflow));
        let still = Atmosphere::default();
        let air = ActingAir {
            still: &still,
            part: 1.0,
        };
        let mut number = numbers();
        for _ in 0..500 {
            let angle = std::f64::consts::PI * number();
            let speed = 75.0 + 40.0 * number();
            let (w, q) = ([speed * angle.cos(), -speed * angle.sin()], 0.0);
            let states = [5.0 * number(), 5.0 * number()];
            // The shaft is along y: n = y, t = -x.
            let flow = [w[0], w[1], 3.0, q, 0.0, 1.0, 0.0, 4.0, 5.0, 0.0];
            let found = strip.report(air, &flow, &states, &[0.0; 2]);
            let (x, y) = (w[0] - states[1], w[1] + states[0]);
            assert!((found.alpha - (-y).atan2(x)).abs() < 1e-14);
            assert!((found.inflow_angle - y.atan2(x)).abs() < 1e-14);
            assert_eq!(found.induced, states);
            assert!((found.speed - x.hypot(y)).abs() < 1e-12);
            let at = Flow {
                alpha: found.alpha,
                mach: found.mach,
                reynolds: found.reynolds,
                flap: 0.0,
            };
            let expected = section.at(&at);
            let expected = [expected.lift, expected.drag, expected.moment];
            for (found, expected) in found.coefficients.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-6 * expected.abs().max(1.0));
            }
        }
    }

    /// A section that turns in a flow along its chord has the angle of the normal velocity q c/2.
    #[test]
    fn the_angle_is_the_one_at_three_quarters_of_the_chord() {
        let (strip, _) = strip(None);
        let still = Atmosphere::default();
        let air = ActingAir {
            still: &still,
            part: 1.0,
        };
        let flow = [50.0, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0, 4.0, 5.0, 0.0];
        let found = strip.report(air, &flow, &[], &[]);
        assert!((found.alpha - (CHORD / 50.0).atan()).abs() < 1e-15);
        assert_eq!(found.induced, [0.0; 2]);
        assert!((found.mach - 50.0 / still.sound_speed).abs() < 1e-9);
        // Lift is normal to the flow at the quarter chord, here along y.
        assert!((found.lift_and_drag[0] - found.force[1]).abs() < 1e-12);
        assert!((found.lift_and_drag[1] + found.force[0]).abs() < 1e-12);
    }

    #[test]
    fn without_flow_all_is_zero() {
        let (strip, _) = strip(None);
        let still = Atmosphere::default();
        let air = ActingAir {
            still: &still,
            part: 1.0,
        };
        // A shaft along the span has no plane of the disk.
        let flow = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 5.0, 0.0];
        let found = strip.report(air, &flow, &[], &[]);
        assert_eq!(found.coefficients, [0.0; 3]);
        assert_eq!(found.inflow_angle, 0.0);
        assert_eq!(found.speed, 0.0);
    }
}
