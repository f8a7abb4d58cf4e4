//! Expressions of named numbers: `2*pi*f*cos(2*pi*f*t)`, with their derivatives.
//!
//! A text is read once into a short program for a stack; the program runs on [`Jet`]s,
//! numbers that carry their first and second derivative, so that derivatives are exact
//! and an evaluation needs no memory of its own. Powers go before signs: `-2^2` is -4.
//!
//! The reader is our own, of some hundred lines: of the crates for it those that know
//! derivatives take `-2^2` for 4, know none of `abs`, `min` and `max`, find 0 times the
//! logarithm of 0 in the slope of a power, and tell no place of a mistake.

mod functions;
mod jet;
mod parse;
mod problem;
mod run;

#[cfg(test)]
mod tests;

pub use functions::FUNCTIONS;
pub use jet::Jet;
pub use parse::{Names, is_name};
pub use problem::ExpressionProblem;

use functions::Operation;

/// An expression that was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    text: String,
    program: Vec<Operation>,
    /// Which variables stand in it, up to the last that does.
    used: Vec<bool>,
    /// Names of the known numbers that stand in it.
    known: Vec<String>,
}

impl Expression {
    /// Reads `text`, in which the names may stand.
    ///
    /// # Errors
    /// [`ExpressionProblem`] with the place in the text.
    pub fn parse(text: &str, names: &Names<'_>) -> Result<Self, ExpressionProblem> {
        parse::expression(text, names)
    }

    /// Variable number `index` alone.
    pub fn variable(index: usize) -> Self {
        Self {
            text: String::new(),
            program: vec![Operation::Variable(index)],
            used: (0..=index).map(|own| own == index).collect(),
            known: Vec::new(),
        }
    }

    /// The text from which it was read.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Names of the known numbers that were put in, each as often as it stands there.
    pub fn known(&self) -> &[String] {
        &self.known
    }

    /// Whether variable number `index` stands in it.
    pub fn uses(&self, index: usize) -> bool {
        self.used.get(index).copied().unwrap_or(false)
    }
}

/// What a text of an input file says when it is an expression: the part behind `=`.
pub fn written(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix('=')
}
