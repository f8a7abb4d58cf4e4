//! The values of a TOML file with their lines, free of the source text.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and the line of its first character.
#[derive(Debug, Clone)]
pub(super) struct Value {
    pub line: usize,
    pub kind: Kind,
}

/// The content of a value.
#[derive(Debug, Clone)]
pub(super) enum Kind {
    Text(String),
    Integer(i64),
    Number(f64),
    Boolean(bool),
    Date,
    Array(Vec<Value>),
    Table(Vec<Entry>),
}

/// A key of a table, in the order of the file.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub key: String,
    pub line: usize,
    pub value: Value,
}

impl Kind {
    /// Its description in messages, with the value if it is short.
    pub fn describe(&self) -> String {
        match self {
            Self::Text(text) => format!("the text \"{}\"", shown(text)),
            Self::Integer(number) => number.to_string(),
            Self::Number(number) if number.abs() >= 1e16 => format!("{number:e}"),
            Self::Number(number) => number.to_string(),
            Self::Boolean(value) => value.to_string(),
            Self::Date => "a date".to_owned(),
            Self::Array(items) => format!("an array of {}", items.len()),
            Self::Table(_) => "a table".to_owned(),
        }
    }
}

/// Most letters of a text that a message shows.
const LETTERS_SHOWN: usize = 60;

/// A text for a message of one line: control characters by their code, long texts cut.
fn shown(text: &str) -> String {
    let mut letters = text.chars();
    let mut shown = String::new();
    for letter in letters.by_ref().take(LETTERS_SHOWN) {
        if letter.is_control() {
            shown.extend(letter.escape_default())
        } else {
            shown.push(letter)
        }
    }
    if letters.next().is_some() {
        shown += "...";
    }
    shown
}

/// Byte offsets of the line beginnings, and the number of the first line.
#[derive(Debug)]
pub(super) struct Lines {
    starts: Vec<usize>,
    base: usize,
}

impl Lines {
    pub fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self {
            starts: std::iter::once(0).chain(ends.map(|(i, _)| i + 1)).collect(),
            base: 0,
        }
    }

    /// The same lines, counted from `base`.
    pub fn from(self, base: usize) -> Self {
        Self { base, ..self }
    }

    /// Line, from one, of a byte offset.
    pub fn at(&self, offset: usize) -> usize {
        let line = self.starts.partition_point(|start| *start <= offset);
        self.base + line.max(1)
    }
}

/// Entries of `table` in the order of the file.
pub(super) fn entries(table: &DeTable<'_>, lines: &Lines) -> Vec<Entry> {
    let mut found: Vec<_> = table
        .iter()
        .map(|(key, item)| {
            let entry = Entry {
                key: key.get_ref().to_string(),
                line: lines.at(key.span().start),
                value: value(item, lines),
            };
            (key.span().start, entry)
        })
        .collect();
    found.sort_by_key(|pair| pair.0);
    found.into_iter().map(|pair| pair.1).collect()
}

fn value(item: &Spanned<DeValue<'_>>, lines: &Lines) -> Value {
    Value {
        line: lines.at(item.span().start),
        kind: kind(item.get_ref(), lines),
    }
}

fn kind(item: &DeValue<'_>, lines: &Lines) -> Kind {
    match item {
        DeValue::String(text) => Kind::Text(text.to_string()),
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix())
            .map_or_else(|_| real(number.as_str()), Kind::Integer),
        DeValue::Float(number) => real(number.as_str()),
        DeValue::Boolean(flag) => Kind::Boolean(*flag),
        DeValue::Datetime(_) => Kind::Date,
        DeValue::Array(items) => Kind::Array(items.iter().map(|i| value(i, lines)).collect()),
        DeValue::Table(table) => Kind::Table(entries(table, lines)),
    }
}

/// A number as TOML writes it; unreadable ones become NaN, which no quantity accepts.
fn real(text: &str) -> Kind {
    Kind::Number(text.parse().unwrap_or(f64::NAN))
}
