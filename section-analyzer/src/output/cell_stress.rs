//! Stresses of the cells of a section per unit internal force, as short numbers.

use nalgebra::Matrix6;
use serde::Serialize;

use super::packed::packed;

/// Largest number of steps of a stress.
const STEPS: f64 = 16383.0;

/// Mean stresses of the cells of a section per unit internal force about the reference point, in
/// material axes.
///
/// A stress is its number times the step of its ply, force and component, the least power of two
/// with which the largest stress there has at most 16383 steps. The error is at most half of a
/// step, 1/16383 of the largest stress.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct CellStress {
    /// Lists of integers as one text: for each ply the 36 exponents of its steps \[1/m^2,
    /// 1/m^3\], by force (the six components of the internal force) and component (11 22 33 23 13
    /// 12), then in the same order a list of the numbers of its cells.
    pub values: String,
}

impl CellStress {
    /// The stresses of cells by ply: for each cell six rows of stress, a column per force.
    pub fn new<'a>(plies: impl Iterator<Item = Vec<&'a Matrix6<f64>>>) -> Self {
        let mut lists = Vec::new();
        for cells in plies {
            let (mut exponents, mut numbers) = (Vec::new(), Vec::new());
            for (force, component) in (0..36).map(|number| (number / 6, number % 6)) {
                let stresses = || cells.iter().map(|cell| cell[(component, force)]);
                let exponent = exponent(stresses());
                let step = 2.0_f64.powi(exponent);
                exponents.push(i64::from(exponent));
                numbers.push(
                    stresses()
                        .map(|stress| (stress / step).round() as i64)
                        .collect(),
                );
            }
            lists.push(exponents);
            lists.append(&mut numbers);
        }
        Self {
            values: packed(&lists),
        }
    }
}

/// Exponent of the least power of two of which the largest stress has at most the number of
/// steps; 0 without a stress.
fn exponent(stresses: impl Iterator<Item = f64>) -> i32 {
    let largest = stresses.fold(0.0_f64, |most, stress| most.max(stress.abs()));
    let least = (largest / STEPS).log2().ceil();
    if least.is_finite() { least as i32 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::packed::unpacked::unpacked;

    /// Random stresses in plies of 1 to 5 cells, over 12 orders of magnitude: errors are at most
    /// half of a step, and the largest stress has 8191 to 16383 steps.
    #[test]
    fn errors_are_half_of_a_step() {
        let mut state = 5_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let mut plies: Vec<Vec<Matrix6<f64>>> = Vec::new();
        for number in 0..100 {
            let cell = |_| Matrix6::from_fn(|_, _| random() * 10_f64.powf(6.0 * random()));
            plies.push((0..1 + number % 5).map(cell).collect());
        }
        plies.push(vec![Matrix6::zeros(); 2]);
        let short = CellStress::new(plies.iter().map(|cells| cells.iter().collect()));
        let lengths = |cells: &Vec<_>| std::iter::once(36).chain(vec![cells.len(); 36]);
        let lengths: Vec<usize> = plies.iter().flat_map(lengths).collect();
        let lists = unpacked(&short.values, &lengths);
        for (cells, lists) in plies.iter().zip(lists.chunks(37)) {
            for number in 0..36 {
                let step = 2.0_f64.powi(lists[0][number] as i32);
                let mut largest = 0.0_f64;
                for (cell, value) in cells.iter().zip(&lists[1 + number]) {
                    let exact = cell[(number % 6, number / 6)];
                    let error = *value as f64 * step - exact;
                    assert!(error.abs() <= 0.5 * step, "{number}: {error}");
                    largest = largest.max(exact.abs());
                }
                let steps = largest / step;
                assert!(
                    largest == 0.0 || (8191.0..=16383.5).contains(&steps),
                    "{steps}"
                );
            }
        }
    }
}
