//! Controls and targets: the border of Newton's method.
//!
//! A control u is a state that does not change, `u' = 0`, and a target is the integral I of a
//! quantity, `I' = q`, `I(0) = 0`: both are unknowns of the motion, so that the map M of a period
//! has their derivatives. In the equations of the shooting, the rows of the controls, which are
//! zero, become rows of the targets, and the rows of the integrals their start:
//!
//! ```text
//! d - M d = y(T) - y(0)              (states)
//! -(M d)_I / T = I(T)/T - target     (rows of the controls)                          (D-445)
//! d_I = 0                            (rows of the integrals)
//! ```
//!
//! Controls that are held have the rows `d_u = 0`.

use nalgebra::DMatrix;

use super::failure::PeriodicFailure;
use crate::analysis::effects;
use crate::case::{Model, PeriodicSettings, TrimControl, TrimTarget};
use crate::input::short_number;
use crate::model::State;

/// Change of a control in its scales above which a correction may be one of singular equations.
const SUSPICIOUS: f64 = 1e3;

/// The unknowns of the controls and integrals.
#[derive(Clone)]
pub(super) struct Border {
    /// Unknowns of the controls.
    controls: Vec<usize>,
    /// Unknowns of the integrals, first of the targets of the controls.
    integrals: Vec<usize>,
    of_controls: Vec<TrimControl>,
    of_targets: Vec<TrimTarget>,
    /// The first scalar among the unknowns.
    first: usize,
    period: f64,
    /// Whether the controls keep their values, and the targets are left open.
    is_held: bool,
}

impl Border {
    /// Of the controls and targets of `settings`.
    ///
    /// # Errors
    /// The model has no such elements, or there are fewer targets than controls.
    pub fn new(model: &Model, settings: &PeriodicSettings) -> Result<Self, PeriodicFailure> {
        let first = model.system.numbering().first_scalar();
        let [controls, targets] = [settings.controls.len(), settings.targets.len()];
        if controls > targets {
            return Err(PeriodicFailure::Counts { controls, targets });
        }
        let index = |label: &String| {
            let mut scalars = model.system.scalars().iter();
            let found = scalars.position(|scalar| scalar.has_rate && scalar.owner == *label);
            let missing = || PeriodicFailure::NoState {
                label: label.clone(),
            };
            found.map(|index| first + index).ok_or_else(missing)
        };
        let controls = settings.controls.iter().map(|one| index(&one.label));
        let integrals = settings.targets.iter().map(|one| index(&one.label));
        Ok(Self {
            controls: controls.collect::<Result<_, _>>()?,
            integrals: integrals.collect::<Result<_, _>>()?,
            of_controls: settings.controls.clone(),
            of_targets: settings.targets.clone(),
            first,
            period: settings.period,
            is_held: false,
        })
    }

    /// The same with controls that keep their values: `d_u = 0` in place of the targets.
    pub fn held(&self) -> Self {
        Self {
            is_held: true,
            ..self.clone()
        }
    }

    /// The same with each target at a `part` of the way from given means to its value, by its index.
    pub fn partly(&self, from: &[f64], part: impl Fn(usize) -> f64) -> Self {
        let mut border = self.clone();
        for (index, (target, from)) in border.of_targets.iter_mut().zip(from).enumerate() {
            target.value = from + part(index) * (target.value - from);
        }
        border
    }

    /// The name of a target by its index.
    pub fn target_name(&self, index: usize) -> &str {
        &self.of_targets[index].name
    }

    /// The targets that means differ from by a part of their scales, with both, as text.
    pub fn differences(&self, means: &[f64], part: f64) -> String {
        let pairs = self.of_targets.iter().zip(means);
        let far = pairs.filter(|(own, mean)| (*mean - own.value).abs() > part * own.scale);
        let texts = far.map(|(own, mean)| {
            let [mean, value] = [*mean, own.value].map(|value| short_number(value, 4));
            format!("\"{}\" = {mean} in place of {value}", own.name)
        });
        texts.collect::<Vec<_>>().join(", ")
    }

    /// The name of the control's target that means are farthest from, in its scale.
    pub fn farthest(&self, means: &[f64]) -> &str {
        let errors = self.errors(means).into_iter().map(f64::abs).enumerate();
        let farthest = errors.max_by(|(_, a), (_, b)| a.total_cmp(b));
        farthest.map_or("", |(index, _)| self.target_name(index))
    }

    /// All their unknowns: those without a part in the modes.
    pub fn unknowns(&self) -> Vec<usize> {
        self.controls
            .iter()
            .chain(&self.integrals)
            .copied()
            .collect()
    }

    /// Unknowns of controls and of their integrals, with their targets.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize, &TrimTarget)> {
        let pairs = self.controls.iter().zip(&self.integrals);
        pairs
            .zip(&self.of_targets)
            .map(|((u, i), target)| (*u, *i, target))
    }

    /// Sets the integrals of a first state to zero.
    pub fn begin(&self, state: &mut State) {
        for integral in &self.integrals {
            state.scalars[integral - self.first] = 0.0;
        }
    }

    /// Values of the controls at a state.
    pub fn values(&self, state: &State) -> Vec<f64> {
        let values = self.controls.iter();
        values.map(|u| state.scalars[u - self.first]).collect()
    }

    /// The controls with their values at a state, as text.
    pub fn written(&self, state: &State) -> String {
        let values = self.of_controls.iter().zip(self.values(state));
        let texts = values.map(|(own, value)| format!("{} = {value:.6}", own.name));
        texts.collect::<Vec<_>>().join(", ")
    }

    /// The integrals at a state.
    pub fn integrals(&self, state: &State) -> Vec<f64> {
        let values = self.integrals.iter();
        values.map(|i| state.scalars[i - self.first]).collect()
    }

    /// The means of all targets over the period that ends at a state.
    pub fn reached(&self, end: &State) -> Vec<f64> {
        let integrals = self.integrals(end).into_iter();
        integrals.map(|integral| integral / self.period).collect()
    }

    /// Replaces the rows of controls and integrals in the residual `y(T) - y(0)`.
    pub fn complete(&self, residual: &mut [f64], end: &State) {
        for (u, integral, target) in self.pairs() {
            let mean = end.scalars[integral - self.first] / self.period;
            residual[u] = if self.is_held {
                0.0
            } else {
                mean - target.value
            };
        }
        self.integrals.iter().for_each(|i| residual[*i] = 0.0);
    }

    /// Replaces them in the product `d - M d`, given d and `M d`.
    pub fn product(&self, [d, later]: [&[f64]; 2], product: &mut [f64]) {
        for (u, integral, _) in self.pairs() {
            let change = -later[integral] / self.period;
            product[u] = if self.is_held { d[u] } else { change };
        }
        self.integrals.iter().for_each(|i| product[*i] = d[*i]);
    }

    /// Sizes of the rows: of the unknowns, and of the targets in the rows of the controls.
    pub fn sizes(&self, sizes: &[f64]) -> Vec<f64> {
        let mut rows = sizes.to_vec();
        for (u, _, target) in self.pairs() {
            rows[u] = target.scale;
        }
        rows
    }

    /// The target of a row, if it is one.
    pub fn target(&self, row: usize) -> Option<&TrimTarget> {
        let pair = self.controls.iter().position(|u| *u == row)?;
        self.of_targets.get(pair)
    }

    /// The rows of the targets; none if the controls are held.
    pub fn target_rows(&self) -> &[usize] {
        if self.is_held { &[] } else { &self.controls }
    }

    /// Shortens a correction `d` of a state so that no control changes by more than its step or leaves
    /// its bounds; returns the control, with its bound, that is at the bound and would leave it.
    pub fn limit(&self, d: &mut [f64], state: &State) -> Option<(&TrimControl, f64)> {
        let all = || self.controls.iter().zip(&self.of_controls);
        let parts = all().map(|(u, control)| control.step / d[*u].abs());
        let part = parts.fold(1.0, f64::min);
        d.iter_mut().for_each(|d| *d *= part);
        let mut blocked = None;
        for (u, control) in all() {
            let value = state.scalars[u - self.first];
            let [lower, upper] = control.bounds;
            let next = (value + d[*u]).clamp(lower, upper);
            if next != value + d[*u] && next == value {
                blocked = Some((control, next));
            }
            d[*u] = next - value;
        }
        blocked
    }

    /// Sets the controls of a state to the values nearest to given ones within their bounds.
    pub fn set(&self, state: &mut State, values: &[f64]) {
        let own = self.controls.iter().zip(&self.of_controls);
        for ((u, control), value) in own.zip(values) {
            let [lower, upper] = control.bounds;
            state.scalars[u - self.first] = value.clamp(lower, upper);
        }
    }

    /// The first control that is at one of its bounds, with it.
    pub fn at_bound(&self, state: &State) -> Option<(&TrimControl, f64)> {
        let values = self.values(state);
        let mut own = self.of_controls.iter().zip(values);
        own.find(|(control, value)| control.bounds.contains(value))
    }

    /// Whether a correction `d` changes a control by so much that the controls may not determine the
    /// targets.
    pub fn is_suspicious(&self, d: &[f64]) -> bool {
        let mut all = self.controls.iter().zip(&self.of_controls);
        all.any(|(u, control)| d[*u].abs() > SUSPICIOUS * control.scale)
    }

    /// Why the controls do not determine the targets, from the response of the means (rows, of size
    /// one) to the controls (columns) with its relative errors, in whatever units both are; `None` if they do.
    pub fn idle(&self, response: &DMatrix<f64>, errors: f64) -> Option<String> {
        effects::idle((response, errors), &self.of_controls, &self.of_targets)
    }

    /// Number of controls.
    pub fn count(&self) -> usize {
        self.controls.len()
    }

    /// Unknown of a control.
    pub fn control(&self, index: usize) -> usize {
        self.controls[index]
    }

    /// Changes of the means of the controls' targets in a variation a period later, of size one.
    pub fn means(&self, later: &[f64]) -> Vec<f64> {
        let pairs = self.pairs();
        pairs
            .map(|(_, i, target)| later[i] / self.period / target.scale)
            .collect()
    }

    /// Errors of the controls' targets, of size one, given means or momentary values.
    pub fn errors(&self, values: &[f64]) -> Vec<f64> {
        let pairs = values.iter().zip(self.pairs());
        pairs
            .map(|(value, (_, _, target))| (value - target.value) / target.scale)
            .collect()
    }

    /// Scales of the controls.
    pub fn scales(&self) -> impl Iterator<Item = f64> {
        self.of_controls.iter().map(|control| control.scale)
    }
}
