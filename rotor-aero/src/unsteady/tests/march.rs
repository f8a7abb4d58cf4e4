//! A march in time with the two-step scheme of the multibody program, at a constant step.

use nalgebra::{DMatrix, DVector};
use num_dual::Dual64;

use crate::unsteady::{Model, Polar, SectionFlow, SectionForce, Strip};

/// Radius of the scheme at infinity.
const RHO: f64 = 0.6;

/// A section of a model in a flow over time.
pub struct March<'a, M, P> {
    pub model: &'a M,
    pub polar: &'a P,
    pub strip: Strip,
    pub step: f64,
}

/// States and rates at the last two times.
struct Past {
    states: [DVector<f64>; 2],
    rates: [DVector<f64>; 2],
}

fn dual(flow: &SectionFlow<f64>) -> SectionFlow<Dual64> {
    SectionFlow {
        normal: flow.normal.into(),
        normal_mid: flow.normal_mid.into(),
        tangential: flow.tangential.into(),
        camber: flow.camber.into(),
        pitch_rate: flow.pitch_rate.into(),
        mach: flow.mach.into(),
        reynolds: flow.reynolds.into(),
        flap: flow.flap.into(),
    }
}

impl<M: Model, P: Polar> March<'_, M, P> {
    /// Forces at the times 1, 2, ... of the step, from a steady start in the flow at time 0.
    pub fn run(
        &self,
        flow: impl Fn(f64) -> SectionFlow<f64>,
        steps: usize,
    ) -> Vec<SectionForce<f64>> {
        let size = self.model.states().len();
        let mut start = vec![0.0; size];
        self.model
            .start(&self.strip, self.polar, &flow(0.0), &mut start)
            .unwrap();
        let start = DVector::from_vec(start);
        let zero = DVector::zeros(size);
        let mut past = Past {
            states: [start.clone(), start],
            rates: [zero.clone(), zero],
        };
        let mut advance = |i: usize| self.advance(&flow(i as f64 * self.step), &mut past);
        (1..=steps).map(&mut advance).collect()
    }

    /// One step.
    fn advance(&self, flow: &SectionFlow<f64>, past: &mut Past) -> SectionForce<f64> {
        let beta = (3.0 * RHO - 1.0) / (3.0 - RHO);
        let b0 = 2.0 / ((1.0 + RHO) * (3.0 - RHO)) * self.step;
        let base = &past.states[0] * (1.0 - beta)
            + &past.states[1] * beta
            + &past.rates[0] * (2.0 * RHO * b0)
            + &past.rates[1] * (RHO * RHO * b0);
        let mut rates = past.rates[0].clone();
        for _ in 0..20 {
            let (rows, matrix) = self.linear(flow, &(&base + &rates * b0), &rates, b0);
            if rows.is_empty() {
                break;
            }
            let change = matrix.lu().solve(&rows).unwrap();
            rates -= &change;
            if change.amax() < 1e-11 * (1.0 + rates.amax()) {
                break;
            }
        }
        let states = base + &rates * b0;
        let force = self.force(flow, &states, &rates);
        past.states.swap(0, 1);
        past.rates.swap(0, 1);
        past.states[0] = states;
        past.rates[0] = rates;
        force
    }

    fn force(
        &self,
        flow: &SectionFlow<f64>,
        states: &DVector<f64>,
        rates: &DVector<f64>,
    ) -> SectionForce<f64> {
        let mut rows = vec![0.0; states.len()];
        let (states, rates) = (states.as_slice(), rates.as_slice());
        self.model
            .evaluate(&self.strip, self.polar, flow, states, rates, &mut rows)
            .unwrap()
    }

    /// The rows, and their derivatives by the rates with states that follow.
    fn linear(
        &self,
        flow: &SectionFlow<f64>,
        states: &DVector<f64>,
        rates: &DVector<f64>,
        b0: f64,
    ) -> (DVector<f64>, DMatrix<f64>) {
        let size = states.len();
        let flow = dual(flow);
        let mut values = DVector::zeros(size);
        let mut matrix = DMatrix::zeros(size, size);
        for column in 0..size {
            let mut x: Vec<Dual64> = states.iter().map(|&it| it.into()).collect();
            let mut dx: Vec<Dual64> = rates.iter().map(|&it| it.into()).collect();
            x[column].eps = b0;
            dx[column].eps = 1.0;
            let mut rows = vec![Dual64::from(0.0); size];
            self.model
                .evaluate(&self.strip, self.polar, &flow, &x, &dx, &mut rows)
                .unwrap();
            for row in 0..size {
                values[row] = rows[row].re;
                matrix[(row, column)] = rows[row].eps;
            }
        }
        (values, matrix)
    }
}
