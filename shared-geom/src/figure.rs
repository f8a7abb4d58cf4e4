//! Figures for reports: functions shared by both programs.
//!
//! A figure is anything that implements [`Drawing`]; [`save`] draws it into a PNG
//! or SVG file, by the ending of the file's name. Lengths are figure pixels: a
//! figure [`WIDTH`] pixels wide is meant for the width of a text page, where
//! [`TEXT`] pixels are the size of the page's own letters. PNG files are drawn
//! twice as large and averaged, so that edges are not jagged.

use std::cell::RefCell;
use std::ffi::OsStr;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::rc::Rc;
use std::sync::OnceLock;

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::drawing::{DrawingAreaErrorKind, IntoDrawingArea};
use plotters::style::{FontStyle, WHITE, register_font};

use crate::error::Explain;

mod canvas;
mod color;
mod raster;
mod shade;
mod sheet;
mod tick;

pub use canvas::{Anchor, Canvas, Label};
pub use color::{CATEGORIES, category, diverging, sequential};
pub use shade::ValueTriangle;
pub use tick::{Ticks, tick_label};

use canvas::Medium;
use sheet::{OVERSAMPLING, Sheet, SheetBackend};

/// Name under which the embedded font is registered.
pub const FONT: &str = "sans-serif";
/// Width of a figure for the full width of a text page \[figure pixels\].
pub const WIDTH: u32 = 1800;
/// Size of the letters of a figure of that width \[figure pixels\].
pub const TEXT: f64 = 36.0;

/// Something that can be drawn on every backend.
pub trait Drawing {
    /// Draws the figure on a white canvas.
    ///
    /// # Errors
    /// [`FigureProblem::Backend`] when the backend refuses.
    fn draw<B: DrawingBackend>(&self, canvas: &Canvas<B>) -> Result<(), FigureProblem>;
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

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for FigureProblem {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        Self::Backend {
            reason: error.to_string(),
        }
    }
}

/// Makes the embedded font (DejaVu Sans) known as [`FONT`], once for the process.
///
/// [`save`] does so itself; programs that use plotters alone call it before any drawing,
/// for SVG too.
///
/// # Errors
/// [`FigureProblem::Font`].
pub fn use_embedded_font() -> Result<(), FigureProblem> {
    static REGISTERED: OnceLock<bool> = OnceLock::new();
    let registered = REGISTERED.get_or_init(|| {
        let normal = register_font(FONT, FontStyle::Normal, dejavu::sans::regular());
        let bold = register_font(FONT, FontStyle::Bold, dejavu::sans::bold());
        normal.is_ok() && bold.is_ok()
    });
    if *registered {
        Ok(())
    } else {
        Err(FigureProblem::Font)
    }
}

/// Draws a figure of `size` (width, height) \[figure pixels\] into the file at
/// `path`, as PNG or SVG by its ending.
///
/// # Errors
/// [`FigureProblem`]: the ending, the drawing, or the writing of the file.
pub fn save(path: &Path, size: (u32, u32), drawing: &impl Drawing) -> Result<(), FigureProblem> {
    use_embedded_font()?;
    let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    match ending.to_lowercase().as_str() {
        "png" => save_png(path, size, drawing),
        "svg" => save_svg(path, size, drawing),
        _ => Err(FigureProblem::Ending {
            file: path.display().to_string(),
        }),
    }
}

fn unwritable(path: &Path, reason: impl ToString) -> FigureProblem {
    FigureProblem::Unwritable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    }
}

fn save_png(path: &Path, size: (u32, u32), drawing: &impl Drawing) -> Result<(), FigureProblem> {
    let sheet = Rc::new(RefCell::new(Sheet::new(size)));
    let area = SheetBackend(Rc::clone(&sheet)).into_drawing_area();
    let medium = Medium::Bitmap(Rc::clone(&sheet));
    drawing.draw(&Canvas::new(area, OVERSAMPLING, medium))?;
    PIXELS.with_borrow_mut(|pixels| {
        sheet.borrow().average(pixels);
        write_png(path, size, pixels).map_err(|error| unwritable(path, error))
    })
}

thread_local! {
    /// Pixels of the last figure of this thread: the next one reuses the memory, which
    /// the system would have to clear.
    static PIXELS: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Writes rows of red, green, blue.
///
/// Pixels of a figure mostly equal the pixels above or next to them, which one filter
/// finds without trying all of them.
fn write_png(
    path: &Path,
    (width, height): (u32, u32),
    pixels: &[u8],
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::FilterType::Paeth);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()
}

/// Coordinates of the backend are whole numbers: an SVG is drawn on a finer grid
/// and shown at its nominal size.
fn save_svg(path: &Path, size: (u32, u32), drawing: &impl Drawing) -> Result<(), FigureProblem> {
    const FINER: u32 = 8;
    let fine = (size.0 * FINER, size.1 * FINER);
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, fine).into_drawing_area();
        area.fill(&WHITE)?;
        let canvas = Canvas::new(area, FINER, Medium::Vector);
        drawing.draw(&canvas)?;
        canvas.area().present()?;
    }
    let drawn = format!("<svg width=\"{}\" height=\"{}\"", fine.0, fine.1);
    // Sharp corners of dense curves have no spikes.
    let shown = format!(
        "<svg width=\"{}\" height=\"{}\" stroke-linejoin=\"round\"",
        size.0, size.1
    );
    let text = text.replacen(&drawn, &shown, 1);
    std::fs::write(path, text).map_err(|error| unwritable(path, error))
}

#[cfg(test)]
mod tests;
