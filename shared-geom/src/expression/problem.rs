//! What can be wrong with an expression.

use super::FUNCTIONS;
use crate::error::{Explain, nearest_name};

/// A problem of an expression, with its place in the text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ExpressionProblem {
    /// Something that cannot stand where it stands.
    #[error("letter {column} of \"{text}\" is {found}, expected {expected}")]
    Unexpected {
        /// The expression.
        text: String,
        /// Letter, from one, behind the equals sign.
        column: usize,
        /// What was found, in words.
        found: String,
        /// What was expected, in words.
        expected: &'static str,
    },
    /// A name that stands for nothing.
    #[error("unknown name \"{name}\" at letter {column} of \"{text}\"")]
    UnknownName {
        /// The expression.
        text: String,
        /// Letter, from one, behind the equals sign.
        column: usize,
        /// The name.
        name: String,
        /// The nearest name that may stand there, or some that may where none is near.
        known: Vec<String>,
    },
    /// A function that does not exist.
    #[error("unknown function \"{name}\" at letter {column} of \"{text}\"")]
    UnknownFunction {
        /// The expression.
        text: String,
        /// Letter, from one, behind the equals sign.
        column: usize,
        /// The name.
        name: String,
    },
    /// A function with another number of arguments.
    #[error(
        "\"{name}\" at letter {column} of \"{text}\" has {found} arguments, expected {expected}"
    )]
    Arguments {
        /// The expression.
        text: String,
        /// Letter, from one, behind the equals sign.
        column: usize,
        /// The function.
        name: String,
        /// Number of arguments found.
        found: usize,
        /// Number expected.
        expected: usize,
    },
    /// Parentheses in parentheses without end.
    #[error("the expression is nested too deeply at letter {column}, expected a simpler one")]
    TooDeep {
        /// Letter, from one, behind the equals sign.
        column: usize,
    },
}

impl Explain for ExpressionProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::UnknownName { name, known, .. } => {
                let near = nearest_name(name, known.iter().map(String::as_str));
                Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("known names: {}", known.join(", ")),
                })
            }
            Self::UnknownFunction { name, .. } => Some(match nearest_name(name, FUNCTIONS) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("known functions: {}", FUNCTIONS.join(", ")),
            }),
            Self::Unexpected { found, .. } if found == "the letter '*' again" => {
                Some("a power is written with ^".to_owned())
            }
            Self::TooDeep { .. } => Some("give a part of it a name in [parameters]".to_owned()),
            _ => None,
        }
    }
}
