//! What can be wrong with an input file as such.

use crate::error::{Explain, nearest_name, quoted};
use crate::expression::ExpressionProblem;
use crate::files::nearest_file;
use crate::units::UnitProblem;

/// A problem of an input file that does not depend on what the file is about.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DocumentProblem {
    /// The file cannot be read.
    #[error("cannot be read: {reason}")]
    Unreadable {
        /// The reason in words.
        reason: String,
    },
    /// A file that is named and not there.
    #[error("\"{key}\": no file \"{name}\"")]
    NoFile {
        /// The key that names it.
        key: String,
        /// Its name as written.
        name: String,
        /// The files of the folder in which it was looked for.
        known: Vec<String>,
    },
    /// The text is no TOML.
    #[error("not valid TOML: {reason}")]
    Syntax {
        /// The parser's words.
        reason: String,
        /// The remedy, where one is known.
        help: Option<String>,
    },
    /// Further errors of syntax.
    #[error("further errors of syntax from here on: {count}")]
    MoreSyntax {
        /// Errors that are not told one by one.
        count: usize,
    },
    /// A file of another kind.
    #[error("the file is {what}, expected an input file in TOML")]
    OtherFormat {
        /// What it is, in words.
        what: &'static str,
    },
    /// A key that no one knows.
    #[error("unknown key \"{key}\" in {table}")]
    UnknownKey {
        /// The key as written.
        key: String,
        /// The table that holds it, in words.
        table: String,
        /// The keys that the table may have.
        known: Vec<String>,
        /// Where such a key belongs, as it is written there: `[[output.column]]`.
        elsewhere: Option<&'static str>,
    },
    /// A required key is absent.
    #[error("{table} has no \"{key}\", expected {expected}")]
    MissingKey {
        /// The absent key.
        key: String,
        /// The table, in words.
        table: String,
        /// What it should hold, in words.
        expected: String,
    },
    /// A value of another type or outside its range.
    #[error("\"{key}\" is {found}, expected {expected}")]
    WrongValue {
        /// The key.
        key: String,
        /// The value found, in words.
        found: String,
        /// What was expected, in words.
        expected: String,
    },
    /// A value that is none of a fixed set of words.
    #[error("\"{key}\" is \"{found}\", expected one of {}", quoted(.known))]
    WrongWord {
        /// The key.
        key: String,
        /// The word found.
        found: String,
        /// The words that may stand there.
        known: Vec<String>,
    },
    /// A unit that is unknown or measures something else.
    #[error("\"{key}\": {problem}")]
    Unit {
        /// The key.
        key: String,
        /// What is wrong with the unit.
        problem: UnitProblem,
    },
    /// An expression that cannot be read.
    #[error("\"{key}\": {problem}")]
    Expression {
        /// The key.
        key: String,
        /// What is wrong with it.
        problem: ExpressionProblem,
    },
    /// A parameter whose name no expression can use.
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
        /// The way from it back to it.
        chain: Vec<String>,
    },
    /// A file that includes itself, at once or by others.
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
    #[error("\"{key}\" is given in {place} already, expected it once")]
    DoubledKey {
        /// The key.
        key: String,
        /// Place of the first.
        place: String,
    },
    /// More copies than anyone means.
    #[error("the copies of \"{name}\" come to more than {limit} cards")]
    ManyCopies {
        /// Name of the repeat.
        name: String,
        /// The largest number accepted.
        limit: usize,
    },
}

impl Explain for DocumentProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::UnknownKey {
                key,
                known,
                elsewhere,
                ..
            } => {
                let near = nearest_name(key, known.iter().map(String::as_str));
                Some(match (elsewhere, near) {
                    (Some(place), _) => format!("did you mean {place}?"),
                    (None, Some(near)) => format!("did you mean \"{near}\"?"),
                    (None, None) => format!("known keys: {}", known.join(", ")),
                })
            }
            Self::WrongWord { found, known, .. } => {
                nearest_name(found, known.iter().map(String::as_str))
                    .map(|near| format!("did you mean \"{near}\"?"))
            }
            Self::Syntax { help, .. } => help.clone(),
            Self::Unit { problem, .. } => problem.help(),
            Self::Expression { problem, .. } => problem.help(),
            Self::NoFile { name, known, .. } => Some(nearest_file(name, known)),
            Self::UnitsOfIncluded => {
                Some("its numbers count in the units of the file that includes it".to_owned())
            }
            Self::ManyCopies { .. } => {
                Some("give a smaller \"count\", or say with fewer cards what is copied".to_owned())
            }
            Self::OtherFormat { .. } => {
                Some("name the file ending in .toml that leads to it".to_owned())
            }
            _ => None,
        }
    }
}
