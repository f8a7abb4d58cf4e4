//! The table `[line]`: a length, points in the table or in a file, or arcs.

use nalgebra::Vector3;

use super::Sources;
use super::columns::{Columns, Measure};
use super::frame::Frame;
use super::keys::{ARC, COURSE, CURVATURE, FILE, LENGTH, ROOT_TWIST, TWIST, TWIST_RATE};
use super::problem::InputProblem;
use crate::document::Table;
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::units::Dimension;

/// Keys of the coordinates of points in the axes of the frame.
const AXES: [&str; 3] = ["x", "y", "z"];
/// The same as words.
const WORDS: [&str; 3] = ["span", "sweep", "prebend"];
/// Keys of lists of points.
const KEYS: [&str; 9] = [
    "x",
    "y",
    "z",
    "span",
    "sweep",
    "prebend",
    "twist",
    "offset_forward",
    "offset_up",
];

/// Reads the line of a blade.
pub(super) fn read(
    table: &Table<'_>,
    frame: Option<&Frame>,
    sources: &Sources,
) -> Option<ReferenceLine> {
    let ways = [LENGTH.name(), FILE.name(), ARC.name(), "span"];
    let mut given: Vec<_> = ways.into_iter().filter(|way| table.has(way)).collect();
    given.extend(AXES.into_iter().find(|axis| table.has(axis)));
    match given[..] {
        ["length"] => straight(table, frame),
        ["arc"] => arcs(table, frame),
        ["file"] => {
            // Noted if it is absent, even if the file cannot be read.
            let course = table.get(&COURSE);
            let columns = Columns::read(table, &KEYS.map(str::to_owned), sources);
            let line = columns.as_ref().and_then(|columns| {
                let lists = Lists::File(columns);
                through(table, (&lists, course), frame)
            });
            if let Some(columns) = columns {
                columns.finish(sources);
            }
            line
        }
        ["x" | "y" | "z" | "span"] => {
            // All of them are known keys, even if others are wrong.
            for key in KEYS {
                table.has(key);
            }
            let course = table.get(&COURSE);
            through(table, (&Lists::Inline(table), course), frame)
        }
        [one, other, ..] => {
            let problem = InputProblem::Both {
                table: "[line]".to_owned(),
                one: one.to_owned(),
                other: other.to_owned(),
            };
            table.note(other, &problem);
            None
        }
        _ => {
            let problem = InputProblem::Neither {
                table: "[line]".to_owned(),
                known: vec![
                    "\"length\" of a straight line",
                    "points (\"x\", \"y\", \"z\", or \"span\")",
                    "a \"file\" of points",
                    "\"arc\"s",
                ],
            };
            table.note("", &problem);
            None
        }
    }
}

/// A straight line of a given length; twist at its ends, or of the whole.
fn straight(table: &Table<'_>, frame: Option<&Frame>) -> Option<ReferenceLine> {
    let (length, twist) = (table.get(&LENGTH), table.get(&TWIST));
    let twist = match twist?[..] {
        [both] => [both; 2],
        [root, tip] => [root, tip],
        ref list => {
            let problem = InputProblem::Count {
                key: TWIST.name().to_owned(),
                found: list.len(),
                expected: "one angle, or those at root and tip",
            };
            table.note(&TWIST, &problem);
            return None;
        }
    };
    let mut line = ReferenceLine::straight(length?);
    for (point, twist) in line.points.iter_mut().zip(twist) {
        point.twist = frame?.twist(twist);
    }
    Some(line)
}

/// Lists of a line: keys of the table, or columns of a file.
enum Lists<'a> {
    Inline(&'a Table<'a>),
    File(&'a Columns<'a>),
}

impl Lists<'_> {
    fn has(&self, key: &str) -> bool {
        match self {
            Self::Inline(table) => table.has(key),
            Self::File(columns) => columns.has(key),
        }
    }

    fn numbers(&self, table: &Table<'_>, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        match self {
            Self::Inline(table) => table.quantities(key, dimension),
            Self::File(columns) => {
                let factor = table.document().factor(dimension);
                columns.numbers(key, Measure { dimension, factor })
            }
        }
    }

    /// The numbers under `key`, `count` of them; zeros if the key is absent.
    fn of_points(
        &self,
        table: &Table<'_>,
        key: &'static str,
        dimension: Dimension,
        first: (&'static str, usize),
    ) -> Option<Vec<f64>> {
        let (other, expected) = first;
        if !self.has(key) {
            return Some(vec![0.0; expected]);
        }
        let numbers = self.numbers(table, key, dimension)?;
        let found = numbers.len();
        if found != expected {
            let problem = InputProblem::Lists {
                key,
                found,
                other,
                expected,
            };
            table.note(key, &problem);
            return None;
        }
        Some(numbers)
    }
}

/// A line through points: coordinates in the frame, or span, sweep and prebend; with its interpolation
/// between them.
fn through(
    table: &Table<'_>,
    (lists, course): (&Lists<'_>, Option<usize>),
    frame: Option<&Frame>,
) -> Option<ReferenceLine> {
    // In axes by their names, or as words; the first that exists counts the points.
    let by_axes = AXES.iter().any(|axis| lists.has(axis));
    let keys = if by_axes { AXES } else { WORDS };
    let first = keys
        .into_iter()
        .find(|key| lists.has(key))
        .unwrap_or(keys[0]);
    let count = (first, lists.numbers(table, first, Dimension::LENGTH)?.len());
    let [first, second, third] =
        keys.map(|key| lists.of_points(table, key, Dimension::LENGTH, count));
    let twist = lists.of_points(table, "twist", Dimension::ANGLE, count);
    let offsets = ["offset_forward", "offset_up"]
        .map(|key| lists.of_points(table, key, Dimension::LENGTH, count));
    let (first, second, third) = (first?, second?, third?);
    let (twist, frame) = (twist?, frame?);
    let point = |i: usize| {
        let position = if by_axes {
            frame.vector([first[i], second[i], third[i]])
        } else {
            // Sweep is positive aft.
            Vector3::new(first[i], -second[i], third[i])
        };
        LinePoint {
            position,
            twist: frame.twist(twist[i]),
        }
    };
    let line = ReferenceLine::through(
        (0..first.len()).map(point).collect(),
        [Course::Polyline, Course::Spline][course?],
    );
    let [forward, up] = offsets;
    Some(displaced(line, &forward?, &up?))
}

/// The line next to `line`: each of its points moved in the section axes there.
fn displaced(line: ReferenceLine, forward: &[f64], up: &[f64]) -> ReferenceLine {
    let is_zero = |numbers: &[f64]| numbers.iter().all(|number| *number == 0.0);
    if (is_zero(forward) && is_zero(up)) || !line.problems().is_empty() {
        return line;
    }
    let curve = line.curve();
    let positions = curve.arc_lengths().iter();
    let moved = positions.zip(forward.iter().zip(up)).zip(&line.points);
    let points = moved.map(|((&s, (&forward, &up)), point)| {
        let axes = curve.at(s).axes;
        LinePoint {
            position: point.position + axes * Vector3::new(0.0, forward, up),
            twist: point.twist,
        }
    });
    ReferenceLine::through(points.collect(), line.course)
}

/// A line by its curvature: `[[line.arc]]`.
fn arcs(table: &Table<'_>, frame: Option<&Frame>) -> Option<ReferenceLine> {
    let twist = table.get(&ROOT_TWIST);
    let arcs = table.each(&ARC, |arc| {
        let (length, rate) = (arc.get(&LENGTH), arc.get(&TWIST_RATE));
        let curvature = frame?.vector(arc.get(&CURVATURE)?.0.into());
        let rate = frame?.twist(rate?);
        Some((length?, curvature + Vector3::new(rate, 0.0, 0.0)))
    });
    let root = LinePoint {
        position: Vector3::zeros(),
        twist: frame?.twist(twist?),
    };
    Some(ReferenceLine::curved(root, &arcs?))
}
