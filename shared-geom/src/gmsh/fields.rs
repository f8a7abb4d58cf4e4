//! The numbers of a record: the fields of a line, or bytes.

use std::str::{FromStr, SplitAsciiWhitespace};

use super::cursor::Cursor;
use super::problem::ReadProblem;
use crate::error::shortened;

/// Reads the numbers of a record one after the other.
#[derive(Debug)]
pub(super) enum Fields<'r, 'a> {
    /// Numbers of a line of text.
    Line(LineFields<'a>),
    /// Numbers that follow as bytes.
    Bytes {
        cursor: &'r mut Cursor<'a>,
        /// Content of the record, for messages.
        expected: &'static str,
    },
}

impl Fields<'_, '_> {
    /// An integer of four bytes in binary files.
    pub(super) fn int(&mut self, what: &'static str) -> Result<i32, ReadProblem> {
        match self {
            Self::Line(line) => line.number(what),
            Self::Bytes { cursor, expected } => cursor.number(expected).map(i32::from_le_bytes),
        }
    }

    /// An integer of four bytes in binary files that is not negative.
    pub(super) fn natural(&mut self, what: &'static str) -> Result<u64, ReadProblem> {
        match self {
            Self::Line(line) => line.number(what),
            Self::Bytes { .. } => {
                let found = self.int(what)?;
                u64::try_from(found).map_err(|_| ReadProblem::NotANumber {
                    what,
                    found: found.to_string(),
                })
            }
        }
    }

    /// An integer of eight bytes in binary files that is not negative.
    pub(super) fn size(&mut self, what: &'static str) -> Result<u64, ReadProblem> {
        match self {
            Self::Line(line) => line.number(what),
            Self::Bytes { cursor, expected } => cursor.number(expected).map(u64::from_le_bytes),
        }
    }

    /// A [`Fields::size`] that counts items of at least `least_bytes` each: at most the
    /// capacity of the rest of the file, so that space can be allocated for them.
    pub(super) fn count(
        &mut self,
        what: &'static str,
        least_bytes: usize,
    ) -> Result<usize, ReadProblem> {
        match self {
            Self::Line(line) => line.count(what, least_bytes),
            Self::Bytes { cursor, expected } => {
                let count = cursor.number(expected).map(u64::from_le_bytes)?;
                fitting(what, count, cursor.remaining() / least_bytes)
            }
        }
    }

    /// A position: three finite numbers; all are read even if one is wrong.
    pub(super) fn position(&mut self) -> Result<[f64; 3], ReadProblem> {
        match self {
            Self::Line(line) => {
                let fields = [line.text()?, line.text()?, line.text()?];
                let mut position = [0.0; 3];
                for (coordinate, field) in position.iter_mut().zip(fields) {
                    *coordinate = coordinate_of(field)?;
                }
                Ok(position)
            }
            Self::Bytes { cursor, expected } => {
                let mut position = [0.0; 3];
                for coordinate in &mut position {
                    *coordinate = f64::from_le_bytes(cursor.number(expected)?);
                }
                match position.iter().find(|coordinate| !coordinate.is_finite()) {
                    None => Ok(position),
                    Some(wrong) => Err(ReadProblem::NotACoordinate(wrong.to_string())),
                }
            }
        }
    }

    /// Skips `count` numbers, of `bytes` each in binary files.
    pub(super) fn skip(&mut self, count: usize, bytes: usize) -> Result<(), ReadProblem> {
        match self {
            Self::Line(line) => {
                for _ in 0..count {
                    line.text()?;
                }
            }
            Self::Bytes { cursor, expected } => {
                cursor.take(count.saturating_mul(bytes), expected)?;
            }
        }
        Ok(())
    }

    /// States that no field is left on the line.
    pub(super) fn end(self) -> Result<(), ReadProblem> {
        match self {
            Self::Line(line) => line.end(),
            Self::Bytes { .. } => Ok(()),
        }
    }
}

/// A finite number.
fn coordinate_of(field: &str) -> Result<f64, ReadProblem> {
    field
        .parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
        .ok_or_else(|| ReadProblem::NotACoordinate(shortened(field)))
}

/// `count`, if it is at most `most`.
fn fitting(what: &'static str, count: u64, most: usize) -> Result<usize, ReadProblem> {
    let fitting = usize::try_from(count).ok().filter(|&count| count <= most);
    fitting.ok_or(ReadProblem::CountTooLarge { what, count })
}

/// The fields of a line.
#[derive(Debug, Clone)]
pub(super) struct LineFields<'a> {
    line: &'a str,
    rest: SplitAsciiWhitespace<'a>,
    /// Expected content of the line, for messages.
    expected: &'static str,
    /// Bytes of the file after the line.
    remaining: usize,
}

impl<'a> LineFields<'a> {
    pub(super) fn new(line: &'a str, expected: &'static str, remaining: usize) -> Self {
        Self {
            line,
            rest: line.split_ascii_whitespace(),
            expected,
            remaining,
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
            found: shortened(found),
        })
    }

    /// As [`Fields::count`].
    pub(super) fn count(
        &mut self,
        what: &'static str,
        least_bytes: usize,
    ) -> Result<usize, ReadProblem> {
        let count = self.number(what)?;
        fitting(what, count, self.remaining / least_bytes)
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
    use super::super::cursor::Encoding;
    use super::*;

    fn line<'a>(line: &'a str, expected: &'static str) -> LineFields<'a> {
        LineFields::new(line, expected, 0)
    }

    #[test]
    fn fields_state_what_is_missing_or_too_much() {
        let mut fields = line("3 x", "two numbers");
        assert_eq!(fields.number::<u64>("tag"), Ok(3));
        assert_eq!(
            fields.number::<u64>("tag").unwrap_err().to_string(),
            "tag: expected a whole number, found \"x\""
        );
        assert_eq!(
            fields.text().unwrap_err().to_string(),
            "expected two numbers, found 2 fields"
        );
        assert!(line("1", "nothing").end().is_err());
        assert!(coordinate_of("nan").is_err());
        assert!(coordinate_of("1e999").is_err());
    }

    #[test]
    fn numbers_as_bytes_have_the_width_of_their_type() {
        let mut bytes = Vec::new();
        bytes.extend((-2_i32).to_be_bytes());
        bytes.extend(7_u64.to_be_bytes());
        for x in [0.5, -1.0, f64::NAN] {
            bytes.extend(x.to_be_bytes());
        }
        bytes.extend((-2_i32).to_be_bytes());
        let mut cursor = Cursor::new(&bytes);
        cursor.encoding = Encoding::Big;
        let mut fields = Fields::Bytes {
            cursor: &mut cursor,
            expected: "numbers",
        };
        assert_eq!(fields.int("tag"), Ok(-2));
        assert_eq!(fields.size("tag"), Ok(7));
        let problem = fields.position().unwrap_err().to_string();
        assert_eq!(
            problem,
            "coordinate: expected a finite number, found \"NaN\""
        );
        assert!(fields.natural("tag").is_err());
        let cut = fields.int("tag").unwrap_err().to_string();
        assert_eq!(cut, "the file ends within numbers");
    }
}
