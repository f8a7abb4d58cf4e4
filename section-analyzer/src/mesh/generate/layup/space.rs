//! The space of the layers ahead, where the section is round: the largest circle in the section that
//! touches the contour at a point has the radius
//!
//! ```text
//! r = min over q of |q - p|^2 / (2 n . (q - p)),    r <= 1/k,
//! ```
//!
//! with q on the other side, n the inward normal and k the curvature at p. Columns along the normals
//! do not cross if the layers are thinner.

use super::super::super::distance;
use super::front;
use super::pairs::FOREMOST;
use super::problem::LayupProblem;
use super::wall::Wall;

/// Part of the radius of the inscribed circle that layers may fill.
const FULL: f64 = 0.98;
/// Samples around the contour in the search for radii.
const SAMPLES: usize = 500;
/// Samples of each side from the nose, closer toward it, and the part of the contour on which they are: the
/// curvature may have a peak between the others.
const AHEAD: (usize, f64) = (100, 0.05);
/// Part of the contour within which two points of it are one.
const SEAM: f64 = 1e-4;
/// Part of the contour around the nose that is on both sides.
const AT_NOSE: f64 = 1e-6;

impl Wall {
    /// Arc lengths and points of samples of both sides.
    pub fn samples(&self) -> Vec<(f64, [f64; 2])> {
        let [aft, end] = self.outline.corners();
        let at = |i: usize| aft + (end - aft) * i as f64 / SAMPLES as f64;
        (0..=SAMPLES)
            .map(|i| (at(i), self.outline.position(at(i))))
            .collect()
    }

    /// Radius of the largest inscribed circle that touches the contour at an arc length, with
    /// samples of the contour.
    pub fn radius(&self, s: f64, points: &[(f64, [f64; 2])]) -> f64 {
        let outline = &self.outline;
        // in a mitre the columns of both sides meet on its line
        let is_round = outline.is_round_behind();
        let mut mitres = self.mitres.iter().filter(|one| is_round || !one.is_rear);
        if mitres.any(|one| one.part(s).is_some()) {
            return f64::INFINITY;
        }
        let touched = (outline.position(s), outline.inward(s));
        let near = AT_NOSE * outline.perimeter();
        let behind = |s: f64| {
            let off = s - outline.nose();
            if off.abs() < near { 0.0 } else { off }
        };
        let mut radius = 1.0 / outline.bend(s).max(1e-12);
        for (other, q) in points {
            // at the seam of a closed contour both sides have one point
            let is_apart = distance(touched.0, *q) > SEAM * outline.perimeter();
            if behind(*other) * behind(s) <= 0.0 && is_apart {
                radius = radius.min(front::radius(touched, *q));
            }
        }
        radius
    }

    /// The place ahead where the layers fill most of the space, if they have too little: layers that
    /// are thicker than the inscribed circle, or layers of both sides that meet.
    pub fn tight_space(&self) -> Option<LayupProblem> {
        let (outline, points) = (&self.outline, self.samples());
        let is_checked = |s: f64| {
            let side = usize::from(s > outline.nose());
            outline.is_smooth() || self.pairs.x(side, s) < FOREMOST
        };
        let (count, reach) = AHEAD;
        let ahead = (1..=count).flat_map(|i| {
            let off = reach * outline.perimeter() * (i as f64 / count as f64).powi(2);
            [outline.nose() - off, outline.nose() + off]
        });
        let checked = points.iter().map(|(s, _)| *s).chain(ahead);
        let checked = checked.filter(|s| is_checked(*s));
        let places = checked.map(|s| (s, self.stack.total(s), self.radius(s, &points)));
        // places of equal parts are in one order for mirror images
        let off = |s: f64| (s - 0.5 * outline.perimeter()).abs();
        let worst = places.max_by(|a, b| {
            let [of_a, of_b] = [a, b].map(|(_, thickness, radius)| thickness / radius);
            of_a.total_cmp(&of_b).then(off(b.0).total_cmp(&off(a.0)))
        });
        if let Some((s, thickness, radius)) = worst.filter(|one| one.1 > FULL * one.2) {
            return Some(LayupProblem::Tight {
                layer: self.stack.innermost_name(s).to_owned(),
                arc: s / outline.perimeter(),
                thickness,
                radius,
                thickest: self.stack.thickest(s),
            });
        }
        let mut contacts = self.contacts.iter();
        contacts.find(|one| one[0] <= FOREMOST)?;
        let pair = self.pairs.pair(FOREMOST);
        let needs = [0, 1].map(|side| pair.need(side, &self.stack));
        let side = usize::from(needs[1] > needs[0]);
        Some(LayupProblem::Meeting {
            layer: self.stack.innermost_name(pair.s[side]).to_owned(),
            arcs: pair.s.map(|s| s / outline.perimeter()),
            taken: needs[0] + needs[1],
            length: pair.length,
            thickest: self.stack.thickest(pair.s[side]),
        })
    }
}
