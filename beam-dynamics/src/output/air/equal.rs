//! Blades whose maps are equal: at each azimuth they have the same values, as in a motion that repeats
//! with every blade.

use std::f64::consts::{PI, TAU};

use super::disk::{MOST_TURN, Map, Point};

/// Difference of equal maps over the range of the values, below the steps of the colors \[-\].
const WITHIN: f64 = 0.01;

/// Whether all blades have the maps of the first one.
pub(super) fn are_equal(maps: &[Map]) -> bool {
    maps.iter().all(|map| {
        let within = WITHIN * (map.range[1] - map.range[0]);
        let Some((first, others)) = map.blades.split_first() else {
            return true;
        };
        // Rows of a turn begin and end at other azimuths.
        let is_as_long = |other: &Vec<Vec<Point>>| other.len().abs_diff(first.len()) <= 1;
        let is_equal = |other: &Vec<Vec<Point>>| {
            is_as_long(other) && other.iter().all(|row| has_values(first, row, within))
        };
        others.iter().all(is_equal)
    })
}

/// Whether a blade has the values of a row, in a pair of its rows at azimuths around it.
fn has_values(blade: &[Vec<Point>], row: &[Point], within: f64) -> bool {
    let Some([azimuth, ..]) = row.first() else {
        return true;
    };
    blade.windows(2).any(|pair| {
        let ends = pair[0].first().zip(pair[1].first());
        let Some(([from, ..], [to, ..])) = ends else {
            return false;
        };
        let (turn, part) = (turn(*to - *from), turn(*azimuth - *from));
        let share = part / turn;
        if turn.abs() > MOST_TURN || !(-1e-6..=1.0 + 1e-6).contains(&share) {
            return false;
        }
        let points = row.iter().zip(pair[0].iter().zip(&pair[1]));
        let mut differences = points.map(|(at, (a, b))| at[2] - a[2] - share * (b[2] - a[2]));
        row.len() == pair[0].len() && differences.all(|difference| difference.abs() <= within)
    })
}

/// An angle from minus to plus half a turn \[rad\].
pub(super) fn turn(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}
