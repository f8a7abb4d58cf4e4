//! Damping ratios over rotor speed, below the frequencies.

use plotters::backend::DrawingBackend;
use shared_geom::figure::{Anchor, Canvas, FigureProblem, Label, TEXT};

use super::axes::Axes;
use super::{FanPlot, curves};
use crate::output::panel::{Panel, range};

/// Distance to the frequencies above, and to the lower edge \[figure pixels\].
const GAPS: [f64; 2] = [96.0, 130.0];

/// Draws the damping of each mode in its color and pattern.
pub(super) fn draw<B: DrawingBackend>(
    canvas: &Canvas<B>,
    plot: &FanPlot,
    axes: &Axes,
) -> Result<(), FigureProblem> {
    let ratios = plot.curves.iter().flat_map(|curve| &curve.damping);
    let panel = Panel {
        left: axes.left,
        right: axes.right,
        top: axes.bottom + GAPS[0],
        bottom: canvas.size().1 - GAPS[1],
        x: axes.speeds,
        y: range(ratios.flatten().copied().chain([0.0]), 0.0),
    };
    panel.draw_zero(canvas)?;
    for curve in &plot.curves {
        let position = |point| panel.position(point);
        for run in curves::runs(&plot.speeds, &curve.damping, position) {
            curves::line(canvas, &run, curve.pattern, curve.color)?;
        }
    }
    panel.draw_frame(canvas, [8, 5], true)?;
    let title = Label::new(TEXT).anchored(Anchor::Middle);
    let middle = [
        0.5 * (panel.left + panel.right),
        0.5 * (panel.top + panel.bottom),
    ];
    canvas.text("rotor speed [rpm]", [middle[0], panel.bottom + 92.0], title)?;
    canvas.text("damping ratio [%]", [34.0, middle[1]], title.upward())
}
