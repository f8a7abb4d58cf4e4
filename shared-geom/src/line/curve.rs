//! A line prepared for queries: splines fitted, arc lengths summed.

use nalgebra::Vector3;

use super::arc::{self, Frame};
use super::axes::level_axes;
use super::{Course, LinePoint, Placed, ReferenceLine, Side, about_x};
use crate::quadrature;
use crate::spline::Spline;

/// Points of the Gauss rule for the length of a spline.
const RULE: usize = 6;
/// Most bisections of an interval of a spline: with an error that falls by 2^12 each
/// time, four or five suffice for any line of a blade.
const MOST_HALVES: u32 = 12;
/// Relative difference of lengths that is treated as round-off.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;
/// Steps of the search for an abscissa; bisection alone needs some 60.
const MOST_STEPS: usize = 100;

/// A reference line prepared for queries.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Arc lengths of the points.
    arc_lengths: Vec<f64>,
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Polyline(Vec<LinePoint>),
    Spline(Splines),
    Arcs {
        frames: Vec<Frame>,
        curvature: Vec<Vector3<f64>>,
        twist: Vec<f64>,
    },
}

#[derive(Debug, Clone, PartialEq)]
struct Splines {
    x: Vec<f64>,
    y: Spline,
    z: Spline,
    twist: Spline,
}

impl Curve {
    pub(super) fn new(line: &ReferenceLine) -> Self {
        let points = &line.points;
        let (lengths, shape): (Vec<f64>, _) = match line.course {
            Course::Polyline => {
                let distance = |pair: &[LinePoint]| (pair[1].position - pair[0].position).norm();
                let lengths = points.windows(2).map(distance).collect();
                (lengths, Shape::Polyline(points.clone()))
            }
            Course::Spline => {
                let splines = Splines::new(points);
                let intervals = points.len().saturating_sub(1);
                let lengths = (0..intervals).map(|i| splines.whole(i)).collect();
                (lengths, Shape::Spline(splines))
            }
            Course::Arcs => {
                // The number of entries that all lists have: see
                // `ReferenceLine::problems`.
                let arcs = line.arc_length.iter().zip(&line.curvature).zip(points);
                let lengths = arcs.clone().map(|((length, _), _)| *length).collect();
                let shape = Shape::Arcs {
                    frames: arc::frames(line),
                    curvature: line.curvature.clone(),
                    twist: arcs.map(|(_, point)| point.twist).collect(),
                };
                (lengths, shape)
            }
        };
        Self {
            arc_lengths: sums(&lengths),
            shape,
        }
    }

    /// Length of the line along itself, to round-off [m].
    pub fn length(&self) -> f64 {
        self.arc_lengths.last().copied().unwrap_or(0.0)
    }

    /// Arc lengths of the points from the first [m].
    pub fn arc_lengths(&self) -> &[f64] {
        &self.arc_lengths
    }

    /// The position at arc length `s` [m]; of two pieces that meet there, on the outer
    /// one.
    ///
    /// Beyond an end the last piece is continued. For a line without length it is the
    /// origin.
    pub fn at(&self, s: f64) -> Placed {
        self.on(s, Side::Outer)
    }

    /// As [`Curve::at`], and of two pieces that meet at `s` on the one of `side`: at a
    /// kink of a line of straight pieces the section axes differ.
    pub fn on(&self, s: f64, side: Side) -> Placed {
        let known = &self.arc_lengths;
        let behind = match side {
            Side::Inner => known.partition_point(|point| *point < s),
            Side::Outer => known.partition_point(|point| *point <= s),
        };
        let Some(last) = known.len().checked_sub(2) else {
            return placed(Vector3::zeros(), Vector3::x(), 0.0);
        };
        let i = behind.saturating_sub(1).min(last);
        let part = s - known[i];
        match &self.shape {
            Shape::Polyline(points) => {
                let length = known[i + 1] - known[i];
                on_piece(&points[i], &points[i + 1], part, length)
            }
            Shape::Spline(splines) => splines.at(i, part),
            Shape::Arcs {
                frames,
                curvature,
                twist,
            } => {
                let (position, axes) = arc::along(&frames[i], &curvature[i], part);
                let expected = twist[i] + curvature[i].x * part;
                Placed {
                    position,
                    axes,
                    twist: arc::twist_near(&axes, expected),
                    tangent: axes.column(0).into_owned(),
                }
            }
        }
    }
}

fn on_piece(from: &LinePoint, to: &LinePoint, part: f64, length: f64) -> Placed {
    let along = to.position - from.position;
    let fraction = part / length;
    placed(
        from.position + along * fraction,
        along,
        from.twist + (to.twist - from.twist) * fraction,
    )
}

/// Position with the axes of the rule at the head of [`super`].
fn placed(position: Vector3<f64>, along: Vector3<f64>, twist: f64) -> Placed {
    let axes = level_axes(&along) * about_x(twist);
    Placed {
        position,
        axes,
        twist,
        tangent: axes.column(0).into_owned(),
    }
}

impl Splines {
    fn new(points: &[LinePoint]) -> Self {
        let list = |of: fn(&LinePoint) -> f64| -> Vec<f64> { points.iter().map(of).collect() };
        let x = list(|point| point.position.x);
        let spline = |of| Spline::new(&x, &list(of));
        Self {
            y: spline(|point| point.position.y),
            z: spline(|point| point.position.z),
            twist: spline(|point| point.twist),
            x,
        }
    }

    fn along(&self, i: usize, x: f64) -> Vector3<f64> {
        Vector3::new(1.0, self.y.slope(i, x), self.z.slope(i, x))
    }

    /// Length of the interval `i`.
    fn whole(&self, i: usize) -> f64 {
        self.length(i, self.x[i], self.x[i + 1])
    }

    /// Length between two abscissas of the interval `i`: Gauss's rule on repeated
    /// bisections, until convergence.
    fn length(&self, i: usize, from: f64, to: f64) -> f64 {
        self.refined(i, from, to, self.gauss(i, from, to), MOST_HALVES)
    }

    fn refined(&self, i: usize, from: f64, to: f64, whole: f64, halves: u32) -> f64 {
        let middle = 0.5 * (from + to);
        let parts = [self.gauss(i, from, middle), self.gauss(i, middle, to)];
        let sum = parts[0] + parts[1];
        let goes_on = halves > 0 && (sum - whole).abs() > ROUND_OFF * sum.abs();
        if !goes_on {
            return sum;
        }
        self.refined(i, from, middle, parts[0], halves - 1)
            + self.refined(i, middle, to, parts[1], halves - 1)
    }

    fn gauss(&self, i: usize, from: f64, to: f64) -> f64 {
        let half = 0.5 * (to - from);
        let middle = 0.5 * (to + from);
        let term =
            |&(point, weight): &(f64, f64)| weight * self.along(i, middle + half * point).norm();
        half * quadrature::line(RULE).iter().map(term).sum::<f64>()
    }

    /// The position at `part` of the length of the interval `i`: Newton's method on the
    /// abscissa, within bounds that are narrowed.
    fn at(&self, i: usize, part: f64) -> Placed {
        let (start, end) = (self.x[i], self.x[i + 1]);
        let mut x = start + part / self.along(i, start).norm();
        let mut bounds = (start, end);
        for _ in 0..MOST_STEPS {
            if part >= 0.0 && !(bounds.0..=bounds.1).contains(&x) {
                x = 0.5 * (bounds.0 + bounds.1);
            }
            let over = self.length(i, start, x) - part;
            if over > 0.0 {
                bounds.1 = x
            } else {
                bounds.0 = x
            }
            let next = x - over / self.along(i, x).norm();
            let moves = (next - x).abs() > ROUND_OFF * end.abs().max(start.abs());
            x = next;
            if !moves {
                break;
            }
        }
        let position = Vector3::new(x, self.y.value(i, x), self.z.value(i, x));
        placed(position, self.along(i, x), self.twist.value(i, x))
    }
}

/// Zero, and the sums of the first, the first two, ...
fn sums(lengths: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut sums = vec![0.0];
    for length in lengths {
        sum += length;
        sums.push(sum);
    }
    sums
}
