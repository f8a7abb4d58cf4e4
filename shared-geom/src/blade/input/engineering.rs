//! Engineering properties of a station: keys of a table, or columns of a file.

use nalgebra::Vector2;

use crate::section::{Centers, Engineering};
use crate::units::Dimension;

/// EA, shear and bending stiffnesses, with their keys.
pub(super) const STIFFNESS: [(&str, Dimension); 6] = [
    ("ea", Dimension::FORCE),
    ("gay", Dimension::FORCE),
    ("gaz", Dimension::FORCE),
    ("gj", Dimension::BENDING_STIFFNESS),
    ("eiy", Dimension::BENDING_STIFFNESS),
    ("eiz", Dimension::BENDING_STIFFNESS),
];
/// Mass per length and moments of inertia per length.
pub(super) const MASS: [(&str, Dimension); 3] = [
    ("m", Dimension::MASS_PER_LENGTH),
    ("iy", Dimension::INERTIA_PER_LENGTH),
    ("iz", Dimension::INERTIA_PER_LENGTH),
];
/// Centers, and the keys of their coordinates in tables of files.
pub(super) const CENTERS: [(&str, [&str; 2]); 3] = [
    ("tension_center", ["tension_center_y", "tension_center_z"]),
    ("shear_center", ["shear_center_y", "shear_center_z"]),
    ("mass_center", ["mass_center_y", "mass_center_z"]),
];
/// Angles of the principal axes.
pub(super) const ANGLES: [&str; 2] = ["stiffness_angle", "inertia_angle"];

/// Source of numbers by their key.
pub(super) trait Numbers {
    /// A required number, in SI units.
    fn number(&self, key: &'static str, dimension: Dimension) -> Option<f64>;
    /// A point (y, z); zero without it.
    fn point(&self, center: (&'static str, [&'static str; 2])) -> Option<Vector2<f64>>;
    /// An angle; zero without it.
    fn angle(&self, key: &'static str) -> Option<f64>;
}

/// Selection of the properties that are read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts {
    pub stiffness: bool,
    pub mass: bool,
}

/// The engineering properties of `numbers`; the others are zero.
pub(super) fn read(numbers: &impl Numbers, parts: Parts) -> Option<Engineering> {
    // Every key is read, so that all problems are reported.
    let of = |requested: bool, (key, dimension)| {
        if requested {
            numbers.number(key, dimension)
        } else {
            Some(0.0)
        }
    };
    let stiffness = STIFFNESS.map(|key| of(parts.stiffness, key));
    let mass = MASS.map(|key| of(parts.mass, key));
    let requested = [parts.stiffness, parts.stiffness, parts.mass];
    let center = |i: usize| {
        if requested[i] {
            numbers.point(CENTERS[i])
        } else {
            Some(Vector2::zeros())
        }
    };
    let centers = [center(0), center(1), center(2)];
    let angle = |i: usize| {
        if [parts.stiffness, parts.mass][i] {
            numbers.angle(ANGLES[i])
        } else {
            Some(0.0)
        }
    };
    let angles = [angle(0), angle(1)];
    let [ea, gay, gaz, gj, eiy, eiz] = stiffness;
    let [m, iy, iz] = mass;
    let [tension, shear, mass_center] = centers;
    Some(Engineering {
        stiffness: [ea?, gay?, gaz?, gj?, eiy?, eiz?],
        mass: [m?, iy?, iz?],
        centers: Centers {
            tension: tension?,
            shear: shear?,
            mass: mass_center?,
        },
        stiffness_angle: angles[0]?,
        inertia_angle: angles[1]?,
    })
}
