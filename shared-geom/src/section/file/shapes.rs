//! Numbers of a property file that are not what their field expects: all of them, each by
//! its name, where the reader of JSON stops at the first and names none.

use serde_json::Value;

use super::{PropertyProblem, place_of};
use crate::error::{Diagnostics, Place};

/// What a field holds.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// A number.
    Number,
    /// An array of so many numbers.
    Row(usize),
    /// A square matrix by rows.
    Square(usize),
    /// Rows of three indices and a number.
    Entries,
}

/// Fields at the top of the file, below `centers` and the like by a dot.
const FIELDS: [(&str, Shape); 17] = [
    ("reference_point", Shape::Row(2)),
    ("stiffness", Shape::Square(6)),
    ("mass", Shape::Square(6)),
    ("centers.tension", Shape::Row(2)),
    ("centers.shear", Shape::Row(2)),
    ("centers.mass", Shape::Row(2)),
    ("principal_axes.bending_angle", Shape::Number),
    ("principal_axes.bending_stiffness", Shape::Row(2)),
    ("principal_axes.inertia_angle", Shape::Number),
    ("principal_axes.inertia", Shape::Row(2)),
    ("initial_curvature.curvature", Shape::Row(3)),
    ("initial_curvature.slope", Shape::Row(3)),
    ("thermal_force", Shape::Row(6)),
    ("damping.stiffness_proportional", Shape::Number),
    ("damping.viscous", Shape::Square(6)),
    ("prestress.third_derivatives", Shape::Entries),
    ("prestress.stiffness_per_kelvin", Shape::Square(4)),
];

/// A row of a table of prestress, in words.
const ENTRY: &str = "three whole numbers and a number, as in [1, 4, 4, 1462.1]";

/// Fields of each imposed state.
const OF_STATE: [(&str, Shape); 3] = [
    ("restrained_force", Shape::Row(6)),
    ("free_strain", Shape::Row(6)),
    ("stiffness_change", Shape::Square(4)),
];

/// Why a text is no property file, from the error of the reader of JSON: every field of
/// another shape, or that error.
pub(super) fn malformed(error: &serde_json::Error, text: &str, file: &str) -> Diagnostics {
    let shapes = misshapen(text);
    let reason = error.to_string();
    let is_of_fields = ["missing field", "unknown field"];
    let is_of_fields = is_of_fields.iter().any(|start| reason.starts_with(start));
    let mut problems = Diagnostics::new();
    if shapes.is_empty() || is_of_fields {
        let place = Place::line(file, error.line().max(1));
        problems.push(place, &PropertyProblem::Malformed { reason });
    }
    for (field, problem) in shapes {
        problems.push(place_of(field, text, file), &problem);
    }
    problems
}

/// The fields of `text` whose numbers are not of their shape, each with the name by which
/// its line is found; empty where it is not JSON.
fn misshapen(text: &str) -> Vec<(&'static str, PropertyProblem)> {
    let Ok(file) = serde_json::from_str::<Value>(text) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for (path, shape) in FIELDS {
        let value = path.split('.').try_fold(&file, |value, key| value.get(key));
        let last = path.rsplit('.').next().unwrap_or(path);
        note(value, shape, format!("\"{path}\""), last, &mut found);
    }
    let states = file.get("imposed").and_then(Value::as_array);
    for (i, state) in states.into_iter().flatten().enumerate() {
        let name = state.get("name").and_then(Value::as_str);
        let name = name.map_or_else(|| format!("number {}", i + 1), |name| format!("\"{name}\""));
        for (key, shape) in OF_STATE {
            let words = format!("\"{key}\" of the imposed state {name}");
            note(state.get(key), shape, words, "imposed", &mut found);
        }
    }
    found
}

fn note(
    value: Option<&Value>,
    shape: Shape,
    field: String,
    line_of: &'static str,
    found: &mut Vec<(&'static str, PropertyProblem)>,
) {
    // what is absent or null is told, or is none, elsewhere
    let Some(value) = value.filter(|value| !value.is_null()) else {
        return;
    };
    let mut add = |row: Option<usize>, value: &Value, expected: String| {
        let row = row.map_or_else(String::new, |row| format!("row {} of ", row + 1));
        let problem = PropertyProblem::Shape {
            field: format!("{row}{field}"),
            found: words(value),
            expected,
        };
        found.push((line_of, problem));
    };
    let rows = value.as_array();
    match shape {
        Shape::Number if !value.is_number() => add(None, value, "a number".to_owned()),
        Shape::Row(n) if !is_row(value, n) => add(None, value, format!("{n} numbers")),
        Shape::Number | Shape::Row(_) => {}
        Shape::Square(n) => match rows.filter(|rows| rows.len() == n) {
            None => add(None, value, format!("{n} rows of {n} numbers")),
            Some(rows) => {
                let wrong = rows.iter().enumerate().filter(|row| !is_row(row.1, n));
                wrong.for_each(|(i, row)| add(Some(i), row, format!("{n} numbers")));
            }
        },
        Shape::Entries => match rows {
            None => add(None, value, "a list of rows".to_owned()),
            Some(rows) => {
                let wrong = rows.iter().enumerate().filter(|row| !is_entry(row.1));
                wrong.for_each(|(i, row)| add(Some(i), row, ENTRY.to_owned()));
            }
        },
    }
}

fn is_row(value: &Value, n: usize) -> bool {
    let row = value.as_array().filter(|row| row.len() == n);
    row.is_some_and(|row| row.iter().all(Value::is_number))
}

fn is_entry(row: &Value) -> bool {
    let [i, j, k, value] = match row.as_array().map(Vec::as_slice) {
        Some([i, j, k, value]) => [i, j, k, value],
        _ => return false,
    };
    [i, j, k].iter().all(|index| index.is_u64()) && value.is_number()
}

/// A value as a message shows it.
fn words(value: &Value) -> String {
    match value {
        Value::Array(all) => match all.iter().find(|one| !one.is_number()) {
            Some(Value::Array(_)) | None => format!("an array of {}", all.len()),
            Some(other) => format!("an array with {}", words(other)),
        },
        Value::Object(_) => "a table".to_owned(),
        Value::String(text) => format!("the text \"{text}\""),
        other => other.to_string(),
    }
}
