//! Whether the blades are equal: multiblade coordinates of blades that differ have coefficients that are
//! periodic even in hover, and whose means are not their equations.
//!
//! Equal blades have the same motion one after the other, so that the means over a period of the
//! coefficients of each blade, in its own axes, are the same.

use std::collections::BTreeMap;

use super::Block;
use crate::analysis::multiblade::{Coordinates, Slot};

/// Difference of two blades relative to the largest number of the block.
const SAME: f64 = 1e-3;
/// The same relative to the largest number of the row: the error of the motion.
const MOTION: f64 = 1e-9;
/// The same relative to the largest number of all rows: round-off in the forces of stiff beams, which joints pass to
/// rows without stiffness.
const ROUND_OFF: f64 = 1e-12;

/// Sums of the coefficients of each blade by itself, by pairs of families.
#[derive(Debug, Default)]
pub(super) struct Equality {
    sums: BTreeMap<(usize, usize), Vec<Option<Block>>>,
}

impl Equality {
    /// Adds the coefficients of the equations of one slot by the unknowns of another, in the axes of their
    /// blade if both are of one.
    pub fn add(&mut self, [row, column]: [&Slot; 2], all: &Coordinates, block: &Block) {
        let (Some((blade, row)), Some((other, column))) = (row.of_blade, column.of_blade) else {
            return;
        };
        if blade != other {
            return;
        }
        let sums = self.sums.entry((row, column));
        let rotor = all.rotor_of(blade);
        let sums = sums.or_insert_with(|| vec![None; rotor.count]);
        match &mut sums[blade - rotor.first] {
            Some(sum) => sum.iter_mut().zip(block).for_each(|(sum, own)| *sum += own),
            empty => *empty = Some(block.clone()),
        }
    }

    /// The unknown whose equation differs most between two blades; `None` for equal blades.
    pub fn different(&self, coordinates: &Coordinates) -> Option<usize> {
        let mut rows: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        for (&(row, _), sums) in &self.sums {
            for (number, size) in sizes(sums).into_iter().enumerate() {
                let largest = rows.entry((row, number)).or_default();
                *largest = largest.max(size);
            }
        }
        let largest = |number: usize| {
            let own = rows.iter().filter(|(row, _)| row.1 == number);
            own.fold(0.0_f64, |largest, (_, size)| largest.max(*size))
        };
        let largest = [0, 1].map(largest);
        let mut worst = (1.0, None);
        for (&(row, _), sums) in &self.sums {
            let of_row = [0, 1].map(|number| rows.get(&(row, number)).copied().unwrap_or(0.0));
            let blocks = sizes(sums);
            for blade in 1..sums.len() {
                let found = differences([&sums[0], &sums[blade]]);
                for number in 0..2 {
                    let allowed = SAME * blocks[number]
                        + MOTION * of_row[number]
                        + ROUND_OFF * largest[number];
                    let part = found[number] / allowed;
                    if part > worst.0 {
                        let slot = coordinates.families[row][blade];
                        worst = (part, Some(coordinates.slots[slot].first));
                    }
                }
            }
        }
        worst.1
    }
}

/// The largest number of each matrix of a block, of all blades.
fn sizes(sums: &[Option<Block>]) -> [f64; 2] {
    [0, 1].map(|number| {
        let own = sums.iter().flatten().map(|block| block[number].amax());
        own.fold(0.0, f64::max)
    })
}

/// The largest difference of each matrix of the blocks of two blades; a block that is not there is zero.
fn differences(blades: [&Option<Block>; 2]) -> [f64; 2] {
    [0, 1].map(|number| match blades {
        [Some(a), Some(b)] => (&a[number] - &b[number]).amax(),
        [Some(own), None] | [None, Some(own)] => own[number].amax(),
        [None, None] => 0.0,
    })
}
