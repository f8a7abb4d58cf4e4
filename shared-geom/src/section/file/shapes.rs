//! All problems of the fields of a property file, each with the name of its field; the
//! reader of JSON stops at the first and does not name it.

use serde_json::{Map, Value};

use super::fields::Shape::{
    Count, Either, Entries, Number, Row, Rows, Square, Table, Tables, Text, Texts, Word,
};
use super::fields::{ENTRY, FILE, Field, Shape, expected};
use super::locations::{FieldLocations, OUTERMOST};
use super::{FORMAT, PropertyProblem};
use crate::error::{Diagnostics, Explain, SourceLocation, nearest_name};
use crate::section::json;

/// A problem of a field, whose name is a text.
#[derive(Debug, thiserror::Error)]
enum ShapeProblem {
    #[error("unknown field {field}")]
    Unknown {
        field: String,
        near: Option<&'static str>,
        known: Vec<&'static str>,
    },
    #[error("{field} is missing, expected {expected}")]
    Missing { field: String, expected: String },
    #[error("{field} is given a second time, expected it once")]
    Twice { field: String },
    #[error("{field} is {found}, expected {expected}")]
    Wrong {
        field: String,
        found: String,
        expected: String,
    },
}

impl Explain for ShapeProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown {
                near: Some(near), ..
            } => Some(format!("did you mean \"{near}\"?")),
            Self::Unknown { known, .. } => Some(format!("known fields: {}", known.join(", "))),
            _ => None,
        }
    }
}

/// Reasons for which a text is no property file, from the error of the reader of JSON:
/// all problems of its fields, or that error.
pub(super) fn malformed(error: &serde_json::Error, text: &str, file: &str) -> Diagnostics {
    let words = |reason: String| {
        let location = SourceLocation::line(file, error.line().max(1));
        Diagnostics::one(location, &PropertyProblem::Malformed { reason })
    };
    let value = match serde_json::from_str::<Value>(text) {
        Ok(value) => value,
        Err(_) => return words(json::reason(error)),
    };
    let Some(fields) = value.as_object().filter(|fields| is_ours(fields)) else {
        let reason = match value.get("format") {
            None => format!("it has no \"format\", expected \"{FORMAT}\""),
            Some(format) => {
                let found = self::words(format);
                format!("\"format\" is {found}, expected \"{FORMAT}\"")
            }
        };
        return words(reason);
    };
    let mut check = Check {
        file,
        locations: FieldLocations::of(text),
        problems: Diagnostics::new(),
    };
    let whole = Holder {
        prefix: String::new(),
        suffix: String::new(),
        number: OUTERMOST,
        line: None,
    };
    check.table(fields, FILE, &whole);
    if check.problems.is_empty() {
        words(json::reason(error))
    } else {
        check.problems.sort_by_line();
        check.problems
    }
}

fn is_ours(fields: &Map<String, Value>) -> bool {
    fields.get("format").and_then(Value::as_str) == Some(FORMAT)
}

/// A table: the names of its fields and its location.
struct Holder {
    /// Text before the name of a field, `centers.`.
    prefix: String,
    /// Text after it, ` of the imposed state "hot"`.
    suffix: String,
    number: usize,
    line: Option<usize>,
}

impl Holder {
    fn words(&self, field: &str) -> String {
        format!("\"{}{field}\"{}", self.prefix, self.suffix)
    }
}

/// Problems so far.
struct Check<'a> {
    file: &'a str,
    locations: FieldLocations,
    problems: Diagnostics,
}

impl Check<'_> {
    fn push(&mut self, line: Option<usize>, problem: &ShapeProblem) {
        let location = match line {
            Some(line) => SourceLocation::line(self.file, line),
            None => SourceLocation::file(self.file),
        };
        self.problems.push(location, problem);
    }

    /// Unknown fields, absent ones that are not misspelled, and the content of the others.
    fn table(&mut self, found: &Map<String, Value>, known: &[Field], holder: &Holder) {
        let names = || known.iter().map(|field| field.name);
        let mut meant = Vec::new();
        for name in found
            .keys()
            .filter(|name| names().all(|known| known != *name))
        {
            let near = nearest_name(name, names());
            meant.extend(near);
            let problem = ShapeProblem::Unknown {
                field: holder.words(name),
                near,
                known: names().collect(),
            };
            let spot = self.locations.inside(holder.number, name);
            self.push(spot.map(|spot| spot.line), &problem);
        }
        for field in known {
            let words = holder.words(field.name);
            if let Some(line) = self.locations.again(holder.number, field.name) {
                let field = words.clone();
                self.push(Some(line), &ShapeProblem::Twice { field });
            }
            match found.get(field.name) {
                // none, if it is optional
                Some(Value::Null) if !field.is_needed => {}
                Some(value) => self.field(value, field, holder),
                None if field.is_needed && !meant.contains(&field.name) => {
                    let expected = expected(field.shape);
                    let problem = ShapeProblem::Missing {
                        field: words,
                        expected,
                    };
                    self.push(holder.line, &problem);
                }
                None => {}
            }
        }
    }

    fn field(&mut self, value: &Value, field: &Field, holder: &Holder) {
        let spot = self.locations.inside(holder.number, field.name);
        let line = spot.map(|spot| spot.line);
        let number = spot.map_or(usize::MAX, |spot| spot.number);
        let words = holder.words(field.name);
        let inner = Holder {
            prefix: format!("{}{}.", holder.prefix, field.name),
            suffix: holder.suffix.clone(),
            number,
            line,
        };
        match (field.shape, value) {
            (Table(known), Value::Object(found)) => self.table(found, known, &inner),
            (Either(known), Value::Object(found)) => {
                self.table(found, known, &inner);
                let has = |field: &Field| found.contains_key(field.name);
                if found.len() > 1 && known.iter().all(has) || found.is_empty() {
                    self.wrong(line, &words, value, expected(field.shape));
                }
            }
            (Tables(called, known), Value::Array(all)) => {
                for (i, value) in all.iter().enumerate() {
                    let name = value.get("name").and_then(Value::as_str);
                    let name =
                        name.map_or_else(|| (i + 1).to_string(), |name| format!("\"{name}\""));
                    let spot = self.locations.inside(number, &i.to_string());
                    let one = Holder {
                        prefix: String::new(),
                        suffix: format!(" of {called} {name}"),
                        number: spot.map_or(usize::MAX, |spot| spot.number),
                        line: spot.map(|spot| spot.line).or(line),
                    };
                    match value.as_object() {
                        Some(found) => self.table(found, known, &one),
                        None => {
                            let words = format!("{called} {name}");
                            self.wrong(one.line, &words, value, "a table".to_owned());
                        }
                    }
                }
            }
            (shape, value) => self.numbers(value, shape, line, &words),
        }
    }

    fn wrong(&mut self, line: Option<usize>, field: &str, value: &Value, expected: String) {
        let problem = ShapeProblem::Wrong {
            field: field.to_owned(),
            found: words(value),
            expected,
        };
        self.push(line, &problem);
    }

    /// A value that is not a table, and the rows of a matrix.
    fn numbers(&mut self, value: &Value, shape: Shape, line: Option<usize>, field: &str) {
        let rows = value.as_array();
        let is_good = match shape {
            Number => value.is_number(),
            Count => value.is_u64(),
            Text => value.is_string(),
            Word(known) => value.as_str().is_some_and(|word| known.contains(&word)),
            Texts => rows.is_some_and(|all| all.iter().all(Value::is_string)),
            Row(n) => is_row(value, n),
            Square(n) => rows.is_some_and(|rows| rows.len() == n),
            Rows | Entries => rows.is_some(),
            Table(_) | Either(_) | Tables(..) => false,
        };
        if !is_good {
            return self.wrong(line, field, value, expected(shape));
        }
        let is_good = |row: &Value| match shape {
            Square(n) => is_row(row, n),
            Rows => row
                .as_array()
                .is_some_and(|row| row.iter().all(Value::is_number)),
            Entries => is_entry(row),
            _ => true,
        };
        let expected = match shape {
            Square(n) => format!("{n} numbers"),
            Entries => ENTRY.to_owned(),
            _ => "numbers".to_owned(),
        };
        for (i, row) in rows.into_iter().flatten().enumerate() {
            if !is_good(row) {
                let words = format!("row {} of {field}", i + 1);
                self.wrong(line, &words, row, expected.clone());
            }
        }
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

#[cfg(test)]
#[path = "shapes_tests.rs"]
mod tests;
