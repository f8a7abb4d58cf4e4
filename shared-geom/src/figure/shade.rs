//! Triangles filled with the values in them, on a grid of pixels.

use super::raster::spans;

/// A triangle with a value at each corner, linear in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueTriangle {
    /// Its corners \[figure pixels, unit of the canvas\].
    pub corners: [[f64; 2]; 3],
    /// The values there \[any unit\].
    pub values: [f64; 3],
}

impl ValueTriangle {
    /// Mean value.
    pub fn mean(&self) -> f64 {
        self.values.iter().sum::<f64>() / 3.0
    }

    pub(super) fn scaled(&self, scale: f64) -> Self {
        Self {
            corners: self.corners.map(|[x, y]| [scale * x, scale * y]),
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

/// The values at the centers of pixels; those that nothing covers have none.
#[derive(Debug)]
pub(super) struct Shading {
    width: u32,
    height: u32,
    /// Row by row; not a number where nothing is.
    values: Vec<f32>,
}

/// Values of neighboring pixels of one row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run<'a> {
    pub row: i32,
    pub start: i32,
    pub values: &'a [f32],
}

impl Shading {
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            values: vec![f32::NAN; width as usize * height as usize],
        }
    }

    /// Puts a triangle over what is there \[pixels\].
    pub fn add(&mut self, triangle: &ValueTriangle) {
        if !triangle.values.iter().all(|value| value.is_finite()) {
            return;
        }
        let [origin, dx, dy] = triangle.plane();
        // Pixels on the rim must not leave the range of the corners by round-off.
        let low = triangle
            .values
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let high = triangle
            .values
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max);
        for span in spans(&triangle.corners, self.width, self.height) {
            let row = span.row as usize * self.width as usize;
            let pixels = &mut self.values[row + span.start as usize..row + span.end as usize];
            let at_row = origin + dy * (f64::from(span.row) + 0.5);
            for (pixel, x) in pixels.iter_mut().zip(span.start..) {
                *pixel = (at_row + dx * (f64::from(x) + 0.5)).clamp(low, high) as f32;
            }
        }
    }

    /// The runs of covered pixels.
    pub fn runs(&self) -> impl Iterator<Item = Run<'_>> {
        let rows = self.values.chunks_exact(self.width.max(1) as usize);
        rows.zip(0..).flat_map(|(row, number)| {
            let mut behind = 0;
            row.chunk_by(|a, b| a.is_nan() == b.is_nan())
                .filter_map(move |values| {
                    let start = behind;
                    behind += values.len();
                    let run = Run {
                        row: number,
                        start: start as i32,
                        values,
                    };
                    (!values[0].is_nan()).then_some(run)
                })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles make a square with the value x + 2 y: every pixel has that of
    /// its center, to the digits of single precision.
    #[test]
    fn linear_fields_are_met_at_every_pixel() {
        let value = |[x, y]: [f64; 2]| x + 2.0 * y;
        let triangle = |corners: [[f64; 2]; 3]| ValueTriangle {
            corners,
            values: corners.map(value),
        };
        let mut shading = Shading::new(20, 10);
        let [a, b, c, d] = [[2.0, 1.0], [12.0, 1.0], [12.0, 9.0], [2.0, 9.0]];
        shading.add(&triangle([a, b, c]));
        shading.add(&triangle([a, c, d]));
        let runs: Vec<_> = shading.runs().collect();
        assert_eq!(runs.len(), 8);
        for run in runs {
            assert_eq!((run.start, run.values.len()), (2, 10));
            for (k, found) in run.values.iter().enumerate() {
                let expected = value([2.5 + k as f64, f64::from(run.row) + 0.5]);
                assert!((f64::from(*found) - expected).abs() < 1e-5 * expected);
            }
        }
    }

    #[test]
    fn later_triangles_cover_earlier_ones_and_no_numbers_are_left_out() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        let of = |values| ValueTriangle { corners, values };
        let mut shading = Shading::new(4, 4);
        shading.add(&of([1.0; 3]));
        shading.add(&of([2.0; 3]));
        shading.add(&of([f64::NAN, 2.0, 2.0]));
        let values: Vec<_> = shading.runs().flat_map(|run| run.values).collect();
        assert_eq!(values.len(), 6);
        assert!(values.iter().all(|value| **value == 2.0));
        assert!(Shading::new(3, 3).runs().next().is_none());
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
