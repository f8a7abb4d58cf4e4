//! Views of a model along the axes: selection of two axes each, and one scale for all.

use nalgebra::Vector3;
use shared_geom::figure::{self, Axes, Color, Drawing};

/// A line in space with its style.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stroke {
    pub points: Vec<Vector3<f64>>,
    pub width: f64,
    pub color: Color,
}

/// Content of the view along each axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extent {
    low: Vector3<f64>,
    high: Vector3<f64>,
}

/// A pair of axes: to the right and up.
pub(super) type View = [usize; 2];

const AXES: [&str; 3] = ["x", "y", "z"];
/// Margin around the content, as part of the largest extent.
const MARGIN: f64 = 0.04;
/// Least extent of a view, as part of the largest: space for ticks and for a line.
const LEAST: f64 = 0.13;
/// Part of the largest extent below which the model has no view along a direction.
const FLAT: f64 = 1e-3;
/// Part of the longest direction from which on the view across it is shown.
const DEEP: f64 = 0.3;
/// Margins of a view: left, right, above, below \[figure pixels\].
pub(super) const MARGINS: [f64; 4] = [150.0, 40.0, 20.0, 120.0];

impl Extent {
    /// The box around all points.
    pub fn around(strokes: &[Stroke], marks: &[Vector3<f64>]) -> Self {
        let points = strokes
            .iter()
            .flat_map(|stroke| &stroke.points)
            .chain(marks);
        let mut extent: Option<Self> = None;
        for point in points.filter(|point| point.iter().all(|x| x.is_finite())) {
            let before = extent.unwrap_or(Self {
                low: *point,
                high: *point,
            });
            extent = Some(Self {
                low: before.low.inf(point),
                high: before.high.sup(point),
            });
        }
        extent.unwrap_or(Self {
            low: Vector3::zeros(),
            high: Vector3::zeros(),
        })
    }

    fn length(&self, axis: usize) -> f64 {
        self.high[axis] - self.low[axis]
    }

    fn largest(&self) -> f64 {
        let largest = (0..3).map(|axis| self.length(axis)).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// The views shown: the two longest directions, the longest and the third unless the model is
    /// flat, and the shorter two if they are long.
    pub fn views(&self) -> Vec<View> {
        let mut axes = [0, 1, 2];
        axes.sort_by(|a, b| self.length(*b).total_cmp(&self.length(*a)));
        let view = |a: usize, b: usize| [a.min(b), a.max(b)];
        let part = |axis: usize| self.length(axis) / self.largest();
        let mut views = vec![view(axes[0], axes[1])];
        if part(axes[2]) > FLAT {
            views.push(view(axes[0], axes[2]));
        }
        if part(axes[2]) > DEEP {
            views.push(view(axes[1], axes[2]));
        }
        views
    }

    /// Height over width of a view.
    pub fn aspect(&self, view: View) -> f64 {
        let [width, height] = view.map(|axis| {
            let [low, high] = self.range(axis);
            high - low
        });
        height / width
    }

    /// The view in a frame of `size` with the upper left corner at `corner`; its scales
    /// are equal where the frame has the aspect of the view.
    pub fn panel(&self, view: View, [left, top]: [f64; 2], size: [f64; 2]) -> Axes {
        Axes {
            left,
            right: left + size[0],
            top,
            bottom: top + size[1],
            x: self.range(view[0]),
            y: self.range(view[1]),
        }
    }

    /// Content of the view along one of its axes: the extent with margins.
    fn range(&self, axis: usize) -> [f64; 2] {
        let half = (0.5 * self.length(axis)).max(0.5 * LEAST * self.largest());
        let half = half + MARGIN * self.largest();
        let middle = 0.5 * (self.low[axis] + self.high[axis]);
        [middle - half, middle + half]
    }
}

/// Views next to or below each other, all in one scale.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arrangement {
    /// Axes of each view, from the upper left corner of all.
    panels: Vec<(View, Axes)>,
    /// Width and height of all \[figure pixels\].
    pub size: [f64; 2],
}

impl Arrangement {
    /// The views of an extent in at most `space` \[figure pixels\], arranged so that the
    /// scale is largest.
    pub fn new(extent: &Extent, space: [f64; 2]) -> Self {
        let views = extent.views();
        let lengths: Vec<[f64; 2]> = views
            .iter()
            .map(|view| {
                view.map(|axis| {
                    let [low, high] = extent.range(axis);
                    high - low
                })
            })
            .collect();
        let [below, beside] = [0, 1].map(|along| scale(&lengths, along, space));
        let is_beside = beside > below;
        let scale = below.max(beside);
        let mut corner = [0.0, 0.0];
        let mut size = [0.0_f64, 0.0_f64];
        let mut panels = Vec::new();
        for (view, length) in views.into_iter().zip(lengths) {
            let left = corner[0] + MARGINS[0];
            let top = corner[1] + MARGINS[2];
            let panel = extent.panel(view, [left, top], length.map(|length| scale * length));
            let end = [panel.right + MARGINS[1], panel.bottom + MARGINS[3]];
            size = [size[0].max(end[0]), size[1].max(end[1])];
            corner = if is_beside {
                [end[0], 0.0]
            } else {
                [0.0, end[1]]
            };
            panels.push((view, panel));
        }
        Self { panels, size }
    }

    /// Draws the strokes and the marks in every view; `corner` is the upper left corner
    /// of all.
    pub fn draw(
        &self,
        drawing: &mut Drawing,
        corner: [f64; 2],
        strokes: &[Stroke],
        marks: &[(Vector3<f64>, Color)],
    ) {
        for (view, panel) in &self.panels {
            let seen = (*view, &lengths(*view));
            draw_view(drawing, seen, &panel.moved(corner), strokes, marks);
        }
    }
}

/// Titles of the axes of a view that are lengths.
pub(super) fn lengths(view: View) -> [String; 2] {
    view.map(|axis| format!("{} [m]", AXES[axis]))
}

/// Draws strokes and marks in the projection of a view, with its axes and their titles.
pub(super) fn draw_view(
    drawing: &mut Drawing,
    (view, names): (View, &[String; 2]),
    panel: &Axes,
    strokes: &[Stroke],
    marks: &[(Vector3<f64>, Color)],
) {
    panel.draw_grid(drawing);
    for stroke in strokes {
        let points: Vec<_> = stroke.points.iter().map(|p| view.map(|i| p[i])).collect();
        let style = figure::Stroke::new(stroke.width, stroke.color);
        panel.curve(drawing, &points, style);
    }
    for (mark, color) in marks {
        drawing.disc(panel.position(view.map(|i| mark[i])), 7.0, *color);
    }
    panel.draw(drawing, Some(&names[0]), &names[1]);
}

/// Pixels per meter of views arranged below each other (`along` 0) or next to each other (1).
fn scale(lengths: &[[f64; 2]], along: usize, space: [f64; 2]) -> f64 {
    let margins = [MARGINS[0] + MARGINS[1], MARGINS[2] + MARGINS[3]];
    let count = lengths.len() as f64;
    // In the direction of the arrangement lengths add up, across it the largest determines.
    let (sum, across) = (1 - along, along);
    let total: f64 = lengths.iter().map(|length| length[sum]).sum();
    let largest = lengths
        .iter()
        .map(|length| length[across])
        .fold(0.0, f64::max);
    let of_sum = (space[sum] - count * margins[sum]) / total;
    let of_largest = (space[across] - margins[across]) / largest;
    of_sum.min(of_largest).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(lengths: [f64; 3]) -> Extent {
        Extent {
            low: Vector3::zeros(),
            high: Vector3::from(lengths),
        }
    }

    #[test]
    fn the_views_that_matter_are_chosen() {
        assert_eq!(extent([10.0, 0.0, 1.0]).views(), [[0, 2]]);
        assert_eq!(extent([10.0, 0.5, 1.0]).views(), [[0, 2], [0, 1]]);
        assert_eq!(extent([1.0, 0.5, 10.0]).views(), [[0, 2], [1, 2]]);
        assert_eq!(extent([8.0, 9.0, 7.0]).views(), [[0, 1], [1, 2], [0, 2]]);
        assert_eq!(extent([0.0; 3]).views(), [[0, 1]]);
    }

    // A long blade has its views below each other, a tower next to each other.
    #[test]
    fn scales_are_equal_and_as_large_as_possible() {
        for (lengths, beside) in [([50.0, 4.0, 8.0], false), ([4.0, 8.0, 50.0], true)] {
            let found = Arrangement::new(&extent(lengths), [1800.0, 1500.0]);
            let [first, second] = [found.panels[0].1, found.panels[1].1];
            assert_eq!(second.left > first.right, beside);
            let scales = [first, second].map(|panel| {
                let [a, b] = [panel.x, panel.y].map(|[low, high]| high - low);
                [
                    (panel.right - panel.left) / a,
                    (panel.bottom - panel.top) / b,
                ]
            });
            for scale in scales.into_iter().flatten() {
                assert!((scale / scales[0][0] - 1.0).abs() < 1e-12);
            }
            assert!(found.size[0] <= 1800.001 && found.size[1] <= 1500.001);
        }
    }
}
