//! The five measures of one cell.
//!
//! ```text
//!        d ---- c          aspect     longest^2 / area            quadrilaterals
//!       /        \                    sqrt(3)/4 longest^2 / area  triangles
//!      /          \        angle      between the tangents of the sides at a corner;
//!     a --- m ---- b                  at a it is 4 m - 3 a - b for a side with a middle m
//!                          middle     |m - (a + b)/2| / |b - a|
//! ```

use shared_geom::mesh::CellKind;

use super::super::jacobian::Jacobian;
use super::super::plane::{distance, polygon_area};

/// The values of a cell with nodes at `positions`, counterclockwise, in the order of
/// [`super::ShapeMeasure::ALL`].
pub(super) fn values_of(jacobian: &Jacobian, kind: CellKind, positions: &[[f64; 2]]) -> [f64; 5] {
    let [least, largest] = jacobian.extremes(kind, positions);
    let corners = &positions[..kind.corner_count()];
    let longest = (0..corners.len())
        .map(|i| distance(corners[i], corners[(i + 1) % corners.len()]))
        .fold(0.0, f64::max);
    let [smallest_angle, largest_angle] = corner_angles(kind, positions);
    let ratio = if corners.len() == 3 {
        0.75_f64.sqrt() / 2.0
    } else {
        1.0
    };
    [
        least / largest,
        ratio * longest * longest / polygon_area(corners.iter().copied()).abs(),
        smallest_angle,
        largest_angle,
        middle_offset(kind, positions),
    ]
}

/// Smallest and largest angle at a corner \[rad\].
fn corner_angles(kind: CellKind, positions: &[[f64; 2]]) -> [f64; 2] {
    let count = kind.corner_count();
    let mut range = [f64::INFINITY, 0.0_f64];
    for corner in 0..count {
        let [along, back] = [corner, (corner + count - 1) % count].map(|side| {
            let (first, second, middle) = kind.side(side);
            let other = if first == corner { second } else { first };
            let (a, b) = (positions[corner], positions[other]);
            [0, 1].map(|i| match middle {
                Some(m) => 4.0 * positions[m][i] - 3.0 * a[i] - b[i],
                None => b[i] - a[i],
            })
        });
        let cross = along[0] * back[1] - along[1] * back[0];
        let dot = along[0] * back[0] + along[1] * back[1];
        let angle = cross.atan2(dot).abs();
        range = [range[0].min(angle), range[1].max(angle)];
    }
    range
}

/// Largest distance of a side's node from the middle of its chord, relative to the
/// chord; zero without such nodes.
fn middle_offset(kind: CellKind, positions: &[[f64; 2]]) -> f64 {
    let mut largest = 0.0_f64;
    for side in 0..kind.corner_count() {
        if let (a, b, Some(middle)) = kind.side(side) {
            let (a, b) = (positions[a], positions[b]);
            let mean = [0, 1].map(|i| 0.5 * (a[i] + b[i]));
            largest = largest.max(distance(positions[middle], mean) / distance(a, b));
        }
    }
    largest
}
