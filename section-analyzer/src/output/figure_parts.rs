//! What the figures of a section have in common: margins, title, cells, color bar.

use plotters::backend::DrawingBackend;
use plotters::style::RGBColor;
use shared_geom::figure::{Canvas, Drawing, FigureProblem, Label, TEXT};

use super::plane::INK;

/// Height of a frame at most, where nothing but a legend stands below it [figure pixels].
pub(super) const HIGHEST: f64 = 1250.0;
/// Room left of the frame, for ticks and the name of the axis [figure pixels].
pub(super) const LEFT: f64 = 190.0;
/// Room right of the frame [figure pixels].
pub(super) const RIGHT: f64 = 50.0;
/// Room above the frame, for the title and a line below it [figure pixels].
pub(super) const TOP: f64 = 150.0;
/// Room between frame and legend, for ticks and the name of the axis [figure pixels].
pub(super) const BELOW: f64 = 135.0;

/// Walls thinner than this cannot be seen: they are drawn as wide [figure pixels].
pub(super) const THINNEST: f64 = 5.0;

/// Walls thinner than this have no white around what stands on them, which would erase
/// them [figure pixels].
pub(super) const SPARED: f64 = 30.0;

/// Size of a title that stands alone above a frame.
pub(super) const TITLE: f64 = 1.15 * TEXT;
/// Letters are at most this much wider when they are bold.
const BOLD: f64 = 1.2;
/// Pieces of a color bar, each of one color.
const STEPS: u32 = 256;

/// A drawing that knows how large it is.
pub trait Figure: Drawing {
    /// Width and height \[figure pixels\].
    fn size(&self) -> (u32, u32);
}

/// The name of the section, cut where it is too long for `room`, and `what` is shown of
/// it; letters of `size` at `place` [figure pixels].
pub(super) fn draw_title<B: DrawingBackend>(
    canvas: &Canvas<B>,
    [name, what]: [&str; 2],
    size: f64,
    place: [f64; 2],
    room: f64,
) -> Result<(), FigureProblem> {
    let label = Label::new(size).bold();
    let left = room - canvas.text_width(what, BOLD * size);
    canvas.text(&(canvas.shortened(name, label, left) + what), place, label)
}

/// Fills a cell, or a piece of one, and where `is_thin` its rim too, so that it can be
/// seen.
pub(super) fn fill_cell<B: DrawingBackend>(
    canvas: &Canvas<B>,
    mut corners: Vec<[f64; 2]>,
    color: RGBColor,
    is_thin: bool,
) -> Result<(), FigureProblem> {
    canvas.polygon(&corners, color)?;
    if is_thin {
        corners.push(corners[0]);
        canvas.line(&corners, THINNEST, color)?;
    }
    Ok(())
}

/// A box with a line around it and `color(part)` in it, where `part` runs from 0 on the
/// left to 1 on the right; `low` and `high` are its corners [figure pixels].
pub(super) fn draw_color_bar<B: DrawingBackend>(
    canvas: &Canvas<B>,
    low: [f64; 2],
    high: [f64; 2],
    color: impl Fn(f64) -> RGBColor,
) -> Result<(), FigureProblem> {
    let boxed = |left: f64, right: f64| {
        let corners = [[left, low[1]], [right, low[1]]];
        [corners[0], corners[1], [right, high[1]], [left, high[1]]]
    };
    let at = |step: f64| low[0] + (high[0] - low[0]) * step / f64::from(STEPS);
    for step in (0..STEPS).map(f64::from) {
        let middle = (step + 0.5) / f64::from(STEPS);
        canvas.polygon(&boxed(at(step), at(step + 1.0)), color(middle))?;
    }
    let [a, b, c, d] = boxed(low[0], high[0]);
    canvas.line(&[a, b, c, d, a], 2.0, INK)
}
