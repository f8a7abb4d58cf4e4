//! The linearized equations with inputs, some of which are integrals of the actual inputs.
//!
//! An input u loses its equation and becomes a column, `F_u`. One that moves a joint or acts by its rate
//! stays an unknown, whose derivative of order k is the input v:
//!
//! ```text
//! k = 1:  u' - v = 0              k = 2:  u' - w = 0 ,  w' - v = 0                 (D-337)
//! ```

use faer::Mat;

use crate::assembly::{Sparse, Tangent};
use crate::solver::Descriptor;

/// Highest order of a derivative that is an input.
const MOST: usize = 2;

/// The unknowns of the equations with inputs.
pub(super) struct Augmented {
    /// Number of unknowns of the system.
    unknowns: usize,
    /// The unknowns of the inputs.
    inputs: Vec<usize>,
    /// Order of the derivative of each that is the input.
    degrees: Vec<usize>,
}

impl Augmented {
    /// Of `unknowns` unknowns of a system, of which some are `inputs`.
    pub fn new(tangent: &Tangent, unknowns: usize, inputs: Vec<usize>) -> Self {
        // By its rate an input acts in the equations of others.
        let acts = |input: &usize| {
            let mut entries = tangent.by_rates.triplets();
            entries.any(|(row, column, value)| column == *input && row != column && value != 0.0)
        };
        Self {
            degrees: inputs
                .iter()
                .map(|input| usize::from(acts(input)))
                .collect(),
            unknowns,
            inputs,
        }
    }

    /// Order of the derivative of each input.
    pub fn degrees(&self) -> &[usize] {
        &self.degrees
    }

    /// Takes the next derivative of an input; `false` if there is none.
    pub fn integrate(&mut self, input: usize) -> bool {
        let is_possible = self.degrees[input] < MOST;
        self.degrees[input] += usize::from(is_possible);
        is_possible
    }

    /// Inputs that are no unknowns, ascending by their unknowns.
    fn removed(&self) -> Vec<usize> {
        let pairs = self.inputs.iter().zip(&self.degrees);
        let removed = pairs.filter(|(_, degree)| **degree == 0);
        let mut removed: Vec<_> = removed.map(|(input, _)| *input).collect();
        removed.sort_unstable();
        removed
    }

    /// Number of unknowns that stay.
    fn kept(&self) -> usize {
        self.unknowns - self.removed().len()
    }

    /// Index among the unknowns that stay of an unknown of the system, or the number of the input that
    /// it is.
    pub fn index(&self, unknown: usize) -> Result<usize, usize> {
        let mut pairs = self.inputs.iter().zip(&self.degrees);
        let is_it = |(input, degree): (&usize, &usize)| *input == unknown && *degree == 0;
        match pairs.position(is_it) {
            Some(input) => Err(input),
            None => Ok(unknown - self.removed().partition_point(|own| *own < unknown)),
        }
    }

    /// The unknown of the system at an index among those that stay.
    pub fn origin(&self, index: usize) -> usize {
        let steps = |unknown: usize, removed: &usize| unknown + usize::from(*removed <= unknown);
        self.removed().iter().fold(index, steps)
    }

    /// The input, and the order of its derivative, that an unknown among those that stay is.
    pub fn integral(&self, index: usize) -> Option<(usize, usize)> {
        if let Some(rate) = index.checked_sub(self.kept()) {
            let mut rates = (0..self.inputs.len()).filter(|k| self.degrees[*k] == MOST);
            return Some((rates.nth(rate)?, 1));
        }
        let origin = self.origin(index);
        let input = self.inputs.iter().position(|own| *own == origin)?;
        Some((input, 0))
    }

    /// The equations.
    pub fn descriptor(&self, tangent: &Tangent) -> Descriptor {
        let kept = self.kept();
        let doubled = self.degrees.iter().filter(|degree| **degree == MOST);
        let size = kept + doubled.count();
        let mut by_inputs = Mat::zeros(size, self.inputs.len());
        let [mut by_rates, mut by_unknowns] = [(); 2].map(|()| Mat::zeros(size, size));
        let indices: Vec<_> = (0..self.unknowns).map(|i| self.index(i)).collect();
        let mut add = |from: &Sparse, to: &mut Mat<f64>| {
            for (row, column, value) in from.triplets() {
                if row.max(column) >= self.unknowns || self.inputs.contains(&row) {
                    continue;
                }
                match (indices[row], indices[column]) {
                    (Ok(row), Ok(column)) => to[(row, column)] += value,
                    (Ok(row), Err(input)) => by_inputs[(row, input)] += value,
                    _ => {}
                }
            }
        };
        add(&tangent.by_unknowns, &mut by_unknowns);
        // Inputs that are no unknowns do not act by their rates.
        add(&tangent.by_rates, &mut by_rates);
        let mut next = kept;
        for (k, (input, degree)) in self.inputs.iter().zip(&self.degrees).enumerate() {
            let Ok(mut last) = indices[*input] else {
                continue;
            };
            by_rates[(last, last)] = 1.0;
            if *degree == MOST {
                by_unknowns[(last, next)] = -1.0;
                by_rates[(next, next)] = 1.0;
                last = next;
                next += 1;
            }
            by_inputs[(last, k)] = -1.0;
        }
        Descriptor {
            by_rates,
            by_unknowns,
            by_inputs,
        }
    }
}

/// Words for the derivative of an order of an input.
pub(super) fn words(name: &str, order: usize) -> String {
    match order {
        0 => name.to_owned(),
        1 => format!("rate of {name}"),
        _ => format!("second derivative of {name}"),
    }
}

/// The unit of the derivative of an order of an input.
pub(super) fn unit(unit: &str, order: usize) -> String {
    match (unit, order) {
        (unit, 0) => unit.to_owned(),
        ("-", 1) => "1/s".to_owned(),
        ("-", _) => "1/s^2".to_owned(),
        (unit, 1) => format!("{unit}/s"),
        (unit, _) => format!("{unit}/s^2"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Five unknowns, of which 1 is an input and 3 the second integral of one.
    #[test]
    fn unknowns_are_numbered_without_inputs() {
        let of = Augmented {
            unknowns: 5,
            inputs: vec![3, 1],
            degrees: vec![2, 0],
        };
        let indices: Vec<_> = (0..5).map(|i| of.index(i)).collect();
        assert_eq!(indices, [Ok(0), Err(1), Ok(1), Ok(2), Ok(3)]);
        let origins: Vec<_> = (0..4).map(|i| of.origin(i)).collect();
        assert_eq!(origins, [0, 2, 3, 4]);
        let integrals: Vec<_> = (0..5).map(|i| of.integral(i)).collect();
        assert_eq!(integrals, [None, None, Some((0, 0)), None, Some((0, 1))]);
        assert_eq!(
            [words("u", 2), unit("rad", 1)],
            ["second derivative of u", "rad/s"]
        );
    }
}
