//! The only file that knows the drawing library: a drawing as PNG or SVG, and widths of texts.

use std::cell::RefCell;
use std::convert::Infallible;
use std::ffi::OsStr;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::sync::OnceLock;

use plotters::backend::SVGBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle, register_font,
};
use plotters_backend::{BackendColor, BackendCoord, DrawingBackend, DrawingErrorKind};

use super::color::Color;
use super::shade::shade;
use super::shape::{Anchor, Label, Shape};
use super::sheet::{OVERSAMPLING, Sheet};
use super::{FigureProblem, bitmap, raster};

/// Name under which the embedded font is registered.
const FONT: &str = "sans-serif";
/// Height of the digits and capitals of the font, in sizes of the font.
const CAPITAL: f64 = 0.63;
/// Distance of the baseline of a text from its top, in sizes of the font: in a bitmap, and in an
/// SVG, where it is 0.76 em, and an em is the size over 1.24.
const BASELINES: [f64; 2] = [0.5, 0.76 / 1.24];
/// Coordinates of the library are whole numbers: an SVG is drawn on a finer grid by this factor
/// and shown at its nominal size.
const FINER: u32 = 8;
/// Pieces between two texts above which they are an image in an SVG, in the pixels of the PNG: a
/// piece takes about 300 bytes, and fields have some for each cell.
const MOST_PIECES: usize = 2000;

/// Writes shapes on a white sheet of this size \[figure pixels\] to `path`, as PNG or SVG by its
/// ending.
///
/// # Errors
/// [`FigureProblem`]: the font, the ending, or the file.
pub(super) fn write(path: &Path, size: (u32, u32), shapes: &[Shape]) -> Result<(), FigureProblem> {
    use_embedded_font()?;
    let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    match ending.to_lowercase().as_str() {
        "png" => write_png(path, size, shapes),
        "svg" => write_svg(path, size, shapes),
        _ => Err(FigureProblem::Ending {
            file: path.display().to_string(),
        }),
    }
}

/// Width of a text written like this \[figure pixels\]; zero if the font cannot be used.
pub(super) fn text_width(text: &str, label: Label) -> f64 {
    if use_embedded_font().is_err() {
        return 0.0;
    }
    let size = font(label, FINER).box_size(text);
    size.map_or(0.0, |(width, _)| f64::from(width) / f64::from(FINER))
}

/// Registers the embedded font (DejaVu Sans) as [`FONT`], once for the process.
fn use_embedded_font() -> Result<(), FigureProblem> {
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

fn font(label: Label, scale: u32) -> FontDesc<'static> {
    let size = label.size * f64::from(scale);
    let style = if label.bold {
        FontStyle::Bold
    } else {
        FontStyle::Normal
    };
    FontDesc::new(FontFamily::from(FONT), size, style)
}

/// Writes a text on a backend with `scale` pixels in a figure pixel.
fn write_text<B: DrawingBackend>(
    backend: &mut B,
    (text, [x, y], label): (&str, [f64; 2], Label),
    (scale, baseline): (u32, f64),
) -> Result<(), FigureProblem> {
    let to_baseline = label.size * (0.5 * CAPITAL - baseline);
    let (position, font) = if label.upward {
        let font = font(label, scale).transform(FontTransform::Rotate270);
        ([x + to_baseline, y], font)
    } else {
        ([x, y + to_baseline], font(label, scale))
    };
    let horizontal = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let mut style = TextStyle::from(font).pos(Pos::new(horizontal, VPos::Top));
    style.color = of_backend(label.color);
    backend
        .draw_text(text, &style, whole(position, scale))
        .map_err(refused)
}

fn of_backend(Color(r, g, b): Color) -> BackendColor {
    BackendColor {
        alpha: 1.0,
        rgb: (r, g, b),
    }
}

fn whole(position: [f64; 2], scale: u32) -> (i32, i32) {
    let [x, y] = position.map(|length| (length * f64::from(scale)).round() as i32);
    (x, y)
}

fn refused(reason: impl ToString) -> FigureProblem {
    FigureProblem::Backend {
        reason: reason.to_string(),
    }
}

fn unwritable(path: &Path, reason: impl ToString) -> FigureProblem {
    FigureProblem::Unwritable {
        file: path.display().to_string(),
        reason: reason.to_string(),
    }
}

fn write_png(path: &Path, size: (u32, u32), shapes: &[Shape]) -> Result<(), FigureProblem> {
    let write = |pixels: &[u8]| {
        let file = BufWriter::new(File::create(path)?);
        bitmap::encode(file, size, pixels, png::ColorType::Rgb)
    };
    with_pixels(([0; 2], size), shapes, write)?.map_err(|error| unwritable(path, error))
}

/// The result of `work` on the pixels of these shapes on a white sheet with this left upper corner and
/// size, rows of red, green, blue.
fn with_pixels<T>(
    (corner, size): ([u32; 2], (u32, u32)),
    shapes: &[Shape],
    work: impl FnOnce(&[u8]) -> T,
) -> Result<T, FigureProblem> {
    let mut sheet = Sheet::new(size);
    for shape in shapes {
        fill_sheet(&mut sheet, shape, corner.map(f64::from))?;
    }
    PIXELS.with_borrow_mut(|pixels| {
        sheet.average(pixels);
        Ok(work(pixels))
    })
}

thread_local! {
    /// Pixels of the last figure of this thread: the next one reuses the memory, which
    /// the system would have to clear.
    static PIXELS: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Draws a shape on the sheet with this left upper corner.
fn fill_sheet(sheet: &mut Sheet, shape: &Shape, corner: [f64; 2]) -> Result<(), FigureProblem> {
    let scale = f64::from(OVERSAMPLING);
    let moved = |point: &[f64; 2]| [0, 1].map(|i| point[i] - corner[i]);
    let finer = |point: &[f64; 2]| moved(point).map(|length| scale * length);
    match shape {
        Shape::Polygon { corners, color } => {
            let corners: Vec<_> = corners.iter().map(finer).collect();
            sheet.polygon(&corners, *color);
        }
        Shape::Region { border, color, .. } => {
            let border: Vec<_> = border.iter().map(|[a, b]| [finer(a), finer(b)]).collect();
            let (width, height) = sheet.size();
            raster::each_span_within(&border, width, height, |span| {
                sheet.fill(span.row, span.start, span.end, color.bytes());
            });
        }
        Shape::Line {
            points,
            width,
            color,
        } => {
            let points: Vec<_> = points.iter().map(finer).collect();
            draw_line(sheet, &points, (scale * width).max(1.0), *color);
        }
        Shape::Values { triangles, colors } => {
            for triangle in triangles {
                shade(sheet, &triangle.mapped(finer), |value| {
                    colors.of(value).bytes()
                });
            }
        }
        Shape::Text {
            text,
            position,
            label,
        } => {
            let text = (text.as_str(), moved(position), *label);
            return write_text(sheet, text, (OVERSAMPLING, BASELINES[0]));
        }
    }
    Ok(())
}

/// Draws a line with round joints [sheet pixels].
fn draw_line(sheet: &mut Sheet, points: &[[f64; 2]], width: f64, color: Color) {
    for piece in points.windows(2) {
        sheet.polygon(&raster::stroke(piece[0], piece[1], width), color);
    }
    if width > 2.0 {
        let is_closed = points.first() == points.last();
        let joints = if is_closed { 0 } else { 1 }..points.len().saturating_sub(1);
        for joint in points.get(joints).unwrap_or_default() {
            sheet.polygon(&raster::disc(*joint, 0.5 * width), color);
        }
    }
}

/// Texts on a sheet: their pixels.
impl DrawingBackend for Sheet {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size()
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(
        &mut self,
        point: BackendCoord,
        color: BackendColor,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let (r, g, b) = color.rgb;
        self.blend(point, [r, g, b], color.alpha);
        Ok(())
    }
}

fn write_svg(path: &Path, size: (u32, u32), shapes: &[Shape]) -> Result<(), FigureProblem> {
    let fine = (size.0 * FINER, size.1 * FINER);
    // Sharp corners of dense curves have no spikes.
    let mut text = format!(
        "<svg width=\"{}\" height=\"{}\" stroke-linejoin=\"round\" viewBox=\"0 0 {} {}\" \
         xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n",
        size.0, size.1, fine.0, fine.1
    );
    for part in shapes.chunk_by(|one, next| one.is_text() == next.is_text()) {
        text.push_str(
            &if part.iter().map(Shape::pieces).sum::<usize>() > MOST_PIECES {
                image(size, part)?.map_err(|error| unwritable(path, error))?
            } else {
                elements(fine, part)?
            },
        );
    }
    text.push_str("</svg>\n");
    std::fs::write(path, text).map_err(|error| unwritable(path, error))
}

/// Shapes on a sheet of this size as an image in an SVG.
fn image(
    size: (u32, u32),
    shapes: &[Shape],
) -> Result<Result<String, png::EncodingError>, FigureProblem> {
    let mut bounds = [f64::from(size.0), f64::from(size.1), 0.0, 0.0];
    for shape in shapes {
        let own = shape.bounds();
        let wider = |i: usize| match i {
            0 | 1 => bounds[i].min(own[i]),
            _ => bounds[i].max(own[i]),
        };
        bounds = [0, 1, 2, 3].map(wider);
    }
    // with a pixel for rounding; numbers beyond the sheet, and none, become its edges
    let inner = |length: f64, most: u32| length.clamp(0.0, f64::from(most)) as u32;
    let corner = [
        inner(bounds[0].floor() - 1.0, size.0),
        inner(bounds[1].floor() - 1.0, size.1),
    ];
    let own = (
        inner(bounds[2].ceil() + 1.0, size.0).saturating_sub(corner[0]),
        inner(bounds[3].ceil() + 1.0, size.1).saturating_sub(corner[1]),
    );
    if own.0 == 0 || own.1 == 0 {
        return Ok(Ok(String::new()));
    }
    with_pixels((corner, own), shapes, |pixels| {
        bitmap::element((corner, own), pixels, FINER)
    })
}

/// The elements of shapes in an SVG of this size [its units].
fn elements(size: (u32, u32), shapes: &[Shape]) -> Result<String, FigureProblem> {
    let mut text = String::new();
    {
        let mut backend = SVGBackend::with_string(&mut text, size);
        for shape in shapes {
            add_to_svg(&mut backend, shape)?;
        }
        backend.present().map_err(refused)?;
    }
    // The library writes a whole file: its first and its last line are the element `svg`.
    let inner = text
        .split_once(">\n")
        .and_then(|(_, rest)| rest.rsplit_once("</svg>"));
    Ok(inner.map_or_else(String::new, |(inner, _)| inner.to_owned()))
}

/// Draws a shape in an SVG.
fn add_to_svg(backend: &mut SVGBackend<'_>, shape: &Shape) -> Result<(), FigureProblem> {
    match shape {
        Shape::Polygon { corners, color } => add_polygon(backend, corners, *color),
        Shape::Region {
            polygons, color, ..
        } => {
            let mut polygons = polygons.iter();
            polygons.try_for_each(|corners| add_polygon(backend, corners, *color))
        }
        Shape::Line {
            points,
            width,
            color,
        } => {
            let width = (width * f64::from(FINER)).round().max(1.0) as u32;
            add_path(backend, points, width, *color)
        }
        Shape::Values { triangles, colors } => {
            let mut triangles = triangles
                .iter()
                .filter(|triangle| triangle.mean().is_finite());
            triangles.try_for_each(|triangle| {
                add_polygon(backend, &triangle.corners, colors.of(triangle.mean()))
            })
        }
        Shape::Text {
            text,
            position,
            label,
        } => write_text(backend, (text, *position, *label), (FINER, BASELINES[1])),
    }
}

/// A filled polygon with a thin outline, without which neighbors have hairlines between them.
fn add_polygon(
    backend: &mut SVGBackend<'_>,
    corners: &[[f64; 2]],
    color: Color,
) -> Result<(), FigureProblem> {
    let [first, _, _, ..] = corners else {
        return Ok(());
    };
    let filled: Vec<_> = corners.iter().map(|corner| whole(*corner, FINER)).collect();
    backend
        .fill_polygon(filled, &of_backend(color))
        .map_err(refused)?;
    add_path(backend, &[corners, &[*first]].concat(), 1, color)
}

fn add_path(
    backend: &mut SVGBackend<'_>,
    points: &[[f64; 2]],
    width: u32,
    Color(r, g, b): Color,
) -> Result<(), FigureProblem> {
    let style = ShapeStyle::from(RGBColor(r, g, b)).stroke_width(width);
    let points: Vec<_> = points.iter().map(|point| whole(*point, FINER)).collect();
    backend.draw_path(points, &style).map_err(refused)
}
