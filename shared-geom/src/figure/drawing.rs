//! A drawing: its shapes, recorded once and rendered in any format.

use super::color::Color;
use super::shade::{ColorTable, ValueTriangle};
use super::shape::{Label, Shape};
use super::{TEXT, raster, render};

/// Shapes in the order in which they cover each other, on a white sheet.
///
/// Coordinates are figure pixels: x to the right, y down, from the upper left corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    size: (u32, u32),
    shapes: Vec<Shape>,
}

impl Drawing {
    /// An empty drawing of this width and height \[figure pixels\].
    pub fn new(size: (u32, u32)) -> Self {
        Self {
            size,
            shapes: Vec::new(),
        }
    }

    /// Width and height \[figure pixels\].
    pub fn size(&self) -> (f64, f64) {
        (f64::from(self.size.0), f64::from(self.size.1))
    }

    /// Width and height in whole pixels.
    pub(super) fn pixels(&self) -> (u32, u32) {
        self.size
    }

    pub(super) fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// All texts, in the order in which they are written.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.shapes.iter().filter_map(|shape| match shape {
            Shape::Text { text, .. } => Some(text.as_str()),
            _ => None,
        })
    }

    /// Points, color and width \[figure pixels\] of each line, in the order in which they are drawn,
    /// dash by dash.
    pub fn lines(&self) -> impl Iterator<Item = (&[[f64; 2]], Color, f64)> {
        self.shapes.iter().filter_map(|shape| match shape {
            Shape::Line {
                points,
                width,
                color,
            } => Some((points.as_slice(), *color, *width)),
            _ => None,
        })
    }

    /// Fills the polygon with these corners, without hairlines between neighbors of the same
    /// color.
    pub fn polygon(&mut self, corners: &[[f64; 2]], color: Color) {
        let corners = corners.to_vec();
        self.shapes.push(Shape::Polygon { corners, color });
    }

    /// Fills polygons of one color that do not overlap; `border` are the straight pieces of the
    /// border of all, in any order, all with the polygons on the same hand. A bitmap is filled
    /// within the border, which is faster than polygon by polygon.
    pub fn region(
        &mut self,
        polygons: Vec<Vec<[f64; 2]>>,
        border: Vec<[[f64; 2]; 2]>,
        color: Color,
    ) {
        self.shapes.push(Shape::Region {
            polygons,
            border,
            color,
        });
    }

    /// Draws the line through these points, `width` wide \[figure pixels\].
    pub fn line(&mut self, points: &[[f64; 2]], width: f64, color: Color) {
        self.shapes.push(Shape::Line {
            points: points.to_vec(),
            width,
            color,
        });
    }

    /// Draws the closed line around a polygon.
    pub fn outline(&mut self, corners: &[[f64; 2]], width: f64, color: Color) {
        let closed: Vec<_> = corners.iter().chain(corners.first()).copied().collect();
        self.line(&closed, width, color);
    }

    /// Fills a disc.
    pub fn disc(&mut self, center: [f64; 2], radius: f64, color: Color) {
        self.polygon(&raster::disc(center, radius), color);
    }

    /// Draws a circle.
    pub fn ring(&mut self, center: [f64; 2], radius: f64, width: f64, color: Color) {
        self.outline(&raster::disc(center, radius), width, color);
    }

    /// Fills triangles with the colors of the values in them, `color(value)`; in a vector
    /// format each triangle has the color of its mean. Later triangles cover earlier ones;
    /// triangles with values that are not finite are ignored.
    pub fn shade(&mut self, triangles: Vec<ValueTriangle>, color: impl Fn(f64) -> Color) {
        let colors = ColorTable::new(&triangles, color);
        self.shapes.push(Shape::Values { triangles, colors });
    }

    /// Writes a text whose capitals are centered on the height of `position` (for an
    /// upward text: on the width).
    pub fn text(&mut self, text: &str, position: [f64; 2], label: Label) {
        self.shapes.push(Shape::Text {
            text: text.to_owned(),
            position,
            label,
        });
    }

    /// Writes a title above all panels on one line, in smaller letters if it is long.
    pub fn title(&mut self, title: &str, [x, y]: [f64; 2]) {
        let label = Label::new(TEXT).bold();
        let part = (self.size().0 - x - 24.0) / text_width(title, label);
        let size = TEXT * part.min(1.0);
        self.text(title, [x, y], Label { size, ..label });
    }

    /// The text, its end cut off if it is wider than `space` \[figure pixels\].
    pub fn shortened(&self, text: &str, label: Label, space: f64) -> String {
        let fits = |text: &str| render::text_width(text, label) <= space;
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
            if fits(&cut(middle)) {
                fitting = middle;
            } else {
                beyond = middle;
            }
        }
        cut(fitting)
    }
}

/// Width of a text written like this \[figure pixels\].
pub fn text_width(text: &str, label: Label) -> f64 {
    render::text_width(text, label)
}
