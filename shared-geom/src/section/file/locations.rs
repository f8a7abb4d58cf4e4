//! Locations of the fields of a JSON text.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use crate::error::SourceLocation;

/// The outermost table of a text.
pub(super) const OUTERMOST: usize = 0;

/// The lines of all fields, and of the tables and lists in lists.
///
/// Tables, lists and fields have numbers; their content is found by the number and a
/// name, an element of a list by its index, counted from zero.
#[derive(Debug, Default)]
pub(super) struct FieldLocations {
    inside: BTreeMap<(usize, String), Spot>,
    /// Lines of fields that are given a second time.
    again: BTreeMap<(usize, String), usize>,
    count: usize,
}

/// Number and line of a field, table or list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Spot {
    pub number: usize,
    pub line: usize,
}

/// A table, or a list and the index of its element.
struct Open {
    number: usize,
    element: Option<usize>,
}

impl FieldLocations {
    /// Locations in a text that is JSON.
    pub fn of(text: &str) -> Self {
        let mut locations = Self::default();
        let mut open: Vec<Open> = Vec::new();
        let mut value_of = None;
        let (mut line, mut at) = (1, 0);
        let bytes = text.as_bytes();
        while let Some(byte) = bytes.get(at) {
            match byte {
                b'\n' => line += 1,
                b'"' => {
                    let end = end_of_string(bytes, at);
                    if let (true, Some(holder)) = (is_key(bytes, end), open.last()) {
                        let written = text.get(at..end).unwrap_or_default();
                        let name = serde_json::from_str(written).unwrap_or_default();
                        value_of = Some(locations.add(holder.number, name, line));
                    }
                    at = end - 1;
                }
                b'{' | b'[' => {
                    let number = match (value_of.take(), open.last()) {
                        (Some(number), _) => number,
                        (None, Some(list)) => {
                            let element = list.element.unwrap_or_default().to_string();
                            locations.add(list.number, element, line)
                        }
                        (None, None) => OUTERMOST,
                    };
                    let element = (*byte == b'[').then_some(0);
                    open.push(Open { number, element });
                }
                b'}' | b']' => drop(open.pop()),
                b',' => {
                    value_of = None;
                    if let Some(element) = open.last_mut().and_then(|list| list.element.as_mut()) {
                        *element += 1;
                    }
                }
                _ => {}
            }
            at += 1;
        }
        locations
    }

    fn add(&mut self, holder: usize, name: String, line: usize) -> usize {
        self.count += 1;
        let number = self.count;
        match self.inside.entry((holder, name)) {
            Entry::Vacant(free) => {
                free.insert(Spot { number, line });
            }
            Entry::Occupied(known) => {
                self.again.insert(known.key().clone(), line);
            }
        }
        number
    }

    /// The field under a name.
    pub fn inside(&self, holder: usize, name: &str) -> Option<Spot> {
        self.inside.get(&(holder, name.to_owned())).copied()
    }

    /// The line on which a field is repeated.
    pub fn again(&self, holder: usize, name: &str) -> Option<usize> {
        self.again.get(&(holder, name.to_owned())).copied()
    }

    /// The location of a field, `imposed.0.name`, or of its nearest existing holder.
    pub fn location(&self, path: &str, file: &str) -> SourceLocation {
        // these have one name only
        let path = match path {
            "history" => "provenance.history",
            "stiffness_per_kelvin" => "prestress.stiffness_per_kelvin",
            _ => path,
        };
        let mut location = SourceLocation::file(file);
        let mut holder = OUTERMOST;
        for name in path.split('.') {
            let Some(spot) = self.inside(holder, name) else {
                break;
            };
            location = SourceLocation::line(file, spot.line);
            holder = spot.number;
        }
        location
    }
}

/// The location of a field of `text`, as [`FieldLocations::location`].
pub(super) fn location_of(path: &str, text: &str, file: &str) -> SourceLocation {
    FieldLocations::of(text).location(path, file)
}

/// Index after the closing quote of the text that begins at `start`.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while let Some(byte) = bytes.get(at) {
        match byte {
            b'"' => return at + 1,
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Whether a text that ends before `end` names a field.
fn is_key(bytes: &[u8], end: usize) -> bool {
    let mut rest = bytes.iter().skip(end);
    rest.find(|byte| !byte.is_ascii_whitespace()) == Some(&b':')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_found_where_they_are() {
        let text =
            "{\n\"a\": {\"b \\\" }\": 1,\n \"c\"\n: [2,\n {\"d\": \"e\"}, [\n3]]},\n\"a\": 4}\n";
        let locations = FieldLocations::of(text);
        let line = |path: &str| locations.location(path, "x").line;
        assert_eq!(line("a"), Some(2));
        assert_eq!(line("a.b \" }"), Some(2));
        assert_eq!(line("a.c"), Some(3));
        assert_eq!(line("a.c.1"), Some(5));
        assert_eq!(line("a.c.1.d"), Some(5));
        assert_eq!(line("a.c.2"), Some(5));
        // an absent field has the location of its holder
        assert_eq!(line("a.c.1.f"), Some(5));
        assert_eq!(line("g"), None);
        assert_eq!(locations.again(OUTERMOST, "a"), Some(7));
    }

    /// Text that is no JSON has locations too, as far as it can be read.
    #[test]
    fn anything_can_be_looked_through() {
        for text in [
            "",
            "}",
            "\"",
            "\"\\",
            "[[[",
            "{\"a\":",
            "]{\"é\" :[,,{",
            ",:\"a\":",
        ] {
            let locations = FieldLocations::of(text);
            assert_eq!(locations.location("b", "x"), SourceLocation::file("x"));
        }
    }
}
