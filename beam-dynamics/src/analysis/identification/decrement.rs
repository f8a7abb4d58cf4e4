//! Logarithmic decrement, from the distances of extremes.
//!
//! The extremes of `y0 + a exp(sigma t) cos(omega t + phi)` alternate at the distance pi/omega, and their
//! differences are free of y0:
//!
//! ```text
//! ln |y_{k+1} - y_k| = sigma t_k + ...        omega = pi (K - 1) / (t_K - t_1)
//! ```

use std::f64::consts::PI;

use super::record::Record;
use super::{line, of_logarithm};
use crate::result::{IdentificationMethod, IdentifiedMode};

/// Fewest extremes.
const LEAST: usize = 5;
/// Largest relative difference of the frequency of the extremes from the one of the largest mode: beyond it
/// the extremes belong to several motions \[-\].
const OTHER: f64 = 0.05;
/// Largest scatter of the logarithms about their line: beyond it several oscillations take turns \[-\].
const ALONE: f64 = 0.2;

/// The mode of the extremes; `None` if they do not belong to one oscillation of about the frequency
/// given \[rad/s\].
pub(super) fn mode(record: &Record, frequency: f64) -> Option<IdentifiedMode> {
    let extremes = extremes(record);
    let count = extremes.len();
    if count < LEAST {
        return None;
    }
    let found = PI * (count - 1) as f64 / (extremes[count - 1][0] - extremes[0][0]);
    if (found / frequency - 1.0).abs() > OTHER {
        return None;
    }
    let changes = extremes.windows(2);
    let changes: Vec<_> = changes
        .map(|pair| {
            [
                0.5 * (pair[0][0] + pair[1][0]),
                (pair[1][1] - pair[0][1]).abs().ln(),
            ]
        })
        .collect();
    of_logarithm(
        IdentificationMethod::Decrement,
        found,
        line::through(&changes).filter(|line| line.scatter < ALONE)?,
    )
}

/// Times and values of the extremes, by parabolas through three samples.
fn extremes(record: &Record) -> Vec<[f64; 2]> {
    let triples = record.values.windows(3).enumerate();
    let turns = triples.filter(|(_, y)| (y[1] - y[0]) * (y[2] - y[1]) < 0.0);
    let vertex = |(k, y): (usize, &[f64])| {
        let (slope, bend) = (0.5 * (y[2] - y[0]), y[0] - 2.0 * y[1] + y[2]);
        let at = -slope / bend;
        [record.step * ((k + 1) as f64 + at), y[1] + 0.5 * slope * at]
    };
    turns.map(vertex).collect()
}
