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

use super::super::bisect::zero;
use super::outline::Outline;

/// Cosine of the angle between the normals at the ends of the fan: 70 degrees.
const FAN: f64 = 0.342;
/// Length of each side from whose points circles are searched, and on which they may touch, of the
/// contour.
const REACH: [f64; 2] = [0.22, 0.3];
/// Samples of each side for both, closer toward the nose.
const SAMPLES: [usize; 2] = [240, 600];
/// Part of the contour within which points are one.
const SAME: f64 = 1e-7;
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
    /// The circles of a contour; `None` if it has corners ahead, or no round nose. The circles of a
    /// mirrored contour are the mirrored circles: they are searched from points of both sides.
    pub fn new(outline: &Outline) -> Option<Self> {
        let (nose, reach) = (outline.nose(), REACH[0] * outline.perimeter());
        let mut corners = outline.breaks().iter();
        if corners.any(|corner| (corner.s - nose).abs() < reach) {
            return None;
        }
        let mut pairs: Vec<[f64; 2]> = (0..2).flat_map(|side| pairs(outline, side)).collect();
        pairs.sort_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        let least = SAME * outline.perimeter();
        let mut partners: Vec<[f64; 2]> = Vec::new();
        for pair in pairs {
            let [a, b] = pair.map(|s| outline.inward(s));
            let is_fan = partners.is_empty() && a[0] * b[0] + a[1] * b[1] > FAN;
            let is_behind =
                |last: &[f64; 2]| pair[0] < last[0] - least && pair[1] > last[1] + least;
            if !is_fan && partners.last().is_none_or(is_behind) {
                partners.push(pair);
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

    /// Distances from the nose between which circles give way to lines, with the fan up to one of
    /// these distances and the last circle at the other one, of the chord.
    pub fn fade([fan, last]: [f64; 2]) -> [f64; 2] {
        let from = FADES[0].max(BEHIND_FAN * fan);
        let to = (from + FADES[1]).min(last);
        [from.min(0.5 * (fan + to)), to]
    }

    /// The part that circles have of the pairs at a distance from the nose.
    pub fn part(x: f64, [from, to]: [f64; 2]) -> f64 {
        let part = ((x - from) / (to - from)).clamp(0.0, 1.0);
        1.0 - part * part * (3.0 - 2.0 * part)
    }

    /// The points of the last circle.
    pub fn last(&self) -> [f64; 2] {
        self.partners[self.partners.len() - 1]
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

    /// The point of the other side on the circle of a point of a side behind the fan; `None` behind
    /// the last circle.
    pub fn partner(&self, side: usize, s: f64) -> Option<f64> {
        let last = self.partners.len() - 1;
        let is_before = |pair: &[f64; 2]| [pair[0] >= s, pair[1] <= s][side];
        let after = self.partners.partition_point(is_before);
        if after > last {
            return None;
        }
        let after = after.max(1);
        let [from, to] = [self.partners[after - 1], self.partners[after]];
        let part = (s - from[side]) / (to[side] - from[side]);
        Some(from[1 - side] + part * (to[1 - side] - from[1 - side]))
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

/// Radius of the circle that touches the contour at a point with this inward normal and goes through
/// another point; infinite if that is not on the inner side.
pub(super) fn radius((p, n): ([f64; 2], [f64; 2]), q: [f64; 2]) -> f64 {
    let d = [q[0] - p[0], q[1] - p[1]];
    let inward = n[0] * d[0] + n[1] * d[1];
    if inward > 0.0 {
        (d[0] * d[0] + d[1] * d[1]) / (2.0 * inward)
    } else {
        f64::INFINITY
    }
}

/// The mean of the centers of the circles of two points.
fn center(outline: &Outline, s: [f64; 2]) -> [f64; 2] {
    let points = s.map(|s| outline.position(s));
    let centers = [0, 1].map(|side| {
        let n = outline.inward(s[side]);
        let r = radius((points[side], n), points[1 - side]);
        [0, 1].map(|i| points[side][i] + r * n[i])
    });
    [0, 1].map(|i| 0.5 * (centers[0][i] + centers[1][i]))
}

/// The pairs of samples of a side, as far as each has one, from the nose aft.
fn pairs(outline: &Outline, side: usize) -> Vec<[f64; 2]> {
    let place = |side: usize, which: usize, i: usize| {
        let part = i as f64 / SAMPLES[which] as f64;
        outline.nose() + [-1.0, 1.0][side] * REACH[which] * outline.perimeter() * part * part
    };
    let others = (1..=SAMPLES[1]).map(|j| place(1 - side, 1, j));
    let others: Vec<(f64, [f64; 2])> = others.map(|s| (s, outline.position(s))).collect();
    let own = (1..=SAMPLES[0]).map(|i| place(side, 0, i));
    let pair = |s: f64| {
        let other = partner(outline, s, &others)?;
        Some(if side == 0 { [s, other] } else { [other, s] })
    };
    own.map_while(pair).collect()
}

/// The point of the other side, of which `others` are samples, on the largest circle at a point;
/// `None` if it is at the end of the samples.
fn partner(outline: &Outline, s: f64, others: &[(f64, [f64; 2])]) -> Option<f64> {
    let touched = (outline.position(s), outline.inward(s));
    let radii: Vec<f64> = others.iter().map(|(_, q)| radius(touched, *q)).collect();
    let best = (0..radii.len()).min_by(|a, b| radii[*a].total_cmp(&radii[*b]))?;
    let ends = [others[best.max(1) - 1].0, others.get(best + 1)?.0];
    // the circle touches the other side where its radius at q is along the normal
    let off = |at: f64| {
        let (q, m) = (outline.position(at), outline.inward(at));
        let (p, n) = touched;
        let r = radius(touched, q);
        let d = [0, 1].map(|i| p[i] + r * n[i] - q[i]);
        d[0] * m[1] - d[1] * m[0]
    };
    Some(zero(ends, off).unwrap_or(others[best].0))
}
