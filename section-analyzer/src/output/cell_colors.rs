//! Cells filled with a color each.

use std::collections::BTreeMap;

use shared_geom::figure::{Color, Drawing};

use super::figure_parts::fill_cell;
use super::outline::{Side, cell_points, side_points};
use crate::section::Section;

/// Cells of one color: their polygons, and the straight pieces of the border of all.
#[derive(Default)]
struct Region {
    polygons: Vec<Vec<[f64; 2]>>,
    border: Vec<[[f64; 2]; 2]>,
}

/// Fills the cells with the colors `color(cell)`, where `position` puts the nodes; cells of thin
/// walls with their rims, so that they can be seen.
///
/// Cells of one color are one region, so that a fine mesh takes no longer than its borders. Cells
/// of thin walls hide each other's rims in their order, one by one.
pub(super) fn fill_cells(
    drawing: &mut Drawing,
    (section, sides): (&Section, &[Side]),
    position: &impl Fn(u32) -> [f64; 2],
    color: impl Fn(usize) -> Color,
    is_thin: bool,
) {
    let mut regions = BTreeMap::<Color, Region>::new();
    for (k, cell) in section.mesh.cells.iter().enumerate() {
        let corners = cell_points(cell, position);
        if is_thin {
            fill_cell(drawing, &corners, color(k), true);
        } else {
            regions.entry(color(k)).or_default().polygons.push(corners);
        }
    }
    for side in sides {
        let (left, right) = (color(side.cell), side.other.map(&color));
        if right == Some(left) {
            continue;
        }
        // A region lies on the left of its border.
        let points = side_points(side.ends, side.middle, position);
        let pieces = || points.windows(2).map(|pair| [pair[0], pair[1]]);
        if let Some(region) = regions.get_mut(&left) {
            region.border.extend(pieces());
        }
        if let Some(region) = right.and_then(|right| regions.get_mut(&right)) {
            region.border.extend(pieces().map(|[a, b]| [b, a]));
        }
    }
    for (color, region) in regions {
        drawing.region(region.polygons, region.border, color);
    }
}
