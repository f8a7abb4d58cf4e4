//! Pairs of points ahead, by the circles in the section that touch both sides.
//!
//! The largest circle that touches the contour at p touches the other side at the point q of least
//!
//! ```text
//! r = |q - p|^2 / (2 n . (q - p)),    C = p + r n,    n the inward normal at p,
//! ```
//!
//! and its center C is on the normals of both points: columns along the normals end in it. Between
//! the points of the first circle behind the nose whose normals are 70 degrees apart, all columns
//! end in the center of this circle: they are a fan.

use super::super::super::distance;
use super::outline::Outline;

/// Cosine of the angle between the normals at the ends of the fan: 70 degrees.
const FAN: f64 = 0.342;
/// Length of each side on which circles are searched, of the contour.
const REACH: [f64; 2] = [0.22, 0.3];
/// Samples of each side, closer toward the nose.
const SAMPLES: [usize; 2] = [240, 600];
/// Steps of the search for the point at which a circle touches.
const STEPS: usize = 40;
/// Distance from the nose from which circles give way to lines, and the length over which they do,
/// of the chord.
const FADES: [f64; 2] = [0.1, 0.15];
/// The same distance, in distances of the end of the fan.
const BEHIND_FAN: f64 = 1.2;

/// The circles ahead.
#[derive(Debug, Clone)]
pub(in super::super) struct Front {
    /// Arc length of the nose: the middle of the fan.
    pub nose: f64,
    /// Arc lengths of the ends of the fan on both sides.
    pub fan: [f64; 2],
    /// Center of the fan.
    center: [f64; 2],
    /// Arc lengths of the points of both sides on one circle, from the fan aft.
    partners: Vec<[f64; 2]>,
}

/// The circle of a pair.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Circle {
    /// Its center.
    pub center: [f64; 2],
    /// Depths of its center below both sides.
    pub radii: [f64; 2],
    /// Whether it is the center of the fan.
    pub is_fan: bool,
}

impl Front {
    /// The circles of a contour; `None` if it has corners ahead, or no round nose.
    pub fn new(outline: &Outline) -> Option<Self> {
        let (nose, perimeter) = (outline.nose(), outline.perimeter());
        let place = |side: usize, i: usize| {
            let part = i as f64 / SAMPLES[side] as f64;
            nose + [-1.0, 1.0][side] * REACH[side] * perimeter * part * part
        };
        let [from, to] = [0, 1].map(|side| place(side, SAMPLES[side]));
        let mut corners = outline.breaks().iter();
        if corners.any(|corner| corner.s > from && corner.s < to) {
            return None;
        }
        let others: Vec<f64> = (1..=SAMPLES[1]).map(|j| place(1, j)).collect();
        let others: Vec<(f64, [f64; 2])> = others
            .into_iter()
            .map(|s| (s, outline.position(s)))
            .collect();
        let mut partners: Vec<[f64; 2]> = Vec::new();
        for i in 1..=SAMPLES[0] {
            let s = place(0, i);
            let Some(other) = partner(outline, s, &others) else {
                break;
            };
            let [a, b] = [s, other].map(|s| outline.inward(s));
            let is_fan = partners.is_empty() && a[0] * b[0] + a[1] * b[1] > FAN;
            let is_behind = partners.last().is_none_or(|last| other > last[1]);
            if !is_fan && is_behind {
                partners.push([s, other]);
            }
        }
        let fan = *partners.first().filter(|_| partners.len() > 1)?;
        let center = center(outline, fan);
        Some(Self {
            nose: 0.5 * (fan[0] + fan[1]),
            fan,
            center,
            partners,
        })
    }

    /// The part that circles have of the pairs at a distance from the nose, with the fan up to
    /// another one, of the chord.
    pub fn part(x: f64, fan: f64) -> f64 {
        let from = FADES[0].max(BEHIND_FAN * fan);
        let part = ((x - from) / FADES[1]).clamp(0.0, 1.0);
        1.0 - part * part * (3.0 - 2.0 * part)
    }

    /// Whether a point is in the fan; its side is 0 or 1.
    pub fn is_fan(&self, side: usize, s: f64) -> bool {
        // its ends are in it after round-off
        (s - self.nose).abs() <= (1.0 + 1e-9) * (self.fan[side] - self.nose).abs()
    }

    /// The part of its side of the fan between the nose and a point of it.
    pub fn part_of_fan(&self, side: usize, s: f64) -> f64 {
        (s - self.nose) / (self.fan[side] - self.nose)
    }

    /// The point of the suction side on the circle of a point of the pressure side behind the fan.
    pub fn partner(&self, s: f64) -> f64 {
        let last = self.partners.len() - 1;
        let after = self.partners.partition_point(|pair| pair[1] <= s);
        let after = after.clamp(1, last);
        let [[p0, q0], [p1, q1]] = [self.partners[after - 1], self.partners[after]];
        p0 + (p1 - p0) * (s - q0) / (q1 - q0)
    }

    /// The circle of a pair of points.
    pub fn circle(&self, outline: &Outline, s: [f64; 2]) -> Circle {
        let is_fan = (0..2).all(|side| self.is_fan(side, s[side]));
        let center = if is_fan {
            self.center
        } else {
            center(outline, s)
        };
        let radii = s.map(|s| {
            let (p, n) = (outline.position(s), outline.inward(s));
            (center[0] - p[0]) * n[0] + (center[1] - p[1]) * n[1]
        });
        Circle {
            center,
            radii,
            is_fan,
        }
    }
}

/// Radius of the circle that touches the contour at one point and goes through another.
fn radius(outline: &Outline, s: f64, q: [f64; 2]) -> f64 {
    let (p, n) = (outline.position(s), outline.inward(s));
    let inward = n[0] * (q[0] - p[0]) + n[1] * (q[1] - p[1]);
    if inward > 0.0 {
        distance(p, q).powi(2) / (2.0 * inward)
    } else {
        f64::INFINITY
    }
}

/// The mean of the centers of the circles of two points.
fn center(outline: &Outline, s: [f64; 2]) -> [f64; 2] {
    let points = s.map(|s| outline.position(s));
    let centers = [0, 1].map(|side| {
        let n = outline.inward(s[side]);
        let r = radius(outline, s[side], points[1 - side]);
        [0, 1].map(|i| points[side][i] + r * n[i])
    });
    [0, 1].map(|i| 0.5 * (centers[0][i] + centers[1][i]))
}

/// The point of the other side, of which `others` are samples, on the largest circle at a point;
/// `None` if it is at the end of the samples.
fn partner(outline: &Outline, s: f64, others: &[(f64, [f64; 2])]) -> Option<f64> {
    let radii: Vec<f64> = others.iter().map(|(_, q)| radius(outline, s, *q)).collect();
    let best = (0..radii.len()).min_by(|a, b| radii[*a].total_cmp(&radii[*b]))?;
    let after = others.get(best + 1)?.0;
    let [mut a, mut b] = [others[best.max(1) - 1].0, after];
    let of = |at: f64| radius(outline, s, outline.position(at));
    for _ in 0..STEPS {
        let [left, right] = [a + 0.381_966 * (b - a), a + 0.618_034 * (b - a)];
        if of(left) < of(right) {
            b = right;
        } else {
            a = left;
        }
    }
    Some(0.5 * (a + b))
}
