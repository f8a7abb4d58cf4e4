//! The words of a text with their lines, and numbers of texts.

use std::str::FromStr;

use super::problem::FileProblem;
use crate::error::shortened;

/// The words of a text, separated by spaces and line ends.
#[derive(Debug)]
pub(super) struct Words<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    rest: std::str::SplitWhitespace<'a>,
    line: usize,
}

impl<'a> Words<'a> {
    /// The words of `text`.
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            lines: text.lines().enumerate(),
            rest: "".split_whitespace(),
            line: 1,
        }
    }

    /// The line of the last word, from one.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// The next whole line; the rest of the present one is skipped.
    pub(super) fn next_line(&mut self) -> Option<&'a str> {
        let (at, line) = self.lines.next()?;
        (self.line, self.rest) = (at + 1, "".split_whitespace());
        Some(line.trim())
    }

    /// The next word.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.rest.next() {
                return Some(word);
            }
            let (at, line) = self.lines.next()?;
            (self.line, self.rest) = (at + 1, line.split_whitespace());
        }
    }

    /// The next word as a number.
    pub(super) fn number<T: FromStr>(&mut self, what: &'static str) -> Result<T, FileProblem> {
        let word = self.word().ok_or(FileProblem::CutOff(what))?;
        whole(word, what)
    }

    /// The next word as a finite number.
    pub(super) fn real(&mut self, what: &'static str) -> Result<f64, FileProblem> {
        let word = self.word().ok_or(FileProblem::CutOff(what))?;
        real(word, what)
    }
}

/// A word as a whole number.
pub(super) fn whole<T: FromStr>(word: &str, what: &'static str) -> Result<T, FileProblem> {
    word.parse().map_err(|_| FileProblem::Field {
        what,
        found: shortened(word),
        expected: "a whole number",
    })
}

/// A word as a finite number; the exponent of double precision in Fortran, `1.0D0`, is read
/// too.
pub(super) fn real(word: &str, what: &'static str) -> Result<f64, FileProblem> {
    let number = word.parse::<f64>();
    let number = number.or_else(|_| word.replace(['d', 'D'], "e").parse());
    let number = number.ok().filter(|number| number.is_finite());
    number.ok_or_else(|| FileProblem::Field {
        what,
        found: shortened(word),
        expected: "a finite number",
    })
}
