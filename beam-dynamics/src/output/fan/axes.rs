//! The two axes: from speeds and frequencies to positions on the drawing.

use shared_geom::figure::{Anchor, BLACK, Drawing, Label, TEXT, Ticks, text_width};

use super::{FanPlot, SIZE, SMALL};
use crate::case::FrequencyUnit;

/// Margin above the highest frequency, as part of it.
const HEADROOM: f64 = 0.04;
/// Part of the highest speed above which the lowest speed keeps the axis from beginning at zero.
const FAR_FROM_ZERO: f64 = 0.5;
/// Length of the lines that lead from the curves to their names, with gaps.
pub(super) const LEADER: f64 = 84.0;

/// The frame of the plot \[figure pixels\] and its ranges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    /// Lowest and highest speed \[rpm\].
    pub speeds: [f64; 2],
    /// Unit of frequencies.
    pub unit: FrequencyUnit,
    /// Highest frequency, in its unit; the lowest is zero.
    pub highest: f64,
}

impl Axes {
    /// Axes that contain all points, with space for the names on the right.
    pub fn new(drawing: &mut Drawing, plot: &FanPlot) -> Self {
        let (width, height) = (drawing.size().0, f64::from(SIZE.1));
        let names = plot
            .curves
            .iter()
            .map(|curve| text_width(&curve.name, Label::new(SMALL)));
        let widest = names.fold(0.0, f64::max);
        let measured_speeds = plot.measured.iter().map(|point| point[0]);
        let speeds = || plot.speeds.iter().copied().chain(measured_speeds.clone());
        let (low, high) = (
            speeds().fold(f64::INFINITY, f64::min),
            speeds().fold(0.0, f64::max),
        );
        let computed = plot
            .curves
            .iter()
            .flat_map(|curve| curve.frequencies.iter().flatten());
        let frequencies = computed
            .copied()
            .chain(plot.measured.iter().map(|point| point[1]));
        let highest = frequencies.fold(0.0, f64::max) * (1.0 + HEADROOM);
        Self {
            left: 150.0,
            right: width - widest - LEADER - 24.0,
            top: match plot.patterns.is_empty() {
                true => 0.125 * height,
                false => 0.165 * height,
            },
            bottom: height - 130.0,
            unit: plot.unit,
            speeds: [if low > FAR_FROM_ZERO * high { low } else { 0.0 }, high],
            highest: if highest > 0.0 { highest } else { 1.0 },
        }
    }

    /// Position of a speed \[rpm\] and a frequency in its unit.
    pub fn position(&self, [speed, frequency]: [f64; 2]) -> [f64; 2] {
        let [low, high] = self.speeds;
        let x = (speed - low) / (high - low);
        let y = frequency / self.highest;
        [
            self.left + x * (self.right - self.left),
            self.bottom - y * (self.bottom - self.top),
        ]
    }

    /// Draws axes, ticks and titles; the title of the speeds only if no damping is drawn below.
    pub fn draw(&self, drawing: &mut Drawing, plot: &FanPlot) {
        const TICK: f64 = 12.0;
        const AXIS: f64 = 3.0;
        let Self {
            left,
            right,
            top,
            bottom,
            ..
        } = *self;
        drawing.line(&[[left, top], [left, bottom], [right, bottom]], AXIS, BLACK);

        let label = Label::new(SMALL);
        for (speed, text) in Ticks::between(self.speeds[0], self.speeds[1], 8).labeled() {
            let [x, y] = self.position([speed, 0.0]);
            drawing.line(&[[x, y], [x, y + TICK]], AXIS, BLACK);
            drawing.text(&text, [x, y + 3.0 * TICK], label.anchored(Anchor::Middle));
        }
        for (frequency, text) in Ticks::between(0.0, self.highest, 8).labeled() {
            let [x, y] = self.position([self.speeds[0], frequency]);
            drawing.line(&[[x, y], [x - TICK, y]], AXIS, BLACK);
            drawing.text(&text, [x - 1.7 * TICK, y], label.anchored(Anchor::End));
        }

        let title = Label::new(TEXT).anchored(Anchor::Middle);
        let middle = [0.5 * (left + right), 0.5 * (top + bottom)];
        if !plot.is_damped() {
            drawing.text("rotor speed [rpm]", [middle[0], bottom + 92.0], title);
        }
        drawing.text(&plot.axis_title(), [34.0, middle[1]], title.upward());
    }
}
