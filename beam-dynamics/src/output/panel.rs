//! A small plot within a figure: frame, ticks, zero line, and positions of points.

use shared_geom::figure::{Anchor, BLACK, Color, Drawing, Label, TEXT, Ticks, text_width};

/// Size of the letters of ticks.
pub(super) const SMALL: f64 = 0.8 * TEXT;
/// Color of the background of the curves.
pub(super) const GRAY: Color = Color(165, 165, 165);
/// Color of zero lines.
pub(super) const LIGHT: Color = Color(215, 215, 215);
const TICK: f64 = 10.0;
const FRAME: f64 = 2.5;
/// Margin above and below the curves, as part of their range.
const MARGIN: f64 = 0.06;

/// A frame \[figure pixels\] and its ranges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Panel {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    /// Values at the left and the right edge.
    pub x: [f64; 2],
    /// Values at the lower and the upper edge.
    pub y: [f64; 2],
}

impl Panel {
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

    /// Draws the line at zero, if zero is within the frame.
    pub fn draw_zero(&self, drawing: &mut Drawing) {
        if self.y[0] < 0.0 && self.y[1] > 0.0 {
            let ends = [[self.x[0], 0.0], [self.x[1], 0.0]].map(|end| self.position(end));
            drawing.line(&ends, FRAME, LIGHT);
        }
    }

    /// Draws the left and the lower edge with about these numbers of ticks; below the lower edge
    /// only if `below`.
    pub fn draw_frame(&self, drawing: &mut Drawing, [across, up]: [usize; 2], below: bool) {
        let Self {
            left,
            right,
            top,
            bottom,
            ..
        } = *self;
        drawing.line(
            &[[left, top], [left, bottom], [right, bottom]],
            FRAME,
            BLACK,
        );
        let label = Label::new(SMALL);
        for (value, text) in Ticks::between(self.x[0], self.x[1], across).labeled() {
            let [x, y] = self.position([value, self.y[0]]);
            drawing.line(&[[x, y], [x, y + TICK]], FRAME, BLACK);
            if below {
                drawing.text(&text, [x, y + 3.4 * TICK], label.anchored(Anchor::Middle));
            }
        }
        for (value, text) in Ticks::between(self.y[0], self.y[1], up).labeled() {
            let [x, y] = self.position([self.x[0], value]);
            drawing.line(&[[x, y], [x - TICK, y]], FRAME, BLACK);
            drawing.text(&text, [x - 1.7 * TICK, y], label.anchored(Anchor::End));
        }
    }

    /// Draws the line through these points of the panel.
    pub fn curve(&self, drawing: &mut Drawing, points: &[[f64; 2]], width: f64, color: Color) {
        let positions: Vec<_> = points.iter().map(|point| self.position(*point)).collect();
        drawing.line(&positions, width, color);
    }
}

/// The range of `values` with margins at both ends; if all are of a size up to `floor`, zero with
/// one at both sides.
pub(super) fn range(values: impl IntoIterator<Item = f64>, floor: f64) -> [f64; 2] {
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

/// A title above all panels that fits on one line, in smaller letters if it is long.
pub(super) fn draw_title(drawing: &mut Drawing, title: &str, [x, y]: [f64; 2]) {
    // Bold letters are wider than the measured ones.
    let width = 1.2 * text_width(title, Label::new(TEXT));
    let size = TEXT * ((drawing.size().0 - x - 24.0) / width).min(1.0);
    drawing.text(title, [x, y], Label::new(size).bold());
}

/// A row of lines with their meaning, from `position` to the right; entries that do not fit into the
/// drawing continue in the next row. Returns the height of the next row.
pub(super) fn draw_legend(
    drawing: &mut Drawing,
    position: [f64; 2],
    entries: &[(String, f64, Color)],
) -> f64 {
    const LINE: f64 = 56.0;
    let [left, mut y] = position;
    let mut x = left;
    for (text, width, color) in entries {
        let needed = LINE + 16.0 + text_width(text, Label::new(SMALL)) + 40.0;
        if x > left && x + needed > drawing.size().0 {
            (x, y) = (left, y + 1.4 * SMALL);
        }
        drawing.line(&[[x, y], [x + LINE, y]], *width, *color);
        drawing.text(text, [x + LINE + 16.0, y], Label::new(SMALL));
        x += needed;
    }
    y + 1.4 * SMALL
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_have_their_positions() {
        let panel = Panel {
            left: 100.0,
            right: 300.0,
            top: 50.0,
            bottom: 150.0,
            x: [0.0, 2.0],
            y: [-1.0, 1.0],
        };
        assert_eq!(panel.position([0.5, 0.5]), [150.0, 75.0]);
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
