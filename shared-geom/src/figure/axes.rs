//! The axes of all plots: frame, ticks, titles, grid, and positions of points.

use super::TEXT;
use super::color::Color;
use super::drawing::{Drawing, text_width};
use super::shape::{Anchor, Label};
use super::stroke::Stroke;
use super::tick::Ticks;

/// Size of the letters of ticks and legends \[figure pixels\].
pub const SMALL: f64 = 0.8 * TEXT;
/// Color of frames, ticks and titles.
pub const INK: Color = Color(40, 40, 40);
/// Color of lines in the background.
pub const GRAY: Color = Color(165, 165, 165);
/// Color of grids and of the lines at zero.
pub const LIGHT: Color = Color(220, 220, 220);
/// Length of a tick, and width of the lines of the frame \[figure pixels\].
const TICK: f64 = 10.0;
const FRAME: f64 = 2.5;
/// Distance of ticks that have labels: across and up \[figure pixels\].
const APART: [f64; 2] = [150.0, 90.0];
/// Distance from the lower edge to the middle of the title below it \[figure pixels\].
pub const TITLE: f64 = TICK + 2.1 * TEXT;
/// Least distance from the left edge to the middle of the title beside it, so that the titles
/// of panels below each other are aligned \[figure pixels\].
const BESIDE: f64 = 120.0;
/// Margin above and below the curves, as part of their range.
const MARGIN: f64 = 0.06;

/// A frame \[figure pixels\] and the values at its edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// Left edge \[figure pixels, unit of the drawing\].
    pub left: f64,
    /// Right edge \[figure pixels, unit of the drawing\].
    pub right: f64,
    /// Upper edge \[figure pixels, unit of the drawing\].
    pub top: f64,
    /// Lower edge \[figure pixels, unit of the drawing\].
    pub bottom: f64,
    /// Values at the left and the right edge \[unit of the axis\].
    pub x: [f64; 2],
    /// Values at the lower and the upper edge \[unit of the axis\].
    pub y: [f64; 2],
}

impl Axes {
    /// Position of a point.
    pub fn position(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let part = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        [
            self.left + part(x, self.x) * (self.right - self.left),
            self.bottom - part(y, self.y) * (self.bottom - self.top),
        ]
    }

    /// The same frame with its corner moved.
    pub fn moved(&self, [x, y]: [f64; 2]) -> Self {
        Self {
            left: self.left + x,
            right: self.right + x,
            top: self.top + y,
            bottom: self.bottom + y,
            ..*self
        }
    }

    /// Draws the line through these points.
    pub fn curve(&self, drawing: &mut Drawing, points: &[[f64; 2]], stroke: Stroke) {
        let positions: Vec<_> = points.iter().map(|point| self.position(*point)).collect();
        stroke.draw(drawing, &positions);
    }

    /// Draws the background of the curves: thin lines at all ticks, and wider ones at zero across
    /// and up, if zero is within the frame.
    pub fn draw_grid(&self, drawing: &mut Drawing) {
        let Self {
            left,
            right,
            top,
            bottom,
            ..
        } = *self;
        let [across, up] = self.ticks();
        for value in across.positions() {
            let [x, _] = self.position([value, self.y[0]]);
            drawing.line(&[[x, top], [x, bottom]], 1.0, LIGHT);
        }
        for value in up.positions() {
            let [_, y] = self.position([self.x[0], value]);
            drawing.line(&[[left, y], [right, y]], 1.0, LIGHT);
        }
        let is_within = |[low, high]: [f64; 2]| low < 0.0 && high > 0.0;
        let [x, y] = self.position([0.0, 0.0]);
        let across = [[left, y], [right, y]];
        let upward = [[x, top], [x, bottom]];
        for (line, range) in [(across, self.y), (upward, self.x)] {
            if is_within(range) {
                drawing.line(&line, FRAME, LIGHT);
            }
        }
    }

    /// Draws the frame, after the curves, with ticks and titles at the left and the lower edge; without labels and title below
    /// the lower edge if `across` is `None`, and without a title if it is empty.
    pub fn draw(&self, drawing: &mut Drawing, across: Option<&str>, up: &str) {
        let Self {
            left,
            right,
            top,
            bottom,
            ..
        } = *self;
        let corners = [[left, top], [left, bottom], [right, bottom], [right, top]];
        drawing.outline(&corners, FRAME, INK);
        let label = Label::new(SMALL).colored(INK);
        let [ticks_across, ticks_up] = self.ticks();
        for (value, text) in ticks_across.labeled() {
            let [x, y] = self.position([value, self.y[0]]);
            drawing.line(&[[x, y], [x, y + TICK]], FRAME, INK);
            if across.is_some() {
                let below = [x, y + TICK + 0.7 * TEXT];
                drawing.text(&text, below, label.anchored(Anchor::Middle));
            }
        }
        let mut widest = 0.0_f64;
        for (value, text) in ticks_up.labeled() {
            let [x, y] = self.position([self.x[0], value]);
            drawing.line(&[[x, y], [x - TICK, y]], FRAME, INK);
            drawing.text(&text, [x - 1.7 * TICK, y], label.anchored(Anchor::End));
            widest = widest.max(text_width(&text, label));
        }
        let [x, y] = [0.5 * (left + right), 0.5 * (top + bottom)];
        let title = Label::new(TEXT).colored(INK).anchored(Anchor::Middle);
        if let Some(text) = across.filter(|text| !text.is_empty()) {
            drawing.text(
                text,
                [x, bottom + TITLE],
                fitting(title, text, right - left),
            );
        }
        if !up.is_empty() {
            let beside = BESIDE.max(2.6 * TICK + widest + 0.6 * TEXT);
            let label = fitting(title.upward(), up, bottom - top);
            drawing.text(up, [left - beside, y], label);
        }
    }

    /// Writes a note in the upper right corner of the frame.
    pub fn note(&self, drawing: &mut Drawing, text: &str) {
        let label = Label::new(SMALL).colored(INK).anchored(Anchor::End);
        drawing.text(text, [self.right - TICK, self.top + 0.7 * TEXT], label);
    }

    /// Ticks as close as their labels allow, across and up.
    fn ticks(&self) -> [Ticks; 2] {
        let lengths = [self.right - self.left, self.bottom - self.top];
        [(self.x, 0), (self.y, 1)].map(|([low, high], axis)| {
            let count = (lengths[axis] / APART[axis]).round().clamp(2.0, 10.0);
            Ticks::between(low, high, count as usize)
        })
    }
}

/// The format of a title that is not much longer than its axis: smaller letters if necessary.
pub fn fitting(label: Label, text: &str, length: f64) -> Label {
    let part = (length + 2.0 * TEXT) / text_width(text, label);
    Label {
        size: label.size * part.min(1.0),
        ..label
    }
}

/// The range of `values` with margins at both ends; if all are of a size up to `floor`, zero with
/// one at both sides \[unit of the values\].
pub fn range(values: impl IntoIterator<Item = f64>, floor: f64) -> [f64; 2] {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values.into_iter().filter(|value| value.is_finite()) {
        low = low.min(value);
        high = high.max(value);
    }
    if low > high || low.abs().max(high.abs()) <= floor {
        let about_zero = floor.max(1.0);
        return [-about_zero, about_zero];
    }
    // A nearly constant curve is not drawn rough.
    let least = 0.02 * low.abs().max(high.abs());
    if high - low < least {
        let middle = 0.5 * (low + high);
        (low, high) = (middle - least, middle + least);
    }
    let margin = MARGIN * (high - low);
    [low - margin, high + margin]
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXES: Axes = Axes {
        left: 100.0,
        right: 300.0,
        top: 50.0,
        bottom: 150.0,
        x: [0.0, 2.0],
        y: [-1.0, 1.0],
    };

    #[test]
    fn points_have_their_positions() {
        assert_eq!(AXES.position([0.5, 0.5]), [150.0, 75.0]);
    }

    #[test]
    fn ticks_and_titles_are_written() {
        let texts = |across: Option<&str>| {
            let mut drawing = Drawing::new((400, 300));
            AXES.draw(&mut drawing, across, "force [N]");
            let texts: Vec<_> = drawing.texts().map(str::to_owned).collect();
            texts.join(" ")
        };
        let up = "-1 0 1";
        assert_eq!(texts(None), format!("{up} force [N]"));
        assert_eq!(texts(Some("")), format!("0 1 2 {up} force [N]"));
        assert_eq!(
            texts(Some("time [s]")),
            format!("0 1 2 {up} time [s] force [N]")
        );
    }

    #[test]
    fn long_titles_are_written_smaller() {
        let label = Label::new(TEXT);
        assert_eq!(fitting(label, "force [N]", 1000.0), label);
        let long = "a title longer than its axis";
        let shown = fitting(label, long, 100.0);
        assert!(shown.size < TEXT);
        assert!((text_width(long, shown) - 172.0).abs() < 2.0);
    }

    #[test]
    fn ranges_have_a_margin_and_round_off_is_flat() {
        assert_eq!(range([0.0, 100.0], 1.0), [-6.0, 106.0]);
        assert_eq!(range([1e-9, -2e-9], 1e-3), [-1.0, 1.0]);
        assert_eq!(range([0.0, 1e-9], 0.0)[1], 1.06e-9);
        assert_eq!(range([], 0.0), [-1.0, 1.0]);
        let [low, high] = range([5.0, 5.0], 1e-3);
        assert!(low < 4.9 && high > 5.1);
    }
}
