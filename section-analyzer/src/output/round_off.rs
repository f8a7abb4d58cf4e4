//! Values of a report that are only round-off.

use nalgebra::Vector6;

use super::text::ZERO;
use crate::section::Section;

/// The values, with zero for components that are round-off compared with the largest
/// component or with `least`, whichever is larger; the last three times `length` are
/// comparable with the first three.
pub(super) fn without_round_off(values: &Vector6<f64>, length: f64, least: f64) -> Vector6<f64> {
    let weight = |i: usize| if i < 3 { 1.0 } else { length };
    let compared = Vector6::from_fn(|i, _| (values[i] * weight(i)).abs());
    let scale = compared.amax().max(least);
    values.zip_map(&compared, |value, compared| {
        if compared <= ZERO * scale { 0.0 } else { value }
    })
}

/// Largest coordinate of a node, the reference size for round-off of positions \[m\].
pub(super) fn size(section: &Section) -> f64 {
    let coordinates = section.mesh.nodes.iter().flatten();
    coordinates.fold(0.0, |size, x| x.abs().max(size))
}
