//! A canvas in figure pixels, on any backend.

use std::cell::RefCell;
use std::rc::Rc;

use plotters::backend::DrawingBackend;
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Polygon, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    BLACK, Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, TextStyle,
};

use super::shade::{ColorTable, ValueTriangle, shade};
use super::sheet::Sheet;
use super::{FONT, FigureProblem, raster};

/// Kind of a backend.
#[derive(Debug)]
pub(super) enum Medium {
    /// Pixels: shapes are filled by [`raster`], on the sheet below the backend.
    Bitmap(Rc<RefCell<Sheet>>),
    /// Shapes.
    Vector,
}

impl Medium {
    /// Distance of the baseline of a text from its top in the backend, in sizes of the
    /// font. SVG: 0.76 em, where an em is the size over 1.24.
    fn baseline(&self) -> f64 {
        match self {
            Self::Bitmap(_) => 0.5,
            Self::Vector => 0.76 / 1.24,
        }
    }
}

/// Height of the digits and capitals of the font, in sizes of the font.
const CAPITAL: f64 = 0.63;

/// Part of a label that is at the given position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The beginning of the text.
    Start,
    /// The middle of the text.
    Middle,
    /// The end of the text.
    End,
}

/// Format of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Label {
    /// Size of the font \[figure pixels, unit of the canvas\].
    pub size: f64,
    /// Part of the text that is at the given position.
    pub anchor: Anchor,
    /// Whether the text runs upward.
    pub upward: bool,
    /// Whether the letters are bold.
    pub bold: bool,
    /// Color of the letters.
    pub color: RGBColor,
}

impl Label {
    /// A black text of `size` \[figure pixels\] that begins at its position.
    pub fn new(size: f64) -> Self {
        Self {
            size,
            anchor: Anchor::Start,
            upward: false,
            bold: false,
            color: BLACK,
        }
    }

    /// The same with another part of the text at the given position.
    pub fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// The same running upward.
    pub fn upward(self) -> Self {
        Self {
            upward: true,
            ..self
        }
    }

    /// The same in bold letters.
    pub fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same in another color.
    pub fn colored(self, color: RGBColor) -> Self {
        Self { color, ..self }
    }
}

/// A drawing area with coordinates in figure pixels: x to the right, y down, from
/// the upper left corner.
///
/// Charts of plotters are drawn on [`Canvas::area`]; their pixel lengths (margins,
/// label areas, font sizes) are then multiplied by [`Canvas::scale`].
pub struct Canvas<B: DrawingBackend> {
    area: DrawingArea<B, Shift>,
    scale: u32,
    medium: Medium,
}

impl<B: DrawingBackend> std::fmt::Debug for Canvas<B> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (width, height) = self.size();
        write!(f, "Canvas({width} x {height}, scale {})", self.scale)
    }
}

impl<B: DrawingBackend> Canvas<B> {
    pub(super) fn new(area: DrawingArea<B, Shift>, scale: u32, medium: Medium) -> Self {
        Self {
            area,
            scale,
            medium,
        }
    }

    /// The area of plotters below the canvas.
    pub fn area(&self) -> &DrawingArea<B, Shift> {
        &self.area
    }

    /// Backend pixels in one figure pixel.
    pub fn scale(&self) -> u32 {
        self.scale
    }

    /// Width and height \[figure pixels\].
    pub fn size(&self) -> (f64, f64) {
        let (width, height) = self.area.dim_in_pixel();
        let scale = f64::from(self.scale);
        (f64::from(width) / scale, f64::from(height) / scale)
    }

    /// Fills the polygon with these corners, without hairlines between neighbors
    /// of the same color.
    ///
    /// # Errors
    /// [`FigureProblem::Backend`].
    pub fn polygon(&self, corners: &[[f64; 2]], color: RGBColor) -> Result<(), FigureProblem> {
        if let Medium::Bitmap(sheet) = &self.medium {
            fill(&mut sheet.borrow_mut(), &self.finer(corners), color);
            return Ok(());
        }
        let mut corners = self.backend(corners);
        if corners.len() < 3 {
            return Ok(());
        }
        self.area
            .draw(&Polygon::new(corners.clone(), color.filled()))?;
        corners.push(corners[0]);
        Ok(self.area.draw(&PathElement::new(corners, color))?)
    }

    /// Whether shapes become pixels, of which those that lie below others need no drawing.
    pub fn is_bitmap(&self) -> bool {
        matches!(self.medium, Medium::Bitmap(_))
    }

    /// Fills the region within these straight pieces of its border, in any order, all with
    /// the region on the same hand; on a bitmap only, where it gives the pixels of the
    /// polygons that the region is made of.
    pub fn region(&self, border: &[[[f64; 2]; 2]], color: RGBColor) {
        let Medium::Bitmap(sheet) = &self.medium else {
            return;
        };
        let scale = f64::from(self.scale);
        let finer = |piece: &[[f64; 2]; 2]| piece.map(|[x, y]| [scale * x, scale * y]);
        let border: Vec<_> = border.iter().map(finer).collect();
        let mut sheet = sheet.borrow_mut();
        let (width, height) = sheet.size();
        raster::each_span_within(&border, width, height, |span| {
            sheet.fill(span.row, span.start, span.end, bytes(color));
        });
    }

    /// Draws the line through these points, `width` wide \[figure pixels\].
    ///
    /// # Errors
    /// [`FigureProblem::Backend`].
    pub fn line(
        &self,
        points: &[[f64; 2]],
        width: f64,
        color: RGBColor,
    ) -> Result<(), FigureProblem> {
        let width = (width * f64::from(self.scale)).max(1.0);
        let Medium::Bitmap(sheet) = &self.medium else {
            let style = color.stroke_width(width.round() as u32);
            return Ok(self
                .area
                .draw(&PathElement::new(self.backend(points), style))?);
        };
        let sheet = &mut sheet.borrow_mut();
        let points = self.finer(points);
        for piece in points.windows(2) {
            fill(sheet, &raster::stroke(piece[0], piece[1], width), color);
        }
        if width > 2.0 {
            let is_closed = points.first() == points.last();
            let joints = if is_closed { 0 } else { 1 }..points.len().saturating_sub(1);
            for joint in points.get(joints).unwrap_or_default() {
                fill(sheet, &raster::disc(*joint, 0.5 * width), color);
            }
        }
        Ok(())
    }

    /// Fills a disc.
    ///
    /// # Errors
    /// [`FigureProblem::Backend`].
    pub fn disc(
        &self,
        center: [f64; 2],
        radius: f64,
        color: RGBColor,
    ) -> Result<(), FigureProblem> {
        self.polygon(&raster::disc(center, radius), color)
    }

    /// Fills triangles with the colors of the values in them, `color(value)`; on a
    /// vector canvas each triangle has the color of its mean. Later triangles cover
    /// earlier ones; triangles with values that are not finite are ignored.
    ///
    /// # Errors
    /// [`FigureProblem::Backend`].
    pub fn shade(
        &self,
        triangles: &[ValueTriangle],
        color: impl Fn(f64) -> RGBColor,
    ) -> Result<(), FigureProblem> {
        let Medium::Bitmap(sheet) = &self.medium else {
            return triangles
                .iter()
                .try_for_each(|triangle| self.polygon(&triangle.corners, color(triangle.mean())));
        };
        let sheet = &mut sheet.borrow_mut();
        let colors = ColorTable::new(triangles, |value| bytes(color(value)));
        for triangle in triangles {
            let triangle = triangle.scaled(f64::from(self.scale));
            shade(sheet, &triangle, |value| colors.of(value));
        }
        Ok(())
    }

    /// Writes a text whose capitals are centered on the height of `position` (for an
    /// upward text: on the width).
    ///
    /// # Errors
    /// [`FigureProblem::Backend`].
    pub fn text(&self, text: &str, position: [f64; 2], label: Label) -> Result<(), FigureProblem> {
        let to_baseline = label.size * (0.5 * CAPITAL - self.medium.baseline());
        let [x, y] = position;
        let position = match label.upward {
            true => [x + to_baseline, y],
            false => [x, y + to_baseline],
        };
        let position = self.backend(&[position])[0];
        let style = self.text_style(label);
        Ok(self
            .area
            .draw(&Text::new(text.to_owned(), position, style))?)
    }

    /// The text, its end cut off if it is wider than `space` \[figure pixels\].
    pub fn shortened(&self, text: &str, label: Label, space: f64) -> String {
        let fits = |text: &str| self.label_width(text, label) <= space;
        if fits(text) {
            return text.to_owned();
        }
        let letters: Vec<char> = text.chars().collect();
        let cut = |count: usize| -> String {
            let kept: String = letters[..count].iter().collect();
            kept.trim_end().to_owned() + "..."
        };
        // the largest number of letters that fit, by bisection
        let (mut fitting, mut beyond) = (0, letters.len());
        while beyond - fitting > 1 {
            let middle = (fitting + beyond) / 2;
            match fits(&cut(middle)) {
                true => fitting = middle,
                false => beyond = middle,
            }
        }
        cut(fitting)
    }

    /// Width of a text set in letters of `size` \[figure pixels\].
    pub fn text_width(&self, text: &str, size: f64) -> f64 {
        self.label_width(text, Label::new(size))
    }

    fn label_width(&self, text: &str, label: Label) -> f64 {
        let label = Label {
            upward: false,
            ..label
        };
        let style = self.text_style(label);
        let estimate = self.area.estimate_text_size(text, &style);
        estimate.map_or(0.0, |(width, _)| f64::from(width) / f64::from(self.scale))
    }

    fn text_style(&self, label: Label) -> TextStyle<'static> {
        let size = label.size * f64::from(self.scale);
        let style = if label.bold {
            FontStyle::Bold
        } else {
            FontStyle::Normal
        };
        let font = FontDesc::new(FontFamily::from(FONT), size, style);
        let horizontal = match label.anchor {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        let font = match label.upward {
            true => font.transform(FontTransform::Rotate270),
            false => font,
        };
        let mut style = TextStyle::from(font).pos(Pos::new(horizontal, VPos::Top));
        style.color = label.color.to_backend_color();
        style
    }

    fn finer(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let scale = f64::from(self.scale);
        points.iter().map(|[x, y]| [scale * x, scale * y]).collect()
    }

    fn backend(&self, points: &[[f64; 2]]) -> Vec<(i32, i32)> {
        let whole = |length: f64| (length * f64::from(self.scale)).round() as i32;
        points.iter().map(|[x, y]| (whole(*x), whole(*y))).collect()
    }
}

/// Fills the polygon with these corners [sheet pixels].
fn fill(sheet: &mut Sheet, corners: &[[f64; 2]], color: RGBColor) {
    let (width, height) = sheet.size();
    raster::each_span(corners, width, height, |span| {
        sheet.fill(span.row, span.start, span.end, bytes(color));
    });
}

fn bytes(RGBColor(r, g, b): RGBColor) -> [u8; 3] {
    [r, g, b]
}
