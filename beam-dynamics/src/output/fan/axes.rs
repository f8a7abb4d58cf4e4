//! The frame of the plot and its ranges.

use shared_geom::figure::{Axes, Label, SMALL, WIDTH, text_width};

use super::legend::legends;
use super::{FanPlot, LEGEND, SIZE};

/// Margin above the highest frequency, as part of it.
const HEADROOM: f64 = 0.04;
/// Part of the highest speed above which the lowest speed keeps the axis from beginning at zero.
const FAR_FROM_ZERO: f64 = 0.5;
/// Length of the lines that lead from the curves to their names, with gaps.
pub(super) const LEADER: f64 = 84.0;
/// Left and right margin, and the distances to the legend above and to the lower edge
/// \[figure pixels\].
const LEFT: f64 = 150.0;
const RIGHT: f64 = 24.0;
const ABOVE: f64 = 34.0;
const BELOW: f64 = 130.0;

/// Axes that contain all points, below the legend and with space for the names on the right:
/// speeds and frequencies in the units of the plot.
pub(super) fn axes(plot: &FanPlot) -> Axes {
    let name = Label::new(SMALL);
    let names = plot
        .curves
        .iter()
        .map(|curve| text_width(&curve.name, name));
    let widest = names.fold(0.0, f64::max);
    let measured = plot.measured.iter().map(|point| point[0]);
    let speeds = || plot.speeds.iter().copied().chain(measured.clone());
    let low = speeds().fold(f64::INFINITY, f64::min);
    let high = speeds().fold(0.0, f64::max);
    let computed = plot.curves.iter().flat_map(|curve| &curve.frequencies);
    let measured = plot.measured.iter().map(|point| point[1]);
    let frequencies = computed.flatten().copied().chain(measured);
    let highest = frequencies.fold(0.0, f64::max) * (1.0 + HEADROOM);
    let legends = legends(plot).map(|legend| legend.height(f64::from(WIDTH) - LEFT));
    Axes {
        left: LEFT,
        right: f64::from(WIDTH) - widest - LEADER - RIGHT,
        top: LEGEND + legends[0] + legends[1] + ABOVE,
        bottom: f64::from(SIZE.1) - BELOW,
        x: [if low > FAR_FROM_ZERO * high { low } else { 0.0 }, high],
        y: [0.0, if highest > 0.0 { highest } else { 1.0 }],
    }
}
