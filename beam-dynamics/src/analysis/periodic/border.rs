//! Controls and targets: the border of Newton's method.
//!
//! A control u is a state that does not change, `u' = 0`, and a target is the integral I of a
//! quantity, `I' = q`, `I(0) = 0`: both are unknowns of the motion, so that the map M of a period
//! has their derivatives. In the equations of the shooting, the rows of the controls, which say
//! nothing, become rows of the targets, and the rows of the integrals their start:
//!
//! ```text
//! d - M d = y(T) - y(0)              (states)
//! -(M d)_I / T = I(T)/T - target     (rows of the controls)                          (D-205)
//! d_I = 0                            (rows of the integrals)
//! ```

use nalgebra::DMatrix;

use super::failure::PeriodicFailure;
use crate::case::{Model, PeriodicSettings, PeriodicTarget};
use crate::model::State;

/// The unknowns of the controls and integrals.
pub(super) struct Border {
    /// Controls and integrals, in pairs.
    pairs: Vec<[usize; 2]>,
    controls: Vec<String>,
    targets: Vec<PeriodicTarget>,
    /// The first scalar among the unknowns.
    first: usize,
    period: f64,
}

impl Border {
    /// Of the controls and targets of `settings`.
    ///
    /// # Errors
    /// The model has no such elements, or their numbers differ.
    pub fn new(model: &Model, settings: &PeriodicSettings) -> Result<Self, PeriodicFailure> {
        let first = model.system.numbering().first_scalar();
        let [controls, targets] = [settings.controls.len(), settings.targets.len()];
        if controls != targets {
            return Err(PeriodicFailure::Counts { controls, targets });
        }
        let index = |label: &str| {
            let mut scalars = model.system.scalars().iter();
            let found = scalars.position(|scalar| scalar.has_rate && scalar.owner == label);
            let missing = || PeriodicFailure::NoState {
                label: label.to_owned(),
            };
            found.map(|index| first + index).ok_or_else(missing)
        };
        let labels = settings.controls.iter().zip(&settings.targets);
        let pairs = labels.map(|((_, control), target)| -> Result<_, PeriodicFailure> {
            Ok([index(control)?, index(&target.integral)?])
        });
        Ok(Self {
            pairs: pairs.collect::<Result<_, _>>()?,
            controls: settings
                .controls
                .iter()
                .map(|(name, _)| name.clone())
                .collect(),
            targets: settings.targets.clone(),
            first,
            period: settings.period,
        })
    }

    /// All their unknowns: those without a part in the modes.
    pub fn unknowns(&self) -> Vec<usize> {
        self.pairs.iter().flatten().copied().collect()
    }

    /// Sets the integrals of a first state to zero.
    pub fn begin(&self, state: &mut State) {
        for [_, integral] in &self.pairs {
            state.scalars[integral - self.first] = 0.0;
        }
    }

    /// Names and values of the controls at a state.
    pub fn values(&self, state: &State) -> Vec<(String, f64)> {
        let pairs = self.controls.iter().zip(&self.pairs);
        pairs
            .map(|(name, [u, _])| (name.clone(), state.scalars[u - self.first]))
            .collect()
    }

    /// Replaces the rows of controls and integrals in the residual `y(T) - y(0)`.
    pub fn complete(&self, residual: &mut [f64], end: &State) {
        for ([u, integral], target) in self.pairs.iter().zip(&self.targets) {
            residual[*u] = end.scalars[integral - self.first] / self.period - target.value;
            residual[*integral] = 0.0;
        }
    }

    /// Replaces them in the product `d - M d`, given d and `M d`.
    pub fn product(&self, [d, later]: [&[f64]; 2], product: &mut [f64]) {
        for [u, integral] in &self.pairs {
            product[*u] = -later[*integral] / self.period;
            product[*integral] = d[*integral];
        }
    }

    /// Sizes of the rows: of the unknowns, and of the targets in the rows of the controls.
    pub fn sizes(&self, sizes: &[f64]) -> Vec<f64> {
        let mut rows = sizes.to_vec();
        for ([u, _], target) in self.pairs.iter().zip(&self.targets) {
            rows[*u] = target.scale;
        }
        rows
    }

    /// The target of a row, if it is one.
    pub fn target(&self, row: usize) -> Option<&PeriodicTarget> {
        let pair = self.pairs.iter().position(|[u, _]| *u == row)?;
        self.targets.get(pair)
    }

    /// The control that acts least and the target that is reached least, from the response of the
    /// means (rows, of size one) to the controls (columns); `None` if all act.
    pub fn idle(&self, response: &DMatrix<f64>) -> Option<[String; 2]> {
        const IDLE: f64 = 1e-9;
        if response.is_empty() {
            return None;
        }
        let largest = response.amax();
        let found = response.clone().svd(true, true);
        let (least, value) = found.singular_values.argmin();
        if value > IDLE * largest.max(IDLE) {
            return None;
        }
        let (u, v_t) = (found.u?, found.v_t?);
        let (target, control) = (u.column(least).iamax(), v_t.row(least).transpose().iamax());
        Some([
            self.controls.get(control)?.clone(),
            self.targets.get(target)?.name.clone(),
        ])
    }

    /// Number of controls.
    pub fn count(&self) -> usize {
        self.pairs.len()
    }

    /// Unknown of a control.
    pub fn control(&self, index: usize) -> usize {
        self.pairs[index][0]
    }

    /// Changes of the means in a variation a period later, of size one.
    pub fn means(&self, later: &[f64]) -> Vec<f64> {
        let pairs = self.pairs.iter().zip(&self.targets);
        pairs
            .map(|([_, i], target)| later[*i] / self.period / target.scale)
            .collect()
    }
}
