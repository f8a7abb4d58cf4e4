//! Triangles filled with the values in them, on a grid of pixels.

use super::color::Color;
use super::raster::{each_span, holds_no_center};
use super::sheet::Sheet;

/// A triangle with a value at each corner, linear in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueTriangle {
    /// Its corners \[figure pixels, unit of the drawing\].
    pub corners: [[f64; 2]; 3],
    /// The values there \[any unit\].
    pub values: [f64; 3],
}

impl ValueTriangle {
    /// Mean value.
    pub fn mean(&self) -> f64 {
        self.values.iter().sum::<f64>() / 3.0
    }

    /// The same with its corners at other points.
    pub(super) fn mapped(&self, map: impl Fn(&[f64; 2]) -> [f64; 2]) -> Self {
        Self {
            corners: self.corners.each_ref().map(map),
            ..*self
        }
    }

    /// Value at the origin and its change along x and y; constant for a triangle
    /// without area.
    fn plane(&self) -> [f64; 3] {
        let [a, b, c] = self.corners;
        let (b, c) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let [first, second, third] = self.values;
        let (along, across) = (second - first, third - first);
        let doubled = b[0] * c[1] - b[1] * c[0];
        let dx = (along * c[1] - across * b[1]) / doubled;
        let dy = (across * b[0] - along * c[0]) / doubled;
        if dx.is_finite() && dy.is_finite() {
            [first - dx * a[0] - dy * a[1], dx, dy]
        } else {
            [self.mean(), 0.0, 0.0]
        }
    }
}

/// Colors of values in equal steps, smaller than visible differences.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ColorTable {
    low: f64,
    /// Steps per unit of the values.
    density: f64,
    colors: Vec<Color>,
}

impl ColorTable {
    const STEPS: usize = 4096;

    /// The colors `color(value)` of all values in `triangles`.
    pub fn new(triangles: &[ValueTriangle], color: impl Fn(f64) -> Color) -> Self {
        let values = triangles.iter().flat_map(|triangle| triangle.values);
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values
            .filter(|value| value.is_finite())
            .fold(none, |(low, high), value| (low.min(value), high.max(value)));
        let step = (high - low) / Self::STEPS as f64;
        // one value, or none, has one color
        let (density, last) = if step > 0.0 && (1.0 / step).is_finite() {
            (1.0 / step, Self::STEPS)
        } else {
            (0.0, 0)
        };
        let colors = (0..=last).map(|k| color(low + step * k as f64));
        Self {
            low,
            density,
            colors: colors.collect(),
        }
    }

    /// The color of a value of the triangles.
    pub fn of(&self, value: f64) -> Color {
        let index = ((value - self.low) * self.density + 0.5) as usize;
        self.colors[index.min(self.colors.len() - 1)]
    }
}

/// Draws a triangle with the colors `color(value)` over the sheet [sheet pixels]; ignores
/// one with values that are not finite.
pub(super) fn shade(sheet: &mut Sheet, triangle: &ValueTriangle, color: impl Fn(f64) -> [u8; 3]) {
    if !triangle.values.iter().all(|value| value.is_finite()) {
        return;
    }
    let (width, height) = sheet.size();
    if holds_no_center(&triangle.corners, (width, height)) {
        return;
    }
    let [origin, dx, dy] = triangle.plane();
    // Pixels on the rim must not leave the range of the corners by round-off.
    let [a, b, c] = triangle.values;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    each_span(&triangle.corners, width, height, |span| {
        let at_row = origin + dy * (f64::from(span.row) + 0.5);
        let value = |x: i32| (at_row + dx * (f64::from(x) + 0.5)).clamp(low, high);
        sheet.shade(span.row, span.start, span.end, |x| color(value(x)));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles make a square with the value x + 2 y: every pixel has the value of
    /// its center.
    #[test]
    fn linear_fields_are_met_at_every_pixel() {
        let value = |[x, y]: [f64; 2]| x + 2.0 * y;
        let triangle = |corners: [[f64; 2]; 3]| ValueTriangle {
            corners,
            values: corners.map(value),
        };
        // tenths of the value: four pixels of the sheet make one of the figure
        let color = |value: f64| [(10.0 * value).round() as u8; 3];
        let mut sheet = Sheet::new((10, 5));
        let [a, b, c, d] = [[2.0, 1.0], [8.0, 1.0], [8.0, 9.0], [2.0, 9.0]];
        shade(&mut sheet, &triangle([a, b, c]), color);
        shade(&mut sheet, &triangle([a, c, d]), color);
        let pixels = sheet.averaged();
        for (k, pixel) in pixels.chunks(3).enumerate() {
            let (x, y) = ((k % 10) as f64, (k / 10) as f64);
            if (1.0..4.0).contains(&x) && (1.0..4.0).contains(&y) {
                // the mean of four values is the value in the middle of them
                let expected = 10.0 * value([2.0 * x + 1.0, 2.0 * y + 1.0]);
                assert_eq!(f64::from(pixel[0]), expected, "{x} {y}");
            }
        }
    }

    #[test]
    fn later_triangles_cover_earlier_ones_and_no_numbers_are_left_out() {
        let corners = [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0]];
        let of = |values| ValueTriangle { corners, values };
        let color = |value: f64| [value as u8; 3];
        let mut sheet = Sheet::new((4, 4));
        shade(&mut sheet, &of([1.0; 3]), color);
        shade(&mut sheet, &of([2.0; 3]), color);
        shade(&mut sheet, &of([f64::NAN, 2.0, 2.0]), color);
        let pixels = sheet.averaged();
        assert_eq!(pixels[..3], [2; 3]);
        assert_eq!(pixels[pixels.len() - 3..], [255; 3]);
    }

    /// The color of a thousandth of the range is right to a step of the table.
    #[test]
    fn tables_have_the_colors_of_their_values() {
        let of = |values| ValueTriangle {
            corners: [[0.0; 2]; 3],
            values,
        };
        let color = |value: f64| Color((1e-10 * value) as u8, 0, 0);
        let triangles = [of([1e11, f64::NAN, 2e11]), of([2.5e12, 0.0, 3e11])];
        let table = ColorTable::new(&triangles, color);
        for k in 0..=250 {
            let value = 1e10 * (f64::from(k) + 0.5);
            assert_eq!(table.of(value).0, k.min(250) as u8, "{k}");
        }
        let one = ColorTable::new(&[of([7e10; 3])], color);
        assert_eq!((one.of(7e10), one.colors.len()), (Color(7, 0, 0), 1));
        assert_eq!(ColorTable::new(&[], color).colors.len(), 1);
    }

    #[test]
    fn triangles_without_area_have_their_mean() {
        let line = ValueTriangle {
            corners: [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]],
            values: [1.0, 2.0, 6.0],
        };
        assert_eq!(line.plane(), [3.0, 0.0, 0.0]);
    }
}
