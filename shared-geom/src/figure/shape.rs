//! The primitives of a drawing, in figure pixels.

use super::color::{BLACK, Color};
use super::shade::{ColorTable, ValueTriangle};

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
    /// Size of the font \[figure pixels, unit of the drawing\].
    pub size: f64,
    /// Part of the text that is at the given position.
    pub anchor: Anchor,
    /// Whether the text runs upward.
    pub upward: bool,
    /// Whether the letters are bold.
    pub bold: bool,
    /// Color of the letters.
    pub color: Color,
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
    pub fn colored(self, color: Color) -> Self {
        Self { color, ..self }
    }
}

/// A recorded primitive; lengths and positions in figure pixels.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// A filled polygon.
    Polygon {
        corners: Vec<[f64; 2]>,
        color: Color,
    },
    /// Filled polygons of one color, and the straight pieces of the border of all, with the
    /// polygons on the same hand.
    Region {
        polygons: Vec<Vec<[f64; 2]>>,
        border: Vec<[[f64; 2]; 2]>,
        color: Color,
    },
    /// A line through points.
    Line {
        points: Vec<[f64; 2]>,
        width: f64,
        color: Color,
    },
    /// Triangles in the colors of their values.
    Values {
        triangles: Vec<ValueTriangle>,
        colors: ColorTable,
    },
    /// A text.
    Text {
        text: String,
        position: [f64; 2],
        label: Label,
    },
}

/// Bounds of no points.
const NOWHERE: [f64; 4] = [
    f64::INFINITY,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NEG_INFINITY,
];

impl Shape {
    /// Whether it is a text.
    pub fn is_text(&self) -> bool {
        matches!(self, Self::Text { .. })
    }

    /// The smallest and the largest coordinates of all but texts: x, y, x, y \[figure pixels\].
    pub fn bounds(&self) -> [f64; 4] {
        let around = |points: &mut dyn Iterator<Item = [f64; 2]>, width: f64| {
            points.fold(NOWHERE, |[left, top, right, bottom], [x, y]| {
                [
                    left.min(x - width),
                    top.min(y - width),
                    right.max(x + width),
                    bottom.max(y + width),
                ]
            })
        };
        match self {
            Self::Polygon { corners, .. } => around(&mut corners.iter().copied(), 0.0),
            Self::Region { polygons, .. } => around(&mut polygons.iter().flatten().copied(), 0.0),
            Self::Line { points, width, .. } => around(&mut points.iter().copied(), *width),
            Self::Values { triangles, .. } => {
                around(&mut triangles.iter().flat_map(|one| one.corners), 0.0)
            }
            Self::Text { .. } => NOWHERE,
        }
    }

    /// Number of polygons and lines that it has in a vector format; zero for a text.
    pub fn pieces(&self) -> usize {
        match self {
            Self::Polygon { .. } | Self::Line { .. } => 1,
            Self::Region { polygons, .. } => polygons.len(),
            Self::Values { triangles, .. } => triangles.len(),
            Self::Text { .. } => 0,
        }
    }
}
