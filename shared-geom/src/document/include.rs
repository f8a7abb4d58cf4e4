//! Files that include the cards of others: `include = ["blade.toml"]`.
//!
//! Lists of tables are joined, the tables of the including file first, and so are the
//! keys of tables. A line keeps its file: line numbers of included files start at a
//! multiple of [`LINES`].

use std::path::{Path, PathBuf};

use super::syntax::syntax_problems;
use super::tree::{self, Entry, Kind, Lines, Value};
use super::{Document, DocumentProblem, read_text};
use crate::error::{Diagnostics, SourceLocation};
use crate::files::{MissingFolder, names_beside};
use toml::de::DeTable;

/// Most lines of a file.
const LINES: usize = 1 << 24;
/// The key of the files to include.
const KEY: &str = "include";

/// Number of the file and line in it, from an internal line number.
pub(super) fn split(line: usize) -> (usize, usize) {
    (line / LINES, line % LINES)
}

/// Content read so far.
#[derive(Default)]
struct Reader {
    files: Vec<String>,
    /// Files that are being read, each included by the previous one.
    open: Vec<PathBuf>,
    /// Files that were read.
    read: Vec<PathBuf>,
    problems: Diagnostics,
    /// Files that do not exist: other errors are still searched.
    absent: Diagnostics,
}

impl Document {
    /// As [`Document::parse`], with the cards of the files that the text includes.
    ///
    /// # Errors
    /// Every error of syntax in any of the files, files that cannot be read, and files
    /// that include themselves. Files that do not exist are noted in the document, so
    /// that [`Document::finish`] reports them with all other problems.
    pub fn parse_with_includes(text: &str, file: &str) -> Result<Self, Diagnostics> {
        let mut reader = Reader::default();
        reader.open.push(known_as(Path::new(file)));
        let root = reader.entries(text, file);
        let (files, mut problems) = (reader.files, reader.problems);
        if !problems.is_empty() {
            problems.append(reader.absent);
            return Err(problems);
        }
        let mut document = Self::of(root, files);
        document.problems.get_mut().append(reader.absent);
        Ok(document)
    }
}

/// The canonical path that identifies a file.
fn known_as(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

impl Reader {
    /// The entries of a text and of its included files.
    fn entries(&mut self, text: &str, file: &str) -> Vec<Entry> {
        let base = LINES * self.files.len();
        self.files.push(file.to_owned());
        let lines = Lines::of(text);
        let (root, errors) = DeTable::parse_recoverable(text);
        let problems = syntax_problems((root.get_ref(), &errors), &lines, text, file);
        self.problems.append(problems);
        let mut entries = tree::entries(root.get_ref(), &lines.from(base));
        let Some(location) = entries.iter().position(|entry| entry.key == KEY) else {
            return entries;
        };
        let include = entries.remove(location).value;
        let items = match &include.kind {
            Kind::Array(items) => items.as_slice(),
            _ => std::slice::from_ref(&include),
        };
        for item in items {
            self.include(item, file, &mut entries);
        }
        entries
    }

    fn note(&mut self, line: usize, problem: &DocumentProblem) {
        let (file, line) = split(line);
        let location = SourceLocation::line(&self.files[file], line);
        self.problems.push(location, problem);
    }

    fn include(&mut self, item: &Value, file: &str, entries: &mut Vec<Entry>) {
        let Kind::Text(written) = &item.kind else {
            let problem = DocumentProblem::WrongValue {
                key: KEY.to_owned(),
                found: item.kind.describe(),
                expected: "the name of a file, or a list of names".to_owned(),
            };
            return self.note(item.line, &problem);
        };
        let folder = Path::new(file).parent().unwrap_or(Path::new(""));
        let path = folder.join(written);
        if !path.is_file() {
            let (key, name) = (KEY.to_owned(), written.clone());
            let problem = match MissingFolder::before(&path) {
                Some(folder) => DocumentProblem::NoFolder {
                    key,
                    name,
                    folder,
                    others: 0,
                },
                None => DocumentProblem::NoFile {
                    key,
                    name,
                    known: names_beside(&path),
                },
            };
            let (file, line) = split(item.line);
            let location = SourceLocation::line(&self.files[file], line);
            return self.absent.push(location, &problem);
        }
        let known = known_as(&path);
        let name = written.clone();
        if self.open.contains(&known) {
            return self.note(item.line, &DocumentProblem::IncludesItself { name });
        }
        if self.read.contains(&known) {
            return self.note(item.line, &DocumentProblem::IncludedTwice { name });
        }
        match read_text(&path) {
            Err(problems) => self.problems.append(problems),
            Ok(text) => {
                self.open.push(known);
                let own = self.entries(&text, &path.display().to_string());
                self.read.extend(self.open.pop());
                self.join(entries, own, true);
            }
        }
    }

    /// Joins the entries of an included file to the entries of the including file.
    fn join(&mut self, entries: &mut Vec<Entry>, own: Vec<Entry>, at_top: bool) {
        for entry in own {
            if at_top && entry.key == "units" {
                self.note(entry.line, &DocumentProblem::UnitsOfIncluded);
                continue;
            }
            let Some(first) = entries.iter_mut().find(|other| other.key == entry.key) else {
                entries.push(entry);
                continue;
            };
            match (&mut first.value.kind, entry.value.kind) {
                (Kind::Array(items), Kind::Array(more)) if at_top => items.extend(more),
                (Kind::Table(items), Kind::Table(more)) if at_top => {
                    let mut joined = std::mem::take(items);
                    self.join(&mut joined, more, false);
                    let again = entries.iter_mut().find(|other| other.key == entry.key);
                    if let Some(again) = again {
                        again.value.kind = Kind::Table(joined);
                    }
                }
                _ => {
                    let (file, line) = split(first.line);
                    let problem = DocumentProblem::DoubledKey {
                        key: entry.key,
                        location: SourceLocation::line(&self.files[file], line).to_string(),
                    };
                    self.note(entry.line, &problem);
                }
            }
        }
    }
}
