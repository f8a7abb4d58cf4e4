//! Damping ratios over rotor speed, below the frequencies.

use shared_geom::figure::{Anchor, Drawing, Label, TEXT};

use super::axes::Axes;
use super::{FanPlot, curves};
use crate::output::panel::{Panel, range};

/// Distance to the frequencies above, and to the lower edge \[figure pixels\].
const GAPS: [f64; 2] = [96.0, 130.0];

/// Draws the damping of each mode in its color and pattern.
pub(super) fn draw(drawing: &mut Drawing, plot: &FanPlot, axes: &Axes) {
    let ratios = plot.curves.iter().flat_map(|curve| &curve.damping);
    let panel = Panel {
        left: axes.left,
        right: axes.right,
        top: axes.bottom + GAPS[0],
        bottom: drawing.size().1 - GAPS[1],
        x: axes.speeds,
        y: range(ratios.flatten().copied().chain([0.0]), 0.0),
    };
    panel.draw_zero(drawing);
    for curve in &plot.curves {
        let position = |point| panel.position(point);
        for run in curves::runs(&plot.speeds, &curve.damping, position) {
            curves::line(drawing, &run, curve.pattern, curve.color);
        }
    }
    panel.draw_frame(drawing, [8, 5], true);
    let title = Label::new(TEXT).anchored(Anchor::Middle);
    let middle = [
        0.5 * (panel.left + panel.right),
        0.5 * (panel.top + panel.bottom),
    ];
    drawing.text("rotor speed [rpm]", [middle[0], panel.bottom + 92.0], title);
    drawing.text("damping ratio [%]", [34.0, middle[1]], title.upward());
}
