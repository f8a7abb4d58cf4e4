//! Cells filled with a color each.

use std::collections::BTreeMap;

use plotters::backend::DrawingBackend;
use plotters::style::RGBColor;
use shared_geom::figure::{Canvas, FigureProblem};

use super::figure_parts::fill_cell;
use super::outline::{Side, cell_points, side_points};
use crate::section::Section;

/// Straight pieces of the border of a region.
type Border = Vec<[[f64; 2]; 2]>;

/// Fills the cells with the colors `color(cell)`, where `position` puts the nodes; cells of thin
/// walls with their rims, so that they can be seen.
///
/// On a bitmap cells of one color are one region, so that a fine mesh takes no longer than
/// its borders. Cells of thin walls hide each other's rims in their order, one by one.
pub(super) fn fill_cells<B: DrawingBackend>(
    canvas: &Canvas<B>,
    (section, sides): (&Section, &[Side]),
    position: &impl Fn(u32) -> [f64; 2],
    color: impl Fn(usize) -> RGBColor,
    is_thin: bool,
) -> Result<(), FigureProblem> {
    if is_thin || !canvas.is_bitmap() {
        let cells = section.mesh.cells.iter().enumerate();
        return cells.into_iter().try_for_each(|(k, cell)| {
            fill_cell(canvas, cell_points(cell, position), color(k), is_thin)
        });
    }
    for (RGBColorKey(r, g, b), border) in borders(sides, position, color) {
        canvas.region(&border, RGBColor(r, g, b));
    }
    Ok(())
}

/// A color with an order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct RGBColorKey(u8, u8, u8);

/// The border of the cells of each color, which lies on its left.
fn borders(
    sides: &[Side],
    position: &impl Fn(u32) -> [f64; 2],
    color: impl Fn(usize) -> RGBColor,
) -> BTreeMap<RGBColorKey, Border> {
    let key = |cell: usize| {
        let RGBColor(r, g, b) = color(cell);
        RGBColorKey(r, g, b)
    };
    let mut borders = BTreeMap::<RGBColorKey, Border>::new();
    for side in sides {
        let (left, right) = (key(side.cell), side.other.map(key));
        if right == Some(left) {
            continue;
        }
        let points = side_points(side.ends, side.middle, position);
        let pieces = || points.windows(2).map(|pair| [pair[0], pair[1]]);
        borders.entry(left).or_default().extend(pieces());
        if let Some(right) = right {
            let turned = pieces().map(|[a, b]| [b, a]);
            borders.entry(right).or_default().extend(turned);
        }
    }
    borders
}
