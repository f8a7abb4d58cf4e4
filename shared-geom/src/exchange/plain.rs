//! A blade as the tables of other tools contain it: a line by its points, and stations of
//! strictly increasing arc length with linear interpolation between them.

use crate::blade::{Blade, Interpolation, Station};
use crate::line::{Course, LinePoint, ReferenceLine};

/// Width of the ramp that replaces a jump, as part of the length: the frequencies change
/// by about as much, and tables with 17 digits still have increasing positions.
const RAMP: f64 = 1e-9;

/// Angle of an arc between two points that replace it [rad]: inside an arc a cubic spline
/// through them is off by some 1e-9 of their distance, next to its ends by 1e-4.
const ARC_ANGLE: f64 = 0.005;

/// Fewest and most points that replace one arc.
const ARC_POINTS: [f64; 2] = [8.0, 200.0];

/// A blade as converted.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plain {
    /// Points of the line.
    pub points: Vec<LinePoint>,
    /// Their arc lengths, as parts of the length [-].
    pub point_parts: Vec<f64>,
    /// The interpolation of the line between its points: straight or splined.
    pub course: Course,
    /// Stations, each after the previous one.
    pub stations: Vec<Station>,
    /// Length of the line [m].
    pub length: f64,
    /// From Helicoid's axes to BeamDyn's, at each point: see [`turns`] [rad].
    pub turns: Vec<f64>,
    /// Description of the changes.
    pub lost: Vec<String>,
}

impl Plain {
    /// Of `blade`.
    pub fn of(blade: &Blade) -> Self {
        let blade = &blade.on_line();
        let mut lost = Vec::new();
        let line = through_points(&blade.line, &mut lost);
        let arcs = line.arc_lengths();
        let length = line.length();
        let mut stations = growing(blade, &mut lost);
        // Points that replace arcs make a slightly shorter line.
        let stretch = length / blade.length();
        for station in &mut stations {
            station.arc_length *= stretch;
        }
        Self {
            point_parts: parts(&arcs, length),
            turns: turns(&line),
            points: line.points,
            course: line.course,
            stations,
            length,
            lost,
        }
    }

    /// Arc lengths of the stations, as parts of the length [-].
    pub fn station_parts(&self) -> Vec<f64> {
        let arcs: Vec<_> = self
            .stations
            .iter()
            .map(|station| station.arc_length)
            .collect();
        parts(&arcs, self.length)
    }
}

/// The word of an interpolation in the head of a file.
pub(super) fn course_name(course: Course) -> &'static str {
    match course {
        Course::Polyline => "polyline",
        _ => "spline",
    }
}

/// The interpolation that a comment in the head of a file states, written by Helicoid: other
/// tools leave it open.
pub(super) fn stated_course(text: &str) -> Option<Course> {
    const HEAD: usize = 40;
    let stated = |line: &str| {
        let (before, word) = line.split_once("course: ")?;
        if !before.trim().chars().all(|letter| "#;!".contains(letter)) {
            return None;
        }
        match word.split_whitespace().next()? {
            "polyline" => Some(Course::Polyline),
            "spline" => Some(Course::Spline),
            _ => None,
        }
    };
    text.lines().take(HEAD).find_map(stated)
}

/// The angle about the tangent from Helicoid's axes without twist, whose y axis is level
/// (without component along z of the root), to the axes of BeamDyn and windIO, whose x
/// axis (Helicoid's z) has no component along y of the root, at each point of a line
/// [rad]:
///
/// ```text
/// delta = -asin(t_y t_z / (sqrt(t_x^2 + t_y^2) sqrt(t_x^2 + t_z^2)))
/// ```
pub(super) fn turns(line: &ReferenceLine) -> Vec<f64> {
    let curve = line.curve();
    let turn = |&s: &f64| {
        let t = curve.at(s).tangent;
        let turn = -(t.y * t.z / (t.x.hypot(t.y) * t.x.hypot(t.z))).asin();
        if turn.is_finite() { turn } else { 0.0 }
    };
    curve.arc_lengths().iter().map(turn).collect()
}

fn parts(arcs: &[f64], length: f64) -> Vec<f64> {
    let last = arcs.len().saturating_sub(1);
    let part = |(i, arc): (usize, &f64)| match arc / length {
        // The end is exact, independent of the last digit of the division.
        part if i == last && (part - 1.0).abs() < 1e-12 => 1.0,
        part if part.is_finite() => part,
        _ => 0.0,
    };
    arcs.iter().enumerate().map(part).collect()
}

/// A line of points: arcs become points that lie close together.
fn through_points(line: &ReferenceLine, lost: &mut Vec<String>) -> ReferenceLine {
    if line.course != Course::Arcs {
        return line.clone();
    }
    let curve = line.curve();
    let mut points: Vec<LinePoint> = line.points.first().copied().into_iter().collect();
    let mut from = 0.0;
    for (i, (length, curvature)) in line.arc_length.iter().zip(&line.curvature).enumerate() {
        let count = (length * curvature.norm() / ARC_ANGLE).ceil();
        let count = count.clamp(ARC_POINTS[0], ARC_POINTS[1]) as usize;
        for k in 1..count {
            let placed = curve.at(from + length * k as f64 / count as f64);
            points.push(LinePoint {
                position: placed.position,
                twist: placed.twist,
            });
        }
        points.extend(line.points.get(i + 1));
        from += length;
    }
    let grows = points
        .windows(2)
        .all(|two| two[1].position.x > two[0].position.x);
    let course = if grows {
        Course::Spline
    } else {
        Course::Polyline
    };
    let plain = ReferenceLine::through(points, course);
    lost.push(format!(
        "a line of constant curvature: written as {} points with a {} between them, off by up to \
         {:.1e} m",
        plain.points.len(),
        course_name(course),
        apart(&plain, line),
    ));
    plain
}

/// Distance of `line` from `other` half way between its points [m].
fn apart(line: &ReferenceLine, other: &ReferenceLine) -> f64 {
    let (line, other) = (line.curve(), other.curve());
    let middles = line
        .arc_lengths()
        .windows(2)
        .map(|two| 0.5 * (two[0] + two[1]));
    let off = middles.map(|s| (line.at(s).position - other.at(s).position).norm());
    off.fold(0.0, f64::max)
}

/// Stations at increasing positions: constant pieces get a station at both ends, and of
/// two stations at one position the inner one moves inward by a ramp.
fn growing(blade: &Blade, lost: &mut Vec<String>) -> Vec<Station> {
    let length = blade.length();
    let mut stations = blade.stations.clone();
    for station in &mut stations {
        station.arc_length = station.arc_length.clamp(0.0, length);
    }
    if blade.interpolation == Interpolation::Constant {
        stations = held(&stations, length);
    }
    // The inner side of a jump at the root has no length.
    let before = stations.iter().skip(1);
    let inside = before.take_while(|station| station.arc_length <= 0.0);
    let inside = inside.count();
    stations.drain(..inside);
    // Tables need two rows or more.
    if let [only] = stations[..] {
        stations = [0.0, length]
            .map(|arc_length| Station { arc_length, ..only })
            .to_vec();
    }
    let ramp = RAMP * length;
    let mut count = 0;
    for i in 1..stations.len() {
        if stations[i].arc_length <= stations[i - 1].arc_length {
            stations[i - 1].arc_length = stations[i].arc_length - ramp;
            count += 1;
        }
    }
    if count > 0 {
        lost.push(format!(
            "jumps of the properties: {count} written as ramps of {ramp:.1e} m, since the \
             positions of the table must increase",
        ));
    }
    stations
}

/// Each station twice: at the beginning and at the end of its piece.
fn held(stations: &[Station], length: f64) -> Vec<Station> {
    let ends = stations.iter().skip(1).map(|next| next.arc_length);
    let ends = ends.chain([length]);
    let both = stations.iter().zip(ends).flat_map(|(station, end)| {
        let end = Station {
            arc_length: end,
            ..*station
        };
        // A piece that begins at the tip has no length.
        let pieces = if end.arc_length > station.arc_length {
            2
        } else {
            0
        };
        [*station, end].into_iter().take(pieces)
    });
    both.collect()
}
