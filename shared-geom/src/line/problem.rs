//! Conditions that a line must satisfy before its use.

use super::{Course, ReferenceLine};
use crate::error::Explain;
use crate::units::rounded;

/// Smallest part of a step of the line outside of the direction of z: below it no chord
/// is level [-].
const LEVEL: f64 = 1e-6;
/// Longest line: longer ones are mistakes, and very long ones overflow \[m\].
const LONGEST: f64 = 1e9;

/// Errors of a line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LineProblem {
    /// Too few points.
    #[error("the line has {found} points, expected two or more")]
    Points {
        /// Points found.
        found: usize,
    },
    /// A number that is not finite.
    #[error("point {point} of the line holds a number that is not finite")]
    NotFinite {
        /// Number of the point, from one.
        point: usize,
    },
    /// A point at the position of the previous one.
    #[error("point {point} of the line lies where point {} lies", .point - 1)]
    SamePoint {
        /// Number of the point, from one.
        point: usize,
    },
    /// A splined line with decreasing x.
    #[error(
        "point {point} of the line lies at x = {} m, and the point before at {} m: a splined line leads outward", rounded(*.found), rounded(*.before)
    )]
    Backward {
        /// Number of the point, from one.
        point: usize,
        /// Its abscissa [m].
        found: f64,
        /// The abscissa before [m].
        before: f64,
    },
    /// A line along z, about which the chord cannot be level.
    #[error("the line leads along z from point {} to point {point}: its chord has no direction", .point - 1)]
    Vertical {
        /// Number of the outer point, from one.
        point: usize,
    },
    /// An arc without length.
    #[error("arc {arc} of the line is {} m long, expected more than zero", rounded(*.found))]
    ArcLength {
        /// Number of the arc, from one.
        arc: usize,
        /// Its length [m].
        found: f64,
    },
    /// A line longer than any blade, or with an overflow of its length.
    #[error("the line is {found:.3e} m long, expected at most {LONGEST:.0e} m")]
    Length {
        /// Its length \[m\].
        found: f64,
    },
    /// Lists of different lengths.
    #[error(
        "the line has {points} points, {curvatures} curvatures and {lengths} lengths of arcs, expected one point more than arcs"
    )]
    Lists {
        /// Points.
        points: usize,
        /// Curvatures.
        curvatures: usize,
        /// Lengths.
        lengths: usize,
    },
}

impl Explain for LineProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Backward { .. } => Some(
                "list the points from the root to the tip, or take course = \"polyline\""
                    .to_owned(),
            ),
            Self::Length { .. } => Some("check the numbers and the unit of the points".to_owned()),
            Self::Vertical { .. } => {
                Some("give the line by its curvature, or turn the root axes".to_owned())
            }
            _ => None,
        }
    }
}

impl ReferenceLine {
    /// All problems of the line; empty if it is valid.
    pub fn problems(&self) -> Vec<LineProblem> {
        let mut found: Vec<_> = self.not_finite().collect();
        let points = self.points.len();
        let (curvatures, lengths) = (self.curvature.len(), self.arc_length.len());
        let arcs = match self.course {
            Course::Arcs => points.saturating_sub(1),
            _ => 0,
        };
        if points < 2 {
            found.push(LineProblem::Points { found: points });
        } else if curvatures != arcs || lengths != arcs {
            found.push(LineProblem::Lists {
                points,
                curvatures,
                lengths,
            });
        }
        if !found.is_empty() {
            return found;
        }
        match self.course {
            Course::Polyline => found.extend(self.same_points().chain(self.vertical())),
            Course::Spline => found.extend(self.backward()),
            Course::Arcs => found.extend(self.without_length()),
        }
        if found.is_empty() {
            found.extend(self.too_long());
        }
        found
    }

    fn not_finite(&self) -> impl Iterator<Item = LineProblem> {
        let bad = |i: usize| {
            let point = &self.points[i];
            let arc = i.checked_sub(1).and_then(|arc| self.curvature.get(arc));
            let mut numbers = point.position.iter().chain(arc.into_iter().flatten());
            !point.twist.is_finite() || numbers.any(|number| !number.is_finite())
        };
        let bad = (0..self.points.len()).filter(move |&i| bad(i));
        bad.map(|i| LineProblem::NotFinite { point: i + 1 })
    }

    fn same_points(&self) -> impl Iterator<Item = LineProblem> {
        let pairs = self.points.windows(2).enumerate();
        let same = pairs.filter(|(_, pair)| pair[0].position == pair[1].position);
        same.map(|(i, _)| LineProblem::SamePoint { point: i + 2 })
    }

    fn vertical(&self) -> impl Iterator<Item = LineProblem> {
        let pairs = self.points.windows(2).enumerate();
        let vertical = pairs.filter(|(_, pair)| {
            let step = pair[1].position - pair[0].position;
            step.norm() > 0.0 && step.x.hypot(step.y) <= LEVEL * step.norm()
        });
        vertical.map(|(i, _)| LineProblem::Vertical { point: i + 2 })
    }

    fn backward(&self) -> impl Iterator<Item = LineProblem> {
        let pairs = self.points.windows(2).enumerate();
        pairs.filter_map(|(i, pair)| {
            let (before, found) = (pair[0].position.x, pair[1].position.x);
            let point = i + 2;
            let problem = LineProblem::Backward {
                point,
                found,
                before,
            };
            (found <= before).then_some(problem)
        })
    }

    fn too_long(&self) -> Option<LineProblem> {
        let found = self.length();
        let is_right = found <= LONGEST;
        (!is_right).then_some(LineProblem::Length { found })
    }

    fn without_length(&self) -> impl Iterator<Item = LineProblem> {
        let arcs = self.arc_length.iter().enumerate();
        let bad = arcs.filter(|(_, length)| !(length.is_finite() && **length > 0.0));
        bad.map(|(i, &found)| LineProblem::ArcLength { arc: i + 1, found })
    }
}
