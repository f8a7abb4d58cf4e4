//! Errors of an input file in general.

use crate::error::{Explain, listed, nearest_name, quoted};
use crate::expression::ExpressionProblem;
use crate::files::{MissingFolder, nearest_file};
use crate::units::UnitProblem;

/// Most words that a sentence lists.
const MANY: usize = 12;

/// A problem of an input file, independent of its subject.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DocumentProblem {
    /// The file cannot be read.
    #[error("cannot be read: {reason}")]
    Unreadable {
        /// The reason as text.
        reason: String,
    },
    /// The file does not exist.
    #[error("cannot be read: no such file")]
    Absent {
        /// Its name as written.
        name: String,
        /// The files of the folder that was searched.
        known: Vec<String>,
    },
    /// The folder of the file does not exist.
    #[error("cannot be read: there is no folder \"{}\"", .0.path)]
    AbsentFolder(MissingFolder),
    /// A file that is named in a folder that does not exist.
    #[error(
        "\"{key}\" is \"{name}\", but there is no folder \"{}\"{}", .folder.path, also(*.others)
    )]
    NoFolder {
        /// The key that names it.
        key: String,
        /// Its name as written.
        name: String,
        /// The missing folder.
        folder: MissingFolder,
        /// Number of further files in it.
        others: usize,
    },
    /// A file that is named and does not exist.
    #[error("\"{key}\": no file \"{name}\"")]
    NoFile {
        /// The key that names it.
        key: String,
        /// Its name as written.
        name: String,
        /// The files of the folder that was searched.
        known: Vec<String>,
    },
    /// A folder in place of a file.
    #[error("cannot be read: it is a folder")]
    Folder {
        /// Its files.
        files: Vec<String>,
    },
    /// The text is no TOML.
    #[error("not valid TOML: {reason}")]
    Syntax {
        /// The parser's message.
        reason: String,
        /// The remedy, if one is known.
        help: Option<String>,
    },
    /// Further errors of syntax.
    #[error("further errors of syntax from here on: {count}")]
    MoreSyntax {
        /// Errors that are not reported one by one.
        count: usize,
    },
    /// A file of another kind.
    #[error("the file is {what}, expected an input file in TOML")]
    OtherFormat {
        /// Its kind, as text.
        what: &'static str,
    },
    /// A file with keys of other files only.
    #[error("this is no {kind}: it has no key of one, and begins with \"{key}\"")]
    Foreign {
        /// The expected kind, as text.
        kind: &'static str,
        /// The first key.
        key: String,
    },
    /// An unknown key.
    #[error("unknown key \"{key}\" in {table}")]
    UnknownKey {
        /// The key as written.
        key: String,
        /// The table that holds it, as text.
        table: String,
        /// The keys that the table may have.
        known: Vec<String>,
        /// Correct location of the key, as written there: `[[output.column]]`.
        right_table: Option<&'static str>,
    },
    /// A required key is absent.
    #[error("{table} has no \"{key}\", expected {expected}")]
    MissingKey {
        /// The absent key.
        key: String,
        /// The table, as text.
        table: String,
        /// Expected content, as text.
        expected: String,
    },
    /// A value of another type or outside its range.
    #[error("\"{key}\" is {found}, expected {expected}")]
    WrongValue {
        /// The key.
        key: String,
        /// The value found, as text.
        found: String,
        /// The value expected, as text.
        expected: String,
    },
    /// A value outside of a fixed set of words.
    #[error("\"{key}\" is \"{found}\", expected one of {}", words(.known))]
    WrongWord {
        /// The key.
        key: String,
        /// The word found.
        found: String,
        /// The permitted words.
        known: Vec<String>,
        /// The permitted word of the same meaning, if one is known.
        meant: Option<&'static str>,
    },
    /// A unit that is unknown or measures something else.
    #[error("\"{key}\": {problem}")]
    Unit {
        /// The key.
        key: String,
        /// The problem of the unit.
        problem: UnitProblem,
    },
    /// An expression that cannot be read.
    #[error("\"{key}\": {problem}")]
    Expression {
        /// The key.
        key: String,
        /// The problem of the expression.
        problem: ExpressionProblem,
    },
    /// A parameter whose name cannot be used in expressions.
    #[error("\"{name}\" is no name of a parameter, expected letters, digits and \"_\"")]
    ParameterName {
        /// The name.
        name: String,
    },
    /// Parameters that depend on themselves.
    #[error("the parameter \"{name}\" depends on itself: {}", .chain.join(" -> "))]
    Cycle {
        /// The parameter.
        name: String,
        /// The path from it back to it.
        chain: Vec<String>,
    },
    /// A file that includes itself, directly or by others.
    #[error("\"include\": the file \"{name}\" includes itself")]
    IncludesItself {
        /// Its name as written.
        name: String,
    },
    /// A file that is included twice.
    #[error("\"include\": the file \"{name}\" is included already")]
    IncludedTwice {
        /// Its name as written.
        name: String,
    },
    /// Units of an included file.
    #[error("an included file has \"units\", expected none")]
    UnitsOfIncluded,
    /// A key that two files have.
    #[error("\"{key}\" is given in {location} already, expected it once")]
    DoubledKey {
        /// The key.
        key: String,
        /// Location of the first.
        location: String,
    },
    /// An excessive number of copies.
    #[error("the copies of \"{name}\" come to more than {limit} cards")]
    ManyCopies {
        /// Name of the repeat.
        name: String,
        /// The largest number accepted.
        limit: usize,
    },
}

/// Words as they are listed within a sentence; only their number if they are many.
fn words(known: &[String]) -> String {
    if known.len() > MANY {
        format!("{} words", known.len())
    } else {
        quoted(known)
    }
}

/// The remedy for parameters that depend on each other.
fn open_cycle(chain: &[String]) -> String {
    match chain {
        [name, _] => format!("give \"{name}\" a number, or an expression of other parameters"),
        [name, ..] => format!("give one of them a number, for example \"{name}\""),
        [] => String::new(),
    }
}

/// The number of further files in a missing folder, as text.
fn also(others: usize) -> String {
    match others {
        0 => String::new(),
        1 => "; 1 more file is named in it".to_owned(),
        _ => format!("; {others} more files are named in it"),
    }
}

impl Explain for DocumentProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::UnknownKey {
                key,
                known,
                right_table,
                ..
            } => {
                let near = nearest_name(key, known.iter().map(String::as_str));
                Some(match (right_table, near) {
                    (Some(location), _) => format!("did you mean {location}?"),
                    (None, Some(near)) => format!("did you mean \"{near}\"?"),
                    (None, None) => format!("known keys: {}", listed(known)),
                })
            }
            Self::WrongWord {
                found,
                known,
                meant,
                ..
            } => meant
                .or_else(|| nearest_name(found, known.iter().map(String::as_str)))
                .map(|near| format!("did you mean \"{near}\"?"))
                .or_else(|| (known.len() > MANY).then(|| format!("words: {}", listed(known)))),
            Self::Syntax { help, .. } => help.clone(),
            Self::Cycle { chain, .. } => Some(open_cycle(chain)),
            Self::Unit { problem, .. } => problem.help(),
            Self::Expression { problem, .. } => problem.help(),
            Self::AbsentFolder(folder) => folder
                .near
                .as_ref()
                .map(|near| format!("did you mean the folder \"{near}\"?")),
            Self::NoFolder { folder, .. } => Some(folder.help()),
            Self::Absent { known, .. } if known.is_empty() => None,
            Self::NoFile { name, known, .. } | Self::Absent { name, known } => {
                Some(nearest_file(name, known))
            }
            Self::Folder { files } => {
                let is_input = |file: &&String| file.ends_with(".toml");
                let mut named: Vec<_> = files.iter().filter(is_input).cloned().collect();
                if named.is_empty() {
                    named.clone_from(files);
                }
                (!named.is_empty()).then(|| format!("name a file in it: {}", listed(&named)))
            }
            Self::UnitsOfIncluded => {
                Some("its numbers count in the units of the file that includes it".to_owned())
            }
            Self::ManyCopies { .. } => {
                Some("give a smaller \"count\", or copy fewer cards".to_owned())
            }
            Self::OtherFormat { .. } => {
                Some("name the file ending in .toml that leads to it".to_owned())
            }
            _ => None,
        }
    }
}
