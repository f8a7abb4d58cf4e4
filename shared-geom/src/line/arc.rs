//! Arcs: pieces of a line with constant curvature and twist rate in section axes.
//!
//! From `dQ/ds = Q [k]x` and `dp/ds = Q e_1` with constant k,
//!
//! ```text
//! Q(s) = Q_0 exp(s [k]x)          p(s) = p_0 + s Q_0 Gamma(s k) e_1
//! ```
//!
//! with `Gamma` the tangent operator of the rotation vector: a helix in general.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use super::axes::twist_of;
use super::{LinePoint, ReferenceLine, about_x};
use crate::rotation::vector;

/// Position and section axes.
pub(super) type Frame = (Vector3<f64>, Matrix3<f64>);

/// The frame at `s` along an arc that begins at `from` [m].
pub(super) fn along(from: &Frame, curvature: &Vector3<f64>, s: f64) -> Frame {
    let turn = curvature * s;
    let chord = vector::tangent(&turn) * Vector3::x() * s;
    (from.0 + from.1 * chord, from.1 * vector::to_rotation(&turn))
}

/// The frames at the ends of all arcs, the root first.
pub(super) fn frames(line: &ReferenceLine) -> Vec<Frame> {
    let Some(root) = line.points.first() else {
        return Vec::new();
    };
    let mut frame = (root.position, about_x(root.twist));
    let mut frames = vec![frame];
    for (curvature, length) in line.curvature.iter().zip(&line.arc_length) {
        frame = along(&frame, curvature, *length);
        frames.push(frame);
    }
    frames
}

/// The twist of section axes: of the angles that differ by turns, the one nearest to
/// `expected` [rad].
pub(super) fn twist_near(axes: &Matrix3<f64>, expected: f64) -> f64 {
    let found = twist_of(axes);
    found + ((expected - found) / TAU).round() * TAU
}

/// The points at the ends of all arcs.
pub(super) fn ends(line: &ReferenceLine) -> Vec<LinePoint> {
    let frames = frames(line);
    let mut twist = line.points.first().map_or(0.0, |point| point.twist);
    let mut points = Vec::with_capacity(frames.len());
    for (i, (position, axes)) in frames.into_iter().enumerate() {
        if let Some(arc) = i.checked_sub(1) {
            let rate = line.curvature[arc].x;
            twist = twist_near(&axes, twist + rate * line.arc_length[arc]);
        }
        points.push(LinePoint { position, twist });
    }
    points
}
