//! A sampled linear system of states: it samples its inputs and holds its outputs.
//!
//! At the instants `t_k = t_0 + k T`, with the inputs u_k there and the outputs limited in
//! value and in rate,
//!
//! ```text
//! y_k     = sat( C x_k + D u_k ) ,     |y_k - y_{k-1}| <= r T
//! x_{k+1} = A x_k + B u_k
//! y(t)    = y_{k-d}      t_k < t <= t_{k+1}                                    (D-277)
//! ```
//!
//! d being the delay of the computation in samples. The outputs jump at samples, which are corners
//! of a run: steps end there, and rates are computed again after them.

use nalgebra::DVector;

use super::Matrices;
use super::inputs::Inputs;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual, Signal};
use crate::elements::{Memory, has};
use crate::model::Scalar;

/// Instants that are closer to each other, in periods, are treated as equal.
const SAME: f64 = 1e-6;

/// Sampling instants of a system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// T [s].
    pub period: f64,
    /// t_0 [s].
    pub offset: f64,
    /// d: samples from an input to the output that follows from it.
    pub delay: usize,
}

impl Sampling {
    /// Sample `k` \[s\].
    fn instant(&self, k: f64) -> f64 {
        self.offset + k * self.period
    }

    /// Index of the first sample at or after `time` \[s\].
    fn first(&self, time: f64) -> f64 {
        ((time - self.offset) / self.period - SAME).ceil()
    }

    /// The first sample after `time` \[s\].
    fn next(&self, time: f64) -> f64 {
        let before = ((time - self.offset) / self.period).floor();
        let near = [before, before + 1.0, before + 2.0].map(|k| self.instant(k));
        let next = near.into_iter().find(|instant| *instant > time);
        // Samples may be closer to each other than this tolerance.
        next.unwrap_or_else(|| time.next_up())
    }
}

/// Limits of an output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Least and largest value [unit of the output].
    pub range: [f64; 2],
    /// Largest rate [unit of the output/s].
    pub rate: f64,
}

impl Default for Limits {
    /// No limits.
    fn default() -> Self {
        Self {
            range: [f64::NEG_INFINITY, f64::INFINITY],
            rate: f64::INFINITY,
        }
    }
}

/// A sampled linear system between signals and scalars.
///
/// Its memory contains the index of the next sample, the states, and the outputs before the delay
/// of this sample and of the previous d samples, the newest first.
#[derive(Debug, Clone)]
pub struct Sampled {
    label: String,
    matrices: Matrices,
    sampling: Sampling,
    limits: Vec<Limits>,
    inputs: Inputs,
    start: Vec<f64>,
    /// The outputs, and the scalars of all inputs in turn.
    scalars: Vec<Scalar>,
}

impl Sampled {
    /// The system `matrices`, which maps the states from sample to sample and the `inputs` to the
    /// `outputs` with their limits (see [`super::StateSpace::output`]); `start` are the states
    /// before the first sample.
    pub fn new(
        label: impl Into<String>,
        (matrices, sampling): (Matrices, Sampling),
        inputs: Vec<Signal>,
        outputs: Vec<(Scalar, Limits)>,
        start: Vec<f64>,
    ) -> Self {
        let (mut scalars, limits): (Vec<_>, Vec<_>) = outputs.into_iter().unzip();
        Self {
            label: label.into(),
            matrices,
            sampling,
            limits,
            inputs: Inputs::new(inputs, &mut scalars),
            start,
            scalars,
        }
    }

    /// Index in the memory of the outputs of the sample `back` before the latest.
    fn outputs(&self, back: usize) -> std::ops::Range<usize> {
        let [states, _, outputs] = self.matrices.sizes();
        let first = 1 + states + back * outputs;
        first..first + outputs
    }

    /// Samples the inputs at a state.
    fn sample(&self, at: &Local<'_>, memory: &mut [f64]) {
        let [states, inputs, outputs] = self.matrices.sizes();
        let u = DVector::from_iterator(inputs, self.inputs.values(at));
        let x = DVector::from_column_slice(&memory[1..=states]);
        let Matrices { a, b, c, d } = &self.matrices;
        let requested = c * &x + d * &u;
        let next = a * x + b * u;
        let latest = self.outputs(0);
        let before: Vec<_> = memory[latest.clone()].to_vec();
        let delayed = latest.start..memory.len() - outputs;
        memory.copy_within(delayed, latest.end);
        for (i, limits) in self.limits.iter().enumerate() {
            let [least, most] = limits.range;
            let far = limits.rate * self.sampling.period;
            let [low, high] = [least.max(before[i] - far), most.min(before[i] + far)];
            // The nearer end, if a limit of the value is beyond the reach of the rate.
            memory[latest.start + i] = requested[i].max(low).min(high);
        }
        memory[1..=states].copy_from_slice(next.as_slice());
        memory[0] += 1.0;
    }
}

impl Element for Sampled {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &[]
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn each_signal<'a>(&'a self, visit: &mut dyn FnMut(&'a Signal)) {
        self.inputs.signals().iter().for_each(visit);
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let held = &at.memory[self.outputs(self.sampling.delay)];
        for (i, held) in held.iter().enumerate() {
            out.add_scalar(i, at.scalars.values[i]);
            out.add_scalar(i, -held);
        }
        let Some(out) = jacobian else { return };
        (0..self.limits.len()).for_each(|i| out.add_scalar(i, i, 1.0, false));
    }

    has!(memory: Memory);
}

impl Memory for Sampled {
    fn size(&self) -> usize {
        self.outputs(self.sampling.delay).end
    }

    fn begin(&self, at: &Local<'_>, memory: &mut [f64]) {
        let time = at.loading.time;
        memory.fill(0.0);
        memory[0] = self.sampling.first(time);
        memory[1..=self.start.len()].copy_from_slice(&self.start);
        self.accept(at, memory);
    }

    fn accept(&self, at: &Local<'_>, memory: &mut [f64]) {
        let soon = at.loading.time + SAME * self.sampling.period;
        if self.sampling.instant(memory[0]) <= soon {
            self.sample(at, memory);
        }
    }

    fn next_change(&self, time: f64) -> f64 {
        self.sampling.next(time)
    }
}
