//! Errors of an expression.

use super::FUNCTIONS;
use crate::error::{Explain, nearest_name};

/// A problem of an expression, with its position in the text.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ExpressionProblem {
    /// Unexpected text.
    #[error("letter {column} of \"{text}\" is {found}, expected {expected}")]
    Unexpected {
        /// The expression.
        text: String,
        /// Letter, from one, after the equals sign.
        column: usize,
        /// The text found.
        found: String,
        /// The text expected.
        expected: &'static str,
    },
    /// An unknown name.
    #[error("unknown name \"{name}\" at letter {column} of \"{text}\"")]
    UnknownName {
        /// The expression.
        text: String,
        /// Letter, from one, after the equals sign.
        column: usize,
        /// The name.
        name: String,
        /// The nearest permitted name, or some permitted ones if none is near.
        known: Vec<String>,
    },
    /// A function that does not exist.
    #[error("unknown function \"{name}\" at letter {column} of \"{text}\"")]
    UnknownFunction {
        /// The expression.
        text: String,
        /// Letter, from one, after the equals sign.
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
        /// Letter, from one, after the equals sign.
        column: usize,
        /// The function.
        name: String,
        /// Number of arguments found.
        found: usize,
        /// Number expected.
        expected: usize,
    },
    /// Too many nested parentheses.
    #[error("the expression is nested too deeply at letter {column}, expected a simpler one")]
    TooDeep {
        /// Letter, from one, after the equals sign.
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
                    None => format!(
                        "known names: {}; [parameters] defines others",
                        known.join(", ")
                    ),
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
