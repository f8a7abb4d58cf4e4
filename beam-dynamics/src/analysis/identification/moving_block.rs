//! Moving block [HammondDoggett1975].
//!
//! The component of a motion `exp((sigma + i omega) t)` at a frequency, in a window w of some length
//! that begins at tau, varies with tau as the motion does:
//!
//! ```text
//! F(tau) = sum_k w_k y(tau + k dt) exp(-i omega0 k dt)        ln |F| = sigma tau + ...
//!                                                             arg F  = omega tau + ...
//! ```
//!
//! The window of Hann, of a whole number of periods, takes nothing from a constant, and little from
//! other frequencies.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::record::Record;
use super::{line, of_logarithm};
use crate::result::{IdentificationMethod, IdentifiedMode};

/// Fewest periods in the window.
const PERIODS: f64 = 2.0;

/// The mode near a frequency \[rad/s\]; `None` if the record is too short for it.
pub(super) fn mode(record: &Record, frequency: f64) -> Option<IdentifiedMode> {
    let period = TAU / (frequency * record.step);
    let count = record.values.len();
    // Half of the record, in whole periods.
    let periods = (0.5 * count as f64 / period).floor();
    if periods < PERIODS {
        return None;
    }
    let length = (periods * period).round() as usize;
    let weight = |k: usize| {
        let angle = TAU * k as f64 / length as f64;
        Complex::from_polar(
            0.5 * (1.0 - angle.cos()),
            -frequency * record.step * k as f64,
        )
    };
    let weights: Vec<_> = (0..length).map(weight).collect();
    let blocks: Vec<Complex<f64>> = record
        .values
        .windows(length)
        .map(|window| window.iter().zip(&weights).map(|(y, w)| w * y).sum())
        .collect();
    let (mut phase, mut last): (f64, Option<Complex<f64>>) = (0.0, None);
    let (mut sizes, mut phases) = (Vec::new(), Vec::new());
    for (k, block) in blocks.iter().enumerate() {
        if let Some(last) = last {
            phase += (block / last).arg();
        }
        last = Some(*block);
        let time = record.step * k as f64;
        sizes.push([time, block.norm().ln()]);
        phases.push([time, phase]);
    }
    let turn = line::through(&phases)?;
    of_logarithm(
        IdentificationMethod::MovingBlock,
        turn.slope,
        line::through(&sizes)?,
    )
}
