//! Moments of inertia in cards.

use nalgebra::Vector3;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::Vector;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::InputProblem;

keys! {
    /// Moments of inertia about the center, `[jx, jy, jz]`, in the same axes.
    pub(super) INERTIA: Vector3<f64> = "inertia", [Vector(3, Dimension::INERTIA)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0.1, 0.2, 0.3]";
}

/// Relative amount by which one moment of inertia may exceed the sum of the others: digits
/// lost in the input.
const ROUNDING: f64 = 1e-6;

/// Moments of inertia about three axes under `inertia`; zeros when absent.
pub(super) fn moments(table: &Table<'_>, label: &str) -> Option<Vector3<f64>> {
    let moments = table.get(&INERTIA);
    moments.filter(|moments| {
        let possible = is_possible(moments);
        if !possible {
            let (body, found) = (label.to_owned(), (*moments).into());
            table.note(&INERTIA, &InputProblem::ImpossibleInertia { body, found });
        }
        possible
    })
}

/// Moments of inertia are sums of two of the three non-negative `int x^2 dm`: no moment is
/// negative, and none larger than the sum of the others.
fn is_possible(moments: &Vector3<f64>) -> bool {
    let sum = moments.sum();
    moments
        .iter()
        .all(|&moment| moment >= 0.0 && 2.0 * moment <= sum * (1.0 + ROUNDING))
}
