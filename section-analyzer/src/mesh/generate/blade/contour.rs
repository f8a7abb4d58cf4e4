//! The outer surface of a blade as a smooth curve.
//!
//! The points of the airfoil, from the trailing edge over the upper surface and the nose
//! to the trailing edge, become one cubic spline over the length u of the polygon through
//! them; in this order it is clockwise, with y toward the nose and z up. A surface at the
//! depth h inside is
//!
//! ```text
//! x(u, h) = P(u) + h m(u),      m = t x e_x (right of the tangent t),
//! dx/du = (1 - b h) dP/du ,     b = (y'' z' - z'' y') / |P'|^3
//! ```
//!
//! and it folds if the depth reaches the radius 1/b.

use shared_geom::spline::Spline;

use super::super::super::distance;
use super::problem::BladeProblem;

/// Number of points repeated at both ends of a contour without a trailing edge.
const OVERLAP: usize = 8;
/// Distance of the two ends, relative to the chord, below which they are one point.
const SAME: f64 = 1e-6;
/// Turn at a trailing edge below which it is treated as smooth \[rad\]: 45 degrees.
const SMOOTH: f64 = std::f64::consts::FRAC_PI_4;
/// Allowed excess of x/c beyond 0 and 1 at the ends of an airfoil.
const LOOSE: f64 = 0.02;
/// Number of bisections of an interval: full precision.
const HALVINGS: usize = 80;
/// Number of chordwise positions at which the thickness is evaluated.
const LOOKS: usize = 100;

/// One of the two halves of the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Half {
    /// From the trailing edge to the nose.
    Upper,
    /// From the nose to the trailing edge.
    Lower,
}

impl Half {
    pub const BOTH: [Self; 2] = [Self::Upper, Self::Lower];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Upper => "upper",
            Self::Lower => "lower",
        }
    }
}

/// Shape of the contour at its rear end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Edge {
    /// Two corners and a straight line between them.
    Blunt,
    /// One corner.
    Sharp,
    /// No corner.
    None,
}

/// The outer surface of a blade.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    y: Spline,
    z: Spline,
    /// Length along the polygon at the trailing edge above, the nose, and the trailing
    /// edge below.
    ends: [f64; 3],
    chord: f64,
    origin: f64,
    edge: Edge,
}

/// A straight line with an inner side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    pub point: [f64; 2],
    /// Unit normal into the section.
    pub inward: [f64; 2],
}

impl Contour {
    /// The contour of an airfoil: `points` are (x/c, z/c), from the trailing edge over
    /// the upper surface to the nose and back over the lower one. The origin of the
    /// section lies at `origin` of the `chord`, and everything behind `end` is cut off.
    ///
    /// # Errors
    /// All problems of the points.
    pub fn new(
        points: &[[f64; 2]],
        chord: f64,
        origin: f64,
        end: f64,
    ) -> Result<Self, Vec<BladeProblem>> {
        check(points)?;
        let position = |[x, z]: [f64; 2]| [(origin - x) * chord, z * chord];
        let mut positions: Vec<[f64; 2]> = points.iter().map(|point| position(*point)).collect();
        let last = positions.len() - 1;
        let mut edge = if distance(positions[0], positions[last]) > SAME * chord {
            Edge::Blunt
        } else {
            Edge::Sharp
        };
        if edge == Edge::Sharp {
            let middle = [0, 1].map(|i| 0.5 * (positions[0][i] + positions[last][i]));
            (positions[0], positions[last]) = (middle, middle);
            if turn_at_end(&positions) < SMOOTH && end >= 1.0 {
                edge = Edge::None;
            }
        }
        let overlap = match edge {
            Edge::None => OVERLAP.min(last / 2),
            _ => 0,
        };
        let padded = [
            &positions[last - overlap..last],
            &positions,
            &positions[1..=overlap],
        ]
        .concat();
        let mut along = vec![0.0];
        for pair in padded.windows(2) {
            along.push(along[along.len() - 1] + distance(pair[0], pair[1]));
        }
        let [y, z] = [0, 1].map(|i| {
            let values: Vec<f64> = padded.iter().map(|position| position[i]).collect();
            Spline::new(&along, &values)
        });
        let (from, to) = (along[overlap], along[overlap + last]);
        let mut contour = Self {
            y,
            z,
            ends: [from, 0.5 * (from + to), to],
            chord,
            origin,
            edge,
        };
        contour.ends[1] = contour.nose_in(from, to);
        if end < 1.0 {
            contour.cut(end)?;
        }
        contour.check_thickness()?;
        Ok(contour)
    }

    /// Cuts the contour off at a chordwise position.
    fn cut(&mut self, end: f64) -> Result<(), Vec<BladeProblem>> {
        let at = |half| self.at_chord(half, end);
        match (at(Half::Upper), at(Half::Lower)) {
            (Some(upper), Some(lower)) => {
                (self.ends[0], self.ends[2]) = (upper, lower);
                self.edge = Edge::Blunt;
                Ok(())
            }
            _ => Err(vec![BladeProblem::End { end }]),
        }
    }

    /// Length along the polygon to the foremost point of the contour.
    fn nose_in(&self, from: f64, to: f64) -> f64 {
        let slope = |u: f64| self.y.slope(self.y.interval(u), u);
        // the foremost of many points, then the zero of the slope next to it
        let position = |i: usize| from + (to - from) * i as f64 / 1000.0;
        let forward = |u: f64| self.y.value(self.y.interval(u), u);
        let foremost =
            (1..1000).max_by(|a, b| forward(position(*a)).total_cmp(&forward(position(*b))));
        let foremost = foremost.unwrap_or(500);
        let bounds = [position(foremost - 1), position(foremost + 1)];
        halve(bounds, slope).unwrap_or(position(foremost))
    }

    /// Shape of the trailing edge.
    pub(super) fn edge(&self) -> Edge {
        self.edge
    }

    /// Length of the chord [unit of the mesh].
    pub(super) fn chord(&self) -> f64 {
        self.chord
    }

    /// The ends of a half, in the direction of the contour.
    pub(super) fn range(&self, half: Half) -> [f64; 2] {
        match half {
            Half::Upper => [self.ends[0], self.ends[1]],
            Half::Lower => [self.ends[1], self.ends[2]],
        }
    }

    /// A point of the contour.
    pub(super) fn position(&self, u: f64) -> [f64; 2] {
        let i = self.y.interval(u);
        [self.y.value(i, u), self.z.value(i, u)]
    }

    /// Unit tangent, clockwise.
    pub(super) fn tangent(&self, u: f64) -> [f64; 2] {
        let i = self.y.interval(u);
        let [y, z] = [self.y.slope(i, u), self.z.slope(i, u)];
        let length = y.hypot(z);
        [y / length, z / length]
    }

    /// Unit normal into the section.
    pub(super) fn inward(&self, u: f64) -> [f64; 2] {
        let [y, z] = self.tangent(u);
        [z, -y]
    }

    /// Curvature, positive if the section is convex [1/unit of the mesh].
    pub(super) fn bend(&self, u: f64) -> f64 {
        let i = self.y.interval(u);
        let [y, z] = [self.y.slope(i, u), self.z.slope(i, u)];
        let [ddy, ddz] = [self.y.bend(i, u), self.z.bend(i, u)];
        (ddy * z - ddz * y) / y.hypot(z).powi(3)
    }

    /// The point at a depth below the contour.
    pub(super) fn offset(&self, u: f64, depth: f64) -> [f64; 2] {
        let (position, inward) = (self.position(u), self.inward(u));
        [0, 1].map(|i| position[i] + depth * inward[i])
    }

    /// Chordwise position of a coordinate y, as a fraction.
    pub(super) fn chord_part(&self, y: f64) -> f64 {
        self.origin - y / self.chord
    }

    /// The coordinate y of a chordwise fraction.
    pub(super) fn at_part(&self, part: f64) -> f64 {
        (self.origin - part) * self.chord
    }

    /// Position on a half at this chordwise fraction; `None` if the half does not reach
    /// it.
    pub(super) fn at_chord(&self, half: Half, part: f64) -> Option<f64> {
        let y = self.at_part(part);
        halve(self.range(half), |u| self.position(u)[0] - y)
    }

    /// Position at which the surface at `depth` under a half lies `gap` inside of a
    /// straight line.
    pub(super) fn meet(&self, half: Half, depth: f64, line: Straight, gap: f64) -> Option<f64> {
        halve(self.range(half), |u| {
            let position = self.offset(u, depth);
            let inside = [0, 1].map(|i| (position[i] - line.point[i]) * line.inward[i]);
            let off = inside[0] + inside[1] - gap;
            // the line through an end meets it there, regardless of round-off
            if off.abs() < 1e-12 * self.chord {
                0.0
            } else {
                off
            }
        })
    }

    /// Positions at which the surfaces at `depth` under both halves meet near the
    /// trailing edge; Newton's method from the intersection of straight surfaces.
    pub(super) fn meet_other(&self, depth: f64) -> Option<[f64; 2]> {
        let [upper, _, lower] = self.ends;
        if depth == 0.0 {
            return Some([upper, lower]);
        }
        let [a, b] = [self.tangent(upper), self.tangent(lower)];
        let half_angle = 0.5 * (-a[0] * b[0] - a[1] * b[1]).clamp(-1.0, 1.0).acos();
        let back = depth / half_angle.tan().max(1e-6);
        let mut at = [upper + back, lower - back];
        let space = [self.ends[1] - upper, lower - self.ends[1]];
        for _ in 0..50 {
            let positions = at.map(|u| self.offset(u, depth));
            let off = [0, 1].map(|i| positions[0][i] - positions[1][i]);
            let slopes = at.map(|u| {
                let stretch = 1.0 - self.bend(u) * depth;
                self.tangent(u).map(|x| x * stretch)
            });
            let [s, t] = slopes;
            // off + s da - t db = 0
            let determinant = -s[0] * t[1] + s[1] * t[0];
            let da = (off[0] * t[1] - off[1] * t[0]) / determinant;
            let db = (off[0] * s[1] - off[1] * s[0]) / determinant;
            at = [at[0] + da, at[1] + db];
            let is_inside = at[0] > upper && at[0] < upper + space[0];
            if !(is_inside && at[1] < lower && at[1] > lower - space[1]) {
                return None;
            }
            if off[0].hypot(off[1]) < 1e-13 * self.chord {
                return Some(at);
            }
        }
        None
    }

    /// Thickness of the airfoil at a chordwise fraction [unit of the mesh].
    pub(super) fn thickness(&self, part: f64) -> Option<f64> {
        let at = |half| self.at_chord(half, part).map(|u| self.position(u)[1]);
        Some(at(Half::Upper)? - at(Half::Lower)?)
    }

    /// Chordwise fraction at which the contour ends.
    pub(super) fn last_part(&self) -> f64 {
        let [upper, lower] = [self.ends[0], self.ends[2]].map(|u| self.position(u)[0]);
        self.chord_part(upper.max(lower))
    }

    fn check_thickness(&self) -> Result<(), Vec<BladeProblem>> {
        let end = self.last_part();
        for look in 1..LOOKS {
            let part = end * look as f64 / LOOKS as f64;
            if self
                .thickness(part)
                .is_some_and(|thickness| thickness <= 0.0)
            {
                return Err(vec![BladeProblem::Crossed { part }]);
            }
        }
        Ok(())
    }
}

/// The zero of a function between two positions at which its signs differ.
pub(super) fn halve([mut a, mut b]: [f64; 2], f: impl Fn(f64) -> f64) -> Option<f64> {
    let (at_a, at_b) = (f(a), f(b));
    if at_a == 0.0 {
        return Some(a);
    }
    if at_b == 0.0 {
        return Some(b);
    }
    if (at_a > 0.0) == (at_b > 0.0) || !(at_a - at_b).is_finite() {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (a + b);
        if (f(middle) > 0.0) == (at_a > 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
    Some(0.5 * (a + b))
}

/// Change of direction from the last line of the points to the first one \[rad\].
fn turn_at_end(positions: &[[f64; 2]]) -> f64 {
    let last = positions.len() - 1;
    let line = |a: [f64; 2], b: [f64; 2]| [b[0] - a[0], b[1] - a[1]];
    let [before, behind] = [
        line(positions[last - 1], positions[last]),
        line(positions[0], positions[1]),
    ];
    let cross = before[0] * behind[1] - before[1] * behind[0];
    let dot = before[0] * behind[0] + before[1] * behind[1];
    cross.atan2(dot).abs()
}

/// Whether the points can be an airfoil in the required order.
fn check(points: &[[f64; 2]]) -> Result<(), Vec<BladeProblem>> {
    const LEAST: usize = 9;
    if points.len() < LEAST {
        return Err(vec![BladeProblem::FewPoints {
            found: points.len(),
            least: LEAST,
        }]);
    }
    let mut problems = Vec::new();
    let xs = || points.iter().map(|point| point[0]);
    let low = xs().fold(f64::INFINITY, f64::min);
    let high = xs().fold(f64::NEG_INFINITY, f64::max);
    if low.abs() > LOOSE || (high - 1.0).abs() > LOOSE {
        return Err(vec![BladeProblem::Range { low, high }]);
    }
    let (first, last) = (points[0], points[points.len() - 1]);
    if [first, last].iter().any(|end| end[0] < high - LOOSE) {
        return Err(vec![BladeProblem::Order {
            first: first[0],
            last: last[0],
        }]);
    }
    for (index, pair) in points.windows(2).enumerate() {
        if distance(pair[0], pair[1]) < 1e-9 {
            let number = index + 2;
            problems.push(BladeProblem::Doubled { number });
        }
    }
    let around = || points.iter().zip(points.iter().cycle().skip(1));
    let area: f64 = around().map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    if area <= 0.0 {
        problems.push(BladeProblem::LowerFirst);
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}
