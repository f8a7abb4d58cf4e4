//! The elements of an XML file in their order, with their lines: as much of XML as files of
//! VTK have, whose appended data may be bytes that are no text.

use crate::mesh_file::problem::FileProblem;

/// An element of XML: its beginning, or its end.
#[derive(Debug, Default)]
pub(super) struct Element {
    pub name: String,
    attributes: Vec<(String, String)>,
    /// Whether it is `</name>`.
    pub is_end: bool,
    /// Whether it is `<name/>`, which has no content and no end.
    pub is_empty: bool,
}

impl Element {
    /// The value of an attribute.
    pub fn get(&self, key: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(name, _)| name == key);
        found.map(|(_, value)| value.as_str())
    }
}

/// Where appended data begin, and whether they are bytes or base 64.
#[derive(Debug, Clone, Copy)]
pub(super) struct Appended<'a> {
    pub bytes: &'a [u8],
    pub is_raw: bool,
}

/// The elements of a file.
#[derive(Debug)]
pub(super) struct Elements<'a> {
    content: &'a [u8],
    position: usize,
    line: usize,
}

impl<'a> Elements<'a> {
    /// Starts at the first element.
    pub fn new(content: &'a [u8]) -> Self {
        Self {
            content,
            position: 0,
            line: 1,
        }
    }

    /// The line of the last element, from one.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The next element; `None` at the end of the file. Comments and declarations are
    /// skipped.
    pub fn next(&mut self) -> Result<Option<Element>, FileProblem> {
        loop {
            if self.to(b"<").is_none() {
                return Ok(None);
            }
            let skipped = match self.rest() {
                rest if rest.starts_with(b"!--") => Some(&b"-->"[..]),
                rest if rest.starts_with(b"?") => Some(&b"?>"[..]),
                rest if rest.starts_with(b"!") => Some(&b">"[..]),
                _ => None,
            };
            let Some(end) = skipped else {
                let tag = self.tag()?;
                return Ok(Some(element(tag)));
            };
            self.to(end)
                .ok_or(FileProblem::CutOff("the end of a comment"))?;
        }
    }

    /// The text up to the next element.
    pub fn text(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|&byte| byte == b'<');
        &rest[..end.unwrap_or(rest.len())]
    }

    /// The data after the underscore of `<AppendedData>`.
    pub fn appended(&mut self, is_raw: bool) -> Result<Option<Appended<'a>>, FileProblem> {
        self.to(b"_")
            .ok_or(FileProblem::CutOff("the \"_\" of the appended data"))?;
        let bytes = if is_raw { self.rest() } else { self.text() };
        Ok(Some(Appended { bytes, is_raw }))
    }

    fn rest(&self) -> &'a [u8] {
        self.content.get(self.position..).unwrap_or_default()
    }

    /// Moves behind the next `end`, and returns the bytes before it.
    fn to(&mut self, end: &[u8]) -> Option<&'a [u8]> {
        let rest = self.rest();
        let at = rest.windows(end.len()).position(|window| window == end)?;
        let before = &rest[..at];
        self.line += before.iter().filter(|&&byte| byte == b'\n').count();
        self.position += at + end.len();
        Some(before)
    }

    /// The text of a tag, up to the `>` that is not in quotes.
    fn tag(&mut self) -> Result<&'a [u8], FileProblem> {
        let rest = self.rest();
        let mut quote = None;
        for (at, &byte) in rest.iter().enumerate() {
            match (quote, byte) {
                (None, b'>') => {
                    let tag = &rest[..at];
                    self.position += at + 1;
                    self.line += tag.iter().filter(|&&byte| byte == b'\n').count();
                    return Ok(tag);
                }
                (None, b'"' | b'\'') => quote = Some(byte),
                (Some(open), byte) if open == byte => quote = None,
                _ => {}
            }
        }
        Err(FileProblem::CutOff("the \">\" of an element"))
    }
}

/// The element of a tag without its `<` and `>`.
fn element(tag: &[u8]) -> Element {
    let text = String::from_utf8_lossy(tag);
    let text = text.trim();
    let (is_end, text) = match text.strip_prefix('/') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (is_empty, text) = match text.strip_suffix('/') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (name, mut rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let mut attributes = Vec::new();
    while let Some((key, after)) = rest.split_once('=') {
        let after = after.trim_start();
        let Some(quote) = after.chars().next().filter(|c| "\"'".contains(*c)) else {
            break;
        };
        let Some((value, after)) = after[1..].split_once(quote) else {
            break;
        };
        attributes.push((key.trim().to_owned(), plain(value)));
        rest = after;
    }
    Element {
        name: name.to_owned(),
        attributes,
        is_end,
        is_empty,
    }
}

/// A value with its entities as letters.
fn plain(value: &str) -> String {
    const ENTITIES: [(&str, &str); 5] = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&apos;", "'"),
        ("&amp;", "&"),
    ];
    let start = value.to_owned();
    ENTITIES
        .iter()
        .fold(start, |text, (entity, letter)| text.replace(entity, letter))
}
