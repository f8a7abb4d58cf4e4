//! Expressions of named numbers: `2*pi*f*cos(2*pi*f*t)`, with their derivatives.
//!
//! A text is read once into a short program for a stack; the program runs on [`Jet`]s,
//! numbers that carry their first and second derivative, so that derivatives are exact
//! and an evaluation does not allocate. Powers go before signs: `-2^2` is -4.
//!
//! The reader is part of Helicoid, with some hundred lines: the crates with derivatives
//! read `-2^2` as 4, do not know `abs`, `min` and `max`, have 0 times the logarithm of 0
//! in the slope of a power, and do not report the position of a mistake.
//!
//! # Example
//!
//! ```
//! use shared_geom::expression::{Expression, Jet, Names};
//!
//! let names = Names { variables: &["t"], constants: &[] };
//! let law = Expression::parse("3 * sin(2 * t)", &names).expect("an expression");
//! // the value, and its derivatives by t
//! let now = law.at(|_| Jet::variable(0.0));
//! assert_eq!((now.value, now.first, now.second), (0.0, 6.0, 0.0));
//! assert!(Expression::parse("3 * sine(t)", &names).is_err());
//! ```

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
    /// Which variables it contains, up to the last one.
    used: Vec<bool>,
    /// Names of the known numbers that it contains.
    known: Vec<String>,
}

impl Expression {
    /// Reads `text`, which may contain the names.
    ///
    /// # Errors
    /// [`ExpressionProblem`] with the position in the text.
    pub fn parse(text: &str, names: &Names<'_>) -> Result<Self, ExpressionProblem> {
        parse::expression(text, names)
    }

    /// Variable number `index` only.
    pub fn variable(index: usize) -> Self {
        Self {
            text: String::new(),
            program: vec![Operation::Variable(index)],
            used: (0..=index).map(|own| own == index).collect(),
            known: Vec::new(),
        }
    }

    /// The text of the expression.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Names of the known numbers that it contains, each as often as it occurs.
    pub fn known(&self) -> &[String] {
        &self.known
    }

    /// Whether it contains variable number `index`.
    pub fn uses(&self, index: usize) -> bool {
        self.used.get(index).copied().unwrap_or(false)
    }
}

/// The words of the text of an expression: names, functions and numbers.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

/// Content of a text of an input file that is an expression: the part after `=`.
pub fn written(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix('=')
}
