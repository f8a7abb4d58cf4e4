//! JSON laid out for reading: one line per field, one line per row of a matrix.

use std::fmt::Write;

use serde_json::Value;
use serde_json::error::Category;

/// The reason for which a text could not be read as JSON, for messages that state the line.
pub(crate) fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let message = text
        .rsplit_once(" at line ")
        .map_or(&*text, |parts| parts.0);
    match (error.classify(), error.line(), error.column()) {
        (Category::Eof, 0 | 1, 0) => "the file is empty".to_owned(),
        (Category::Eof, ..) => "the file ends early".to_owned(),
        (Category::Syntax, ..) if message.starts_with("number out of range") => message.to_owned(),
        // Letters, which begin no value: a text of another kind.
        (Category::Syntax, 1, 1 | 2) => "it is not JSON".to_owned(),
        (Category::Syntax, _, column) => format!("not JSON at column {column}: {message}"),
        _ => text,
    }
}

/// The text of `value`, with rows of numbers and texts on one line each.
pub(crate) fn layout(value: &Value) -> String {
    let mut text = String::new();
    write_value(&mut text, value, 0);
    text.push('\n');
    text
}

fn write_value(text: &mut String, value: &Value, depth: usize) {
    match value {
        Value::Object(fields) if !fields.is_empty() => {
            let items = fields.iter().map(|(key, item)| (Some(key), item));
            write_items(text, ['{', '}'], items, depth);
        }
        Value::Array(items) if items.iter().any(|item| item.is_array() || item.is_object()) => {
            let items = items.iter().map(|item| (None, item));
            write_items(text, ['[', ']'], items, depth);
        }
        Value::Array(items) => {
            let words: Vec<_> = items.iter().map(Value::to_string).collect();
            let _ = write!(text, "[{}]", words.join(", "));
        }
        other => {
            let _ = write!(text, "{other}");
        }
    }
}

fn write_items<'a>(
    text: &mut String,
    brackets: [char; 2],
    items: impl Iterator<Item = (Option<&'a String>, &'a Value)>,
    depth: usize,
) {
    text.push(brackets[0]);
    for (i, (key, item)) in items.enumerate() {
        let comma = if i > 0 { "," } else { "" };
        let _ = write!(text, "{comma}\n{:1$}", "", 2 * depth + 2);
        if let Some(key) = key {
            let _ = write!(text, "{}: ", Value::from(key.as_str()));
        }
        write_value(text, item, depth + 1);
    }
    let _ = write!(text, "\n{:1$}{2}", "", 2 * depth, brackets[1]);
}
