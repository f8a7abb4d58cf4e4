//! Figures for reports: functions shared by both programs.
//!
//! A figure is anything that implements [`Figure`]. It is recorded once, as a [`Drawing`], which
//! is saved as PNG or SVG by the ending of the file's name. Fields of many cells are images in an
//! SVG, with texts, axes and curves around them as elements. Lengths are figure pixels: a figure
//! [`WIDTH`] pixels wide is meant for the width of a text page, where [`TEXT`] pixels are the
//! size of the page's own letters. PNG files are drawn twice as large and averaged, so that edges
//! are not jagged.

use std::path::Path;

use crate::error::Explain;

mod axes;
mod bitmap;
mod color;
mod drawing;
mod legend;
mod panels;
mod raster;
mod render;
mod shade;
mod shape;
mod sheet;
mod stroke;
mod tick;

pub use axes::{Axes, GRAY, INK, LIGHT, SMALL, TITLE, fitting, range};
pub use color::{BLACK, CATEGORIES, Color, WHITE, category, diverging, sequential};
pub use drawing::{Drawing, text_width};
pub use legend::{Legend, Sample};
pub use panels::{Panel, PanelPlot, scale};
pub use shade::ValueTriangle;
pub use shape::{Anchor, Label};
pub use stroke::{Mark, Stroke};
pub use tick::{Ticks, tick_label};

/// Width of a figure for the full width of a text page \[figure pixels\].
pub const WIDTH: u32 = 1800;
/// Size of the letters of a figure of that width \[figure pixels\].
pub const TEXT: f64 = 36.0;

/// Something that can be drawn.
pub trait Figure {
    /// Width and height \[figure pixels\].
    fn size(&self) -> (u32, u32);

    /// Draws the figure on a white sheet of its size.
    fn draw(&self, drawing: &mut Drawing);

    /// The figure, recorded.
    fn drawing(&self) -> Drawing {
        let mut drawing = Drawing::new(self.size());
        self.draw(&mut drawing);
        drawing
    }
}

impl Drawing {
    /// Writes the drawing to `path`, as PNG or SVG by its ending.
    ///
    /// # Errors
    /// [`FigureProblem`]: the ending, the font, or the writing of the file.
    pub fn save(&self, path: &Path) -> Result<(), FigureProblem> {
        render::write(path, self.pixels(), self.shapes())
    }
}

/// Reason for which a figure was not made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FigureProblem {
    /// The embedded font cannot be used.
    #[error("the embedded font cannot be used")]
    Font,
    /// A file name whose ending does not give the format.
    #[error("figure \"{file}\" ends in neither \".png\" nor \".svg\"")]
    Ending {
        /// The file name.
        file: String,
    },
    /// The file cannot be written.
    #[error("figure \"{file}\" cannot be written: {reason}")]
    Unwritable {
        /// The file name.
        file: String,
        /// The reason as text.
        reason: String,
    },
    /// The drawing backend refused.
    #[error("the figure cannot be drawn: {reason}")]
    Backend {
        /// The backend's message.
        reason: String,
    },
}

impl Explain for FigureProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Ending { .. } => Some("name the file .png or .svg".to_owned()),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests;
