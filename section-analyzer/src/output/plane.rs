//! The plane of the section on a figure: equal scales along y and z, axes with
//! ticks and units.

use shared_geom::figure::{Anchor, Color, Drawing, Label, TEXT, Ticks, text_width, tick_label};

use crate::input::InputSummary;

/// Color of frames and ticks.
pub(super) const INK: Color = Color(40, 40, 40);
/// Color of the lines across the plot at the ticks.
const GRID: Color = Color(226, 226, 226);
/// Length of a tick mark [figure pixels].
const TICK: f64 = 10.0;

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
        let (right, bottom) = (left + self.frame[0], top + self.frame[1]);
        let label = Label::new(0.88 * TEXT).colored(INK);

        for (tick, text) in self.ticks(0, unit).labeled() {
            let [x, _] = self.position([tick * unit.meters, 0.0]);
            drawing.line(&[[x, top], [x, bottom]], 1.0, GRID);
            drawing.line(&[[x, bottom], [x, bottom + TICK]], 2.0, INK);
            let position = [x, bottom + TICK + 0.7 * TEXT];
            drawing.text(&text, position, label.anchored(Anchor::Middle));
        }
        let mut widest = 0.0_f64;
        for (tick, text) in self.ticks(1, unit).labeled() {
            let [_, y] = self.position([0.0, tick * unit.meters]);
            drawing.line(&[[left, y], [right, y]], 1.0, GRID);
            drawing.line(&[[left - TICK, y], [left, y]], 2.0, INK);
            let position = [left - 1.8 * TICK, y];
            drawing.text(&text, position, label.anchored(Anchor::End));
            widest = widest.max(text_width(&text, Label::new(label.size)));
        }
        let corners = [
            [left, top],
            [right, top],
            [right, bottom],
            [left, bottom],
            [left, top],
        ];
        drawing.line(&corners, 2.0, INK);

        let name = Label::new(TEXT).colored(INK).anchored(Anchor::Middle);
        let below = [0.5 * (left + right), bottom + TICK + 2.0 * TEXT];
        drawing.text(&format!("y [{}]", unit.name), below, name);
        let beside = [
            left - 2.8 * TICK - widest - 0.5 * TEXT,
            0.5 * (top + bottom),
        ];
        drawing.text(&format!("z [{}]", unit.name), beside, name.upward());
    }

    /// Ticks as close as their labels allow.
    fn ticks(&self, axis: usize, unit: &PlotUnit) -> Ticks {
        let space = if axis == 0 { 170.0 } else { 75.0 };
        let count = (self.frame[axis] / space).floor().clamp(2.0, 12.0) as usize;
        let [low, high] = [self.extent.low, self.extent.high].map(|end| end[axis] / unit.meters);
        Ticks::between(low, high, count)
    }
}
