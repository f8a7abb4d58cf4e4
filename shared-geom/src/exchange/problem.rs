//! Errors of a file of another tool.

use std::path::Path;

use crate::error::{Diagnostics, Explain, SourceLocation, shortened};
use crate::files::{MissingFolder, names_beside, nearest_file};

/// Number of problems of one file that are reported; the others are counted.
const LIMIT: usize = 20;

fn unknown(begin: &str, tried: &[&str]) -> String {
    let tried = tried.join(", ");
    match begin {
        "" => format!("the file is empty, expected one of the formats {tried}"),
        _ => format!(
            "the format of the file is not known: it begins with \"{begin}\", tried {tried}"
        ),
    }
}

/// A problem of a blade file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ExchangeProblem {
    /// A text of no known format.
    #[error("{}", unknown(begin, tried))]
    Unknown {
        /// Its first line that is not blank.
        begin: String,
        /// The formats that were tried.
        tried: Vec<&'static str>,
    },
    /// A format that is only written.
    #[error("{title}: this format is written, but cannot be read")]
    NotRead {
        /// The format.
        title: &'static str,
    },
    /// A format that is only read.
    #[error("{title}: this format is read, but cannot be written")]
    NotWritten {
        /// The format.
        title: &'static str,
    },
    /// Another number of values on a line.
    #[error("{what}: expected {expected} numbers, found {found}")]
    Count {
        /// The content of the line.
        what: String,
        /// Expected number of values.
        expected: usize,
        /// Number of values found.
        found: usize,
        /// Separator of the values: `blanks` or `commas`.
        separator: &'static str,
    },
    /// A word instead of a number.
    #[error("{what}: expected a finite number, found \"{found}\"")]
    NotANumber {
        /// The meaning of the number.
        what: String,
        /// The word.
        found: String,
    },
    /// The end of the file within its content.
    #[error("the file ends within {what}, expected {expected}")]
    CutShort {
        /// The part within which it ends.
        what: String,
        /// The expected content.
        expected: String,
    },
    /// A file that is named in a folder that does not exist.
    #[error("{what}: no file \"{name}\", for there is no folder \"{}\"", .folder.path)]
    NoFolder {
        /// The statement that names it.
        what: String,
        /// Its name as written.
        name: String,
        /// The missing folder.
        folder: MissingFolder,
    },
    /// A file that another one names and that does not exist.
    #[error("{what}: no file \"{name}\"")]
    NoFile {
        /// The name's source.
        what: String,
        /// Its name as written.
        name: String,
        /// The files of the folder that was searched.
        known: Vec<String>,
    },
    /// A value smaller than the previous one.
    #[error("{what} is {found}, expected at least the value of the previous station, {before}")]
    Order {
        /// The value.
        what: String,
        /// The value found.
        found: f64,
        /// The value of the previous station.
        before: f64,
    },
    /// Anything else: found and expected values, and the remedy.
    #[error("{what}: found {found}, expected {expected}")]
    Other {
        /// The wrong part.
        what: String,
        /// The value found.
        found: String,
        /// The value expected.
        expected: String,
        /// The remedy.
        help: String,
    },
    /// A required statement that is missing.
    #[error("{what} is missing")]
    Missing {
        /// The missing part.
        what: String,
        /// The remedy.
        help: String,
    },
    /// More problems than are reported.
    #[error("and {0} more problems")]
    More(usize),
}

impl ExchangeProblem {
    /// The problem that `text` is of no known format.
    pub fn unknown(text: &str, tried: Vec<&'static str>) -> Self {
        let first = text.lines().map(str::trim).find(|line| !line.is_empty());
        Self::Unknown {
            begin: shortened(first.unwrap_or_default()),
            tried,
        }
    }

    /// The problem that a file of another format than htc has no body with a name.
    pub fn no_bodies(name: &str) -> Self {
        Self::Other {
            what: format!("the body \"{name}\""),
            found: "a file with one line of sections only".to_owned(),
            expected: "an htc file of HAWC2, whose main_body have names, or body = \"tower\" of a windIO file"
                .to_owned(),
            help: "remove the name of the body".to_owned(),
        }
    }
}

impl Explain for ExchangeProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown { .. } => Some(
                "give a file of one of these formats, or describe the stations in a \
                 NAME.blade.toml"
                    .to_owned(),
            ),
            Self::CutShort { .. } => Some(
                "the file may have been cut off while it was written or copied, or a count in \
                 it is wrong"
                    .to_owned(),
            ),
            Self::Count { separator, .. } => Some(format!(
                "columns are separated by {separator}; see the page on formats"
            )),
            Self::NotANumber { .. } => Some("write a number, as 0.25 or 1e-3".to_owned()),
            Self::NoFolder { folder, .. } => Some(folder.help()),
            Self::NoFile { name, known, .. } => Some(nearest_file(name, known)),
            Self::Order { .. } => {
                Some("put the stations in order from the root to the tip".to_owned())
            }
            Self::Other { help, .. } | Self::Missing { help, .. } => Some(help.clone()),
            _ => None,
        }
    }
}

/// The problems of one file, the first of many.
#[derive(Debug)]
pub struct Problems {
    file: String,
    all: Diagnostics,
    count: usize,
}

impl Problems {
    /// No problems, of `file`.
    pub fn new(file: &str) -> Self {
        Self {
            file: file.to_owned(),
            all: Diagnostics::new(),
            count: 0,
        }
    }

    /// Adds the problem of a line, counted from one; 0 for the whole file.
    pub fn push(&mut self, line: usize, problem: &ExchangeProblem) {
        self.count += 1;
        if self.count > LIMIT {
            return;
        }
        let location = match line {
            0 => SourceLocation::file(&self.file),
            _ => SourceLocation::line(&self.file, line),
        };
        self.all.push(location, problem);
    }

    /// From here on, lines refer to `file`.
    pub fn turn_to(&mut self, file: &Path) {
        self.file = file.display().to_string();
    }

    /// The value of a good result; notes the problems of a bad one.
    pub fn keep<T>(&mut self, result: Result<T, Diagnostics>) -> Option<T> {
        self.count += usize::from(result.is_err());
        self.all.keep(result)
    }

    /// Notes on a line that there is no file at `path`, which `what` names as `name`;
    /// returns whether the file exists.
    pub fn finds(&mut self, path: &Path, what: &str, name: &str, line: usize) -> bool {
        if path.exists() {
            return true;
        }
        if let Some(folder) = MissingFolder::before(path) {
            let (what, name) = (what.to_owned(), name.to_owned());
            self.push(line, &ExchangeProblem::NoFolder { what, name, folder });
            return false;
        }
        let (what, name, known) = (what.to_owned(), name.to_owned(), names_beside(path));
        self.push(line, &ExchangeProblem::NoFile { what, name, known });
        false
    }

    /// Whether there are no problems.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// All problems, in the order of their lines.
    pub fn into_diagnostics(mut self) -> Diagnostics {
        self.all.sort_by_line();
        if self.count > LIMIT {
            let more = ExchangeProblem::More(self.count - LIMIT);
            self.all.push(SourceLocation::file(&self.file), &more);
        }
        self.all
    }

    /// The value, when there is one and no problem.
    pub fn finish<T>(self, value: Option<T>) -> Result<T, Diagnostics> {
        match value {
            Some(value) if self.is_empty() => Ok(value),
            _ => Err(self.into_diagnostics()),
        }
    }
}
