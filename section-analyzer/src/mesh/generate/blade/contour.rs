//! The outer surface of a blade: the contour of an airfoil, with y toward the nose and z up.

use super::super::super::distance;
use super::super::bisect::zero;
use super::super::layup::Outline;
use super::super::layup::line::Line;
use super::problem::BladeProblem;

/// Distance of the two ends, relative to the chord, below which they are one point.
const SAME: f64 = 1e-6;
/// Allowed excess of x/c beyond 0 and 1 at the ends of an airfoil.
const LOOSE: f64 = 0.02;
/// Number of chordwise positions at which the thickness is evaluated.
const LOOKS: usize = 100;

/// Names of the sides.
pub(super) const SIDES: [&str; 2] = ["upper", "lower"];

/// The outer surface of a blade. Its sides are 0 above and 1 below, between the trailing edge and the
/// foremost point.
#[derive(Debug, Clone)]
pub struct Contour {
    outline: Outline,
    chord: f64,
    origin: f64,
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
        if distance(positions[0], positions[last]) <= SAME * chord {
            let middle = [0, 1].map(|i| 0.5 * (positions[0][i] + positions[last][i]));
            (positions[0], positions[last]) = (middle, middle);
        }
        let outline = Outline::new(&positions).map_err(|one| vec![BladeProblem::Layup(one)])?;
        let mut contour = Self {
            outline: outline.with_foremost_nose(),
            chord,
            origin,
        };
        if end < 1.0 {
            let [Some(upper), Some(lower)] = [0, 1].map(|side| contour.at_chord(side, end)) else {
                return Err(vec![BladeProblem::End { end }]);
            };
            let part = contour.outline.between_ends([upper, lower]);
            contour.outline = part.with_foremost_nose();
        }
        contour.check_thickness()?;
        Ok(contour)
    }

    /// The contour over its arc length.
    pub(super) fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Length of the chord [unit of the mesh].
    pub(super) fn chord(&self) -> f64 {
        self.chord
    }

    /// Arc lengths of a side, from the trailing edge to the nose.
    pub(super) fn range(&self, side: usize) -> [f64; 2] {
        [self.outline.corners()[side], self.outline.nose()]
    }

    /// Chordwise position of a coordinate y, as a fraction.
    pub(super) fn chord_part(&self, y: f64) -> f64 {
        self.origin - y / self.chord
    }

    /// Chordwise position at an arc length, as a fraction.
    pub(super) fn part_at(&self, s: f64) -> f64 {
        self.chord_part(self.outline.position(s)[0])
    }

    /// The coordinate y of a chordwise fraction.
    pub(super) fn at_part(&self, part: f64) -> f64 {
        (self.origin - part) * self.chord
    }

    /// Arc length on a side at this chordwise fraction; `None` if the side does not reach it.
    pub(super) fn at_chord(&self, side: usize, part: f64) -> Option<f64> {
        let y = self.at_part(part);
        zero(self.range(side), |s| self.outline.position(s)[0] - y)
    }

    /// The line across the section at a chordwise fraction, and the arc lengths of its ends.
    pub(super) fn across(&self, part: f64) -> Option<(Line, [f64; 2])> {
        let ends = [self.at_chord(0, part)?, self.at_chord(1, part)?];
        Some((Line::between(ends.map(|s| self.outline.position(s))), ends))
    }

    /// Thickness of the airfoil at a chordwise fraction [unit of the mesh].
    pub(super) fn thickness(&self, part: f64) -> Option<f64> {
        let at = |side| Some(self.outline.position(self.at_chord(side, part)?)[1]);
        Some(at(0)? - at(1)?)
    }

    /// Chordwise fraction at which the contour ends.
    pub(super) fn last_part(&self) -> f64 {
        let [upper, lower] = self.outline.corners().map(|s| self.part_at(s));
        upper.min(lower)
    }

    /// The chordwise position ahead of which the airfoil is thicker than `needed`.
    pub(super) fn space_ahead(&self, needed: f64) -> Option<f64> {
        let last = self.last_part();
        let parts = (1..500).map(|i| last * (1.0 - i as f64 / 500.0));
        let mut fitting = parts.filter(|part| {
            let space = self.thickness(*part);
            space.is_some_and(|space| space > needed)
        });
        fitting.next().filter(|part| *part > 0.3 * last)
    }

    fn check_thickness(&self) -> Result<(), Vec<BladeProblem>> {
        let end = self.last_part();
        let mut parts = (1..LOOKS).map(|look| end * look as f64 / LOOKS as f64);
        let is_crossed = |part: &f64| self.thickness(*part).is_some_and(|space| space <= 0.0);
        let crossed = parts.find(is_crossed);
        crossed.map_or(Ok(()), |part| Err(vec![BladeProblem::Crossed { part }]))
    }
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
