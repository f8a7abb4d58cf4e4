//! The plane of the section on a figure: equal scales along y and z, axes with
//! ticks and units.

use shared_geom::figure::{Axes, Drawing, tick_label};

use crate::input::InputSummary;

/// The unit in which a section is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlotUnit {
    pub name: String,
    /// Size of the unit [m].
    pub meters: f64,
}

impl PlotUnit {
    /// The declared unit of length; millimeters for a section below a meter that is
    /// declared in meters.
    pub fn of(summary: &InputSummary, size: f64) -> Self {
        if summary.length_unit == "m" && size < 0.5 {
            return Self {
                name: "mm".to_owned(),
                meters: 1e-3,
            };
        }
        Self {
            name: summary.length_unit.clone(),
            meters: summary.length_factor,
        }
    }

    /// A coordinate to a ten-thousandth of a section of `size` [m], in this unit.
    pub fn shown(&self, value: f64, size: f64) -> String {
        let digit = 10_f64.powf((1e-4 * size / self.meters).log10().floor());
        let value = (value / self.meters / digit).round() * digit;
        tick_label(value, size / self.meters)
    }
}

/// A box around points of the plane [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extent {
    pub low: [f64; 2],
    pub high: [f64; 2],
}

impl Extent {
    /// The box of these points; a unit box around the origin without points.
    pub fn of(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut extent = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for point in points {
            extent.include(point);
        }
        let is_sound = (0..2).all(|axis| extent.size(axis) >= 0.0 && extent.size(axis).is_finite());
        if is_sound && extent.largest() > 0.0 {
            extent
        } else {
            Self {
                low: [-0.5; 2],
                high: [0.5; 2],
            }
        }
    }

    pub fn include(&mut self, point: [f64; 2]) {
        for axis in 0..2 {
            self.low[axis] = self.low[axis].min(point[axis]);
            self.high[axis] = self.high[axis].max(point[axis]);
        }
    }

    /// Whether the point lies in the box.
    pub fn holds(&self, point: [f64; 2]) -> bool {
        (0..2).all(|axis| (self.low[axis]..=self.high[axis]).contains(&point[axis]))
    }

    /// Length along one axis [m].
    pub fn size(&self, axis: usize) -> f64 {
        self.high[axis] - self.low[axis]
    }

    pub fn largest(&self) -> f64 {
        self.size(0).max(self.size(1))
    }

    /// The box enlarged by `margin` on every side [m].
    pub fn grown(self, margin: f64) -> Self {
        Self {
            low: self.low.map(|value| value - margin),
            high: self.high.map(|value| value + margin),
        }
    }
}

/// A frame on the figure, and the part of the plane that it shows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plane {
    /// Left and upper edge of the frame [figure pixels].
    pub corner: [f64; 2],
    /// Width and height of the frame [figure pixels].
    pub frame: [f64; 2],
    /// Scale [figure pixels per meter].
    pub scale: f64,
    extent: Extent,
}

impl Plane {
    /// The largest frame for `extent` within the space `space` (width, height) whose upper
    /// left corner is `corner`, centered horizontally.
    pub fn fitted(extent: Extent, corner: [f64; 2], space: [f64; 2]) -> Self {
        let scale = (space[0] / extent.size(0)).min(space[1] / extent.size(1));
        let frame = [0, 1].map(|axis| scale * extent.size(axis));
        Self {
            corner: [corner[0] + 0.5 * (space[0] - frame[0]), corner[1]],
            frame,
            scale,
            extent,
        }
    }

    /// Position of a point (y, z) of the section on the figure.
    pub fn position(&self, [y, z]: [f64; 2]) -> [f64; 2] {
        [
            self.corner[0] + self.scale * (y - self.extent.low[0]),
            self.corner[1] + self.scale * (self.extent.high[1] - z),
        ]
    }

    /// Whether the point lies within the frame.
    pub fn shows(&self, point: [f64; 2]) -> bool {
        self.extent.holds(point)
    }

    /// Draws frame, grid, ticks and names of the axes; before the content.
    pub fn draw_axes(&self, drawing: &mut Drawing, unit: &PlotUnit) {
        let [left, top] = self.corner;
        let ends = |axis: usize| {
            [self.extent.low[axis], self.extent.high[axis]].map(|end| end / unit.meters)
        };
        let axes = Axes {
            left,
            right: left + self.frame[0],
            top,
            bottom: top + self.frame[1],
            x: ends(0),
            y: ends(1),
        };
        axes.draw_grid(drawing);
        let [y, z] = ["y", "z"].map(|name| format!("{name} [{}]", unit.name));
        axes.draw(drawing, Some(&y), &z);
    }
}
