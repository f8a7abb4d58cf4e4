//! Scalar unknowns of a system, and the scales by which they are measured.

use super::System;
use crate::elements::{Charges, ElectrodeState, Local, Queries};
use crate::model::{Conditions, Scalar, State};

/// Scales relative to which changes of scalars, or residuals of their equations, are measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ScalarScales {
    /// The numbers of the scalars of each unit.
    units: Vec<Vec<usize>>,
    /// Least scale of each scalar [unit of it].
    least: Vec<f64>,
}

/// The change of a scalar that is the largest relative to its scale.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ScalarChange {
    /// Number of the scalar.
    pub scalar: usize,
    /// The change relative to the scale [-].
    pub part: f64,
    /// The scale [unit of the scalar].
    pub scale: f64,
}

impl ScalarScales {
    /// The same with the least scales multiplied by `part`.
    #[must_use]
    pub fn finer(&self, part: f64) -> Self {
        Self {
            least: self.least.iter().map(|least| part * least).collect(),
            ..self.clone()
        }
    }

    /// Scales of scalars given by unit and least scale.
    fn of<'a>(scalars: impl Iterator<Item = Option<(&'a str, f64)>>) -> Self {
        let mut known: Vec<&str> = Vec::new();
        let (mut units, mut least): (Vec<Vec<usize>>, _) = (Vec::new(), Vec::new());
        for (number, scalar) in scalars.enumerate() {
            let (unit, scale) = scalar.unzip();
            least.push(scale.unwrap_or_default());
            let Some(unit) = unit else { continue };
            match known.iter().position(|own| *own == unit) {
                Some(index) => units[index].push(number),
                None => {
                    known.push(unit);
                    units.push(vec![number]);
                }
            }
        }
        Self { units, least }
    }

    /// Whether there are no scalars.
    pub fn is_empty(&self) -> bool {
        self.units.is_empty()
    }

    /// The largest of `changes` relative to its scale: the largest `size` of the scalars of its
    /// unit, given by their numbers, and at least its own. NaN if a change is NaN.
    pub fn largest(&self, changes: &[f64], size: impl Fn(usize) -> f64) -> ScalarChange {
        let mut most = ScalarChange::default();
        for unit in 0..self.units.len() {
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

    /// The largest of `errors` relative to the largest value of each unit so far, `before`.
    /// While the values `now` of a unit grow by a factor of more than `grown` in a step, no
    /// reference exists and the unit is ignored.
    pub fn error(&self, errors: &[f64], [now, before]: [&[f64]; 2], grown: f64) -> f64 {
        let of_unit = |unit: usize| {
            let own = self.of_unit(unit, errors);
            let scale = |scalar: usize| self.largest_value(unit, before).max(self.least[scalar]);
            let now = self.largest_value(unit, now);
            let counted = own.filter(|(scalar, _)| now <= grown * scale(*scalar));
            let parts = counted.map(|(scalar, error)| (error / scale(scalar)).abs());
            parts.fold(0.0, f64::max)
        };
        (0..self.units.len()).map(of_unit).fold(0.0, f64::max)
    }

    /// The numbers of the scalars of a unit; values after the scalars are ignored.
    fn of_unit<'a>(
        &'a self,
        unit: usize,
        numbers: &'a [f64],
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let own = self.units[unit].iter();
        own.map(move |&number| (number, numbers[number]))
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

    /// Whether the equation of a scalar has a multiplier, as of a reaction that is read.
    pub fn scalars_read_multipliers(&self) -> bool {
        let first = self.numbering().first_scalar();
        let multipliers = first - self.numbering().multipliers()..first;
        let (pattern, starts) = (self.pattern(), self.pattern().column_starts());
        let rows = &pattern.rows()[starts[multipliers.start]..starts[multipliers.end]];
        let scalars = first..self.numbering().unknowns();
        rows.iter().any(|row| scalars.contains(&(*row as usize)))
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
}
