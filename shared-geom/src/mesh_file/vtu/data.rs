//! Arrays of an XML file of VTK as numbers.
//!
//! ```text
//! binary:      number of bytes, bytes
//! compressed:  blocks, size of a block, size of the last, compressed sizes ..., blocks
//! ```
//!
//! The header has numbers of 4 or 8 bytes; as base 64, header and bytes may be encoded
//! together or one after the other.

use std::io::Read;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::bufread::ZlibDecoder;

use super::xml::Appended;
use crate::mesh_file::problem::FileProblem;
use crate::mesh_file::words::real;

/// Where the values of an array are.
#[derive(Debug)]
pub(super) enum Content<'a> {
    /// Numbers as text.
    Text(&'a [u8]),
    /// Bytes as base 64.
    Base64(&'a [u8]),
    /// In the appended data, from this byte or letter on.
    Appended(usize),
}

/// An array that is not decoded.
#[derive(Debug)]
pub(super) struct Encoded<'a> {
    pub line: usize,
    /// The type of its numbers, as `Float64`.
    pub kind: String,
    pub content: Content<'a>,
}

impl Encoded<'_> {
    /// Its position in the appended data.
    pub fn offset(&self) -> Option<usize> {
        match self.content {
            Content::Appended(offset) => Some(offset),
            _ => None,
        }
    }
}

/// How all arrays of a file are encoded.
#[derive(Debug, Default)]
pub(super) struct Encoding<'a> {
    pub is_big_endian: bool,
    /// Whether numbers of headers have 8 bytes, not 4.
    pub is_wide: bool,
    pub is_compressed: bool,
    pub appended: Option<Appended<'a>>,
}

impl Encoding<'_> {
    /// The values of `array`; `offsets` are the positions of all arrays in the appended
    /// data, of which the next one ends it.
    pub fn values(
        &self,
        array: &Encoded<'_>,
        offsets: impl Iterator<Item = usize>,
    ) -> Result<Vec<f64>, FileProblem> {
        let bytes = match array.content {
            Content::Text(text) => return numbers(text),
            Content::Base64(text) => self.unpacked(&decoded(text)?)?,
            Content::Appended(offset) => {
                let missing = FileProblem::CutOff("the appended data of an array");
                let appended = self.appended.as_ref().ok_or(missing.clone())?;
                let end = offsets.filter(|other| *other > offset).min();
                let end = end.unwrap_or(appended.bytes.len());
                let part = appended.bytes.get(offset..end).ok_or(missing)?;
                if appended.is_raw {
                    self.unpacked(part)?
                } else {
                    self.unpacked(&decoded(part)?)?
                }
            }
        };
        self.of_bytes(&bytes, &array.kind)
    }

    /// The bytes of an array after its header, uncompressed.
    fn unpacked(&self, bytes: &[u8]) -> Result<Vec<u8>, FileProblem> {
        let (count, mut rest) = self.number(bytes)?;
        let cut = || FileProblem::CutOff("the end of an array");
        if !self.is_compressed {
            return Ok(rest.get(..count).ok_or_else(cut)?.to_vec());
        }
        if count == 0 {
            return Ok(Vec::new());
        }
        let (size, after) = self.number(rest)?;
        let (last, after) = self.number(after)?;
        rest = after;
        // each block has a number in the header
        let mut sizes = Vec::new();
        for _ in 0..count {
            let (packed, after) = self.number(rest)?;
            sizes.push(packed);
            rest = after;
        }
        let mut unpacked = Vec::new();
        for (index, packed) in sizes.into_iter().enumerate() {
            let (block, after) = rest.split_at_checked(packed).ok_or_else(cut)?;
            rest = after;
            let is_last = index + 1 == count;
            let size = if is_last && last > 0 { last } else { size };
            let before = unpacked.len();
            let read = ZlibDecoder::new(block)
                .take(size as u64)
                .read_to_end(&mut unpacked);
            if read.is_err() || unpacked.len() - before != size {
                return Err(FileProblem::Header {
                    found: format!("block {} of an array cannot be uncompressed", index + 1),
                    expected: "zlib",
                });
            }
        }
        Ok(unpacked)
    }

    /// The first number of a header, and the bytes after it.
    fn number<'b>(&self, bytes: &'b [u8]) -> Result<(usize, &'b [u8]), FileProblem> {
        let width = if self.is_wide { 8 } else { 4 };
        let (number, rest) = bytes
            .split_at_checked(width)
            .ok_or(FileProblem::CutOff("the size of an array"))?;
        let add = |sum: u64, byte: &u8| (sum << 8) | u64::from(*byte);
        let number = if self.is_big_endian {
            number.iter().fold(0, add)
        } else {
            number.iter().rev().fold(0, add)
        };
        Ok((usize::try_from(number).unwrap_or(usize::MAX), rest))
    }

    /// The numbers of `kind` in `bytes`.
    fn of_bytes(&self, bytes: &[u8], kind: &str) -> Result<Vec<f64>, FileProblem> {
        match kind {
            "Int8" => self.each(bytes, |b| f64::from(i8::from_le_bytes(b))),
            "UInt8" => self.each(bytes, |[b]| f64::from(b)),
            "Int16" => self.each(bytes, |b| f64::from(i16::from_le_bytes(b))),
            "UInt16" => self.each(bytes, |b| f64::from(u16::from_le_bytes(b))),
            "Int32" => self.each(bytes, |b| f64::from(i32::from_le_bytes(b))),
            "UInt32" => self.each(bytes, |b| f64::from(u32::from_le_bytes(b))),
            "Int64" => self.each(bytes, |b| i64::from_le_bytes(b) as f64),
            "UInt64" => self.each(bytes, |b| u64::from_le_bytes(b) as f64),
            "Float32" => self.each(bytes, |b| f64::from(f32::from_le_bytes(b))),
            "Float64" => self.each(bytes, f64::from_le_bytes),
            other => Err(FileProblem::Header {
                found: format!("an array of the type \"{other}\""),
                expected: "Int8 to UInt64, Float32 or Float64",
            }),
        }
    }

    /// The numbers of `N` bytes each, which `number` makes of bytes with the lowest first.
    fn each<const N: usize>(
        &self,
        bytes: &[u8],
        number: impl Fn([u8; N]) -> f64,
    ) -> Result<Vec<f64>, FileProblem> {
        let parts = bytes.chunks_exact(N);
        if !parts.remainder().is_empty() {
            return Err(FileProblem::CutOff("the last number of an array"));
        }
        let values = parts.filter_map(|part| {
            let mut bytes: [u8; N] = part.try_into().ok()?;
            if self.is_big_endian {
                bytes.reverse();
            }
            Some(number(bytes))
        });
        Ok(values.collect())
    }
}

/// Numbers as text.
fn numbers(text: &[u8]) -> Result<Vec<f64>, FileProblem> {
    let text = std::str::from_utf8(text).map_err(|_| FileProblem::NotText)?;
    let words = text.split_whitespace();
    words
        .map(|word| match word.to_ascii_lowercase().as_str() {
            "nan" | "-nan" => Ok(f64::NAN),
            "inf" | "+inf" => Ok(f64::INFINITY),
            "-inf" => Ok(f64::NEG_INFINITY),
            _ => real(word, "a value"),
        })
        .collect()
}

/// The bytes of texts of base 64, one after the other: each ends with its padding.
fn decoded(text: &[u8]) -> Result<Vec<u8>, FileProblem> {
    let letters = text.iter().copied();
    let letters: Vec<u8> = letters.filter(|byte| !byte.is_ascii_whitespace()).collect();
    let mut bytes = Vec::with_capacity(letters.len() / 4 * 3);
    let mut rest = &letters[..];
    while !rest.is_empty() {
        let padding = rest.iter().position(|&letter| letter == b'=');
        let end = padding.map_or(rest.len(), |at| (at / 4 + 1) * 4);
        let (part, after) = rest.split_at(end.min(rest.len()));
        STANDARD
            .decode_vec(part, &mut bytes)
            .map_err(|error| FileProblem::Header {
                found: format!("the base 64 of an array has an error: {error}"),
                expected: "letters of base 64",
            })?;
        rest = after;
    }
    Ok(bytes)
}
