//! The contour over its true arc length.
//!
//! The points become a cubic spline over the length u of their polygon, and the arc
//! length is the integral of its speed,
//!
//! ```text
//! s(u) = b/2 + int |dP/du| du,    0 <= s <= P,
//! ```
//!
//! with b the length of the flat base, whose middle is s = 0 and s = P.

use shared_geom::quadrature;
use shared_geom::spline::Spline;

use super::super::super::distance;
use super::problem::LayupProblem;

/// Points repeated at both ends of a smooth contour.
const OVERLAP: usize = 8;
/// Steps of the table of arc length.
const STEPS: usize = 3000;
/// A turn at the trailing edge is no corner below the first of these \[rad\], and below the second
/// \[rad\] or the third times the turns beside it [-].
const SMOOTH: [f64; 3] = [0.7, 0.035, 3.0];
/// Parts of the contour, from its ends, within which and at which distance points are kept.
const ROUNDING: [f64; 2] = [0.01, 1e-3];
/// Fewest points of a contour.
const LEAST: usize = 9;
/// Samples of a search along the contour.
const SAMPLES: usize = 400;

/// A contour over its arc length.
#[derive(Debug, Clone)]
pub struct Outline {
    y: Spline,
    z: Spline,
    /// First parameter of the table and its step.
    start: [f64; 2],
    /// Arc length at equal steps of the parameter.
    arcs: Vec<f64>,
    base: f64,
    perimeter: f64,
    is_smooth: bool,
    nose: f64,
    middle: [f64; 2],
}

impl Outline {
    /// The contour through points, from the trailing edge over the suction side to the nose and
    /// back.
    ///
    /// # Errors
    /// Points that are no contour.
    pub fn new(points: &[[f64; 2]]) -> Result<Self, LayupProblem> {
        let mut points = checked(points)?;
        let mut last = points.len() - 1;
        let length: f64 = points
            .windows(2)
            .map(|pair| distance(pair[0], pair[1]))
            .sum();
        let is_closed = distance(points[0], points[last]) < 1e-7 * length;
        if is_closed {
            points[last] = points[0];
        }
        let is_smooth = is_smooth(&points, is_closed);
        if !is_smooth {
            points = without_rounding(points, length);
            last = points.len() - 1;
        }
        let base = if is_smooth || is_closed {
            0.0
        } else {
            distance(points[0], points[last])
        };
        let middle = [0, 1].map(|i| 0.5 * (points[0][i] + points[last][i]));
        if is_smooth && is_closed {
            points.pop();
            last -= 1;
        }
        let overlap = if is_smooth { OVERLAP.min(last / 2) } else { 0 };
        let (along, [y, z]) = splines(&points, overlap);
        let end = overlap + last;
        let range = match (is_smooth, is_closed) {
            (false, _) => [along[0], along[last]],
            (true, true) => [along[overlap], along[end + 1]],
            (true, false) => {
                let half = 0.5 * (along[end + 1] - along[end]);
                [along[overlap] - half, along[end] + half]
            }
        };
        let mut outline = Self {
            y,
            z,
            start: [range[0], (range[1] - range[0]) / STEPS as f64],
            arcs: Vec::with_capacity(STEPS + 1),
            base,
            perimeter: 0.0,
            is_smooth,
            nose: 0.0,
            middle,
        };
        outline.measure();
        Ok(outline)
    }

    /// Fills the table of arc length, and finds the nose.
    fn measure(&mut self) {
        let [start, step] = self.start;
        self.arcs.push(0.5 * self.base);
        for i in 0..STEPS {
            let from = start + step * i as f64;
            let next = self.arcs[i] + self.length(from, from + step);
            self.arcs.push(next);
        }
        self.perimeter = self.arcs[STEPS] + 0.5 * self.base;
        self.nose = self.farthest(|point| distance(point, self.middle));
    }

    /// The arc length at which a measure of points is largest, by golden section around the best
    /// of samples.
    fn farthest(&self, measure: impl Fn([f64; 2]) -> f64) -> f64 {
        let far = |s: f64| measure(self.position(s));
        let at = |i: usize| self.perimeter * i as f64 / SAMPLES as f64;
        let best = (1..SAMPLES).max_by(|a, b| far(at(*a)).total_cmp(&far(at(*b))));
        let best = best.unwrap_or(SAMPLES / 2);
        let (mut a, mut b) = (at(best - 1), at(best + 1));
        for _ in 0..60 {
            let [left, right] = [a + 0.381_966 * (b - a), a + 0.618_034 * (b - a)];
            if far(left) > far(right) {
                b = right;
            } else {
                a = left;
            }
        }
        0.5 * (a + b)
    }

    /// Length of the spline between two parameters.
    fn length(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * (to - from);
        let points = quadrature::line(3).iter();
        points
            .map(|(xi, weight)| half * weight * self.speed(from + half * (1.0 + xi)))
            .sum()
    }

    fn speed(&self, u: f64) -> f64 {
        let i = self.y.interval(u);
        self.y.slope(i, u).hypot(self.z.slope(i, u))
    }

    /// Parameter of the spline at an arc length.
    fn parameter(&self, s: f64) -> f64 {
        let after = self.arcs.partition_point(|arc| *arc <= s).clamp(1, STEPS);
        let (low, high) = (self.arcs[after - 1], self.arcs[after]);
        let from = self.start[0] + self.start[1] * (after - 1) as f64;
        let mut u = from + self.start[1] * (s - low) / (high - low).max(f64::MIN_POSITIVE);
        for _ in 0..2 {
            u -= (low + self.length(from, u) - s) / self.speed(u);
        }
        u
    }

    /// Length with the base.
    pub fn perimeter(&self) -> f64 {
        self.perimeter
    }

    /// Length of the base.
    pub fn base(&self) -> f64 {
        self.base
    }

    /// Whether there is no corner.
    pub fn is_smooth(&self) -> bool {
        self.is_smooth
    }

    /// Arc length at the nose: the point farthest from the middle of the trailing edge.
    pub fn nose(&self) -> f64 {
        self.nose
    }

    /// Middle of the trailing edge.
    pub fn middle(&self) -> [f64; 2] {
        self.middle
    }

    /// Arc lengths of the corners of the trailing edge, on the suction and the pressure side.
    pub fn corners(&self) -> [f64; 2] {
        [0.5 * self.base, self.perimeter - 0.5 * self.base]
    }

    /// The part of the base at an arc length, from its middle: -1 to 1; `None` elsewhere.
    fn on_base(&self, s: f64) -> Option<f64> {
        let half = 0.5 * self.base;
        if s < half {
            return Some(s / half);
        }
        (s > self.perimeter - half).then(|| (s - self.perimeter) / half)
    }

    /// The arc length on a side, 0 suction, 1 pressure, at a coordinate y: the foremost one.
    pub fn at_y(&self, side: usize, y: f64) -> Option<f64> {
        self.first_behind(side, |point| point[0] > y)
    }

    /// The arc length on a side, 0 suction, 1 pressure, of the foremost point at which the
    /// statement `ahead` about points changes.
    pub fn first_behind(&self, side: usize, ahead: impl Fn([f64; 2]) -> bool) -> Option<f64> {
        let (nose, end) = (self.nose, self.corners()[side]);
        let at = |i: usize| nose + (end - nose) * i as f64 / SAMPLES as f64;
        let ahead = |s: f64| ahead(self.position(s));
        let first = (1..=SAMPLES).find(|i| ahead(at(i - 1)) != ahead(at(*i)))?;
        let (mut fore, mut aft) = (at(first - 1), at(first));
        let is_ahead = ahead(fore);
        for _ in 0..60 {
            let middle = 0.5 * (fore + aft);
            if ahead(middle) == is_ahead {
                fore = middle;
            } else {
                aft = middle;
            }
        }
        Some(0.5 * (fore + aft))
    }

    /// Arc length of the foremost point: the largest y.
    pub fn foremost(&self) -> f64 {
        self.farthest(|point| point[0])
    }

    /// The point at an arc length.
    pub fn position(&self, s: f64) -> [f64; 2] {
        if let Some(part) = self.on_base(s) {
            let values = [self.y.values(), self.z.values()];
            let ends = values.map(|values| [values[0], values[values.len() - 1]]);
            return [0, 1].map(|i| self.middle[i] + 0.5 * part * (ends[i][0] - ends[i][1]));
        }
        let u = self.parameter(s);
        let i = self.y.interval(u);
        [self.y.value(i, u), self.z.value(i, u)]
    }

    /// Unit normal into the section; at a corner the normal of the side.
    pub fn inward(&self, s: f64) -> [f64; 2] {
        if self.on_base(s).is_some() {
            return self.base_inward();
        }
        let u = self.parameter(s);
        let i = self.y.interval(u);
        let [y, z] = [self.y.slope(i, u), self.z.slope(i, u)];
        let length = y.hypot(z);
        [z / length, -y / length]
    }

    /// Unit normal of the base into the section.
    pub fn base_inward(&self) -> [f64; 2] {
        let values = [self.y.values(), self.z.values()];
        let [y, z] = values.map(|values| values[0] - values[values.len() - 1]);
        let length = y.hypot(z).max(f64::MIN_POSITIVE);
        [z / length, -y / length]
    }

    /// Curvature, positive if the section is convex.
    pub fn bend(&self, s: f64) -> f64 {
        if self.on_base(s).is_some() {
            return 0.0;
        }
        let u = self.parameter(s);
        let i = self.y.interval(u);
        let [y, z] = [self.y.slope(i, u), self.z.slope(i, u)];
        let [ddy, ddz] = [self.y.bend(i, u), self.z.bend(i, u)];
        (ddy * z - ddz * y) / y.hypot(z).powi(3)
    }
}

/// The length of the polygon and the splines of both coordinates through points, of which
/// `overlap` are repeated at both ends.
fn splines(points: &[[f64; 2]], overlap: usize) -> (Vec<f64>, [Spline; 2]) {
    let ring = [
        &points[points.len() - overlap..],
        points,
        &points[..overlap],
    ]
    .concat();
    let mut along = vec![0.0];
    for pair in ring.windows(2) {
        along.push(along[along.len() - 1] + distance(pair[0], pair[1]));
    }
    let of = |i: usize| {
        let values: Vec<f64> = ring.iter().map(|point| point[i]).collect();
        Spline::new(&along, &values)
    };
    let splines = [of(0), of(1)];
    (along, splines)
}

/// Points without those that round the corners of a trailing edge: near both ends only points
/// at some distance from the one before are kept. Walls are mitred at sharp corners.
fn without_rounding(points: Vec<[f64; 2]>, length: f64) -> Vec<[f64; 2]> {
    let one_end = |points: Vec<[f64; 2]>| {
        let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
        let (mut along, mut before) = (0.0, points[0]);
        for point in points {
            along += distance(before, point);
            before = point;
            let is_apart = |last: &[f64; 2]| distance(*last, point) > ROUNDING[1] * length;
            if along > ROUNDING[0] * length || kept.last().is_none_or(is_apart) {
                kept.push(point);
            }
        }
        kept.reverse();
        kept
    };
    one_end(one_end(points))
}

/// Points without doubled ones; refuses lists that are no contour.
fn checked(points: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, LayupProblem> {
    let wrong = |why: String| Err(LayupProblem::Contour { why });
    if let Some(index) = points
        .iter()
        .position(|p| !(p[0].is_finite() && p[1].is_finite()))
    {
        return wrong(format!("has no number in row {}", index + 1));
    }
    let mut distinct: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    let size: f64 = points
        .windows(2)
        .map(|pair| distance(pair[0], pair[1]))
        .sum();
    for point in points {
        let is_new = distinct
            .last()
            .is_none_or(|last| distance(*last, *point) > 1e-9 * size);
        if is_new {
            distinct.push(*point);
        }
    }
    if distinct.len() < LEAST {
        return wrong(format!(
            "has {} points, expected {LEAST} or more",
            distinct.len()
        ));
    }
    let around = || distinct.iter().zip(distinct.iter().cycle().skip(1));
    let area: f64 = around().map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    if area >= 0.0 {
        let why = "runs counterclockwise, expected from the trailing edge over the suction side";
        return wrong(why.into());
    }
    if let Some([a, b]) = crossing(&distinct) {
        return wrong(format!(
            "crosses itself between rows {} and {}",
            a + 1,
            b + 1
        ));
    }
    Ok(distinct)
}

/// Two lines of a polygon that cross: the numbers of their first points. The first and the last
/// line may share a point.
fn crossing(points: &[[f64; 2]]) -> Option<[usize; 2]> {
    let side = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let last = points.len() - 2;
    for (i, one) in points.windows(2).enumerate() {
        for (j, other) in points.windows(2).enumerate().skip(i + 2) {
            let crosses = side(one[0], one[1], other[0]) * side(one[0], one[1], other[1]) < 0.0
                && side(other[0], other[1], one[0]) * side(other[0], other[1], one[1]) < 0.0;
            let is_end =
                i == 0 && j == last && distance(one[0], other[1]) < 1e-3 * distance(one[0], one[1]);
            if crosses && !is_end {
                return Some([i, j]);
            }
        }
    }
    None
}

/// Whether the ends of the points are no corners: the direction changes there about as much as
/// beside them.
fn is_smooth(points: &[[f64; 2]], is_closed: bool) -> bool {
    let last = points.len() - 1;
    let line = |a: usize, b: usize| [0, 1].map(|i| points[b][i] - points[a][i]);
    let angle = |a: [f64; 2], b: [f64; 2]| {
        let (sine, cosine) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        sine.atan2(cosine).abs()
    };
    let [first, end] = [line(0, 1), line(last - 1, last)];
    let base = line(last, 0);
    let turn = match is_closed {
        true => angle(end, first),
        false => angle(end, base).max(angle(base, first)),
    };
    let beside = angle(first, line(1, 2)).max(angle(line(last - 2, last - 1), end));
    turn < SMOOTH[0] && turn < SMOOTH[1].max(SMOOTH[2] * beside)
}
