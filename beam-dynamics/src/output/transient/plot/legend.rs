//! Rows of names with their lines, whose height is known before they are drawn.

use plotters::backend::DrawingBackend;
use shared_geom::figure::{Canvas, FigureProblem, Label};

use super::line::Stroke;
use crate::output::panel::SMALL;

/// Height of a row \[figure pixels\].
const ROW: f64 = 1.4 * SMALL;
/// Length of the line before a name \[figure pixels\].
const SAMPLE: f64 = 70.0;
/// Between line, name and next line \[figure pixels\].
const GAPS: [f64; 2] = [14.0, 36.0];
/// Width of a letter in its height, a wide one.
const LETTER: f64 = 0.66;

/// Names in a grid, each with the line it stands for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Legend {
    /// Names; without a line where the name is that of all curves.
    pub entries: Vec<(String, Option<Stroke>)>,
}

impl Legend {
    /// Height in a figure that has `room` from left to right \[figure pixels\].
    pub fn height(&self, room: f64) -> f64 {
        let rows = self.entries.len().div_ceil(self.across(room));
        rows as f64 * ROW
    }

    /// Width of an entry \[figure pixels\].
    fn cell(&self, room: f64) -> f64 {
        let letters = |(name, _): &(String, Option<Stroke>)| name.chars().count();
        let most = self.entries.iter().map(letters).max().unwrap_or(0);
        (SAMPLE + GAPS[0] + GAPS[1] + LETTER * SMALL * most as f64).min(room)
    }

    /// Entries of a row.
    fn across(&self, room: f64) -> usize {
        ((room / self.cell(room)) as usize).max(1)
    }

    /// Draws the entries from the upper left corner to the right and downward.
    pub fn draw<B: DrawingBackend>(
        &self,
        canvas: &Canvas<B>,
        [left, top]: [f64; 2],
        room: f64,
    ) -> Result<(), FigureProblem> {
        let (cell, across) = (self.cell(room), self.across(room));
        for (k, (name, stroke)) in self.entries.iter().enumerate() {
            let mut x = left + cell * (k % across) as f64;
            let y = top + ROW * ((k / across) as f64 + 0.5);
            let mut rest = cell - GAPS[1];
            if let Some(stroke) = stroke {
                stroke.draw(canvas, &[[x, y], [x + SAMPLE, y]])?;
                x += SAMPLE + GAPS[0];
                rest -= SAMPLE + GAPS[0];
            }
            let label = Label::new(SMALL);
            let text = canvas.shortened(name, label, rest);
            canvas.text(&text, [x, y], label)?;
        }
        Ok(())
    }
}
