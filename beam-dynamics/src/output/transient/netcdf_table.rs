//! The table of a run in binary, read back: NetCDF-3 with numbers of eight bytes.
//!
//! ```text
//! "CDF" version records  dimensions  attributes  variables  data
//! list       = 0 0 | tag count {item}
//! dimension  = name length             the length of the one that grows is 0
//! attribute  = name type count values
//! variable   = name count {dimension} attributes type size begin
//! name       = count letters           values and letters padded to four bytes
//! ```
//!
//! This is a separate reader: the library allocates the memory that the counts of the header state,
//! so that a file of 16 bytes can abort the program. This reader allocates no more than the size of
//! the file.
//!
//! # References
//! - Unidata, "NetCDF file format specifications": classic and 64-bit offset formats.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::Heading;

/// Tags of the lists.
const DIMENSIONS: usize = 10;
const VARIABLES: usize = 11;
const ATTRIBUTES: usize = 12;
/// Bytes of a number of each type, from 1; letters are of type 2.
const SIZES: [usize; 6] = [1, 1, 2, 4, 4, 8];
const LETTERS: usize = 2;
const REAL: usize = 6;
/// The number of records that marks an unknown number.
const UNKNOWN: usize = u32::MAX as usize;
/// Number of bytes that are searched for the title of a file.
const HEAD: u64 = 1 << 16;

/// Headings and numbers of a file, and its title.
#[derive(Debug)]
pub(super) struct Content {
    /// The attribute `title` of the file; empty if there is none.
    pub title: String,
    pub headings: Vec<Heading>,
    pub columns: Vec<Vec<f64>>,
}

/// Bytes that are read from the front.
#[derive(Clone, Copy)]
struct Cursor<'a> {
    rest: &'a [u8],
    /// Whether offsets have eight bytes.
    is_wide: bool,
}

/// A variable of the header.
struct Variable {
    heading: Heading,
    /// Numbers per record, or in all.
    chunk: usize,
    /// Whether there is a chunk in every record.
    is_recorded: bool,
    begin: usize,
}

/// Attributes of text with their names.
type Attributes = Vec<(String, String)>;

impl<'a> Cursor<'a> {
    /// The position after the first eight bytes, and the number of records stated there.
    fn open(bytes: &'a [u8]) -> Option<(Self, usize)> {
        let (&version, rest) = bytes.strip_prefix(b"CDF")?.split_first()?;
        let is_wide = version == 2;
        let mut cursor = Self { rest, is_wide };
        let records = cursor.whole()?;
        (1..=2).contains(&version).then_some((cursor, records))
    }

    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    fn whole(&mut self) -> Option<usize> {
        let bytes = self.take(4)?.first_chunk()?;
        usize::try_from(u32::from_be_bytes(*bytes)).ok()
    }

    fn offset(&mut self) -> Option<usize> {
        if self.is_wide {
            usize::try_from(u64::from_be_bytes(*self.take(8)?.first_chunk()?)).ok()
        } else {
            self.whole()
        }
    }

    /// Bytes, padded to a multiple of four.
    fn padded(&mut self, count: usize) -> Option<&'a [u8]> {
        let bytes = self.take(count)?;
        self.take(count.next_multiple_of(4) - count)?;
        Some(bytes)
    }

    fn name(&mut self) -> Option<String> {
        let count = self.whole()?;
        String::from_utf8(self.padded(count)?.to_vec()).ok()
    }

    /// A list; each item takes bytes, so that the number of items is limited by the file.
    fn list<T>(
        &mut self,
        tag: usize,
        mut item: impl FnMut(&mut Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let (found, count) = (self.whole()?, self.whole()?);
        match found {
            0 if count == 0 => Some(Vec::new()),
            found if found == tag => (0..count).map(|_| item(self)).collect(),
            _ => None,
        }
    }

    fn dimension(&mut self) -> Option<usize> {
        self.name()?;
        self.whole()
    }

    fn attributes(&mut self) -> Option<Attributes> {
        let all = self.list(ATTRIBUTES, |cursor| {
            let (name, kind, count) = (cursor.name()?, cursor.whole()?, cursor.whole()?);
            let size = SIZES.get(kind.checked_sub(1)?)?;
            let bytes = cursor.padded(count.checked_mul(*size)?)?;
            let text = String::from_utf8(bytes.to_vec()).ok();
            Some((name, text.filter(|_| kind == LETTERS)))
        })?;
        let texts = all.into_iter();
        Some(
            texts
                .filter_map(|(name, text)| Some((name, text?)))
                .collect(),
        )
    }

    /// A variable of numbers of eight bytes.
    fn variable(&mut self, dimensions: &[usize]) -> Option<Variable> {
        let name = self.name()?;
        let count = self.whole()?;
        let lengths: Option<Vec<_>> = (0..count)
            .map(|_| dimensions.get(self.whole()?).copied())
            .collect();
        let lengths = lengths?;
        let is_recorded = lengths.first() == Some(&0);
        let own = &lengths[usize::from(is_recorded)..];
        let chunk = own
            .iter()
            .try_fold(1, |all: usize, &one| all.checked_mul(one))?;
        let attributes = self.attributes()?;
        let kind = self.whole()?;
        self.whole()?;
        let begin = self.offset()?;
        (kind == REAL).then(|| Variable {
            heading: Heading {
                unit: of(&attributes, "units"),
                words: of(&attributes, "long_name"),
                name,
            },
            chunk,
            is_recorded,
            begin,
        })
    }
}

/// The attribute of a name, empty if there is none.
fn of(attributes: &Attributes, name: &str) -> String {
    let found = attributes.iter().find(|own| own.0 == name);
    found.map(|own| own.1.clone()).unwrap_or_default()
}

impl Content {
    /// Reads a whole file; `None` if it is of another kind, or shorter than its header states.
    pub fn parse(bytes: &[u8]) -> Option<Self> {
        let (mut cursor, records) = Cursor::open(bytes)?;
        let dimensions = cursor.list(DIMENSIONS, Cursor::dimension)?;
        let title = of(&cursor.attributes()?, "title");
        let variables = cursor.list(VARIABLES, |cursor| cursor.variable(&dimensions))?;
        let recorded = variables.iter().filter(|variable| variable.is_recorded);
        let sizes = recorded
            .clone()
            .map(|variable| variable.chunk.checked_mul(8));
        let record = sizes
            .into_iter()
            .try_fold(0, |all: usize, one| all.checked_add(one?))?;
        let records = match recorded.map(|variable| variable.begin).min() {
            Some(first) if records == UNKNOWN => {
                bytes.len().checked_sub(first)?.checked_div(record)?
            }
            _ => records,
        };
        // Overlapping data would exceed the file.
        let mut left = bytes.len();
        let columns = variables.iter().map(|variable| {
            let count = if variable.is_recorded { records } else { 1 };
            let size = variable.chunk.checked_mul(8)?;
            left = left.checked_sub(size.checked_mul(count)?)?;
            let chunk = |number: usize| {
                let begin = variable.begin.checked_add(number.checked_mul(record)?)?;
                bytes.get(begin..begin.checked_add(size)?)
            };
            let chunks: Option<Vec<_>> =
                (0..if size == 0 { 0 } else { count }).map(chunk).collect();
            Some(numbers(&chunks?))
        });
        let columns: Option<_> = columns.collect();
        Some(Self {
            title,
            columns: columns?,
            headings: variables
                .into_iter()
                .map(|variable| variable.heading)
                .collect(),
        })
    }
}

fn numbers(chunks: &[&[u8]]) -> Vec<f64> {
    let (numbers, _): (Vec<&[[u8; 8]]>, Vec<_>) =
        chunks.iter().map(|chunk| chunk.as_chunks()).unzip();
    let all = numbers.into_iter().flatten();
    all.map(|bytes| f64::from_be_bytes(*bytes)).collect()
}

/// The title of the file at `path`; `None` if it has none.
pub(super) fn title(path: &Path) -> Option<String> {
    let mut bytes = Vec::new();
    let file = File::open(path).ok()?;
    file.take(HEAD).read_to_end(&mut bytes).ok()?;
    let (mut cursor, _) = Cursor::open(&bytes)?;
    cursor.list(DIMENSIONS, Cursor::dimension)?;
    let title = of(&cursor.attributes()?, "title");
    (!title.is_empty()).then_some(title)
}
