//! The format of a file: version and encoding.

use super::cursor::{Cursor, Encoding};
use super::fields::LineFields;
use super::problem::ReadProblem;
use crate::error::shortened;

/// A version of the format that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    V22,
    V41,
}

/// Reads the format of a file and goes back to its beginning; the cursor then has its
/// encoding, unless there is a problem at the cursor.
pub(super) fn format(cursor: &mut Cursor) -> Result<Version, ReadProblem> {
    let start = *cursor;
    if cursor.remaining() == 0 {
        return Err(ReadProblem::Empty);
    }
    while let Some(line) = cursor.line() {
        if line == "$MeshFormat" {
            let (version, encoding) = read_format(cursor)?;
            *cursor = start;
            cursor.encoding = encoding;
            return Ok(version);
        }
    }
    Err(ReadProblem::NotGmsh)
}

/// Reads `4.1 0 8`: version, file type (0 ascii, 1 binary), bytes of a number; in binary
/// files the integer one follows, which shows the order of its bytes.
fn read_format(cursor: &mut Cursor) -> Result<(Version, Encoding), ReadProblem> {
    let line = cursor.content().unwrap_or("");
    let mut fields = LineFields::new(
        line,
        "version, file type and number size, as \"4.1 0 8\"",
        0,
    );
    let version = fields.text()?;
    let file_type = fields.text()?;
    let size: u32 = fields.number("number size")?;
    fields.end()?;
    let encoding = match file_type {
        "0" => Encoding::Text,
        "1" => byte_order(cursor)?,
        _ => return Err(ReadProblem::FileType(shortened(file_type))),
    };
    if size != 8 {
        return Err(ReadProblem::NumberSize(size));
    }
    match version {
        "2.2" => Ok((Version::V22, encoding)),
        "4.1" => Ok((Version::V41, encoding)),
        _ => Err(ReadProblem::Version(shortened(version))),
    }
}

fn byte_order(cursor: &mut Cursor) -> Result<Encoding, ReadProblem> {
    let mut one = [0; 4];
    one.copy_from_slice(cursor.take(4, "the number that shows the order of bytes")?);
    match (i32::from_le_bytes(one), i32::from_be_bytes(one)) {
        (1, _) => Ok(Encoding::Little),
        (_, 1) => Ok(Encoding::Big),
        (other, _) => Err(ReadProblem::ByteOrder(other)),
    }
}

/// The line of a text whose bytes are no text: names in another encoding.
pub(super) fn not_text(bytes: &[u8], cursor: Cursor) -> Option<usize> {
    if cursor.is_binary() {
        return None;
    }
    let before = std::str::from_utf8(bytes).err()?.valid_up_to();
    Some(1 + bytes[..before].iter().filter(|&&b| b == b'\n').count())
}
