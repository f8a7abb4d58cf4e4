//! The values of columns of the air.

use super::AcceptedStep;
use crate::assembly::System;
use crate::case::Quantity;
use crate::elements::{AirState, Definition, Observations, RotorAir, RotorQuantity, StripQuantity};

/// Columns of strips and rotors, and the strips that they need.
#[derive(Debug, Default)]
pub(super) struct AirColumns {
    /// Indices of the strips among the elements.
    strips: Vec<usize>,
    columns: Vec<(usize, Source)>,
    observed: Observations,
}

/// Source of a column, by indices among the strips.
#[derive(Debug)]
enum Source {
    Strip(Vec<(usize, f64)>, StripQuantity),
    Rotor(Vec<usize>, RotorQuantity, Definition),
}

impl AirColumns {
    /// Adds the column with the index `column`, if it is of the air.
    pub fn add(&mut self, column: usize, quantity: &Quantity, system: &System) {
        let source = match quantity {
            Quantity::Strip { strips, quantity } => {
                let strips = strips.iter();
                let strips =
                    strips.filter_map(|(name, weight)| Some((self.strip(name, system)?, *weight)));
                Source::Strip(strips.collect(), *quantity)
            }
            Quantity::Rotor {
                strips,
                quantity,
                definition,
            } => {
                let strips = strips.iter().filter_map(|name| self.strip(name, system));
                Source::Rotor(strips.collect(), *quantity, *definition)
            }
            _ => return,
        };
        self.columns.push((column, source));
    }

    /// The index of a strip among the ones that are needed, which it joins.
    fn strip(&mut self, name: &str, system: &System) -> Option<usize> {
        let element = system
            .elements()
            .position(|element| element.label() == name)?;
        let known = self.strips.iter().position(|strip| *strip == element);
        Some(known.unwrap_or_else(|| {
            self.strips.push(element);
            self.strips.len() - 1
        }))
    }

    /// Writes the values at `accepted` to `out`, in SI units.
    pub fn evaluate(&mut self, system: &System, accepted: &AcceptedStep<'_>, out: &mut [f64]) {
        self.observed.air.clear();
        let (state, conditions) = (accepted.state, accepted.conditions);
        for &strip in &self.strips {
            system.observe_element(strip, state, conditions, &mut self.observed);
        }
        let air = &self.observed.air;
        for (column, source) in &self.columns {
            let value = match source {
                Source::Strip(strips, quantity) => {
                    let part = |(strip, weight): &(usize, f64)| {
                        Some(weight * quantity.of(air.get(*strip)?))
                    };
                    strips.iter().map(part).sum()
                }
                Source::Rotor(strips, quantity, definition) => {
                    let strips = strips.iter().filter_map(|strip| air.get(*strip));
                    let rotor = RotorAir::of(strips.collect::<Vec<&AirState>>());
                    rotor.map(|rotor| rotor.value(*quantity, *definition))
                }
            };
            out[*column] = value.unwrap_or(f64::NAN);
        }
    }
}
