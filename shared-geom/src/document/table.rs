//! One table of an input file, and the values in it.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;

use super::schema::TableSchema;
use super::tree::{Entry, Kind, Value};
use super::{Document, DocumentProblem, Item};
use crate::error::{Diagnostics, Explain};
use crate::expression::written;
use crate::files::names_beside;
use crate::units::Dimension;

/// Largest number of an expression that can be a count: below it whole numbers are exact.
const COUNTS: f64 = 9e15;

/// A table of a [`Document`]. Each reading method notes its own problems.
#[derive(Debug)]
pub struct Table<'a> {
    pub(super) document: &'a Document,
    pub(super) entries: &'a [Entry],
    /// The title of the table, for messages: `material "steel"`.
    pub(super) title: String,
    /// Its keys from the root, separated by points; empty for the root.
    pub(super) path: String,
    line: usize,
    /// Its descriptions: several if its key has several kinds of tables. Without any, every
    /// requested key is a key of the table.
    pub(super) schemas: Vec<&'static TableSchema>,
    pub(super) requested: RefCell<Vec<String>>,
}

impl<'a> Table<'a> {
    pub(super) fn new(
        document: &'a Document,
        entries: &'a [Entry],
        title: String,
        line: usize,
    ) -> Self {
        Self {
            document,
            entries,
            title,
            path: String::new(),
            line,
            schemas: Vec::new(),
            requested: RefCell::default(),
        }
    }

    /// The table with a description: it then has only the described keys.
    pub fn described(mut self, schema: &'static TableSchema) -> Self {
        self.schemas.push(schema);
        self
    }

    /// The file that holds the table.
    pub fn document(&self) -> &'a Document {
        self.document
    }

    /// The title of the table, for messages.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The line of the head of the table.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The line of `key`, or of the table if it does not have the key.
    pub fn line_of(&self, key: impl AsRef<str>) -> usize {
        self.entry(key.as_ref())
            .map_or(self.line, |entry| entry.line)
    }

    /// Notes a problem at the line of `key`.
    pub fn note(&self, key: impl AsRef<str>, problem: &impl Explain) {
        self.document.note(self.line_of(key), problem);
    }

    /// Notes that the value of `key` differs from the expected one.
    pub fn wrong(&self, key: impl AsRef<str>, expected: &str) {
        let key = key.as_ref();
        if let Some(entry) = self.entry(key) {
            let _: Option<()> = self.wrong_value(key, &entry.value, expected);
        }
    }

    /// Whether the table has `key`. The key is then known.
    pub fn has(&self, key: impl AsRef<str>) -> bool {
        self.look_up(key.as_ref()).is_some()
    }

    /// Whether `key` holds a text that is not an expression of a number.
    pub fn is_text(&self, key: impl AsRef<str>) -> bool {
        let item = self.item(key);
        let text = item.as_ref().and_then(Item::text);
        text.is_some_and(|text| written(text).is_none())
    }

    /// The value under `key`, of any type.
    pub fn item(&self, key: impl AsRef<str>) -> Option<Item<'a>> {
        let key = key.as_ref();
        let value = self.look_up(key)?;
        Some(Item::new(self.document, key, &self.title, value))
    }

    /// As [`Table::item`], and required.
    pub fn require_item(&self, key: impl AsRef<str>, expected: &str) -> Option<Item<'a>> {
        let key = key.as_ref();
        self.require(key, expected)?;
        self.item(key)
    }

    /// Whether `key` holds a list of lists.
    pub fn is_nested(&self, key: impl AsRef<str>) -> bool {
        match self.look_up(key.as_ref()).map(|value| &value.kind) {
            Some(Kind::Array(items)) => {
                let is_list = |item: &Value| matches!(item.kind, Kind::Array(_));
                items.first().is_some_and(is_list)
            }
            _ => false,
        }
    }

    /// Whether `key` holds a list.
    pub fn is_list(&self, key: impl AsRef<str>) -> bool {
        matches!(
            self.look_up(key.as_ref()),
            Some(Value {
                kind: Kind::Array(_),
                ..
            })
        )
    }

    /// The keys of the table, in their order: for tables whose keys are names.
    pub fn keys(&self) -> Vec<String> {
        self.entries.iter().map(|entry| entry.key.clone()).collect()
    }

    /// Names and values of a table whose keys are names.
    pub(super) fn values(&self) -> impl Iterator<Item = (&'a str, &'a Value)> {
        let entries = self.entries.iter();
        entries.map(|entry| (entry.key.as_str(), &entry.value))
    }

    /// Text under `key`.
    pub fn text(&self, key: &str) -> Option<String> {
        let value = self.look_up(key)?;
        match &value.kind {
            Kind::Text(text) => Some(text.clone()),
            _ => self.wrong_value(key, value, "a text in quotes"),
        }
    }

    /// The path that `key` names as `written`: relative ones are relative to the folder
    /// of the file that holds it.
    pub fn path(&self, key: impl AsRef<str>, written: &str) -> PathBuf {
        self.document.path_from(self.line_of(key), written)
    }

    /// The path of the file that `key` names as `written`; notes a missing file.
    pub fn existing(&self, key: impl AsRef<str>, written: &str) -> Option<PathBuf> {
        let key = key.as_ref();
        let path = self.path(key, written);
        if path.exists() {
            return Some(path);
        }
        if self.is_in_missing_folder(key, written, &path) {
            return None;
        }
        let problem = DocumentProblem::NoFile {
            key: key.to_owned(),
            name: written.to_owned(),
            known: names_beside(&path),
        };
        self.note(key, &problem);
        None
    }

    /// Whether the folder of the file at `path`, which `key` names as `written`, does not exist; this is
    /// noted, once for all files in it.
    pub fn is_in_missing_folder(&self, key: impl AsRef<str>, written: &str, path: &Path) -> bool {
        let key = key.as_ref();
        let line = self.line_of(key);
        self.document
            .is_in_missing_folder(line, [key, written], path)
    }

    /// The content of the file that `key` names; notes its problems, with the key.
    pub fn keep_file<T>(&self, key: &str, content: Result<T, Diagnostics>) -> Option<T> {
        let location = self.document.location(self.line_of(key));
        let by = format!("\"{key}\" of {}, {location}", self.title);
        self.document
            .keep(content.map_err(|problems| problems.named(&by)))
    }

    /// A list of texts under `key`; one text is a list of one.
    pub fn texts(&self, key: &str) -> Option<Vec<String>> {
        let value = self.look_up(key)?;
        let items = match &value.kind {
            Kind::Text(text) => return Some(vec![text.clone()]),
            Kind::Array(items) => items,
            _ => return self.wrong_value(key, value, "a text in quotes, or a list of texts"),
        };
        // Every item is read, so that each wrong one is noted.
        let texts: Vec<_> = items
            .iter()
            .map(|item| match &item.kind {
                Kind::Text(text) => Some(text.clone()),
                _ => self.wrong_value(key, item, "a text in quotes"),
            })
            .collect();
        texts.into_iter().collect()
    }

    /// Required text under `key`; `expected` is its purpose.
    pub fn require_text(&self, key: &str, expected: &str) -> Option<String> {
        self.require(key, expected)?;
        self.text(key)
    }

    /// One of a set of words under `key`.
    pub fn word(&self, key: &str, known: &[&str]) -> Option<usize> {
        self.word_or_meant(key, known, &[])
    }

    /// As [`Table::word`]; `meant` has other words of the field with the word to use, for the
    /// message.
    pub fn word_or_meant(
        &self,
        key: &str,
        known: &[&str],
        meant: &[(&str, &'static str)],
    ) -> Option<usize> {
        self.index_of(key, self.text(key)?, known, meant)
    }

    /// The index of a word of `key`; notes an unknown one.
    pub(super) fn index_of(
        &self,
        key: &str,
        found: String,
        known: &[&str],
        meant: &[(&str, &'static str)],
    ) -> Option<usize> {
        let index = known.iter().position(|word| *word == found);
        if index.is_none() {
            let meant = meant.iter().find(|word| word.0 == found).copied();
            let problem = DocumentProblem::WrongWord {
                key: key.to_owned(),
                found,
                known: known.iter().map(|&word| word.to_owned()).collect(),
                meant: meant.map(|word| word.1),
            };
            self.note(key, &problem);
        }
        index
    }

    /// A truth value under `key`.
    pub fn boolean(&self, key: &str) -> Option<bool> {
        let value = self.look_up(key)?;
        match value.kind {
            Kind::Boolean(flag) => Some(flag),
            _ => self.wrong_value(key, value, "true or false"),
        }
    }

    /// A whole number of at least one under `key`.
    pub fn count(&self, key: &str) -> Option<usize> {
        self.count_or(key, "a whole number of at least 1")
    }

    /// As [`Table::count`]; `expected` is what messages say.
    pub fn count_or(&self, key: impl AsRef<str>, expected: &str) -> Option<usize> {
        let key = key.as_ref();
        let value = self.look_up(key)?;
        let count = match value.kind {
            Kind::Integer(number) => usize::try_from(number).ok().filter(|n| *n > 0),
            Kind::Text(ref text) if written(text).is_some() => {
                let number = self.document.evaluate(key, value.line, text)?;
                let is_count = (1.0..COUNTS).contains(&number) && number.fract() == 0.0;
                is_count.then_some(number as usize)
            }
            _ => None,
        };
        match count {
            Some(count) => Some(count),
            None => self.wrong_value(key, value, expected),
        }
    }

    /// As [`Table::count`], and required.
    pub fn require_count(&self, key: &str) -> Option<usize> {
        self.require(key, "a whole number of at least 1")?;
        self.count(key)
    }

    /// A quantity under `key` in SI units: a plain number is in the declared unit, a text
    /// such as `"0.063 in"` in its own.
    pub fn quantity(&self, key: &str, dimension: Dimension) -> Option<f64> {
        let value = self.look_up(key)?;
        self.in_si(key, value, dimension)
    }

    /// As [`Table::quantity`], and required.
    pub fn require_quantity(&self, key: &str, dimension: Dimension) -> Option<f64> {
        self.require(key, &dimension.to_string())?;
        self.quantity(key, dimension)
    }

    /// As [`Table::require_quantity`], and greater than zero.
    pub fn require_positive(&self, key: &str, dimension: Dimension) -> Option<f64> {
        let number = self.require_quantity(key, dimension)?;
        if number > 0.0 {
            return Some(number);
        }
        self.wrong(key, &format!("{dimension} greater than zero"));
        None
    }

    /// A list of quantities under `key`, in SI units; one quantity is a list of one.
    pub fn quantities(&self, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        let value = self.look_up(key)?;
        let Kind::Array(items) = &value.kind else {
            return self.in_si(key, value, dimension).map(|number| vec![number]);
        };
        // Every item is read, so that each wrong one is noted.
        let numbers: Vec<_> = items
            .iter()
            .map(|item| self.in_si(key, item, dimension))
            .collect();
        numbers.into_iter().collect()
    }

    /// Three quantities under `key`, in SI units.
    pub fn vector(&self, key: &str, dimension: Dimension) -> Option<Vector3<f64>> {
        let expected = format!("an array of 3, each {dimension}");
        self.array(key, dimension, &expected).map(Vector3::from)
    }

    /// `N` quantities under `key`, in SI units; `expected` describes them.
    pub fn array<const N: usize>(
        &self,
        key: &str,
        dimension: Dimension,
        expected: &str,
    ) -> Option<[f64; N]> {
        let found = if self.is_list(key) {
            self.quantities(key, dimension)?.try_into().ok()
        } else {
            None
        };
        if found.is_none() {
            self.wrong(key, expected);
        }
        found
    }

    /// Vectors of three quantities under `key`, in SI units; one vector is a list of one.
    pub fn vectors(&self, key: &str, dimension: Dimension) -> Option<Vec<Vector3<f64>>> {
        let value = self.look_up(key)?;
        let expected = format!("an array of 3, each {dimension}, or a list of such arrays");
        let Kind::Array(items) = &value.kind else {
            return self.wrong_value(key, value, &expected);
        };
        if !items.iter().any(|item| matches!(item.kind, Kind::Array(_))) {
            return self.vector(key, dimension).map(|vector| vec![vector]);
        }
        let row = |item: &Value| -> Option<Vector3<f64>> {
            let Kind::Array(numbers) = &item.kind else {
                return self.wrong_value(key, item, &expected);
            };
            let numbers: Vec<_> = numbers
                .iter()
                .map(|number| self.in_si(key, number, dimension))
                .collect();
            let numbers: Option<Vec<_>> = numbers.into_iter().collect();
            match numbers?[..] {
                [x, y, z] => Some(Vector3::new(x, y, z)),
                _ => self.wrong_value(key, item, &expected),
            }
        };
        let rows: Vec<_> = items.iter().map(row).collect();
        rows.into_iter().collect()
    }

    /// Length of the list under `key`.
    pub fn row_count(&self, key: impl AsRef<str>) -> Option<usize> {
        match self.look_up(key.as_ref()).map(|value| &value.kind) {
            Some(Kind::Array(items)) => Some(items.len()),
            _ => None,
        }
    }

    /// Rows of plain numbers under `key`, each of `columns`; no unit is applied.
    pub fn rows(&self, key: &str, rows: usize, columns: usize) -> Option<Vec<Vec<f64>>> {
        self.rows_of(key, [rows, columns], Dimension::NUMBER)
    }

    /// As [`Table::rows`], for quantities in SI.
    pub fn rows_of(&self, key: &str, size: [usize; 2], unit: Dimension) -> Option<Vec<Vec<f64>>> {
        let [rows, columns] = size;
        let expected = format!("{rows} rows of {columns} numbers");
        let value = self.look_up(key)?;
        let Kind::Array(items) = &value.kind else {
            return self.wrong_value(key, value, &expected);
        };
        let row = |item: &Value| -> Option<Vec<f64>> {
            let Kind::Array(numbers) = &item.kind else {
                return self.wrong_value(key, item, &format!("a row of {columns} numbers"));
            };
            if numbers.len() != columns {
                return self.wrong_value(key, item, &format!("a row of {columns} numbers"));
            }
            let number = |n| self.in_si(key, n, unit);
            numbers.iter().map(number).collect()
        };
        let read: Vec<_> = items.iter().map(row).collect();
        let read: Option<Vec<_>> = read.into_iter().collect();
        match read {
            Some(read) if read.len() != rows => self.wrong_value(key, value, &expected),
            other => other,
        }
    }

    fn entry(&self, key: &str) -> Option<&'a Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    pub(super) fn look_up_entry(&self, key: &str) -> Option<&'a Entry> {
        let mut requested = self.requested.borrow_mut();
        if !requested.iter().any(|known| known == key) {
            requested.push(key.to_owned());
        }
        self.entry(key)
    }

    pub(super) fn look_up(&self, key: &str) -> Option<&'a Value> {
        self.look_up_entry(key).map(|entry| &entry.value)
    }

    pub(super) fn require(&self, key: &str, expected: &str) -> Option<()> {
        if self.look_up(key).is_none() {
            let problem = DocumentProblem::MissingKey {
                key: key.to_owned(),
                table: self.title.clone(),
                expected: expected.to_owned(),
            };
            self.document.note(self.line, &problem);
            return None;
        }
        Some(())
    }

    fn in_si(&self, key: &str, value: &Value, dimension: Dimension) -> Option<f64> {
        Item::new(self.document, key, &self.title, value).quantity(dimension)
    }

    pub(super) fn wrong_value<T>(&self, key: &str, value: &Value, expected: &str) -> Option<T> {
        Item::new(self.document, key, &self.title, value).wrong(expected)
    }
}
