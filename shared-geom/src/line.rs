//! Reference lines of blades: position, arc length and section axes along a curve in
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
//! so that before twist the chord is in the plane of rotation for any direction of the
//! line. The axes of a line given by its curvature follow from it (see [`Course::Arcs`]).
//!
//! Repeated queries of a line use its [`Curve`], which is prepared once.
//!
//! # Example
//!
//! ```
//! use nalgebra::Vector3;
//! use shared_geom::line::{LinePoint, ReferenceLine};
//!
//! // a quarter of a circle of 2 m radius: constant curvature about z
//! let root = LinePoint { position: Vector3::zeros(), twist: 0.0 };
//! let quarter = std::f64::consts::PI;
//! let line = ReferenceLine::curved(root, &[(quarter, Vector3::new(0.0, 0.0, 0.5))]);
//! let tip = line.at(quarter);
//! assert!((tip.position - Vector3::new(2.0, 2.0, 0.0)).norm() < 1e-12);
//! assert!((tip.tangent - Vector3::y()).norm() < 1e-12);
//! ```

use nalgebra::{Matrix3, Vector3};

mod arc;
mod axes;
mod curvature;
mod curve;
mod problem;

pub use curve::Curve;
pub use problem::LineProblem;

/// The interpolation of the line between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Course {
    /// Straight from point to point; twist linear in arc length.
    Polyline,
    /// Natural cubic splines of y, z and twist over x.
    Spline,
    /// Constant curvature and twist rate from point to point: `dQ/ds = Q [k]x`. The
    /// line begins along x with the twist of its first point; the other points follow.
    Arcs,
}

/// A given point of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Position in root axes [m].
    pub position: Vector3<f64>,
    /// Twist, positive nose up [rad].
    pub twist: f64,
}

/// The reference line of a blade, from the root outward.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceLine {
    /// The points through which it runs.
    pub points: Vec<LinePoint>,
    /// The interpolation between them.
    pub course: Course,
    /// Of a line of arcs, one for each: twist rate about x and curvature about y and z
    /// in section axes [1/m]. Empty for other lines.
    pub curvature: Vec<Vector3<f64>>,
    /// Of a line of arcs, the length of each [m]. Empty for other lines.
    pub arc_length: Vec<f64>,
}

/// Side of a position on the line, seen from the root.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Toward the root.
    Inner,
    /// Toward the tip.
    Outer,
}

/// A position on a line, with its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Position in root axes [m].
    pub position: Vector3<f64>,
    /// Section axes (columns) in root axes, twist included [-].
    pub axes: Matrix3<f64>,
    /// Twist, positive nose up [rad].
    pub twist: f64,
    /// Unit vector along the line, outward: the first of the axes [-].
    pub tangent: Vector3<f64>,
}

impl ReferenceLine {
    /// A line through `points`, straight or splined between them.
    pub fn through(points: Vec<LinePoint>, course: Course) -> Self {
        Self {
            points,
            course,
            curvature: Vec::new(),
            arc_length: Vec::new(),
        }
    }

    /// A straight line of `length` [m] along x, without twist.
    pub fn straight(length: f64) -> Self {
        let point = |x| LinePoint {
            position: Vector3::new(x, 0.0, 0.0),
            twist: 0.0,
        };
        Self::through(vec![point(0.0), point(length)], Course::Polyline)
    }

    /// A line that begins at `root` along x and continues with arcs: the length of each
    /// [m], its twist rate about x and its curvature about y and z in section axes [1/m].
    pub fn curved(root: LinePoint, arcs: &[(f64, Vector3<f64>)]) -> Self {
        let mut line = Self {
            points: vec![root],
            course: Course::Arcs,
            curvature: arcs.iter().map(|arc| arc.1).collect(),
            arc_length: arcs.iter().map(|arc| arc.0).collect(),
        };
        line.points = arc::ends(&line);
        line
    }

    /// The line prepared for repeated queries.
    pub fn curve(&self) -> Curve {
        Curve::new(self)
    }

    /// Length of the line along itself, to round-off [m].
    pub fn length(&self) -> f64 {
        self.curve().length()
    }

    /// Arc lengths of its points from the first [m].
    pub fn arc_lengths(&self) -> Vec<f64> {
        self.curve().arc_lengths().to_vec()
    }

    /// The position at arc length `s` [m], as [`Curve::at`].
    pub fn at(&self, s: f64) -> Placed {
        self.curve().at(s)
    }

    /// The same line with its sections turned by `angle` about it, nose up [rad].
    pub fn twisted(&self, angle: f64) -> Self {
        let mut turned = self.clone();
        for point in &mut turned.points {
            point.twist += angle;
        }
        let back = about_x(angle).transpose();
        for curvature in &mut turned.curvature {
            *curvature = back * *curvature;
        }
        turned
    }
}

/// Rotation about x.
pub(crate) fn about_x(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

#[cfg(test)]
mod tests;
