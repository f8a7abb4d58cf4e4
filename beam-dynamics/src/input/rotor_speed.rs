//! Rotor speeds: their usual unit, and speeds that are the same.

use std::f64::consts::PI;

use super::short_number;

/// Radians per second in one revolution per minute.
pub(super) const RPM: f64 = PI / 30.0;

/// A speed \[rad/s\] as text in rpm.
pub(super) fn rpm(speed: f64) -> String {
    format!("{} rpm", short_number(speed / RPM, 6))
}

/// Speeds closer than this part of the larger are the same speed.
pub(super) const SAME_SPEED: f64 = 1e-9;

/// The speed nearest to `wanted`, and whether it is the same one; `None` without speeds.
pub(super) fn analyzed(speeds: &[f64], wanted: f64) -> Option<(bool, f64)> {
    let distance = |speed: f64| (speed - wanted).abs();
    let nearest = speeds
        .iter()
        .copied()
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))?;
    Some((distance(nearest) <= SAME_SPEED * nearest.abs(), nearest))
}
