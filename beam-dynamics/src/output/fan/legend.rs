//! Meaning of the marks, in a row above the plot.

use plotters::backend::DrawingBackend;
use plotters::style::RGBColor;
use shared_geom::figure::{Canvas, FigureProblem, Label};

use super::axes::Axes;
use super::{FanPlot, SIZE, SMALL, curves};
use crate::result::ModeKind;

const GRAY: RGBColor = RGBColor(90, 90, 90);
/// From the middle of a mark to its word, and from a word to the next mark.
const GAPS: [f64; 2] = [24.0, 44.0];
/// Distance of the two rows, and length of the samples of lines.
const ROW: f64 = 46.0;
const SAMPLE: f64 = 80.0;

/// Draws the marks of the kinds that the plot has, and the ring of measured points.
pub(super) fn draw<B: DrawingBackend>(
    canvas: &Canvas<B>,
    plot: &FanPlot,
    axes: &Axes,
) -> Result<(), FigureProblem> {
    let y = 0.078 * f64::from(SIZE.1);
    let mut x = axes.left + 12.0;
    let word = |x: &mut f64, text: &str| {
        let start = *x + GAPS[0];
        *x = start + canvas.text_width(text, SMALL) + GAPS[1];
        canvas.text(text, [start, y], Label::new(SMALL))
    };
    let others = [ModeKind::Lateral, ModeKind::Coupled, ModeKind::Rigid];
    for kind in ModeKind::PURE.into_iter().chain(others) {
        let mut kinds = plot.curves.iter().flat_map(|curve| &curve.kinds);
        if kinds.any(|found| *found == Some(kind)) {
            curves::mark(canvas, [x, y], kind, GRAY)?;
            word(&mut x, kind.word_in(plot.words))?;
        }
    }
    if !plot.measured.is_empty() {
        curves::ring(canvas, [x, y])?;
        word(&mut x, "measured")?;
    }
    x += GAPS[0];
    canvas.line(&[[x - 34.0, y], [x, y]], 2.0, RGBColor(175, 175, 175))?;
    word(&mut x, "nP: n per revolution")?;
    patterns(canvas, plot, axes, y + ROW)
}

/// Draws the meaning of the patterns of lines, and of the marks of critical speeds, in a row of
/// their own.
fn patterns<B: DrawingBackend>(
    canvas: &Canvas<B>,
    plot: &FanPlot,
    axes: &Axes,
    y: f64,
) -> Result<(), FigureProblem> {
    let mut x = axes.left;
    for (pattern, text) in &plot.patterns {
        curves::line(canvas, &[[x, y], [x + SAMPLE, y]], *pattern, GRAY)?;
        canvas.text(text, [x + SAMPLE + 14.0, y], Label::new(SMALL))?;
        x += SAMPLE + 14.0 + canvas.text_width(text, SMALL) + GAPS[1];
    }
    if plot.critical.is_empty() {
        return Ok(());
    }
    let size = curves::diamond_size(plot.critical.len());
    curves::diamond(canvas, [x + 17.0, y], size)?;
    canvas.text("critical speed", [x + 48.0, y], Label::new(SMALL))
}
