//! Common parts of the figures of a section: margins, title, cells, color bar.

use shared_geom::figure::{Color, Drawing, Label, TEXT, text_width};

use super::plane::INK;

/// Maximum height of a frame if only a legend is below it [figure pixels].
pub(super) const HIGHEST: f64 = 1250.0;
/// Margin left of the frame, for ticks and the name of the axis [figure pixels].
pub(super) const LEFT: f64 = 190.0;
/// Margin right of the frame [figure pixels].
pub(super) const RIGHT: f64 = 50.0;
/// Margin above the frame, for the title and a line below it [figure pixels].
pub(super) const TOP: f64 = 150.0;
/// Space between frame and legend, for ticks and the name of the axis [figure pixels].
pub(super) const BELOW: f64 = 135.0;

/// Width to which walls too thin to be seen are widened [figure pixels].
pub(super) const THINNEST: f64 = 5.0;

/// Width below which marks on a wall have no white rim, which would hide the wall
/// [figure pixels].
pub(super) const SPARED: f64 = 30.0;

/// Size of a title that is alone above a frame.
pub(super) const TITLE: f64 = 1.15 * TEXT;
/// Largest ratio of the width of bold letters to others.
const BOLD: f64 = 1.2;
/// Pieces of a color bar, each of one color.
const STEPS: u32 = 256;

/// The name of the section, cut if it is longer than the width `space`, and `what` is shown;
/// letters of `size` at the position `position` [figure pixels].
pub(super) fn draw_title(
    drawing: &mut Drawing,
    [name, what]: [&str; 2],
    size: f64,
    position: [f64; 2],
    space: f64,
) {
    let label = Label::new(size).bold();
    let left = space - text_width(what, Label::new(BOLD * size));
    drawing.text(
        &(drawing.shortened(name, label, left) + what),
        position,
        label,
    );
}

/// Fills a cell, or a piece of one, and if `is_thin` its rim too, so that it can be seen.
pub(super) fn fill_cell(drawing: &mut Drawing, corners: &[[f64; 2]], color: Color, is_thin: bool) {
    drawing.polygon(corners, color);
    if is_thin {
        drawing.outline(corners, THINNEST, color);
    }
}

/// A box with a line around it and `color(part)` in it, where `part` runs from 0 on the
/// left to 1 on the right; `low` and `high` are its corners [figure pixels].
pub(super) fn draw_color_bar(
    drawing: &mut Drawing,
    low: [f64; 2],
    high: [f64; 2],
    color: impl Fn(f64) -> Color,
) {
    let boxed = |left: f64, right: f64| {
        let corners = [[left, low[1]], [right, low[1]]];
        [corners[0], corners[1], [right, high[1]], [left, high[1]]]
    };
    let at = |step: f64| low[0] + (high[0] - low[0]) * step / f64::from(STEPS);
    for step in (0..STEPS).map(f64::from) {
        let middle = (step + 0.5) / f64::from(STEPS);
        drawing.polygon(&boxed(at(step), at(step + 1.0)), color(middle));
    }
    let [a, b, c, d] = boxed(low[0], high[0]);
    drawing.line(&[a, b, c, d, a], 2.0, INK);
}
