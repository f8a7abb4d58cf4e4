//! The lines of a file and the fields of a line, with line numbers for messages.

use std::str::{FromStr, SplitAsciiWhitespace};

use super::problem::ReadProblem;

/// Walks over the lines that are not blank.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineCursor<'a> {
    rest: &'a str,
    number: usize,
}

impl<'a> LineCursor<'a> {
    /// Stands before the first line of `text`.
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            rest: text.strip_prefix('\u{feff}').unwrap_or(text),
            number: 0,
        }
    }

    /// Number of the line that was taken last, from one.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Bytes behind the line that was taken last.
    pub(super) fn remaining(&self) -> usize {
        self.rest.len()
    }

    /// Takes the next line that is not blank, without the blanks around it.
    pub(super) fn line(&mut self) -> Option<&'a str> {
        while !self.rest.is_empty() {
            let (line, rest) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
            self.rest = rest;
            self.number += 1;
            let line = line.trim();
            if !line.is_empty() {
                return Some(line);
            }
        }
        None
    }

    /// Takes the next line if it belongs to the content of a section: `None`
    /// before a line that begins with `$` and at the end of the file.
    pub(super) fn content(&mut self) -> Option<&'a str> {
        let mut ahead = *self;
        let line = ahead.line().filter(|line| !line.starts_with('$'))?;
        *self = ahead;
        Some(line)
    }
}

/// Takes the fields of a line one after the other.
#[derive(Debug, Clone)]
pub(super) struct Fields<'a> {
    line: &'a str,
    rest: SplitAsciiWhitespace<'a>,
    /// What the line should hold, for messages.
    expected: &'static str,
}

impl<'a> Fields<'a> {
    pub(super) fn new(line: &'a str, expected: &'static str) -> Self {
        Self {
            line,
            rest: line.split_ascii_whitespace(),
            expected,
        }
    }

    /// The next field.
    pub(super) fn text(&mut self) -> Result<&'a str, ReadProblem> {
        let found = self.rest.next();
        found.ok_or_else(|| self.wrong_count())
    }

    /// The next field as a number; `what` is its name for messages.
    pub(super) fn number<T: FromStr>(&mut self, what: &'static str) -> Result<T, ReadProblem> {
        let found = self.text()?;
        found.parse().map_err(|_| ReadProblem::NotANumber {
            what,
            found: found.to_string(),
        })
    }

    /// The next field as a coordinate: a finite number.
    pub(super) fn coordinate(&mut self) -> Result<f64, ReadProblem> {
        let found = self.text()?;
        found
            .parse()
            .ok()
            .filter(|value: &f64| value.is_finite())
            .ok_or_else(|| ReadProblem::NotACoordinate(found.to_string()))
    }

    /// Passes over `count` fields.
    pub(super) fn skip(&mut self, count: usize) -> Result<(), ReadProblem> {
        for _ in 0..count {
            self.text()?;
        }
        Ok(())
    }

    /// States that no field is left.
    pub(super) fn end(mut self) -> Result<(), ReadProblem> {
        match self.rest.next() {
            None => Ok(()),
            Some(_) => Err(self.wrong_count()),
        }
    }

    fn wrong_count(&self) -> ReadProblem {
        ReadProblem::FieldCount {
            expected: self.expected,
            found: self.line.split_ascii_whitespace().count(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_trimmed_numbered_and_blank_ones_passed_over() {
        let mut cursor = LineCursor::new("\u{feff}$A\r\n\r\n  1 2 \r\n$EndA");
        assert_eq!(cursor.content(), None);
        assert_eq!((cursor.line(), cursor.number()), (Some("$A"), 1));
        assert_eq!((cursor.content(), cursor.number()), (Some("1 2"), 3));
        assert_eq!((cursor.content(), cursor.number()), (None, 3));
        assert_eq!((cursor.line(), cursor.number()), (Some("$EndA"), 4));
        assert_eq!((cursor.line(), cursor.remaining()), (None, 0));
    }

    #[test]
    fn fields_state_what_is_missing_or_too_much() {
        let mut fields = Fields::new("3 x", "two numbers");
        assert_eq!(fields.number::<u64>("tag"), Ok(3));
        assert_eq!(
            fields.number::<u64>("tag").unwrap_err().to_string(),
            "tag: expected a whole number, found \"x\""
        );
        assert_eq!(
            fields.text().unwrap_err().to_string(),
            "expected two numbers, found 2 fields"
        );
        assert!(Fields::new("1", "nothing").end().is_err());
        assert!(Fields::new("nan", "x").coordinate().is_err());
        assert!(Fields::new("1e999", "x").coordinate().is_err());
    }
}
