//! Limits of the step length from quantities given over time.
//!
//! Steps that are chosen by the error at their points may pass over a pulse between them.
//! So drives are evaluated before a run: each is divided into pieces on which it is the
//! cubic through the values and rates of their ends, to a part of its range,
//!
//! ```text
//! | f(a + s h) - H(s) | <= eta ( max f - min f )      s = 1/4, 1/2, 3/4            (D-121)
//! ```
//!
//! and no step is longer than a piece into which it reaches. The range grows during the
//! search: the tail of a pulse, almost zero, leads to the pulse.

use super::{Drive, DriveValue};

/// Smallest number of pieces of a run, 2^12, each evaluated three times.
const COARSEST: u32 = 12;
/// Largest number of halvings of a piece.
const FINEST: u32 = 30;
/// eta: largest error of a piece, as part of the range.
const OFF: f64 = 0.02;
/// Less than this part of the largest value is round-off.
const ROUND_OFF: f64 = 1e-11;
/// Largest number of evaluations of a drive.
const MOST: usize = 1 << 21;
/// Largest number of corners between which a drive is evaluated: with more, steps end at
/// corners often enough.
const MOST_CORNERS: usize = 4096;

/// Ends of the pieces of all drives.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Pace(Vec<Vec<f64>>);

impl Pace {
    /// The pace of `drives` in a run from its first to its last instant \[s\].
    pub fn new<'a>(drives: impl Iterator<Item = &'a Drive>, [from, to]: [f64; 2]) -> Self {
        let mut known: Vec<&Drive> = Vec::new();
        for drive in drives.filter(|drive| drive.constant().is_none()) {
            if !known.contains(&drive) {
                known.push(drive);
            }
        }
        let ends = known.into_iter().map(|drive| Search::run(drive, from, to));
        Self(ends.filter(|ends| ends.len() > 2).collect())
    }

    /// The longest step from `time` that is no longer than any piece into which it reaches
    /// \[s\].
    pub fn longest_step(&self, time: f64) -> f64 {
        let mut longest = f64::INFINITY;
        for ends in &self.0 {
            let next = ends.partition_point(|end| *end <= time).max(1);
            for piece in ends[next - 1..].windows(2) {
                let until = piece[0] - time;
                if until >= longest {
                    break;
                }
                longest = longest.min(until.max(piece[1] - piece[0]));
            }
        }
        longest
    }
}

/// A piece of a drive between two corners.
#[derive(Debug, Clone, Copy)]
struct Piece {
    start: f64,
    end: f64,
    /// Number of halvings, and index among the pieces of the same length.
    level: u32,
    index: u64,
}

/// The search on a drive so far.
struct Search<'a> {
    drive: &'a Drive,
    least: f64,
    most: f64,
    looked: usize,
}

impl Search<'_> {
    /// Ends of the pieces of `drive`.
    fn run(drive: &Drive, from: f64, to: f64) -> Vec<f64> {
        let mut search = Search {
            drive,
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
            looked: 0,
        };
        let Some(corners) = corners(drive, from, to) else {
            return Vec::new();
        };
        let stretches = corners.windows(2).map(|pair| {
            // The same number of pieces in total, whatever the corners.
            let halvings = ((to - from) / (pair[1] - pair[0])).log2().floor();
            let coarsest = COARSEST.saturating_sub(halvings.clamp(0.0, 64.0) as u32);
            let whole = Piece {
                start: pair[0],
                end: pair[1],
                level: 0,
                index: 0,
            };
            let mut found = Vec::new();
            search.split(&whole, coarsest, &mut found);
            found
        });
        let stretches: Vec<_> = stretches.collect();
        let merged = stretches.into_iter().flat_map(|found| search.merge(found));
        let mut ends = vec![from];
        ends.extend(merged.map(|piece| piece.end));
        ends
    }

    fn value(&mut self, time: f64) -> DriveValue {
        self.looked += 1;
        let found = self.drive.at(time);
        if found.value.is_finite() {
            self.least = self.least.min(found.value);
            self.most = self.most.max(found.value);
        }
        found
    }

    /// Halves a piece until (D-121) holds, at least `coarsest` times.
    fn split(&mut self, piece: &Piece, coarsest: u32, out: &mut Vec<Piece>) {
        let is_coarse = piece.level < coarsest;
        let goes_on = piece.level < FINEST && self.looked < MOST;
        if !is_coarse && (self.is_cubic(piece) || !goes_on) {
            out.push(*piece);
            return;
        }
        for half in piece.halves() {
            self.split(&half, coarsest, out);
        }
    }

    /// Joins halves on which (D-121) holds together, now that the range is known.
    fn merge(&mut self, pieces: Vec<Piece>) -> Vec<Piece> {
        let mut merged: Vec<Piece> = Vec::new();
        for piece in pieces {
            merged.push(piece);
            while let [.., first, second] = merged[..] {
                let are_halves = first.level == second.level
                    && first.index % 2 == 0
                    && second.index == first.index + 1;
                let both = Piece {
                    end: second.end,
                    level: first.level.saturating_sub(1),
                    index: first.index / 2,
                    ..first
                };
                if !are_halves || !self.is_cubic(&both) {
                    break;
                }
                merged.truncate(merged.len() - 2);
                merged.push(both);
            }
        }
        merged
    }

    /// Whether (D-121) holds; true where there are no values.
    fn is_cubic(&mut self, piece: &Piece) -> bool {
        let length = piece.end - piece.start;
        // At a corner the value is the one after it.
        let ends = [piece.start, piece.end.next_down()].map(|time| self.value(time));
        let [a, b] = ends;
        let inner = [0.25, 0.5, 0.75].map(|s| (s, self.value(piece.start + s * length).value));
        let largest = self.most.abs().max(self.least.abs());
        let allowed = OFF * (self.most - self.least).max(ROUND_OFF * largest);
        inner.into_iter().all(|(s, value)| {
            let back = 1.0 - s;
            let values =
                back * back * (1.0 + 2.0 * s) * a.value + s * s * (3.0 - 2.0 * s) * b.value;
            let rates = s * back * length * (back * a.rate - s * b.rate);
            let off = (value - values - rates).abs();
            off <= allowed || off.is_nan()
        })
    }
}

impl Piece {
    fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.start + self.end);
        let (level, index) = (self.level + 1, 2 * self.index);
        let first = Self {
            end: middle,
            level,
            index,
            ..*self
        };
        let second = Self {
            start: middle,
            level,
            index: index + 1,
            ..*self
        };
        [first, second]
    }
}

/// The corners of a drive in a run, with its ends; `None` if there are too many.
fn corners(drive: &Drive, from: f64, to: f64) -> Option<Vec<f64>> {
    let mut times = vec![from];
    let mut time = from;
    while times.len() < MOST_CORNERS {
        time = drive.next_corner(time);
        if time.is_nan() || time >= to {
            times.push(to);
            return Some(times);
        }
        times.push(time);
    }
    None
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::{Rng, SeedableRng};
    use shared_geom::expression::{Expression, Names};

    use super::*;
    use crate::effort::cases;
    use crate::model::drive::Formula;

    fn uniform(random: &mut Pcg64Mcg, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn formula(text: &str) -> Drive {
        let names = Names {
            variables: &["t"],
            constants: &[],
        };
        let expression = Expression::parse(text, &names).unwrap();
        Drive::Formula(Arc::new(Formula::new(expression, 1.0)))
    }

    /// Integral by steps of the pace, with Gauss' two points, which are exact for cubics.
    fn integral(drive: &Drive, to: f64) -> (f64, usize) {
        let pace = Pace::new([drive].into_iter(), [0.0, to]);
        let (mut time, mut sum, mut steps) = (0.0, 0.0, 0);
        while time < to {
            let length = pace.longest_step(time).min(to - time).min(0.02 * to);
            let at = |part: f64| drive.at(time + part * length).value;
            let off = 0.5 / 3.0_f64.sqrt();
            sum += 0.5 * length * (at(0.5 - off) + at(0.5 + off));
            (time, steps) = (time + length, steps + 1);
        }
        (sum, steps)
    }

    // Unit pulses of 1e-2 to 1e-6 of the run, at any time. The error of a piece from its
    // cubic is 0.02 of the peak, which is 0.56 over the width, and so is the error of the
    // points: twice this over the 2.5 relevant widths is 0.06. The pulse needs 100 steps.
    #[test]
    fn short_pulses_are_not_stepped_over() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        for _ in 0..cases(30) {
            let width = 10.0_f64.powf(uniform(&mut random, [-5.0, -1.0]));
            let at = uniform(&mut random, [1.0, 9.0]);
            let root = std::f64::consts::PI.sqrt();
            let pulse = format!("exp(-((t - {at})/{width})^2)/({width}*{root})");
            let (sum, steps) = integral(&formula(&pulse), 10.0);
            assert!((sum - 1.0).abs() < 0.06, "{pulse}: {sum}");
            assert!(steps < 150, "{pulse}: {steps}");
        }
    }
}
