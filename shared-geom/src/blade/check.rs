//! The checks of a blade.

use super::{Blade, BladeDamping, BladeProblem, Interpolation, Side};
use crate::section::{self, PropertyProblem};

/// Part of the length of the line by which a station may lie beyond its end:
/// round-off of a file.
const BEYOND: f64 = 1e-6;

/// Smallest eigenvalue of a stiffness scaled to a unit diagonal treated as positive:
/// a few roundings of a sum of six.
const POSITIVE: f64 = 1e-14;
/// Bisections of the distance between two stations: six digits for a message.
const BISECTIONS: usize = 20;

impl Blade {
    /// All problems of the blade; empty if it is valid. A valid blade has a valid line,
    /// stations in order on it, and at each station a positive definite stiffness and a
    /// positive semidefinite mass.
    ///
    /// Between valid stations all is valid: a mean of positive definite matrices is
    /// positive definite. See [`Blade::problems_at`] for a blade that was not checked.
    pub fn problems(&self) -> Vec<BladeProblem> {
        self.placed_problems().into_iter().map(|p| p.1).collect()
    }

    /// Problems of the stiffness at the arc lengths `positions` [m] at which it is
    /// evaluated.
    pub fn problems_at(&self, positions: &[f64]) -> Vec<BladeProblem> {
        let known = self.positions();
        let problem = |&position: &f64| {
            let sides = [Side::Inner, Side::Outer].map(|side| self.at(position, side).0);
            let [inner, outer] = sides.map(|k| section::least_eigenvalue(&k));
            // NaN is treated as the smallest.
            let value = if inner <= outer || inner.is_nan() {
                inner
            } else {
                outer
            };
            let before = known.iter().rev().find(|s| **s <= position);
            let behind = known.iter().find(|s| **s >= position);
            let (inner, outer) = (before.or(behind)?, behind.or(before)?);
            let good = value >= POSITIVE;
            (!good).then_some(BladeProblem::Indefinite {
                position,
                inner: *inner,
                outer: *outer,
                value,
            })
        };
        positions.iter().filter_map(problem).collect()
    }

    /// Each problem with the index of its station; `None` for the blade as a whole.
    pub(crate) fn placed_problems(&self) -> Vec<(Option<usize>, BladeProblem)> {
        let mut found = Vec::new();
        let line = self.line.problems();
        let line_is_good = line.is_empty();
        found.extend(line.into_iter().map(|problem| (None, problem.into())));
        if self.stations.is_empty() {
            found.push((None, BladeProblem::NoStations));
        }
        if !self.reference_point.iter().all(|x| x.is_finite()) {
            let field = "reference_point";
            found.push((None, BladeProblem::NotFinite { field }));
        }
        if line_is_good {
            found.extend(self.off_line());
        }
        found.extend(self.out_of_order());
        found.extend(self.unsound());
        found.extend(self.damping_problems().map(|problem| (None, problem)));
        found
    }

    fn off_line(&self) -> impl Iterator<Item = (Option<usize>, BladeProblem)> {
        let length = self.length();
        let margin = BEYOND * length;
        let stations = self.stations.iter().enumerate();
        stations.filter_map(move |(k, station)| {
            let found = station.arc_length;
            let on = (-margin..=length + margin).contains(&found);
            let station = k + 1;
            let problem = BladeProblem::OffLine {
                station,
                found,
                length,
            };
            (!on).then_some((Some(k), problem))
        })
    }

    fn out_of_order(&self) -> Vec<(Option<usize>, BladeProblem)> {
        let positions: Vec<_> = self.stations.iter().map(|s| s.arc_length).collect();
        let is_constant = self.interpolation == Interpolation::Constant;
        let problem = |k: usize| {
            let (before, found, station) = (positions[k - 1], positions[k], k + 1);
            if found < before {
                return Some(BladeProblem::Order {
                    station,
                    found,
                    before,
                });
            }
            let position = found;
            let doubled = found == before;
            if doubled && k >= 2 && positions[k - 2] == found {
                return Some(BladeProblem::Third { station, position });
            }
            (doubled && is_constant).then_some(BladeProblem::Doubled { station, position })
        };
        let stations = 1..positions.len();
        stations
            .filter_map(|k| Some((Some(k), problem(k)?)))
            .collect()
    }

    /// Problems of the matrices of each station. A polar moment that differs from the sum
    /// of the other two is reported by [`Blade::remarks`]: tables round it.
    fn unsound(&self) -> impl Iterator<Item = (Option<usize>, BladeProblem)> {
        let stations = self.stations.iter().enumerate();
        stations.flat_map(move |(k, at)| {
            let problems = section::matrix_problems(&at.stiffness, &at.mass);
            let of_station = move |problem: PropertyProblem| {
                let (station, position) = (k + 1, at.arc_length);
                let reported = match problem {
                    PropertyProblem::Polar { .. } => return None,
                    PropertyProblem::Indefinite {
                        field: "stiffness",
                        value,
                        ..
                    } => BladeProblem::IndefiniteStation {
                        station,
                        position,
                        from: self.reach(k, k.checked_sub(1)),
                        to: self.reach(k, Some(k + 1)),
                        value,
                    },
                    problem => BladeProblem::Station {
                        station,
                        position,
                        problem,
                    },
                };
                Some((Some(k), reported))
            };
            problems.into_iter().filter_map(of_station)
        })
    }

    /// Arc length to which the indefinite stiffness of station `k` reaches toward the
    /// station `next`: the mean of both becomes positive definite there.
    fn reach(&self, k: usize, next: Option<usize>) -> f64 {
        let at = &self.stations[k];
        let Some(next) = next.and_then(|next| self.stations.get(next)) else {
            return at.arc_length;
        };
        let is_good = |part: f64| {
            let mean = at.stiffness * (1.0 - part) + next.stiffness * part;
            section::least_eigenvalue(&mean) > 0.0
        };
        let position = |part: f64| at.arc_length + part * (next.arc_length - at.arc_length);
        if self.interpolation == Interpolation::Constant {
            return position(if next.arc_length > at.arc_length {
                1.0
            } else {
                0.0
            });
        }
        if !is_good(1.0) {
            return next.arc_length;
        }
        let (mut bad, mut good) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (bad + good);
            if is_good(middle) {
                good = middle
            } else {
                bad = middle
            }
        }
        position(good)
    }

    fn damping_problems(&self) -> impl Iterator<Item = BladeProblem> {
        let field = "damping";
        let negative = |time: &f64| match *time {
            time if !time.is_finite() => Some(BladeProblem::NotFinite { field }),
            found if found < 0.0 => Some(BladeProblem::NegativeDamping { found }),
            _ => None,
        };
        let found: Vec<_> = match &self.damping {
            None => Vec::new(),
            Some(BladeDamping::Proportional(time)) => negative(time).into_iter().collect(),
            Some(BladeDamping::Times(times)) => times.iter().filter_map(negative).collect(),
            Some(BladeDamping::Viscous(all)) if all.len() != self.stations.len() => {
                let (found, stations) = (all.len(), self.stations.len());
                vec![BladeProblem::DampingCount { found, stations }]
            }
            Some(BladeDamping::Viscous(all)) => {
                let bad = all.iter().flatten().any(|entry| !entry.is_finite());
                bad.then_some(BladeProblem::NotFinite { field })
                    .into_iter()
                    .collect()
            }
        };
        found.into_iter()
    }
}
