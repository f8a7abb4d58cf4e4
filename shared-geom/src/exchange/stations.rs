//! Stations, lines and matrices converted between formats.

use nalgebra::{Matrix6, Vector2};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::hash::{sha256_of, sha256_of_content};
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::section::Provenance;

use super::Options;
use super::problem::{ExchangeProblem, Problems};

/// Asymmetry of a matrix, relative to the roots of its diagonal entries, that rounded
/// digits explain; beyond it the matrix is treated as wrong.
const ROUNDED: f64 = 1e-3;

/// Origin of a blade read from files of another tool.
pub(super) fn provenance(tool: &str, texts: &[&str]) -> Provenance {
    let parts: Vec<_> = texts.iter().map(|text| text.as_bytes()).collect();
    Provenance {
        program: tool.to_owned(),
        version: String::new(),
        input_hash: match parts[..] {
            [one] => sha256_of_content(one),
            _ => sha256_of(&parts),
        },
        nodes: 0,
        cells: 0,
        history: Vec::new(),
        sections: Vec::new(),
    }
}

/// The name of a blade from the name of its file.
pub(super) fn name_of(file: &std::path::Path) -> String {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let stem = name.split('.').next().unwrap_or_default();
    if stem.is_empty() { "blade" } else { stem }.to_owned()
}

/// A station is at an end of the line within this part of its length.
const END: f64 = 1e-9;

/// Points of an arc in a format without arcs.
const POINTS_OF_ARC: usize = 8;

/// `blade` as formats of points and times can contain it: about its line, which is
/// defined by points, with at most one damping time for each component. Adds the losses.
pub(super) fn prepared(blade: &Blade, lost: &mut Vec<String>) -> Blade {
    let mut result = if blade.reference_point == Vector2::zeros() {
        blade.clone()
    } else {
        blade.on_line()
    };
    if let Some(BladeDamping::Viscous(all)) = &result.damping {
        let (times, change) = fitted(&result.stations, all);
        lost.push(format!(
            "damping is written as six damping times: up to {:.2} % of its largest entry lost",
            100.0 * change
        ));
        result.damping = Some(BladeDamping::Times(times));
    }
    if result.line.course == Course::Arcs {
        let (line, difference) = sampled(&result.line);
        lost.push(format!(
            "the line of arcs is written as {} points: the difference is up to {difference:.2e} m",
            line.points.len()
        ));
        let scale = line.length() / result.line.length();
        for station in &mut result.stations {
            station.arc_length *= scale;
        }
        result.line = line;
    }
    result
}

/// Times with `D = diag(times) K` as close as possible, and the largest relative
/// difference of the damping [-].
fn fitted(stations: &[Station], damping: &[Matrix6<f64>]) -> ([f64; 6], f64) {
    let pairs = || stations.iter().zip(damping);
    let times = std::array::from_fn(|i| {
        let of = |(station, d): (&Station, &Matrix6<f64>)| d[(i, i)] / station.stiffness[(i, i)];
        pairs().map(of).sum::<f64>() / (pairs().count().max(1) as f64)
    });
    let apart = |(station, d): (&Station, &Matrix6<f64>)| {
        let fit = Matrix6::from_fn(|i, j| times[i] * station.stiffness[(i, j)]);
        (d - fit).amax() / d.amax().max(f64::MIN_POSITIVE)
    };
    (times, pairs().map(apart).fold(0.0, f64::max))
}

/// A line of arcs as splines through points, or straight pieces if it turns back; and
/// their difference [m].
fn sampled(line: &ReferenceLine) -> (ReferenceLine, f64) {
    let curve = line.curve();
    let pieces = (line.arc_length.len() * POINTS_OF_ARC).max(1);
    let spot = |i: usize| curve.length() * i as f64 / pieces as f64;
    let point = |i: usize| {
        let placed = curve.at(spot(i));
        LinePoint {
            position: placed.position,
            twist: placed.twist,
        }
    };
    let points: Vec<_> = (0..=pieces).map(point).collect();
    let mut steps = points.windows(2);
    let course = if steps.all(|pair| pair[1].position.x > pair[0].position.x) {
        Course::Spline
    } else {
        Course::Polyline
    };
    let through = ReferenceLine::through(points, course);
    let other = through.curve();
    let apart = (0..pieces).map(|i| {
        let middle = 0.5 * (spot(i) + spot(i + 1));
        let there = other.at(middle * other.length() / curve.length());
        (curve.at(middle).position - there.position).norm()
    });
    let apart = apart.fold(0.0, f64::max);
    (through, apart)
}

/// The stations of `blade` for a format that is linear between stations, from end to end:
/// stations of a blade with constant pieces are doubled at the ends of the pieces.
pub(super) fn linear_stations(blade: &Blade) -> Vec<Station> {
    let length = blade.length();
    let margin = END * length;
    let mut stations = match blade.interpolation {
        Interpolation::Linear => blade.stations.clone(),
        Interpolation::Constant => doubled(&blade.stations, length - margin),
    };
    // The properties of the outer stations apply beyond them.
    if let Some(&first) = stations.first().filter(|first| first.arc_length > margin) {
        let arc_length = 0.0;
        stations.insert(
            0,
            Station {
                arc_length,
                ..first
            },
        );
    }
    let short = |last: &&Station| last.arc_length < length - margin;
    if let Some(&last) = stations.last().filter(short) {
        let arc_length = length;
        stations.push(Station { arc_length, ..last });
    }
    stations
}

/// Two stations for each piece of constant properties; the last begins a piece only if it
/// is before the `end` [m].
fn doubled(stations: &[Station], end: f64) -> Vec<Station> {
    let pieces = stations
        .windows(2)
        .filter(|pair| pair[1].arc_length > pair[0].arc_length);
    let ends = pieces.flat_map(|pair| {
        let arc_length = pair[1].arc_length;
        [
            pair[0],
            Station {
                arc_length,
                ..pair[0]
            },
        ]
    });
    let mut all: Vec<_> = ends.collect();
    let last = stations.last();
    all.extend(last.filter(|last| all.is_empty() || last.arc_length < end));
    all
}

/// Arc lengths at which the properties of a list of stations jump.
pub(super) fn jumps(stations: &[Station]) -> Vec<f64> {
    let pairs = stations.windows(2);
    let doubled = pairs.filter(|pair| pair[0].arc_length == pair[1].arc_length);
    doubled
        .filter(|pair| pair[0].stiffness != pair[1].stiffness || pair[0].mass != pair[1].mass)
        .map(|pair| pair[0].arc_length)
        .collect()
}

/// The symmetric part of a matrix that is symmetric up to rounded digits; notes other
/// matrices.
pub(super) fn symmetric(
    matrix: &Matrix6<f64>,
    what: &str,
    line: usize,
    problems: &mut Problems,
) -> Matrix6<f64> {
    for i in 0..6 {
        for j in i + 1..6 {
            let (upper, lower) = (matrix[(i, j)], matrix[(j, i)]);
            let scale = (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
            let size = scale.max(upper.abs().min(lower.abs()));
            if (upper - lower).abs() > ROUNDED * size {
                problems.push(
                    line,
                    &ExchangeProblem::Other {
                        what: format!(
                            "{what} at ({}, {}) and ({}, {})",
                            i + 1,
                            j + 1,
                            j + 1,
                            i + 1
                        ),
                        found: format!("{upper:e} and {lower:e}"),
                        expected: "a symmetric matrix".to_owned(),
                        help: "a row may be missing or misplaced".to_owned(),
                    },
                );
                return *matrix;
            }
        }
    }
    // The mean of equal numbers is the number itself.
    Matrix6::from_fn(|i, j| 0.5 * matrix[(i, j)] + 0.5 * matrix[(j, i)])
}

/// Distance of two lines through the same points, half way between
/// points: position [m] and twist [rad].
pub(super) fn apart(a: &ReferenceLine, b: &ReferenceLine) -> (f64, f64) {
    let (mut distance, mut twist) = (0.0_f64, 0.0_f64);
    let (a, b) = (a.curve(), b.curve());
    let (in_a, in_b) = (a.arc_lengths(), b.arc_lengths());
    for (at_a, at_b) in in_a.windows(2).zip(in_b.windows(2)) {
        let here = a.at(0.5 * (at_a[0] + at_a[1]));
        let there = b.at(0.5 * (at_b[0] + at_b[1]));
        distance = distance.max((here.position - there.position).norm());
        twist = twist.max((here.twist - there.twist).abs());
    }
    (distance, twist)
}

/// Remark on a length that was given for a file with its own line.
pub(super) fn unused_length(blade: &Blade, options: &Options) -> Option<String> {
    const SAME: f64 = 1e-9;
    let (given, length) = (options.length?, blade.length());
    let is_same = (given - length).abs() <= SAME * length;
    (!is_same).then(|| {
        format!(
            "the length {given} m that was given is not used: the file has a line of its own, \
             {length} m long"
        )
    })
}
