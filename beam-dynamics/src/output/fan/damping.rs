//! Damping ratios over rotor speed, below the frequencies.

use shared_geom::figure::{Axes, Drawing, range};

use super::{FanPlot, curves};

/// Distance to the frequencies above, and to the lower edge \[figure pixels\].
const GAPS: [f64; 2] = [66.0, 130.0];

/// Draws the damping of each mode in its color and pattern, below the axes of the frequencies.
pub(super) fn draw(drawing: &mut Drawing, plot: &FanPlot, above: &Axes) {
    let ratios = plot.curves.iter().flat_map(|curve| &curve.damping);
    let axes = Axes {
        top: above.bottom + GAPS[0],
        bottom: drawing.size().1 - GAPS[1],
        y: range(ratios.flatten().copied().chain([0.0]), 0.0),
        ..*above
    };
    axes.draw_grid(drawing);
    for curve in &plot.curves {
        for run in curves::runs(&plot.speeds, &curve.damping, |point| axes.position(point)) {
            curve.stroke(0).draw(drawing, &run);
        }
    }
    axes.draw(drawing, Some(&plot.speed_title()), "damping ratio [%]");
}
