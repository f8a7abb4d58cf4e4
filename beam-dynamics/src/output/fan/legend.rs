//! Meaning of the marks, in a row above the plot.

use shared_geom::figure::{Color, Drawing, Label, text_width};

use super::axes::Axes;
use super::{FanPlot, SIZE, SMALL, curves};
use crate::result::ModeKind;

const GRAY: Color = Color(90, 90, 90);
/// From the middle of a mark to its word, and from a word to the next mark.
const GAPS: [f64; 2] = [24.0, 44.0];
/// Distance of the two rows, and length of the samples of lines.
const ROW: f64 = 46.0;
const SAMPLE: f64 = 80.0;

/// Draws the marks of the kinds that the plot has, and the ring of measured points.
pub(super) fn draw(drawing: &mut Drawing, plot: &FanPlot, axes: &Axes) {
    let y = 0.078 * f64::from(SIZE.1);
    let mut x = axes.left + 12.0;
    let word = |drawing: &mut Drawing, x: &mut f64, text: &str| {
        let start = *x + GAPS[0];
        *x = start + text_width(text, Label::new(SMALL)) + GAPS[1];
        drawing.text(text, [start, y], Label::new(SMALL))
    };
    let others = [ModeKind::Lateral, ModeKind::Coupled];
    for kind in ModeKind::PURE.into_iter().chain(others) {
        let mut kinds = plot.curves.iter().flat_map(|curve| &curve.kinds);
        if kinds.any(|found| *found == Some(kind)) {
            curves::mark(drawing, [x, y], kind, GRAY);
            word(drawing, &mut x, kind.word_in(plot.words));
        }
    }
    if !plot.measured.is_empty() {
        curves::ring(drawing, [x, y]);
        word(drawing, &mut x, "measured");
    }
    x += GAPS[0];
    drawing.line(&[[x - 34.0, y], [x, y]], 2.0, Color(175, 175, 175));
    word(drawing, &mut x, "nP: n per revolution");
    patterns(drawing, plot, axes, y + ROW);
}

/// Draws the meaning of the patterns of lines, and of the marks of critical speeds, in a row of
/// their own.
fn patterns(drawing: &mut Drawing, plot: &FanPlot, axes: &Axes, y: f64) {
    let mut x = axes.left;
    for (pattern, text) in &plot.patterns {
        curves::line(drawing, &[[x, y], [x + SAMPLE, y]], *pattern, GRAY);
        drawing.text(text, [x + SAMPLE + 14.0, y], Label::new(SMALL));
        x += SAMPLE + 14.0 + text_width(text, Label::new(SMALL)) + GAPS[1];
    }
    if plot.critical.is_empty() {
        return;
    }
    let size = curves::diamond_size(plot.critical.len());
    curves::diamond(drawing, [x + 17.0, y], size);
    drawing.text("critical speed", [x + 48.0, y], Label::new(SMALL));
}
