//! Section axes and twist: the rule at the head of [`super`], and its inverse.

use nalgebra::{Matrix3, Vector3};

/// Section axes before twist; along z, where the rule is undefined, with y unchanged.
pub(super) fn level_axes(along: &Vector3<f64>) -> Matrix3<f64> {
    let tangent = along.try_normalize(0.0).unwrap_or(Vector3::x());
    let level = Vector3::z().cross(&tangent);
    let y = level.try_normalize(f64::EPSILON).unwrap_or(Vector3::y());
    Matrix3::from_columns(&[tangent, y, tangent.cross(&y)])
}

/// The twist of section axes [rad], within half a turn.
pub(super) fn twist_of(axes: &Matrix3<f64>) -> f64 {
    let level = level_axes(&axes.column(0).into_owned());
    let y = axes.column(1);
    y.dot(&level.column(2)).atan2(y.dot(&level.column(1)))
}
