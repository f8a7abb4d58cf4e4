//! Rows of names with their lines; their height is known before drawing.

use shared_geom::figure::{Drawing, Label};

use super::line::Stroke;
use crate::output::panel::SMALL;

/// Height of a row \[figure pixels\].
const ROW: f64 = 1.4 * SMALL;
/// Length of the line before a name \[figure pixels\].
const SAMPLE: f64 = 70.0;
/// Between line, name and next line \[figure pixels\].
const GAPS: [f64; 2] = [14.0, 30.0];
/// Width of a letter relative to its height, a wide one: wider text is cut off.
const LETTER: f64 = 0.64;

/// Names in rows, each with its line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Legend {
    /// Names; without a line if the name applies to all curves.
    pub entries: Vec<(String, Option<Stroke>)>,
}

impl Legend {
    /// Height in a figure of width `space` \[figure pixels\].
    pub fn height(&self, space: f64) -> f64 {
        let last = self.positions(space).last().copied();
        last.map_or(0.0, |[_, row]| (row + 1.0) * ROW)
    }

    /// Beginning of each entry \[figure pixels\], and its row.
    fn positions(&self, space: f64) -> Vec<[f64; 2]> {
        let (mut x, mut row) = (0.0, 0.0);
        let mut positions = Vec::new();
        for entry in &self.entries {
            let width = width(entry);
            if x > 0.0 && x + width > space {
                (x, row) = (0.0, row + 1.0);
            }
            positions.push([x, row]);
            x += width + GAPS[1];
        }
        positions
    }

    /// Draws the entries from the upper left corner to the right and downward.
    pub fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2], space: f64) {
        for (entry, [position, row]) in self.entries.iter().zip(self.positions(space)) {
            let (name, stroke) = entry;
            let mut x = left + position;
            let y = top + ROW * (row + 0.5);
            let mut rest = width(entry).min(space - position);
            if let Some(stroke) = stroke {
                stroke.draw(drawing, &[[x, y], [x + SAMPLE, y]]);
                x += SAMPLE + GAPS[0];
                rest -= SAMPLE + GAPS[0];
            }
            let label = Label::new(SMALL);
            // A single letter is not shortened by dots.
            let text = match name.chars().count() {
                0 | 1 => name.clone(),
                _ => drawing.shortened(name, label, rest),
            };
            drawing.text(&text, [x, y], label);
        }
    }
}

/// Width of an entry without the gap after it \[figure pixels\].
fn width((name, stroke): &(String, Option<Stroke>)) -> f64 {
    let letters = LETTER * SMALL * name.chars().count() as f64;
    letters + stroke.map_or(0.0, |_| SAMPLE + GAPS[0])
}
