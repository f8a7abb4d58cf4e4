//! Scalar unknowns of a system: their scales, and values that agree with a motion.

use std::sync::Arc;

use super::{System, Tangent};
use crate::assembly::{Pattern, Sparse};
use crate::elements::{Charges, ElectrodeState, Local};
use crate::model::{Conditions, Name, Scalar, ScalarStart, State};
use crate::solver::LinearSolver;

/// Corrections by this part of the scales of the scalars are the last ones.
const LAST: f64 = 1e-10;
/// Corrections below this part that do not shrink any more are round-off.
const FLOOR: f64 = 1e-6;
/// Iterations at most.
const MOST: usize = 30;

/// What is unknown of scalars at a given motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settling {
    /// Values of those that settle, at rest; rates of those that begin at a given value.
    AtRest,
    /// Values of those without a rate, and the rates of the others.
    InMotion,
}

/// Scales by which changes of scalars, or residuals of their equations, are measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ScalarScales {
    /// Units.
    count: usize,
    /// The unit of each scalar by its number; `None` where it does not count.
    units: Vec<Option<usize>>,
    /// Least scale of each scalar [unit of it].
    least: Vec<f64>,
}

/// A change of a scalar that is the largest by its scale.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ScalarChange {
    /// Number of the scalar.
    pub scalar: usize,
    /// The change by the scale [-].
    pub part: f64,
    /// The scale [unit of the scalar].
    pub scale: f64,
}

impl ScalarScales {
    /// Of scalars given by unit and least scale.
    fn of<'a>(scalars: impl Iterator<Item = Option<(&'a str, f64)>>) -> Self {
        let mut known: Vec<&str> = Vec::new();
        let (mut units, mut least) = (Vec::new(), Vec::new());
        for scalar in scalars {
            let (unit, scale) = scalar.unzip();
            units.push(unit.map(|unit| {
                let place = known.iter().position(|own| *own == unit);
                place.unwrap_or_else(|| {
                    known.push(unit);
                    known.len() - 1
                })
            }));
            least.push(scale.unwrap_or_default());
        }
        Self {
            count: known.len(),
            units,
            least,
        }
    }

    /// The largest of `changes` by its scale: the largest `size` of the scalars of its unit,
    /// given by their numbers, and at least its own. No number where a change is none.
    pub fn largest(&self, changes: &[f64], size: impl Fn(usize) -> f64) -> ScalarChange {
        let mut most = ScalarChange::default();
        for unit in 0..self.count {
            let own = self.of_unit(unit, changes).map(|(scalar, _)| size(scalar));
            let largest = own.fold(0.0, f64::max);
            for (scalar, change) in self.of_unit(unit, changes) {
                let scale = largest.max(self.least[scalar]);
                let part = if change == 0.0 {
                    0.0
                } else {
                    (change / scale).abs()
                };
                if !most.part.is_nan() && (part.is_nan() || part > most.part) {
                    most = ScalarChange {
                        scalar,
                        part,
                        scale,
                    };
                }
            }
        }
        most
    }

    /// The largest of `errors` by the largest of each unit so far, `before`. While the values
    /// `now` of a unit grow by more than `grown` times in a step there is nothing to measure
    /// them by.
    pub fn error(&self, errors: &[f64], [now, before]: [&[f64]; 2], grown: f64) -> f64 {
        let of_unit = |unit: usize| {
            let own = self.of_unit(unit, errors);
            let scale = |scalar: usize| self.largest_value(unit, before).max(self.least[scalar]);
            let now = self.largest_value(unit, now);
            let counted = own.filter(|(scalar, _)| now <= grown * scale(*scalar));
            let parts = counted.map(|(scalar, error)| (error / scale(scalar)).abs());
            parts.fold(0.0, f64::max)
        };
        (0..self.count).map(of_unit).fold(0.0, f64::max)
    }

    fn of_unit<'a>(
        &'a self,
        unit: usize,
        numbers: &'a [f64],
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let numbers = numbers.iter().copied().enumerate();
        numbers.filter(move |(scalar, _)| self.units[*scalar] == Some(unit))
    }

    fn largest_value(&self, unit: usize, values: &[f64]) -> f64 {
        let own = self.of_unit(unit, values).map(|(_, value)| value.abs());
        own.fold(0.0, f64::max)
    }
}

impl System {
    /// The scalar unknowns, in the order of their numbers.
    pub fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    /// Scales of the scalar unknowns for which it `counts`.
    pub fn scalar_scales(&self, counts: impl Fn(&Scalar) -> bool) -> ScalarScales {
        let counted = self.scalars.iter().map(|scalar| {
            let unknown = &scalar.unknown;
            counts(scalar).then(|| (&unknown.unit[..], unknown.scale))
        });
        ScalarScales::of(counted)
    }

    /// Scales of the equations of scalars.
    pub fn scalar_equation_scales(&self) -> ScalarScales {
        let equations = self.scalars.iter().map(|scalar| &scalar.equation);
        ScalarScales::of(equations.map(|equation| Some((&equation.unit[..], equation.scale))))
    }

    /// Voltages, charges and currents of all electrodes.
    pub fn electrodes(&self, state: &State, conditions: &Conditions) -> Vec<ElectrodeState> {
        let mut charges = Charges::default();
        for (index, element) in self.elements.iter().enumerate() {
            let call = |at: &Local<'_>| element.charges(at, &mut charges);
            self.seen(index, state, conditions, call);
        }
        charges.electrodes()
    }

    /// Values and rates with which the scalars of a run begin, before they settle.
    pub fn begin_scalars(&self, state: &mut State) {
        for (value, scalar) in state.scalars.iter_mut().zip(&self.scalars) {
            *value = match scalar.start {
                ScalarStart::Value(value) => value,
                ScalarStart::Settled => 0.0,
            };
        }
        state.scalar_rates.fill(0.0);
    }

    /// Brings the scalars of a state in line with its motion and with what acts, by Newton's
    /// method on their equations.
    ///
    /// # Errors
    ///
    /// The equation that is farthest off, where that finds nothing; the state stays as it was.
    pub fn settle_scalars(
        &self,
        state: &mut State,
        conditions: &Conditions,
        settling: Settling,
    ) -> Result<(), Name> {
        if self.scalars.is_empty() {
            return Ok(());
        }
        let before = (state.scalars.clone(), state.scalar_rates.clone());
        state.scalar_rates.fill(0.0);
        if self.find_scalars(state, conditions, settling).is_some() {
            return Ok(());
        }
        let first = self.numbering.first_scalar();
        let residual = self.residual(state, conditions);
        let scales = self.scalar_equation_scales();
        let worst = scales.largest(&residual.values[first..], |i| residual.sizes[first + i]);
        (state.scalars, state.scalar_rates) = before;
        Err(self.equation(first + worst.scalar))
    }

    fn find_scalars(
        &self,
        state: &mut State,
        conditions: &Conditions,
        settling: Settling,
    ) -> Option<()> {
        let is_rate = self.scalars.iter().map(|scalar| {
            let stays = settling == Settling::InMotion || scalar.start != ScalarStart::Settled;
            scalar.has_rate && stays
        });
        let is_rate: Vec<bool> = is_rate.collect();
        let pattern = self.pattern_of_scalars();
        let solver = LinearSolver::new(&pattern)?;
        let scales = self.scalar_scales(|_| true);
        let of_rates = ScalarScales {
            least: vec![0.0; self.scalars.len()],
            ..scales.clone()
        };
        let mut before = f64::INFINITY;
        for _ in 0..MOST {
            let tangent = self.tangent(state, conditions);
            let residual = self.residual(state, conditions).values;
            let first = self.numbering.first_scalar();
            let mut change: Vec<_> = residual[first..].iter().map(|value| -value).collect();
            let matrix = self.matrix_of_scalars(&tangent, &pattern, &is_rate);
            solver.factorize(matrix)?.solve(&mut change)?;
            let mut changes = [vec![0.0; change.len()], vec![0.0; change.len()]];
            for (i, change) in change.into_iter().enumerate() {
                let of = usize::from(is_rate[i]);
                changes[of][i] = change;
                [&mut state.scalars, &mut state.scalar_rates][of][i] += change;
            }
            let of_values = scales.largest(&changes[0], |i| state.scalars[i].abs());
            let of_rates = of_rates.largest(&changes[1], |i| state.scalar_rates[i].abs());
            let last = of_values.part.max(of_rates.part);
            if last <= LAST || last <= FLOOR && last >= 0.5 * before {
                return Some(());
            }
            before = last;
        }
        None
    }

    /// The block of the scalars in the pattern of the system.
    fn pattern_of_scalars(&self) -> Arc<Pattern> {
        let first = self.numbering.first_scalar();
        let whole = Sparse::zero(Arc::clone(&self.pattern));
        let block = whole.triplets().filter(|&(i, j, _)| i.min(j) >= first);
        let block = block.map(|(i, j, _)| (i - first, j - first)).collect();
        Arc::new(Pattern::new(self.scalars.len(), block))
    }

    /// Derivatives of the equations of scalars, by the rates of those for which it `is_rate`
    /// and by the values of the others.
    fn matrix_of_scalars(
        &self,
        tangent: &Tangent,
        pattern: &Arc<Pattern>,
        is_rate: &[bool],
    ) -> Sparse {
        let first = self.numbering.first_scalar();
        let mut matrix = Sparse::zero(Arc::clone(pattern));
        for (from, wanted) in [(&tangent.by_unknowns, false), (&tangent.by_rates, true)] {
            let own = from.triplets().filter(|&(i, j, _)| i.min(j) >= first);
            for (i, j, value) in own.filter(|&(_, j, _)| is_rate[j - first] == wanted) {
                if let Some(place) = pattern.place(i - first, j - first) {
                    matrix.values_mut()[place] += value;
                }
            }
        }
        matrix
    }
}
