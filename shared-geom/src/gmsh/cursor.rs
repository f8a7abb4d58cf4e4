//! Reads the bytes of a file in order: its lines, and the numbers between them in binary
//! files.

use super::problem::ReadProblem;

/// Encoding of the numbers of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    /// As text, a line for each record.
    Text,
    /// As bytes, the least significant one first.
    Little,
    /// As bytes, the most significant one first.
    Big,
}

/// Position in a file: reads lines that are not blank, and bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    begin: usize,
    foreign: bool,
    pub(super) encoding: Encoding,
}

impl<'a> Cursor<'a> {
    /// The position before the first line of a text.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let mark = "\u{feff}".as_bytes();
        Self {
            bytes,
            at: if bytes.starts_with(mark) {
                mark.len()
            } else {
                0
            },
            line: 0,
            begin: 0,
            foreign: false,
            encoding: Encoding::Text,
        }
    }

    /// Whether numbers are written as bytes.
    pub(super) fn is_binary(&self) -> bool {
        self.encoding != Encoding::Text
    }

    /// Beginning of the last item read: in a text the line, from one; in a binary file the
    /// byte, from zero.
    pub(super) fn location(&self) -> usize {
        if self.is_binary() {
            self.begin
        } else {
            self.line
        }
    }

    /// Whether the last line read contains bytes that are no text.
    pub(super) fn is_foreign(&self) -> bool {
        self.foreign
    }

    /// Bytes after the last item read.
    pub(super) fn remaining(&self) -> usize {
        self.rest().len()
    }

    fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// Reads the next line that is not blank, without the blanks around it; of a line
    /// that is no text, only the valid beginning.
    pub(super) fn line(&mut self) -> Option<&'a str> {
        while self.at < self.bytes.len() {
            self.begin = self.at;
            let rest = self.rest();
            let length = rest.iter().position(|&byte| byte == b'\n');
            let line = &rest[..length.unwrap_or(rest.len())];
            self.at += length.map_or(rest.len(), |length| length + 1);
            self.line += 1;
            let text = std::str::from_utf8(line);
            self.foreign = text.is_err();
            let text = text.unwrap_or_else(|error| {
                std::str::from_utf8(&line[..error.valid_up_to()]).unwrap_or_default()
            });
            let text = text.trim();
            if self.foreign || !text.is_empty() {
                return Some(text);
            }
        }
        None
    }

    /// Reads the next line if it belongs to the content of a section: `None` before a
    /// line that begins with `$` and at the end of the file.
    pub(super) fn content(&mut self) -> Option<&'a str> {
        let mut ahead = *self;
        let line = ahead.line().filter(|line| !line.starts_with('$'))?;
        *self = ahead;
        Some(line)
    }

    /// Begins a record of numbers as bytes.
    pub(super) fn begin(&mut self) {
        self.begin = self.at;
    }

    /// Reads `count` bytes of `what`, a name for messages.
    pub(super) fn take(
        &mut self,
        count: usize,
        what: &'static str,
    ) -> Result<&'a [u8], ReadProblem> {
        let end = self.at.checked_add(count);
        let taken = end.and_then(|end| self.bytes.get(self.at..end));
        let taken = taken.ok_or(ReadProblem::CutOff(what))?;
        self.at += count;
        Ok(taken)
    }

    /// Reads the bytes of one number, ordered with the least significant one first.
    pub(super) fn number<const N: usize>(
        &mut self,
        what: &'static str,
    ) -> Result<[u8; N], ReadProblem> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.take(N, what)?);
        if self.encoding == Encoding::Big {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// Moves to the end of the next line, or rest of a line, that is `$End` and then the
    /// name of `section`; returns whether it exists.
    pub(super) fn pass_end(&mut self, section: &str) -> bool {
        let name = section.strip_prefix('$').unwrap_or(section);
        let end = format!("$End{name}");
        let mut from = self.at;
        while let Some(found) = position(&self.bytes[from..], end.as_bytes()) {
            from += found + end.len();
            if self.bytes.get(from).is_none_or(u8::is_ascii_whitespace) {
                self.at = from;
                return true;
            }
        }
        false
    }
}

/// Index of the first `part`, which begins with `$`, in `bytes`.
fn position(bytes: &[u8], part: &[u8]) -> Option<usize> {
    let mut from = 0;
    while let Some(found) = bytes[from..].iter().position(|&byte| byte == b'$') {
        from += found;
        if bytes[from..].starts_with(part) {
            return Some(from);
        }
        from += 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_trimmed_numbered_and_blank_ones_passed_over() {
        let mut cursor = Cursor::new("\u{feff}$A\r\n\r\n  1 2 \r\n$EndA".as_bytes());
        assert_eq!(cursor.content(), None);
        assert_eq!((cursor.line(), cursor.location()), (Some("$A"), 1));
        assert_eq!((cursor.content(), cursor.location()), (Some("1 2"), 3));
        assert_eq!((cursor.content(), cursor.location()), (None, 3));
        assert_eq!((cursor.line(), cursor.location()), (Some("$EndA"), 4));
        assert_eq!((cursor.line(), cursor.remaining()), (None, 0));
    }

    #[test]
    fn numbers_are_between_lines_in_either_order() {
        let mut cursor = Cursor::new(b"$A\n\x01\x02\x03\x04\n$EndAB\n$EndA\nx");
        for (encoding, expected) in [
            (Encoding::Little, 0x0403_0201),
            (Encoding::Big, 0x0102_0304),
        ] {
            cursor.encoding = encoding;
            let mut cursor = cursor;
            assert_eq!(cursor.line(), Some("$A"));
            cursor.begin();
            let found = cursor.number("number").map(i32::from_le_bytes);
            assert_eq!((found, cursor.location()), (Ok(expected), 3));
            // the end of another section does not belong to this one
            assert!(cursor.pass_end("$A"));
            assert_eq!((cursor.line(), cursor.location()), (Some("x"), 21));
            assert!(cursor.take(1, "number").is_err() && !cursor.pass_end("$A"));
        }
    }

    #[test]
    fn bytes_that_are_no_text_end_their_line() {
        let mut cursor = Cursor::new(b"1 \xff 2\n3");
        assert_eq!((cursor.line(), cursor.is_foreign()), (Some("1"), true));
        assert_eq!((cursor.line(), cursor.is_foreign()), (Some("3"), false));
    }
}
