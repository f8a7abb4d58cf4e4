//! Rows of names with samples of their lines or marks; their height is known before drawing.

use super::axes::SMALL;
use super::color::Color;
use super::drawing::{Drawing, text_width};
use super::shape::Label;
use super::stroke::{Mark, Stroke};

/// Height of a row \[figure pixels\].
const ROW: f64 = 1.5 * SMALL;
/// Length of a sample line, and width of a mark \[figure pixels\].
const LINE: f64 = 70.0;
const MARK: f64 = 26.0;
/// Between sample, name and next sample \[figure pixels\].
const GAPS: [f64; 2] = [14.0, 38.0];

/// Sample before a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// None: the name applies to all.
    None,
    /// A line.
    Line(Stroke),
    /// A line with a mark of a size in its color \[figure pixels\].
    Marked(Stroke, Mark, f64),
    /// A mark of a size \[figure pixels\].
    Mark(Mark, f64, Color),
}

impl Sample {
    /// Width with the gap after it \[figure pixels\].
    fn width(&self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Line(_) | Self::Marked(..) => LINE + GAPS[0],
            Self::Mark(..) => MARK + GAPS[0],
        }
    }
}

/// Names in rows, each with its sample.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Legend {
    /// The names and their samples.
    pub entries: Vec<(String, Sample)>,
}

impl Legend {
    /// The legend of solid lines: names, widths \[figure pixels\] and colors.
    pub fn of_lines(lines: impl IntoIterator<Item = (String, f64, Color)>) -> Self {
        let entry = |(name, width, color)| (name, Sample::Line(Stroke::new(width, color)));
        Self {
            entries: lines.into_iter().map(entry).collect(),
        }
    }

    /// Adds a name with its sample.
    pub fn add(&mut self, name: impl Into<String>, sample: Sample) {
        self.entries.push((name.into(), sample));
    }

    /// Height in a figure of width `space` \[figure pixels\].
    pub fn height(&self, space: f64) -> f64 {
        let last = self.positions(space).last().copied();
        last.map_or(0.0, |[_, row]| (row + 1.0) * ROW)
    }

    /// Beginning of each entry \[figure pixels\], and its row.
    fn positions(&self, space: f64) -> Vec<[f64; 2]> {
        let (mut x, mut row) = (0.0, 0.0);
        let mut positions = Vec::new();
        for (name, sample) in &self.entries {
            let width = sample.width() + text_width(name, Label::new(SMALL));
            if x > 0.0 && x + width > space {
                (x, row) = (0.0, row + 1.0);
            }
            positions.push([x, row]);
            x += width + GAPS[1];
        }
        positions
    }

    /// Draws the entries from the upper left corner to the right and downward; a name wider than
    /// `space` \[figure pixels\] is cut off.
    pub fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2], space: f64) {
        for ((name, sample), [position, row]) in self.entries.iter().zip(self.positions(space)) {
            let x = left + position;
            let y = top + ROW * (row + 0.5);
            match sample {
                Sample::None => {}
                Sample::Line(stroke) => stroke.draw(drawing, &[[x, y], [x + LINE, y]]),
                Sample::Marked(stroke, mark, size) => {
                    stroke.draw(drawing, &[[x, y], [x + LINE, y]]);
                    mark.draw(drawing, [x + 0.5 * LINE, y], *size, stroke.color);
                }
                Sample::Mark(mark, size, color) => {
                    mark.draw(drawing, [x + 0.5 * MARK, y], *size, *color);
                }
            }
            let label = Label::new(SMALL);
            let width = sample.width();
            let name = drawing.shortened(name, label, space - position - width);
            drawing.text(&name, [x + width, y], label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::BLACK;

    #[test]
    fn entries_continue_in_the_next_row() {
        let mut legend = Legend::default();
        assert_eq!(legend.height(500.0), 0.0);
        for name in ["one", "two"] {
            legend.add(name, Sample::Line(Stroke::new(4.0, BLACK)));
        }
        legend.add("ring", Sample::Mark(Mark::Ring, 13.0, BLACK));
        assert_eq!(legend.height(1000.0), ROW);
        assert_eq!(legend.height(200.0), 3.0 * ROW);
        let mut drawing = Drawing::new((200, 200));
        legend.add("a name that is too long", Sample::None);
        legend.draw(&mut drawing, [0.0, 0.0], 200.0);
        let texts: Vec<_> = drawing.texts().collect();
        assert_eq!(texts[..3], ["one", "two", "ring"]);
        assert!(texts[3].ends_with("..."), "{texts:?}");
    }
}
