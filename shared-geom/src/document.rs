//! TOML input with line numbers, units and complete error reports.
//!
//! A [`Document`] is read once; a [`Table`] returns the values of one table, notes every
//! problem with file and line, and at [`Table::finish`] reports the keys that were not
//! requested or that its description does not have, with the nearest name. A [`Key`] is
//! the declaration of a key, by which [`Table::get`] reads it. A request returns `None` both if an
//! optional key is absent and if it is wrong; in the latter case the problem has been
//! noted and [`Document::finish`] fails.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use toml::de::DeTable;

use crate::error::{Diagnostics, Explain, SourceLocation};
use crate::files::{MissingFolder, names_beside, read_bytes};
use crate::units::{DECLARABLE, Dimension, Units, parse_as};

mod absent;
mod card;
mod declare;
mod include;
mod inner;
mod item;
mod joined;
mod key;
mod lookup;
mod nested;
mod parameters;
mod problem;
mod repeat;
pub mod schema;
mod syntax;
mod table;
mod tree;

pub use card::{Card, Content, basic_string};
pub use declare::meaning;
pub use item::Item;
pub use key::{ByHand, Declared, Key, Nested, NestedByName, NestedList, Value};
pub use lookup::PARAMETER_TABLE;
pub use problem::DocumentProblem;
pub use table::Table;

use parameters::Parameters;
use schema::TableSchema;
use syntax::syntax_problems;
use tree::{Entry, Lines};

/// A TOML file, its name, the units that it declares, and its problems.
#[derive(Debug)]
pub struct Document {
    /// The file itself, then the files that it includes.
    files: Vec<String>,
    root: Vec<Entry>,
    problems: RefCell<Diagnostics>,
    absent: RefCell<Vec<absent::Absent>>,
    units: RefCell<Units>,
    parameters: RefCell<Parameters>,
    /// Values of a parameter at the rows of the tables over it, by its name.
    rows: RefCell<Vec<(String, Vec<f64>)>>,
}

impl Document {
    /// Reads the file at `path`.
    ///
    /// # Errors
    /// A file that cannot be read, and all errors of TOML syntax.
    pub fn read(path: &Path) -> Result<Self, Diagnostics> {
        let file = path.display().to_string();
        let text = read_text(path)?;
        Self::parse(&text, &file)
    }

    /// Reads `text`, which is shown as `file` in messages.
    ///
    /// # Errors
    /// All errors of TOML syntax, with their lines.
    pub fn parse(text: &str, file: &str) -> Result<Self, Diagnostics> {
        let lines = Lines::of(text);
        let (root, errors) = DeTable::parse_recoverable(text);
        let problems = syntax_problems((root.get_ref(), &errors), &lines, text, file);
        let entries = tree::entries(root.get_ref(), &lines);
        problems.into_result(Self::of(entries, vec![file.to_owned()]))
    }

    fn of(root: Vec<Entry>, files: Vec<String>) -> Self {
        Self {
            files,
            root,
            problems: RefCell::default(),
            absent: RefCell::default(),
            units: RefCell::new(Units::si()),
            parameters: RefCell::default(),
            rows: RefCell::default(),
        }
    }

    /// The top table of the file.
    pub fn root(&self) -> Table<'_> {
        Table::new(self, &self.root, "the file".to_owned(), 1)
    }

    /// The top table of a file that has only the keys of `schema`.
    pub fn root_of(&self, schema: &'static TableSchema) -> Table<'_> {
        self.root().described(schema)
    }

    /// Checks that the file has a key of `schema`, if it has keys at all; `kind` is the kind of the
    /// file that is read, as text.
    ///
    /// # Errors
    /// Only keys that such a file does not have: a file of another kind.
    pub fn require_known(
        &self,
        schema: &TableSchema,
        kind: &'static str,
    ) -> Result<(), Diagnostics> {
        let is_known = |entry: &Entry| schema.all_keys().any(|key| key.name == entry.key);
        match self.root.first() {
            Some(first) if !self.root.iter().any(is_known) => {
                let key = first.key.clone();
                let problem = DocumentProblem::Foreign { kind, key };
                Err(Diagnostics::one(self.location(first.line), &problem))
            }
            _ => Ok(()),
        }
    }

    /// The file name, as shown in messages.
    pub fn file(&self) -> &str {
        &self.files[0]
    }

    /// The location of a line number of a table, which may be in an included file.
    pub fn location(&self, line: usize) -> SourceLocation {
        let (file, line) = include::split(line);
        SourceLocation::line(&self.files[file.min(self.files.len() - 1)], line)
    }

    /// A line number of a table, as text: `line 7`, or `line 7 of "blade.toml"`.
    pub fn line_words(&self, line: usize) -> String {
        match include::split(line) {
            (0, line) => format!("line {line}"),
            (_, in_file) => format!("line {in_file} of \"{}\"", self.location(line).file),
        }
    }

    /// A path written in this file: relative paths are relative to the file's folder.
    pub fn path(&self, written: &str) -> PathBuf {
        self.path_from(1, written)
    }

    /// A path written on `line`: relative paths are relative to the folder of its file.
    pub fn path_from(&self, line: usize, written: &str) -> PathBuf {
        let location = self.location(line);
        let folder = Path::new(&location.file).parent().unwrap_or(Path::new(""));
        folder.join(written)
    }

    /// Notes a problem at `line`.
    pub fn note(&self, line: usize, problem: &impl Explain) {
        let location = self.location(line);
        self.problems.borrow_mut().push(location, problem);
    }

    /// The value of a good result; notes the problems of a bad one.
    pub fn keep<T>(&self, result: Result<T, Diagnostics>) -> Option<T> {
        self.problems.borrow_mut().keep(result)
    }

    /// The value, if it exists and no problem was noted.
    ///
    /// # Errors
    /// All noted problems, each file in the order of its lines.
    pub fn finish<T>(self, value: Option<T>) -> Result<T, Diagnostics> {
        let mut problems = self.problems.take();
        self.note_folders(&mut problems);
        problems.sort_by_line();
        match value {
            Some(value) => problems.into_result(value),
            None => Err(problems.explained(&self.files[0], "the file")),
        }
    }

    /// Reads the required key `units` of the top table, which sets the unit of every
    /// plain number requested afterwards: the word `"SI"`, or a table with some of the
    /// keys of [`DECLARABLE`].
    pub fn declare_units(&self, root: &Table<'_>) {
        const EXPECTED: &str = "\"SI\", or a table as in { length = \"mm\", force = \"N\" }";
        if root.has("units") && !root.is_table("units") {
            if !root.is_text("units") || root.text("units").as_deref() != Some("SI") {
                root.wrong("units", EXPECTED);
            }
            return;
        }
        let Some(table) = root.require_table("units", EXPECTED) else {
            return;
        };
        for (key, dimension) in DECLARABLE {
            let Some(text) = table.text(key) else {
                continue;
            };
            match parse_as(&text, dimension) {
                Ok(unit) => self.units.borrow_mut().declare(dimension, unit),
                Err(problem) => {
                    let key = key.to_owned();
                    table.note(key.clone(), &DocumentProblem::Unit { key, problem });
                }
            }
        }
        table.finish();
    }

    /// SI units in one declared unit of `dimension` [SI unit of the dimension].
    pub fn factor(&self, dimension: Dimension) -> f64 {
        self.units.borrow().factor(dimension)
    }
}

/// Reads a text file.
///
/// # Errors
/// The file cannot be read or is no text, as a message with a remedy.
pub fn read_text(path: &Path) -> Result<String, Diagnostics> {
    let text = read_bytes(path).and_then(|bytes| {
        String::from_utf8(bytes).map_err(|_| std::io::ErrorKind::InvalidData.into())
    });
    text.map_err(|error| {
        let name = path.display().to_string();
        let reason = match error.kind() {
            std::io::ErrorKind::NotFound => {
                let problem = match MissingFolder::before(path) {
                    Some(folder) => DocumentProblem::AbsentFolder(folder),
                    None => DocumentProblem::Absent {
                        name: name.clone(),
                        known: names_beside(path),
                    },
                };
                return Diagnostics::one(SourceLocation::file(name), &problem);
            }
            std::io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
            std::io::ErrorKind::IsADirectory => {
                let problem = DocumentProblem::Folder {
                    files: names_beside(&path.join("file")),
                };
                return Diagnostics::one(SourceLocation::file(name), &problem);
            }
            std::io::ErrorKind::InvalidData => "not a text file in UTF-8".to_owned(),
            _ => error.to_string(),
        };
        Diagnostics::one(
            SourceLocation::file(name),
            &DocumentProblem::Unreadable { reason },
        )
    })
}

#[cfg(test)]
mod tests;
