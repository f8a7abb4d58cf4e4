//! The contour over its true arc length.
//!
//! The points become a cubic spline over the length u of their polygon, and the arc
//! length is the integral of its speed,
//!
//! ```text
//! s(u) = b/2 + int |dP/du| du,    0 <= s <= P,
//! ```
//!
//! with b the length of the flat base, whose middle is s = 0 and s = P. A point given twice is a
//! corner, at which one spline ends and the next one begins.

use shared_geom::quadrature;
use shared_geom::spline::Spline;

use super::super::super::distance;
use super::super::bisect::{bisect, zero};
use super::points::{checked, splines, without_rounding};
use super::polygon::is_smooth;
use super::problem::LayupProblem;

/// Points repeated at both ends of a smooth contour.
const OVERLAP: usize = 8;
/// Steps of the table of arc length.
const STEPS: usize = 3000;
/// Sum of the turns at both ends of a base below which the rear is round \[rad\]: 135 degrees; both
/// turns are 180 degrees if the sides are parallel.
const ROUND_BEHIND: f64 = 2.36;
/// Part of the contour within which the nose is at a corner.
const AT_CORNER: f64 = 1e-5;
/// Part of the contour by which equal distances differ.
const SAME: f64 = 1e-9;
/// Part of the contour around an estimate in which the nearest point is searched.
const AROUND: f64 = 0.01;
/// Samples of a search along the contour.
const SAMPLES: usize = 400;

/// A contour over its arc length.
#[derive(Debug, Clone)]
pub struct Outline {
    /// The pieces between the corners, over one parameter.
    pieces: Vec<[Spline; 2]>,
    /// The corners between them.
    corners: Vec<Corner>,
    /// First parameter of the table and its step.
    start: [f64; 2],
    /// Arc length at equal steps of the parameter.
    arcs: Vec<f64>,
    /// Piece and interval of the splines at these steps.
    intervals: Vec<[usize; 2]>,
    base: f64,
    perimeter: f64,
    is_smooth: bool,
    nose: f64,
    /// First and last point.
    rear: [[f64; 2]; 2],
}

/// A corner of the contour that is not at the trailing edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Its arc length [unit of the mesh].
    pub s: f64,
    /// Tangent of half the turn, positive if the section is convex [-].
    pub tangent: f64,
    /// The parameter of the splines.
    u: f64,
}

impl Outline {
    /// The contour through points, from the trailing edge over the suction side to the nose and
    /// back; a point given twice is a corner.
    ///
    /// # Errors
    /// Points that are no contour.
    pub fn new(points: &[[f64; 2]]) -> Result<Self, LayupProblem> {
        let [mut points, sharp] = checked(points)?;
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
        let rear = [points[0], points[last]];
        if is_smooth && is_closed {
            points.pop();
            last -= 1;
        }
        let overlap = if is_smooth { OVERLAP.min(last / 2) } else { 0 };
        let (along, pieces) = splines(&points, overlap, &sharp);
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
            pieces,
            corners: Vec::new(),
            start: [range[0], (range[1] - range[0]) / STEPS as f64],
            arcs: Vec::with_capacity(STEPS + 1),
            intervals: Vec::new(),
            base,
            perimeter: 0.0,
            is_smooth,
            nose: 0.0,
            rear,
        };
        outline.measure();
        Ok(outline)
    }

    /// Fills the table of arc length, and finds the nose.
    fn measure(&mut self) {
        let [start, step] = self.start;
        let at = |i: usize| self.interval(start + step * i as f64);
        self.intervals = (0..=STEPS).map(at).collect();
        self.arcs.push(0.5 * self.base);
        for i in 0..STEPS {
            let from = start + step * i as f64;
            let next = self.arcs[i] + self.length(from, from + step);
            self.arcs.push(next);
        }
        self.perimeter = self.arcs[STEPS] + 0.5 * self.base;
        self.corners = self.sharp();
        let middle = self.middle();
        let near = self.farthest(|point| distance(point, middle));
        // golden section finds the place of a maximum only to half of the digits
        let reach = AT_CORNER * self.perimeter;
        let away = |s: f64| {
            let (p, n) = (self.position(s), self.inward(s));
            (p[1] - middle[1]) * n[0] - (p[0] - middle[0]) * n[1]
        };
        self.nose = zero([near - reach, near + reach], away).unwrap_or(near);
        let near = |one: &&Corner| (one.s - self.nose).abs() < AT_CORNER * self.perimeter;
        if let Some(corner) = self.corners.iter().find(near) {
            self.nose = corner.s;
        }
    }

    /// The corners between the pieces.
    fn sharp(&self) -> Vec<Corner> {
        let corner = |pair: &[[Spline; 2]]| {
            let u = pair[1][0].positions()[0];
            let slope = |piece: &[Spline; 2]| piece.each_ref().map(|f| f.slope(f.interval(u), u));
            let [a, b] = [slope(&pair[0]), slope(&pair[1])];
            let (sine, cosine) = (a[1] * b[0] - a[0] * b[1], a[0] * b[0] + a[1] * b[1]);
            let index = ((u - self.start[0]) / self.start[1]).floor();
            let index = (index.max(0.0) as usize).min(STEPS - 1);
            let from = self.start[0] + self.start[1] * index as f64;
            Corner {
                s: self.arcs[index] + self.length(from, u),
                tangent: (0.5 * sine.atan2(cosine)).tan(),
                u,
            }
        };
        let end = self.start[0] + self.start[1] * STEPS as f64;
        let starts = |pair: &&[[Spline; 2]]| pair[1][0].positions()[0];
        // pieces may begin in the overlap of both ends
        let pairs = self.pieces.windows(2);
        let pairs = pairs.filter(|pair| starts(pair) > self.start[0] && starts(pair) < end);
        pairs.map(corner).collect()
    }

    /// The arc length at which a measure of points is largest, by golden section around the best
    /// of samples; of several equal places, as at a flat nose, the middle between the first and the last.
    fn farthest(&self, measure: impl Fn([f64; 2]) -> f64) -> f64 {
        let far = |s: f64| measure(self.position(s));
        let at = |i: usize| self.perimeter * i as f64 / SAMPLES as f64;
        let sizes: Vec<f64> = (0..=SAMPLES).map(|i| far(at(i))).collect();
        let best = (1..SAMPLES).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b]));
        let best = best.unwrap_or(SAMPLES / 2);
        let refined = |i: usize| self.between([at(i - 1), at(i + 1)], far);
        let place = refined(best);
        let most = far(place);
        let may_be = |i: &usize| {
            let is_peak = sizes[*i] >= sizes[i - 1] && sizes[*i] >= sizes[i + 1];
            is_peak && sizes[*i] > sizes[best] - at(1)
        };
        let is_equal = |s: &f64| far(*s) >= most - SAME * self.perimeter;
        let equal = || (1..SAMPLES).filter(may_be).map(refined);
        let first = equal().find(is_equal).unwrap_or(place);
        let last = equal().rev().find(is_equal).unwrap_or(place);
        if last - first > AT_CORNER * self.perimeter {
            0.5 * (first + last)
        } else {
            place
        }
    }

    /// The arc length of the point that is nearest to another one, near an estimate.
    pub fn nearest(&self, point: [f64; 2], near: f64) -> f64 {
        let reach = AROUND * self.perimeter;
        let [from, to] = self.corners();
        let range = [(near - reach).max(from), (near + reach).min(to)];
        self.between(range, |s| -distance(self.position(s), point))
    }

    /// The arc length between two others at which a measure is largest, by golden section.
    fn between(&self, [mut a, mut b]: [f64; 2], far: impl Fn(f64) -> f64) -> f64 {
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
        let [y, z] = self.slopes(u);
        y.hypot(z)
    }

    /// Index of the piece at a parameter, and the interval of its splines.
    fn interval(&self, u: f64) -> [usize; 2] {
        let after = |piece: &[Spline; 2]| piece[0].positions()[0] <= u;
        let index = self.pieces.partition_point(after).max(1) - 1;
        [index, self.pieces[index][0].interval(u)]
    }

    /// The splines at a parameter, and their interval: searched from the one of the step of the table
    /// before.
    fn piece(&self, u: f64) -> (&[Spline; 2], usize) {
        let step = ((u - self.start[0]) / self.start[1]) as usize;
        let [mut index, mut interval] = match step {
            0 => self.interval(u),
            _ => self.intervals[(step - 1).min(STEPS)],
        };
        while let Some(next) = self.pieces.get(index + 1)
            && next[0].positions()[0] <= u
        {
            (index, interval) = (index + 1, 0);
        }
        let piece = &self.pieces[index];
        let positions = piece[0].positions();
        while interval + 2 < positions.len() && positions[interval + 1] <= u {
            interval += 1;
        }
        (piece, interval)
    }

    fn slopes(&self, u: f64) -> [f64; 2] {
        let (piece, i) = self.piece(u);
        piece.each_ref().map(|f| f.slope(i, u))
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
        // round-off must not lead over a corner
        for corner in &self.corners {
            u = if s >= corner.s {
                u.max(corner.u)
            } else {
                u.min(corner.u.next_down())
            };
        }
        u
    }

    /// The corners that are not at the trailing edge, in their order.
    pub fn breaks(&self) -> &[Corner] {
        &self.corners
    }

    /// Length with the base.
    pub fn perimeter(&self) -> f64 {
        self.perimeter
    }

    /// Length of the base.
    pub fn base(&self) -> f64 {
        self.base
    }

    /// Whether there is no corner at the trailing edge.
    pub fn is_smooth(&self) -> bool {
        self.is_smooth
    }

    /// Arc length at the nose: the point farthest from the middle of the trailing edge, or the middle between
    /// such points.
    pub fn nose(&self) -> f64 {
        self.nose
    }

    /// Middle of the trailing edge.
    pub fn middle(&self) -> [f64; 2] {
        let [first, last] = self.rear;
        [0, 1].map(|i| 0.5 * (first[i] + last[i]))
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
        let ends = [at(first - 1), at(first)];
        Some(bisect(ends, ahead(ends[0]), ahead))
    }

    /// Arc length of the foremost point: the largest y.
    pub fn foremost(&self) -> f64 {
        let near = self.farthest(|point| point[0]);
        let reach = AT_CORNER * self.perimeter;
        let forward = |s: f64| self.inward(s)[1];
        zero([near - reach, near + reach], forward).unwrap_or(near)
    }

    /// The contour with its nose at the foremost point.
    pub fn with_foremost_nose(mut self) -> Self {
        self.nose = self.foremost();
        self
    }

    /// The contour with its nose at an arc length.
    pub fn with_nose(&self, nose: f64) -> Self {
        Self {
            nose,
            ..self.clone()
        }
    }

    /// The part of the contour between two arc lengths, with a base between its ends.
    pub fn between_ends(&self, ends: [f64; 2]) -> Self {
        let [from, to] = ends.map(|s| self.parameter(s));
        let rear = ends.map(|s| self.position(s));
        let mut part = Self {
            start: [from, (to - from) / STEPS as f64],
            arcs: Vec::with_capacity(STEPS + 1),
            intervals: Vec::new(),
            base: distance(rear[0], rear[1]),
            is_smooth: false,
            rear,
            ..self.clone()
        };
        part.measure();
        part
    }

    /// The point at an arc length.
    pub fn position(&self, s: f64) -> [f64; 2] {
        if let Some(part) = self.on_base(s) {
            let ([first, last], middle) = (self.rear, self.middle());
            return [0, 1].map(|i| middle[i] + 0.5 * part * (first[i] - last[i]));
        }
        let u = self.parameter(s);
        let (piece, i) = self.piece(u);
        piece.each_ref().map(|f| f.value(i, u))
    }

    /// Unit normal into the section; at a corner the normal of the side.
    pub fn inward(&self, s: f64) -> [f64; 2] {
        if self.on_base(s).is_some() {
            return self.base_inward();
        }
        let [y, z] = self.slopes(self.parameter(s));
        let length = y.hypot(z);
        [z / length, -y / length]
    }

    /// Unit normal of the base into the section.
    pub fn base_inward(&self) -> [f64; 2] {
        let [first, last] = self.rear;
        let [y, z] = [first[0] - last[0], first[1] - last[1]];
        let length = y.hypot(z).max(f64::MIN_POSITIVE);
        [z / length, -y / length]
    }

    /// Tangents of half the turns at the corners of the trailing edge, between side and base.
    pub fn rear_tangents(&self) -> [f64; 2] {
        let base = self.base_inward();
        self.corners().map(|s| {
            let n = self.inward(s);
            let (cosine, sine) = (
                n[0] * base[0] + n[1] * base[1],
                n[0] * base[1] - n[1] * base[0],
            );
            (0.5 * sine.abs().atan2(cosine)).tan()
        })
    }

    /// Tangent of half the turn at the corner of a trailing edge without a base.
    pub fn rear_tangent(&self) -> f64 {
        let [a, b] = [self.perimeter, 0.0].map(|s| self.inward(s));
        let (sine, cosine) = (a[1] * b[0] - a[0] * b[1], a[0] * b[0] + a[1] * b[1]);
        (0.5 * sine.atan2(cosine)).tan()
    }

    /// Whether both sides turn to the base so little that they do not run beside each other there.
    pub fn is_round_behind(&self) -> bool {
        let turns = self.rear_tangents().map(|tangent| 2.0 * tangent.atan());
        turns[0] + turns[1] < ROUND_BEHIND
    }

    /// Curvature, positive if the section is convex.
    pub fn bend(&self, s: f64) -> f64 {
        if self.on_base(s).is_some() {
            return 0.0;
        }
        let u = self.parameter(s);
        let (piece, i) = self.piece(u);
        let [y, z] = piece.each_ref().map(|f| f.slope(i, u));
        let [ddy, ddz] = piece.each_ref().map(|f| f.bend(i, u));
        (ddy * z - ddz * y) / y.hypot(z).powi(3)
    }
}
