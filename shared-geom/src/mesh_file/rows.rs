//! Rows of numbers: lines that are not blank, without comments.

use std::ops::RangeInclusive;

use super::problem::FileProblem;
use super::words::{real, whole};
use crate::error::shortened;

/// Letters that begin a comment.
const COMMENT: [char; 3] = ['!', '#', '%'];

/// The rows of a text; words are separated by blanks or commas.
#[derive(Debug)]
pub(super) struct Rows<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    line: usize,
}

impl<'a> Rows<'a> {
    /// The rows of `text`.
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            lines: text.lines().enumerate(),
            line: 1,
        }
    }

    /// The line of the last row, from one.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// The words of the next row, at least one.
    pub(super) fn next(&mut self) -> Option<Vec<&'a str>> {
        for (at, line) in self.lines.by_ref() {
            let text = line.split(COMMENT).next().unwrap_or_default();
            let words = text.split(|c: char| c.is_whitespace() || c == ',');
            let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
            if !words.is_empty() {
                self.line = at + 1;
                return Some(words);
            }
        }
        None
    }

    /// The next row, which must exist: the file ends before `what` otherwise.
    pub(super) fn expect(&mut self, what: &'static str) -> Result<Vec<&'a str>, FileProblem> {
        self.next().ok_or(FileProblem::CutOff(what))
    }

    /// The next row, which must have `count` words.
    pub(super) fn counted(
        &mut self,
        what: &'static str,
        count: RangeInclusive<usize>,
    ) -> Result<Vec<&'a str>, FileProblem> {
        let row = self.expect(what)?;
        if count.contains(&row.len()) {
            Ok(row)
        } else {
            Err(FileProblem::Count {
                what: what.to_owned(),
                found: row.len(),
                expected: count.start().to_string(),
            })
        }
    }
}

/// A word as a whole number.
pub(super) fn integer(word: &str, what: &'static str) -> Result<i64, FileProblem> {
    whole(word, what)
}

/// A word as a number of a node, an element or a material; tables may write it as a real
/// number, `1.0e+00`.
pub(super) fn index(word: &str, what: &'static str) -> Result<u64, FileProblem> {
    let number = word.parse().ok().or_else(|| {
        let number = real(word, what).ok()?;
        let is_index = number >= 0.0 && number.fract() == 0.0 && number < 2.0_f64.powi(53);
        is_index.then_some(number as u64)
    });
    number.ok_or_else(|| FileProblem::Field {
        what,
        found: shortened(word),
        expected: "a whole number",
    })
}
