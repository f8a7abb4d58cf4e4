//! Outputs of a strip with their derivatives by the flow, the unknowns and the rates, by dual
//! numbers.

use num_dual::DualSVec64;

use super::{ActingAir, FLOW, INPUTS, OUTPUTS, STATES, Strip, StripFlow};

/// Numbers of the flow before the deflection of the flap.
const MOTION: usize = FLOW - 1;

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

impl Strip {
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
        let mut jacobian = match states.len() {
            0..=2 => self.dual::<11, 2>(air, flow, states, rates),
            3..=7 => self.dual::<16, 7>(air, flow, states, rates),
            _ => self.dual::<{ MOTION + STATES }, STATES>(air, flow, states, rates),
        };
        if self.flap.is_some() {
            self.add_flap(air, flow, (states, rates), &mut jacobian);
        }
        jacobian
    }

    /// Derivatives by the flow and the states in N dual numbers, and by the rates in R: the rates
    /// enter few terms, and numbers without derivatives cost little.
    fn dual<const N: usize, const R: usize>(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        states: &[f64],
        rates: &[f64],
    ) -> StripJacobian {
        let count = states.len();
        let variable = |value: f64, index: usize| DualSVec64::<N>::from_re(value).derivative(index);
        let numbers: [_; FLOW] = std::array::from_fn(|i| match i < MOTION {
            true => variable(flow[i], i),
            false => DualSVec64::from_re(flow[i]),
        });
        let mut unknowns = [DualSVec64::<N>::from_re(0.0); STATES];
        let mut speeds = unknowns;
        for k in 0..count {
            unknowns[k] = variable(states[k], MOTION + k);
            speeds[k] = DualSVec64::from_re(rates[k]);
        }
        let numbers = StripFlow::from_numbers(&numbers);
        let outputs = self.outputs(air, &numbers, &unknowns[..count], &speeds[..count]);
        let mut jacobian = StripJacobian::of_values(outputs.map(|output| output.re));
        for (row, output) in jacobian.by.iter_mut().zip(&outputs) {
            if let Some(slopes) = &output.eps.0 {
                let (motion, states) = slopes.as_slice().split_at(MOTION);
                row[..MOTION].copy_from_slice(motion);
                row[FLOW..FLOW + count].copy_from_slice(&states[..count]);
            }
        }
        if self.states.iter().any(|state| state.has_rate) {
            self.add_rates::<R>(air, flow, (states, rates), &mut jacobian);
        }
        jacobian
    }

    /// Writes the derivatives by the rates.
    fn add_rates<const R: usize>(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        (states, rates): (&[f64], &[f64]),
        jacobian: &mut StripJacobian,
    ) {
        let count = states.len();
        let numbers = StripFlow::from_numbers(&flow.map(DualSVec64::<R>::from_re));
        let mut unknowns = [DualSVec64::<R>::from_re(0.0); STATES];
        let mut speeds = unknowns;
        for k in 0..count {
            unknowns[k] = DualSVec64::from_re(states[k]);
            speeds[k] = DualSVec64::from_re(rates[k]).derivative(k);
        }
        let outputs = self.outputs(air, &numbers, &unknowns[..count], &speeds[..count]);
        for (row, output) in jacobian.by.iter_mut().zip(&outputs) {
            if let Some(slopes) = &output.eps.0 {
                let rates = &mut row[FLOW + STATES..FLOW + STATES + count];
                rates.copy_from_slice(&slopes.as_slice()[..count]);
            }
        }
    }

    /// Writes the derivatives by the deflection of the flap.
    fn add_flap(
        &self,
        air: ActingAir<'_>,
        flow: &[f64; FLOW],
        (states, rates): (&[f64], &[f64]),
        jacobian: &mut StripJacobian,
    ) {
        let number = DualSVec64::<1>::from_re;
        let mut flow = StripFlow::from_numbers(&flow.map(number));
        flow.flap = flow.flap.derivative(0);
        let [states, rates] = [states, rates].map(|of| {
            let mut all = [number(0.0); STATES];
            all.iter_mut()
                .zip(of)
                .for_each(|(to, from)| *to = number(*from));
            all
        });
        let count = self.states.len();
        let outputs = self.outputs(air, &flow, &states[..count], &rates[..count]);
        for (row, output) in jacobian.by.iter_mut().zip(&outputs) {
            if let Some(slopes) = &output.eps.0 {
                row[MOTION] = slopes[0];
            }
        }
    }
}
