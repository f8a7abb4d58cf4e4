//! Stations with sections that were solved for a curved and twisted beam.
//!
//! The line of the blade carries the curvature in kinematics and equilibrium, the
//! matrices of the section its effect inside of the section. Nothing is added, and the
//! line must have the curvature for which the section was solved (D-230), (D-232).

use nalgebra::{Matrix6, Vector2};

use super::{Blade, BladeProblem, Interpolation, Side};
use crate::figure::tick_label;
use crate::line::Curve;
use crate::section::{Agreement, CurvatureMismatch, InitialCurvature, SectionProperties};

/// The section of a station that was solved for a curved and twisted beam.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CurvedStation {
    /// The property file, as it is named.
    pub file: String,
    /// Curvature for which it was solved, by the parameter of its matrices, in its own
    /// axes and about its own reference point.
    initial: InitialCurvature,
    /// Its 6x6 stiffness.
    stiffness: Matrix6<f64>,
    /// Its reference point, (y, z) from the line in the section axes of the line.
    point: Vector2<f64>,
    /// From the section axes of the line to its own.
    angle: f64,
}

/// Properties between two arc lengths of the line.
struct Span {
    from: f64,
    to: f64,
    /// Stations at both ends.
    stations: [usize; 2],
}

impl CurvedStation {
    /// The section called `file`, its reference point at `point` [m] from the line and
    /// its axes turned by `angle` [rad]; `None` for the section of a straight beam.
    pub fn of(
        file: &str,
        section: &SectionProperties,
        point: Vector2<f64>,
        angle: f64,
    ) -> Option<Self> {
        let initial = section.initial_curvature;
        let initial = initial.filter(|initial| !initial.is_straight())?;
        Some(Self {
            file: file.to_owned(),
            initial,
            stiffness: section.stiffness,
            point,
            angle,
        })
    }

    /// Curvature for which the section was solved, about the line and in its axes.
    fn on_line(&self) -> InitialCurvature {
        self.initial.rotated(-self.angle).shifted(-self.point)
    }

    /// Length of the line per unit of the parameter of the matrices [-]: `c` of (D-231).
    pub fn stretch(&self) -> f64 {
        self.on_line().slope.norm()
    }

    /// Agreement with the line on both sides of the station, in the axes of the section
    /// and about its reference point.
    fn agreement(&self, line: [InitialCurvature; 2]) -> Agreement {
        let own = |line: InitialCurvature| {
            let there = line.shifted(self.point).rotated(self.angle);
            there.per_arc_length()
        };
        let section = self.initial.per_arc_length();
        Agreement::of(&section, line.map(own), &self.stiffness)
    }
}

impl Blade {
    /// Compares the sections of stations that were solved for a curved beam, parallel to
    /// the stations, with the line: problems with the index of their station, and
    /// remarks.
    pub(crate) fn compare_curved(
        &self,
        curved: &[Option<CurvedStation>],
    ) -> (Vec<(usize, BladeProblem)>, Vec<String>) {
        let (mut problems, mut remarks) = (Vec::new(), Vec::new());
        if curved.iter().all(Option::is_none) {
            return (problems, remarks);
        }
        let curve = self.line.curve();
        for (station, found) in curved.iter().enumerate().take(self.stations.len()) {
            let Some(section) = found else {
                continue;
            };
            let position = self.stations[station].arc_length;
            match section.agreement(self.sides(&curve, station)) {
                Agreement::Same => {}
                Agreement::Near(mismatch) => remarks.push(format!(
                    "station {} at {} m, {}: {mismatch}; {}; the matrices are used as given",
                    station + 1,
                    tick_label(position, 0.0),
                    section.file,
                    mismatch.size()
                )),
                Agreement::Other(mismatch) => problems.push((
                    station,
                    BladeProblem::Curvature {
                        station: station + 1,
                        position,
                        file: section.file.clone(),
                        mismatch,
                    },
                )),
            }
        }
        if problems.is_empty() {
            remarks.extend(self.between_stations(&curve, curved));
        }
        (problems, remarks)
    }

    /// Curvature of the line on the sides of a station to which its properties belong.
    fn sides(&self, curve: &Curve, station: usize) -> [InitialCurvature; 2] {
        let position = self.stations[station].arc_length;
        let is_at = |other: Option<usize>| {
            let other = other.and_then(|other| self.stations.get(other));
            other.is_some_and(|other| other.arc_length == position)
        };
        let is_last = position >= curve.length();
        let outer_only = match self.interpolation {
            Interpolation::Constant => !is_last,
            Interpolation::Linear => is_at(station.checked_sub(1)),
        };
        let sides = match (is_at(Some(station + 1)), outer_only) {
            (_, true) => [Side::Outer; 2],
            (true, false) => [Side::Inner; 2],
            (false, false) => [Side::Inner, Side::Outer],
        };
        sides.map(|side| curve.initial_curvature(position, side))
    }

    /// The largest difference between the stations that is reported.
    fn between_stations(&self, curve: &Curve, curved: &[Option<CurvedStation>]) -> Option<String> {
        let mut worst: Option<(f64, CurvatureMismatch)> = None;
        for span in self.spans(curve.length()) {
            let [inner, outer] = span.stations.map(|station| curved[station].as_ref());
            let Some((inner, outer)) = inner.zip(outer) else {
                continue;
            };
            let ends = [inner, outer].map(|section| section.on_line().per_arc_length());
            let known = curve.arc_lengths().iter().copied();
            let mut positions: Vec<f64> =
                known.filter(|s| *s > span.from && *s < span.to).collect();
            positions.insert(0, span.from);
            positions.push(span.to);
            for pair in positions.windows(2) {
                let position = 0.5 * (pair[0] + pair[1]);
                let part = if span.stations[0] == span.stations[1] {
                    0.0
                } else {
                    (position - span.from) / (span.to - span.from)
                };
                let section = InitialCurvature {
                    curvature: ends[0].curvature.lerp(&ends[1].curvature, part),
                    slope: ends[0].slope.lerp(&ends[1].slope, part),
                };
                let line = curve.initial_curvature(position, Side::Outer);
                let stiffness = self.at(position, Side::Outer).0;
                let found = match Agreement::of(&section, [line; 2], &stiffness) {
                    Agreement::Same => continue,
                    Agreement::Near(mismatch) | Agreement::Other(mismatch) => mismatch,
                };
                if worst.is_none_or(|known| found.delta > known.1.delta) {
                    worst = Some((position, found));
                }
            }
        }
        let (position, mismatch) = worst?;
        Some(format!(
            "between stations, most at {} m: {mismatch}; {}: add stations there for the \
             curvature of the line",
            tick_label(position, 0.0),
            mismatch.size()
        ))
    }

    /// The parts of the line between stations, inside the first and outside the last.
    fn spans(&self, length: f64) -> Vec<Span> {
        let positions: Vec<_> = self.stations.iter().map(|at| at.arc_length).collect();
        let last = positions.len().saturating_sub(1);
        let mut spans: Vec<Span> = (1..positions.len())
            .map(|k| Span {
                from: positions[k - 1],
                to: positions[k],
                stations: match self.interpolation {
                    Interpolation::Linear => [k - 1, k],
                    Interpolation::Constant => [k - 1; 2],
                },
            })
            .collect();
        let ends = positions.first().zip(positions.last());
        for (from, to, station) in ends
            .map(|(first, outer)| [(0.0, *first, 0), (*outer, length, last)])
            .into_iter()
            .flatten()
        {
            let stations = [station; 2];
            spans.push(Span { from, to, stations });
        }
        spans.retain(|span| span.to > span.from);
        spans
    }
}
