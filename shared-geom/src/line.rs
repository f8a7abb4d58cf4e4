//! Reference lines of blades: place, arc length and section axes along a curve in
//! space.
//!
//! In the root axes of the blade (x outward along the span, y toward the leading edge,
//! z toward the upper surface) a section at a point of the line with tangent t, and
//! its twist beta, nose up, has the axes
//!
//! ```text
//! y_0 = z x t / |z x t|       z_0 = t x y_0        Q = [t y_0 z_0] Rx(beta)
//! ```
//!
//! so that before twist the chord lies in the plane of rotation wherever the line leads.

use nalgebra::Vector3;

/// How the line runs between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Course {
    /// Straight from point to point; twist linear in arc length.
    Polyline,
    /// Natural cubic splines of y, z and twist over x.
    Spline,
}

/// A point of a line as it was given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Place in root axes [m].
    pub position: Vector3<f64>,
    /// Twist, positive nose up [rad].
    pub twist: f64,
}

/// The reference line of a blade, from the root outward.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceLine {
    /// The points through which it runs.
    pub points: Vec<LinePoint>,
    /// Its course between them.
    pub course: Course,
}
