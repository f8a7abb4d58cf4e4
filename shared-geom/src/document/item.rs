//! One value of an input file, at any location.

use super::tree::{Kind, Value};
use super::{Document, DocumentProblem};
use crate::error::Explain;
use crate::expression::written;
use crate::units::{Dimension, parse_quantity, rounded};

/// Largest magnitude of a number: squares and products with other numbers do not overflow
/// [SI unit of the dimension].
const LARGEST: f64 = 1e100;

/// A value of a [`Document`] under a key, or in a list under it. Each reading method
/// notes its own problems.
#[derive(Debug, Clone)]
pub struct Item<'a> {
    document: &'a Document,
    key: String,
    /// The title of the table that holds it.
    owner: String,
    value: &'a Value,
}

impl<'a> Item<'a> {
    pub(super) fn new(document: &'a Document, key: &str, owner: &str, value: &'a Value) -> Self {
        Self {
            document,
            key: key.to_owned(),
            owner: owner.to_owned(),
            value,
        }
    }

    /// The file that holds the value.
    pub fn document(&self) -> &'a Document {
        self.document
    }

    /// The key of the value.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The title of the table that holds the value, for messages: `load "tip"`.
    pub fn owner(&self) -> &str {
        &self.owner
    }

    /// The value as in the file.
    pub(super) fn value(&self) -> &'a Value {
        self.value
    }

    /// The line of its first character.
    pub fn line(&self) -> usize {
        self.value.line
    }

    /// Notes a problem at its line.
    pub fn note(&self, problem: &impl Explain) {
        self.document.note(self.value.line, problem);
    }

    /// Notes that the value differs from the expected one.
    pub fn wrong<T>(&self, expected: &str) -> Option<T> {
        self.note(&DocumentProblem::WrongValue {
            key: self.key.clone(),
            found: self.found(),
            expected: expected.to_owned(),
        });
        None
    }

    /// The value in a message, with the one that an expression has.
    fn found(&self) -> String {
        let text = self.value.kind.describe();
        let number = self.text().and_then(|text| self.document.quietly(text));
        number.map_or(text.clone(), |number| {
            format!(
                "{}, the value of {}",
                rounded(number),
                text.trim_start_matches("the text ")
            )
        })
    }

    /// The text, if it is one.
    pub fn text(&self) -> Option<&'a str> {
        match &self.value.kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The number, if it is a whole one of at least one.
    pub fn whole_number(&self) -> Option<u64> {
        match self.value.kind {
            Kind::Integer(number) => u64::try_from(number).ok().filter(|number| *number > 0),
            _ => None,
        }
    }

    /// The values of a list, if it is one.
    pub fn list(&self) -> Option<Vec<Item<'a>>> {
        match &self.value.kind {
            Kind::Array(items) => {
                let item = |value| Item::new(self.document, &self.key, &self.owner, value);
                Some(items.iter().map(item).collect())
            }
            _ => None,
        }
    }

    /// Rows of two numbers, each row with its line, as `expected` describes them.
    pub fn pairs(&self, expected: &str) -> Option<Vec<(usize, [f64; 2])>> {
        let Some(items) = self.list() else {
            return self.wrong(expected);
        };
        let row = |item: &Item<'_>| match item.list().as_deref() {
            Some([x, y]) => {
                let pair = [x, y].map(|number| number.quantity(Dimension::NUMBER));
                Some((item.line(), [pair[0]?, pair[1]?]))
            }
            _ => item.wrong(expected),
        };
        // All rows are read, so that each problem is noted.
        let rows: Vec<_> = items.iter().map(row).collect();
        rows.into_iter().collect()
    }

    /// The quantity in SI units: a plain number and the value of an expression are in the
    /// declared unit, a text such as `"0.063 in"` is in its own.
    pub fn quantity(&self, dimension: Dimension) -> Option<f64> {
        let plain = |number: f64| number * self.document.factor(dimension);
        let number = match &self.value.kind {
            Kind::Integer(number) => plain(*number as f64),
            Kind::Number(number) => plain(*number),
            Kind::Text(text) if written(text).is_some() => {
                plain(self.document.evaluate(&self.key, self.value.line, text)?)
            }
            Kind::Text(text) => match parse_quantity(text, dimension) {
                Ok(number) => number,
                Err(problem) => {
                    let key = self.key.clone();
                    self.note(&DocumentProblem::Unit { key, problem });
                    return None;
                }
            },
            _ => return self.wrong(&dimension.to_string()),
        };
        match number.is_finite() {
            true if number.abs() <= LARGEST => Some(number),
            true => self.wrong(&format!(
                "{dimension}, at most 1e100 in magnitude in SI units"
            )),
            false => self.wrong(&format!("{dimension}, finite")),
        }
    }
}
