//! Cards that a program adds to a document, and their text.
//!
//! A card that expands to others is read first; the cards to which it expands are appended, with
//! its line, so that problems of them are reported there. The same cards can be written as text.

use std::fmt::{Display, Formatter, Result as Shown};

use super::tree::{Entry, Kind, Value};
use super::{Document, DocumentProblem, Item, Table};

/// The value of a key of a [`Card`].
#[derive(Debug, Clone)]
pub struct Content(Value);

impl Content {
    fn new(kind: Kind) -> Self {
        // The line of the card replaces zero.
        Self(Value { line: 0, kind })
    }

    /// A number with its unit.
    pub fn quantity(number: f64, unit: &str) -> Self {
        Self::new(Kind::Text(format!("{number} {unit}")))
    }

    /// A list.
    pub fn list(items: impl IntoIterator<Item = Self>) -> Self {
        Self::new(Kind::Array(items.into_iter().map(|item| item.0).collect()))
    }

    /// A list of numbers with their unit.
    pub fn quantities(numbers: impl IntoIterator<Item = f64>, unit: &str) -> Self {
        let numbers = numbers.into_iter();
        Self::list(numbers.map(|number| Self::quantity(number, unit)))
    }

    /// A list of plain numbers.
    pub fn numbers(numbers: impl IntoIterator<Item = f64>) -> Self {
        Self::list(numbers.into_iter().map(Self::from))
    }

    /// A list of texts.
    pub fn texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> Self {
        Self::list(texts.into_iter().map(Self::from))
    }

    /// A table in braces.
    pub fn table<'a>(entries: impl IntoIterator<Item = (&'a str, Self)>) -> Self {
        let entries = entries.into_iter();
        Self::new(Kind::Table(
            entries.map(|(key, value)| entry(key, value)).collect(),
        ))
    }

    /// The value, whose problems are reported at `line` and not at the line of its card; parts
    /// with a line keep it.
    pub fn on_line(mut self, line: usize) -> Self {
        set_line(&mut self.0, line);
        self
    }

    /// A table with a further key; other values are unchanged.
    pub fn with(mut self, key: &str, content: impl Into<Self>) -> Self {
        if let Kind::Table(entries) = &mut self.0.kind {
            entries.push(entry(key, content.into()));
        }
        self
    }
}

fn entry(key: &str, content: Content) -> Entry {
    Entry {
        key: key.to_owned(),
        line: content.0.line,
        value: content.0,
    }
}

impl From<&str> for Content {
    fn from(text: &str) -> Self {
        Self::new(Kind::Text(text.to_owned()))
    }
}

impl From<String> for Content {
    fn from(text: String) -> Self {
        Self::new(Kind::Text(text))
    }
}

impl From<f64> for Content {
    fn from(number: f64) -> Self {
        Self::new(Kind::Number(number))
    }
}

impl From<usize> for Content {
    fn from(number: usize) -> Self {
        Self::new(i64::try_from(number).map_or(Kind::Number(number as f64), Kind::Integer))
    }
}

impl From<bool> for Content {
    fn from(flag: bool) -> Self {
        Self::new(Kind::Boolean(flag))
    }
}

/// A table of a document that a program writes.
#[derive(Debug, Clone)]
pub struct Card {
    /// Its keys from the root.
    path: Vec<String>,
    /// Whether it is one of a list of tables.
    is_listed: bool,
    line: usize,
    entries: Vec<Entry>,
}

impl Card {
    /// A table of the list `[[kind]]`, whose problems are reported at `line`.
    pub fn listed(kind: &str, line: usize) -> Self {
        Self::at([kind], true, line)
    }

    /// The table with these keys from the root, `[a.b]`, whose problems are reported at `line`.
    pub fn single<'a>(path: impl IntoIterator<Item = &'a str>, line: usize) -> Self {
        Self::at(path, false, line)
    }

    fn at<'a>(path: impl IntoIterator<Item = &'a str>, is_listed: bool, line: usize) -> Self {
        Self {
            path: path.into_iter().map(str::to_owned).collect(),
            is_listed,
            line,
            entries: Vec::new(),
        }
    }

    /// The card with a further key.
    pub fn with(mut self, key: &str, content: impl Into<Content>) -> Self {
        self.entries.push(entry(key, content.into()));
        self
    }

    /// The card with a further key if there is a value for it.
    pub fn with_some(self, key: &str, content: Option<impl Into<Content>>) -> Self {
        match content {
            Some(content) => self.with(key, content),
            None => self,
        }
    }

    /// The card with further keys.
    pub fn with_all(mut self, contents: impl IntoIterator<Item = (String, Content)>) -> Self {
        let contents = contents.into_iter();
        self.entries
            .extend(contents.map(|(key, content)| entry(&key, content)));
        self
    }

    /// The card with further keys.
    pub(super) fn with_entries(mut self, entries: &[Entry]) -> Self {
        self.entries.extend_from_slice(entries);
        self
    }

    fn value(&self) -> Value {
        let mut value = Value {
            line: self.line,
            kind: Kind::Table(self.entries.clone()),
        };
        set_line(&mut value, self.line);
        value
    }
}

/// Gives a value and all in it the line, unless they have one.
fn set_line(value: &mut Value, line: usize) {
    let own = |found: &mut usize| {
        if *found == 0 {
            *found = line;
        }
    };
    own(&mut value.line);
    match &mut value.kind {
        Kind::Array(items) => items.iter_mut().for_each(|item| set_line(item, line)),
        Kind::Table(entries) => {
            for entry in entries {
                own(&mut entry.line);
                set_line(&mut entry.value, line);
            }
        }
        _ => {}
    }
}

/// The card in TOML.
impl Display for Card {
    fn fmt(&self, f: &mut Formatter<'_>) -> Shown {
        let path: Vec<_> = self.path.iter().map(|key| key_text(key)).collect();
        if self.is_listed {
            writeln!(f, "[[{}]]", path.join("."))?
        } else {
            writeln!(f, "[{}]", path.join("."))?
        }
        for entry in &self.entries {
            writeln!(f, "{} = {}", key_text(&entry.key), text(&entry.value))?;
        }
        Ok(())
    }
}

pub(super) fn key_text(key: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
    if !key.is_empty() && key.chars().all(is_bare) {
        key.to_owned()
    } else {
        basic_string(key)
    }
}

/// A text as TOML writes it: a basic string.
pub fn basic_string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            _ if letter.is_control() => quoted += &format!("\\u{:04X}", u32::from(letter)),
            _ => quoted.push(letter),
        }
    }
    quoted + "\""
}

pub(super) fn text(value: &Value) -> String {
    match &value.kind {
        Kind::Text(text) => basic_string(text),
        Kind::Integer(number) => number.to_string(),
        Kind::Number(number) if number.is_nan() => "nan".to_owned(),
        // The shortest digits that are read as the same number.
        Kind::Number(number) => format!("{number:?}"),
        Kind::Boolean(flag) => flag.to_string(),
        // No key has a date: the reader of the card reports it.
        Kind::Date => basic_string("a date"),
        Kind::Array(items) => {
            let items: Vec<_> = items.iter().map(text).collect();
            format!("[{}]", items.join(", "))
        }
        Kind::Table(entries) => {
            let entries = entries.iter();
            let entries =
                entries.map(|one| format!("{} = {}", key_text(&one.key), text(&one.value)));
            format!("{{ {} }}", entries.collect::<Vec<_>>().join(", "))
        }
    }
}

impl Table<'_> {
    /// The value under `key` as in the file, for a card. The key is then known.
    pub fn copied(&self, key: impl AsRef<str>) -> Option<Content> {
        self.look_up(key.as_ref()).cloned().map(Content)
    }
}

impl Item<'_> {
    /// The value as in the file, for a card.
    pub fn copied(&self) -> Content {
        Content(self.value().clone())
    }

    /// Whether it is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.value().kind, Kind::Table(_))
    }
}

impl Document {
    /// Appends cards: to the other tables of their lists, or as new tables. A table that the
    /// document has already is noted.
    pub fn append<'a>(&mut self, cards: impl IntoIterator<Item = &'a Card>) {
        for card in cards {
            if !put(&mut self.root, &card.path, card) {
                let key = card.path.join(".");
                let location = self.file().to_owned();
                self.note(card.line, &DocumentProblem::DoubledKey { key, location });
            }
        }
    }

    /// The text of the file with other text in place of each table `[[kind]]`: number k is
    /// replaced by number k of `texts`. `None` if a table is in an included file, written as a
    /// value of the key, or has a part behind another table.
    pub fn replaced(&self, source: &str, kind: &str, texts: &[String]) -> Option<String> {
        let mut lines: Vec<_> = source.lines().map(str::to_owned).collect();
        let (cards, others): (Vec<_>, Vec<_>) = self.root.iter().partition(|one| one.key == kind);
        let Some(Kind::Array(cards)) = cards.first().map(|entry| &entry.value.kind) else {
            return Some(source.to_owned());
        };
        let mut starts: Vec<_> = cards.iter().map(|card| card.line).collect();
        let last_line = |card: &Value| {
            let mut lines = Vec::new();
            lines_of_value(card, &mut lines);
            lines.into_iter().max().unwrap_or(0)
        };
        let ends: Vec<_> = cards.iter().map(last_line).collect();
        let cards = starts.len().min(texts.len());
        others
            .into_iter()
            .for_each(|entry| lines_of(entry, &mut starts));
        for number in (0..cards).rev() {
            let start = starts[number];
            let head = lines.get(start.checked_sub(1)?)?;
            if !head.trim_start().starts_with("[[") {
                return None;
            }
            let after = starts.iter().filter(|line| **line > start).min();
            if after.is_some_and(|line| ends[number] >= *line) {
                return None;
            }
            let mut end = after.map_or(lines.len(), |line| (line - 1).min(lines.len()));
            // Comments above the next table are of that table.
            let is_comment =
                |line: &str| line.trim().is_empty() || line.trim_start().starts_with('#');
            while after.is_some() && end > start && is_comment(&lines[end - 1]) {
                end -= 1;
            }
            lines.splice(start - 1..end, texts[number].lines().map(str::to_owned));
        }
        Some(lines.join("\n") + "\n")
    }
}

/// The lines of a key and of all in it.
fn lines_of(entry: &Entry, lines: &mut Vec<usize>) {
    lines.push(entry.line);
    lines_of_value(&entry.value, lines);
}

fn lines_of_value(value: &Value, lines: &mut Vec<usize>) {
    lines.push(value.line);
    match &value.kind {
        Kind::Array(items) => items.iter().for_each(|item| lines_of_value(item, lines)),
        Kind::Table(entries) => entries.iter().for_each(|entry| lines_of(entry, lines)),
        _ => {}
    }
}

/// Puts a card at its path; `false` if there is another value.
fn put(entries: &mut Vec<Entry>, path: &[String], card: &Card) -> bool {
    let [first, inner @ ..] = path else {
        return false;
    };
    let found = entries.iter_mut().find(|entry| entry.key == *first);
    match (found.map(|entry| &mut entry.value.kind), inner) {
        (Some(Kind::Array(items)), []) if card.is_listed => items.push(card.value()),
        (Some(Kind::Table(entries)), [_, ..]) => return put(entries, inner, card),
        (Some(_), _) => return false,
        (None, _) => {
            let (line, is_last) = (card.line, inner.is_empty());
            let mut kind = match (is_last, card.is_listed) {
                (true, true) => Kind::Array(vec![card.value()]),
                (true, false) => card.value().kind,
                (false, _) => Kind::Table(Vec::new()),
            };
            if let (Kind::Table(entries), false) = (&mut kind, is_last) {
                put(entries, inner, card);
            }
            entries.push(Entry {
                key: first.clone(),
                line,
                value: Value { line, kind },
            });
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Dimension;

    fn card() -> Card {
        Card::listed("node", 2)
            .with("name", "a \"b\"")
            .with("position", Content::quantities([0.1, -2e-7, 3.0], "m"))
            .with_some("flag", Some(true))
            .with(
                "law",
                Content::table([("k", 0.1.into()), ("n", 2_usize.into())]).with("m", 1e30),
            )
    }

    // The text of a card is read as the same values as the card itself.
    #[test]
    fn a_card_and_its_text_are_equal() {
        let mut one = Document::parse("x = 1\n\n", "a.toml").unwrap();
        one.append([
            &card(),
            &Card::single(["sensors", "b c"], 2).with("d", Content::texts(["e"])),
        ]);
        let text = format!(
            "{}{}",
            card(),
            Card::single(["sensors", "b c"], 2).with("d", Content::texts(["e"]))
        );
        let other = Document::parse(&text, "a.toml").unwrap();
        for document in [&one, &other] {
            let root = document.root();
            let nodes = root.tables("node");
            assert_eq!(nodes[0].text("name").as_deref(), Some("a \"b\""));
            let found = nodes[0].vector("position", Dimension::LENGTH).unwrap();
            assert_eq!(found.as_slice(), [0.1, -2e-7, 3.0]);
            let law = nodes[0].table("law").unwrap();
            assert_eq!(law.quantity("k", Dimension::NUMBER), Some(0.1));
            assert_eq!(
                (law.count("n"), law.quantity("m", Dimension::NUMBER)),
                (Some(2), Some(1e30))
            );
            let sensors = root.named_tables("sensors");
            assert_eq!(
                (sensors[0].0.as_str(), sensors[0].1.texts("d")),
                ("b c", Some(vec!["e".to_owned()]))
            );
        }
        assert_eq!(one.root().tables("node")[0].line(), 2);
    }

    #[test]
    fn a_table_that_exists_is_noted() {
        let mut document = Document::parse("[a.b]\nc = 1\n", "a.toml").unwrap();
        document.append([&Card::single(["a", "b"], 1), &Card::single(["a", "d"], 1)]);
        let shown = document.finish(Some(())).unwrap_err().to_string();
        assert!(shown.contains("\"a.b\" is given"), "{shown}");
        assert!(!shown.contains("a.d"), "{shown}");
    }

    #[test]
    fn tables_are_replaced_with_their_inner_tables() {
        let source = "x = 1\n[[r]]\na = [\n  [1, 2],\n]\n[r.s]\nb = 2\n# next\n[drives.d]\nv = 1\n[[r]]\na = 2\n[drives.e]\nv = 2\n";
        let document = Document::parse(source, "a.toml").unwrap();
        let texts = ["[[n]]\nk = 1\n".to_owned(), "[[n]]\nk = 2\n".to_owned()];
        let expected =
            "x = 1\n[[n]]\nk = 1\n# next\n[drives.d]\nv = 1\n[[n]]\nk = 2\n[drives.e]\nv = 2\n";
        assert_eq!(
            document.replaced(source, "r", &texts).as_deref(),
            Some(expected)
        );
        let inline = "r = [{ a = 1 }]\n";
        let document = Document::parse(inline, "a.toml").unwrap();
        assert_eq!(document.replaced(inline, "r", &texts[..1]), None);
        let apart = "[[r]]\na = 1\n[p]\nb = 2\n[r.s]\nc = 3\n";
        let document = Document::parse(apart, "a.toml").unwrap();
        assert_eq!(document.replaced(apart, "r", &texts[..1]), None);
    }
}
