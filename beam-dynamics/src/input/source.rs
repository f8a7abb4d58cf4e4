//! The text of the input beside its tables: for lists of names, which the tables do
//! not hand out.

use shared_geom::document::{Document, Table};

/// What a list of names should be, in messages.
const NAMES: &str = "a list of names in quotes";

/// An input file: its tables and its text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    document: &'a Document,
    text: &'a str,
}

impl<'a> Source<'a> {
    /// `text` is what `document` was parsed from.
    pub fn new(document: &'a Document, text: &'a str) -> Self {
        Self { document, text }
    }

    /// The tables of the file.
    pub fn document(&self) -> &'a Document {
        self.document
    }

    /// The names listed under `key` of `table`; `None` without the key, and for
    /// anything but a list of texts, which is then noted.
    pub fn names(&self, table: &Table<'_>, key: &str) -> Option<Vec<String>> {
        if !table.has(key) {
            return None;
        }
        let names = self.value_of(table, key).and_then(listed);
        if names.is_none() {
            table.wrong(key, NAMES);
        }
        names
    }

    /// The text behind `key =`, from the line of the key on.
    fn value_of(&self, table: &Table<'_>, key: &str) -> Option<&'a str> {
        let line_starts = self.text.split_inclusive('\n');
        let before: usize = line_starts.take(table.line_of(key) - 1).map(str::len).sum();
        let rest = &self.text[before..];
        rest.match_indices(key).find_map(|(at, _)| {
            let behind = rest[at + key.len()..].trim_start_matches(['"', '\'']);
            Some(behind.trim_start().strip_prefix('=')?.trim_start())
        })
    }
}

/// The texts of the TOML array that `text` begins with.
fn listed(text: &str) -> Option<Vec<String>> {
    let mut rest = text.strip_prefix('[')?;
    let mut names = Vec::new();
    loop {
        rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
        rest = match rest.chars().next()? {
            ']' => return Some(names),
            '#' => rest.split_once('\n')?.1,
            '"' | '\'' => {
                let (token, behind) = rest.split_at(token_length(rest)?);
                names.push(unquoted(token)?);
                behind
            }
            _ => return None,
        };
    }
}

/// Bytes of the quoted text that `text` begins with, quotes included.
fn token_length(text: &str) -> Option<usize> {
    let quote = text.chars().next()?;
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = quote == '"',
            _ if c == quote => return Some(at + 1),
            _ => {}
        }
    }
    None
}

/// The text that a quoted token of TOML means.
fn unquoted(token: &str) -> Option<String> {
    let document = Document::parse(&format!("name = {token}"), "").ok()?;
    document.root().text("name")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names under `key` of the file's top table, or the problem.
    fn names(text: &str, key: &str) -> Result<Option<Vec<String>>, String> {
        let document = Document::parse(text, "a.toml").unwrap();
        let found = Source::new(&document, text).names(&document.root(), key);
        document
            .finish(Some(found))
            .map_err(|problems| problems.to_string())
    }

    fn some(names: &[&str]) -> Result<Option<Vec<String>>, String> {
        Ok(Some(names.iter().map(|&name| name.to_owned()).collect()))
    }

    #[test]
    fn lists_of_any_layout_are_read() {
        assert_eq!(names("a = [\"x\", 'y']\n", "a"), some(&["x", "y"]));
        assert_eq!(
            names("b = 1\na=[ # one\n  \"x]\",\n  \"q\\\"\",\n]\n", "a"),
            some(&["x]", "q\""])
        );
        assert_eq!(names("a = []\n", "a"), some(&[]));
        assert_eq!(names("\"a\" = ['']\n", "a"), some(&[""]));
        assert_eq!(names("b = []\n", "a"), Ok(None));
    }

    #[test]
    fn anything_else_is_told() {
        for text in [
            "a = 3",
            "a = \"x\"",
            "a = [1]",
            "a = [\"x\", [\"y\"]]",
            "a = [\"\"\"x\"\"\", 1]",
        ] {
            let shown = names(text, "a").unwrap_err();
            assert!(
                shown.contains("expected a list of names in quotes"),
                "{text}: {shown}"
            );
        }
    }
}
