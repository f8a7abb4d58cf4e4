//! Common parts of the figures of a section: margins, title, cells, color bar.

use shared_geom::figure::{
    Anchor, Color, Drawing, INK, Label, SMALL, TEXT, TITLE, Ticks, text_width,
};

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

/// Pieces of a color bar, each of one color.
const STEPS: u32 = 256;
/// Distance of ticks of a color bar, and their length [figure pixels].
const APART: f64 = 170.0;
const TICK: f64 = 10.0;

/// The name of the section, cut if it is longer than the width `space`, and `what` is shown, at
/// `position` [figure pixels].
pub(super) fn draw_title(
    drawing: &mut Drawing,
    [name, what]: [&str; 2],
    position: [f64; 2],
    space: f64,
) {
    let label = Label::new(TEXT).bold();
    let left = space - text_width(what, label);
    let title = drawing.shortened(name, label, left) + what;
    drawing.text(&title, position, label);
}

/// Fills a cell, or a piece of one, and if `is_thin` its rim too, so that it can be seen.
pub(super) fn fill_cell(drawing: &mut Drawing, corners: &[[f64; 2]], color: Color, is_thin: bool) {
    drawing.polygon(corners, color);
    if is_thin {
        drawing.outline(corners, THINNEST, color);
    }
}

/// The scale of the colors `color(value)` of values between `ends`: a bar between the corners
/// `low` and `high` [figure pixels] with ticks below it, and its name below these.
pub(super) fn draw_color_bar(
    drawing: &mut Drawing,
    [low, high]: [[f64; 2]; 2],
    (ends, name): ([f64; 2], &str),
    color: impl Fn(f64) -> Color,
) {
    let value = |part: f64| ends[0] + (ends[1] - ends[0]) * part;
    let at = |part: f64| low[0] + (high[0] - low[0]) * part;
    let steps = f64::from(STEPS);
    for step in (0..STEPS).map(f64::from) {
        let [left, right] = [step, step + 1.0].map(|step| at(step / steps));
        let corners = boxed([left, low[1]], [right, high[1]]);
        drawing.polygon(&corners, color(value((step + 0.5) / steps)));
    }
    drawing.outline(&boxed(low, high), 2.0, INK);
    let label = Label::new(SMALL).colored(INK).anchored(Anchor::Middle);
    let count = ((high[0] - low[0]) / APART).max(2.0) as usize;
    for (tick, text) in Ticks::between(ends[0], ends[1], count).labeled() {
        let x = at((tick - ends[0]) / (ends[1] - ends[0]));
        drawing.line(&[[x, high[1]], [x, high[1] + TICK]], 2.0, INK);
        drawing.text(&text, [x, high[1] + TICK + 0.7 * TEXT], label);
    }
    let label = Label {
        size: TEXT,
        ..label
    };
    drawing.text(name, [at(0.5), high[1] + TITLE], label);
}

/// The corners of a box between two of them.
pub(super) fn boxed(low: [f64; 2], high: [f64; 2]) -> [[f64; 2]; 4] {
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}
