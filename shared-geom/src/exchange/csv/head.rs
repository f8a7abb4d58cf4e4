//! The header of a table: the meaning of its numbers.

use crate::blade::{BladeDamping, Interpolation};
use crate::error::nearest_name;
use crate::exchange::frame::Convention;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, number};
use crate::line::Course;

/// The keys of the header that are read.
const KEYS: [&str; 9] = [
    "name",
    "units",
    "frame",
    "order",
    "reference point",
    "course",
    "interpolation",
    "damping",
    "stations",
];

/// Content of the header.
#[derive(Debug)]
pub(super) struct Head {
    pub name: Option<String>,
    pub frame: Option<Convention>,
    pub course: Option<Course>,
    pub interpolation: Option<Interpolation>,
    pub damping: Option<BladeDamping>,
    /// Number of stations of the file; `None` if it is not stated.
    pub stations: Option<usize>,
}

impl Head {
    /// Reads the comment lines; notes wrong or missing ones.
    pub fn parse(lines: &[Line<'_>], problems: &mut Problems) -> Self {
        let entries: Vec<_> = lines.iter().filter_map(entry).collect();
        let find = |key: &str| entries.iter().find(|entry| entry.key == key);
        for key in ["units", "frame", "order", "reference point"] {
            if find(key).is_none() {
                problems.push(0, &undeclared(key, &entries));
            }
        }
        if let Some(units) = find("units") {
            one_of(units, &["SI"], problems);
        }
        if let Some(point) = find("reference point") {
            one_of(point, &["reference line"], problems);
        }
        let frame = find("frame").and_then(|entry| {
            let names = Convention::ALL.map(Convention::name);
            let name = one_of(entry, &names, problems)?;
            Convention::ALL.into_iter().find(|one| one.name() == name)
        });
        if let (Some(frame), Some(order)) = (frame, find("order")) {
            let expected = frame.order().join(", ");
            one_of(order, &[expected.as_str()], problems);
        }
        let chosen = |key: &str, names: &[&'static str], problems: &mut Problems| {
            find(key).map_or(Some(names[0]), |entry| one_of(entry, names, problems))
        };
        let course = chosen("course", &["polyline", "spline"], problems);
        let interpolation = chosen("interpolation", &["linear", "constant"], problems);
        Self {
            name: find("name").map(|entry| entry.value.to_owned()),
            frame,
            course: course.map(|name| match name {
                "spline" => Course::Spline,
                _ => Course::Polyline,
            }),
            interpolation: interpolation.map(|name| match name {
                "constant" => Interpolation::Constant,
                _ => Interpolation::Linear,
            }),
            damping: find("damping").and_then(|entry| damping(entry, problems)),
            stations: find("stations").and_then(|entry| count(entry, problems)),
        }
    }
}

/// A line `# key: value`.
struct Entry<'a> {
    line: usize,
    key: &'a str,
    value: &'a str,
}

fn entry<'a>(line: &Line<'a>) -> Option<Entry<'a>> {
    let (key, value) = line.text.strip_prefix('#')?.split_once(':')?;
    Some(Entry {
        line: line.number,
        key: key.trim(),
        value: value.trim(),
    })
}

fn undeclared(key: &str, entries: &[Entry<'_>]) -> ExchangeProblem {
    let example = match key {
        "units" => "SI",
        "frame" => "helicoid",
        "order" => "axial, shear y, shear z, torsion, bending y, bending z",
        _ => "reference line",
    };
    let strange = entries
        .iter()
        .map(|entry| entry.key)
        .filter(|found| !KEYS.contains(found));
    let near = nearest_name(key, strange);
    let help = match near {
        Some(near) => format!("is \"# {near}:\" meant to be \"# {key}:\"?"),
        None => format!(
            "numbers without it could mean anything; state it on a line of the header, such as \
             \"# {key}: {example}\""
        ),
    };
    ExchangeProblem::Missing {
        what: format!("the statement of {key}"),
        help,
    }
}

/// The name of `names` that the value is, or begins with before a parenthesis.
fn one_of<'a>(entry: &Entry<'_>, names: &[&'a str], problems: &mut Problems) -> Option<&'a str> {
    // Notes in parentheses may follow a name, but belong to an order.
    let plain = entry.value.split(" (").next().unwrap_or_default().trim();
    let is =
        |name: &&&str| entry.value.eq_ignore_ascii_case(name) || plain.eq_ignore_ascii_case(name);
    let found = names.iter().find(is).copied();
    if found.is_none() {
        let problem = ExchangeProblem::Other {
            what: entry.key.to_owned(),
            found: format!("\"{plain}\""),
            expected: format!("\"{}\"", names.join("\" or \"")),
            help: nearest_name(plain, names.iter().copied()).map_or_else(
                || {
                    "tables in other units, orders or points are converted by their writer"
                        .to_owned()
                },
                |name| format!("did you mean \"{name}\"?"),
            ),
        };
        problems.push(entry.line, &problem);
    }
    found
}

/// A whole number.
fn count(entry: &Entry<'_>, problems: &mut Problems) -> Option<usize> {
    let number = entry.value.parse().ok();
    if number.is_none() {
        let problem = ExchangeProblem::Other {
            what: entry.key.to_owned(),
            found: format!("\"{}\"", entry.value),
            expected: "the number of stations".to_owned(),
            help: "write a whole number, or remove the line".to_owned(),
        };
        problems.push(entry.line, &problem);
    }
    number
}

/// `none`, `proportional T` or `times T1 ... T6`.
fn damping(entry: &Entry<'_>, problems: &mut Problems) -> Option<BladeDamping> {
    let mut words = entry.value.split_whitespace();
    let kind = words.next().unwrap_or_default();
    let times: Option<Vec<f64>> = words.map(number).collect();
    match (kind, times.as_deref()) {
        ("none", Some([])) => return None,
        ("proportional", Some(&[time])) => return Some(BladeDamping::Proportional(time)),
        ("times", Some(times)) => {
            if let Ok(times) = times.try_into() {
                return Some(BladeDamping::Times(times));
            }
        }
        _ => {}
    }
    problems.push(
        entry.line,
        &ExchangeProblem::Other {
            what: "damping".to_owned(),
            found: format!("\"{}\"", entry.value),
            expected: "\"none\", \"proportional\" and a time, or \"times\" and six times"
                .to_owned(),
            help: "times are in seconds, in the order axial, shear y, shear z, torsion, bending \
                   y, bending z"
                .to_owned(),
        },
    );
    None
}
