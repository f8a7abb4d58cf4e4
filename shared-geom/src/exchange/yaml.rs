//! YAML as a tree with the line of every value.
//!
//! Built from the events of the parser, with a limit to the depth, so that no file can
//! exhaust the stack; aliases share their values. Numbers remain text until they are
//! requested, and are reported as written in the file.

use std::collections::HashMap;
use std::rc::Rc;

use saphyr_parser::{Event, Parser};

use super::problem::{ExchangeProblem, Problems};
use crate::error::{nearest_name, shortened};

/// Deeper than any description of a turbine.
const DEPTH: usize = 64;

/// A value with the line of its beginning, counted from one.
#[derive(Debug)]
pub struct Node {
    /// Line of its beginning, counted from one.
    pub line: usize,
    /// Content.
    pub value: Value,
    depth: usize,
}

/// Content.
#[derive(Debug)]
pub enum Value {
    /// A scalar, as written in the file.
    Text(String),
    /// A sequence.
    List(Vec<Rc<Node>>),
    /// A mapping, in the order of the file.
    Table(Vec<(String, Rc<Node>)>),
}

impl Node {
    /// The value of `key` in a table.
    pub fn entry(&self, key: &str) -> Option<&Node> {
        let Value::Table(entries) = &self.value else {
            return None;
        };
        let found = entries.iter().find(|(name, _)| name == key)?;
        Some(&found.1)
    }

    /// The value under all `keys`, each in the table of the previous one.
    pub fn path(&self, keys: &[&str]) -> Option<&Node> {
        keys.iter().try_fold(self, |node, key| node.entry(key))
    }

    /// Names of the entries of a table.
    pub fn keys(&self) -> Vec<&str> {
        match &self.value {
            Value::Table(entries) => entries.iter().map(|(name, _)| name.as_str()).collect(),
            _ => Vec::new(),
        }
    }

    /// The words of a text.
    pub fn text(&self) -> Option<&str> {
        match &self.value {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Its kind, for messages.
    pub fn kind(&self) -> String {
        match &self.value {
            Value::Text(text) => format!("\"{}\"", shortened(text)),
            Value::List(list) => format!("a list of {}", list.len()),
            Value::Table(_) => "a table".to_owned(),
        }
    }
}

/// The value of `key` in the table `node`, which is called `parent`; notes a missing key,
/// with the nearest one.
pub fn required<'n>(
    node: &'n Node,
    parent: &str,
    key: &str,
    problems: &mut Problems,
) -> Option<&'n Node> {
    let found = node.entry(key);
    if found.is_none() {
        let keys = node.keys();
        let help = match nearest_name(key, keys.iter().copied()) {
            Some(near) => format!("did you mean \"{near}\" to be \"{key}\"?"),
            None if keys.is_empty() => format!("{parent} is {}", node.kind()),
            None => format!("there are {}", keys.join(", ")),
        };
        let what = format!("key \"{key}\" of {parent}");
        problems.push(node.line, &ExchangeProblem::Missing { what, help });
    }
    found
}

/// The first document of `text`.
///
/// # Errors
/// The line and its problem.
pub fn parse(text: &str) -> Result<Node, (usize, ExchangeProblem)> {
    let mut builder = Builder::default();
    // a tabulator behind a key separates it from its value, which the parser does not accept
    let text = text.replace(":\t", ": ");
    for event in Parser::new_from_str(&text) {
        let (event, span) = event.map_err(|error| {
            let problem = wrong("the YAML text", error.info(), "YAML 1.2");
            (error.marker().line(), problem)
        })?;
        let line = span.start.line();
        if let Event::DocumentEnd = event {
            break;
        }
        builder
            .take(event, line)
            .map_err(|problem| (line, problem))?;
    }
    let cut = || ExchangeProblem::CutShort {
        what: "the YAML text".to_owned(),
        expected: "a table of a turbine or blade".to_owned(),
    };
    let root = builder.root.ok_or_else(|| (0, cut()))?;
    // Only this variable holds the root: it has no anchor, or the anchors were dropped.
    builder.anchors.clear();
    Rc::try_unwrap(root).map_err(|_| (0, cut()))
}

fn wrong(what: &str, found: &str, expected: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: what.to_owned(),
        found: found.to_owned(),
        expected: expected.to_owned(),
        help: "check the indentation and the brackets up to this line; the file may have been \
               cut off"
            .to_owned(),
    }
}

/// A list or table that is not closed yet.
struct Open {
    line: usize,
    anchor: usize,
    depth: usize,
    key: Option<String>,
    value: Value,
}

#[derive(Default)]
struct Builder {
    stack: Vec<Open>,
    anchors: HashMap<usize, Rc<Node>>,
    root: Option<Rc<Node>>,
}

impl Builder {
    fn take(&mut self, event: Event<'_>, line: usize) -> Result<(), ExchangeProblem> {
        match event {
            Event::SequenceStart(anchor, _) => self.open(line, anchor, Value::List(Vec::new())),
            Event::MappingStart(anchor, _) => self.open(line, anchor, Value::Table(Vec::new())),
            Event::SequenceEnd | Event::MappingEnd => self.close(),
            Event::Scalar(text, _, anchor, _) => {
                let value = Value::Text(text.into_owned());
                let node = Rc::new(Node {
                    line,
                    value,
                    depth: 1,
                });
                self.insert(anchor, node)
            }
            Event::Alias(anchor) => {
                let node = self.anchors.get(&anchor).cloned();
                let node = node.ok_or_else(|| {
                    wrong(
                        "an alias",
                        "one that holds itself",
                        "the name of a value before it",
                    )
                })?;
                self.insert(0, node)
            }
            _ => Ok(()),
        }
    }

    fn open(&mut self, line: usize, anchor: usize, value: Value) -> Result<(), ExchangeProblem> {
        if self.stack.len() >= DEPTH {
            return Err(too_deep());
        }
        self.stack.push(Open {
            line,
            anchor,
            depth: 0,
            key: None,
            value,
        });
        Ok(())
    }

    fn close(&mut self) -> Result<(), ExchangeProblem> {
        let Some(open) = self.stack.pop() else {
            return Ok(());
        };
        let node = Rc::new(Node {
            line: open.line,
            value: open.value,
            depth: open.depth + 1,
        });
        self.insert(open.anchor, node)
    }

    fn insert(&mut self, anchor: usize, node: Rc<Node>) -> Result<(), ExchangeProblem> {
        if anchor > 0 {
            self.anchors.insert(anchor, Rc::clone(&node));
        }
        let Some(open) = self.stack.last_mut() else {
            self.root = Some(node);
            return Ok(());
        };
        open.depth = open.depth.max(node.depth);
        if open.depth > DEPTH {
            return Err(too_deep());
        }
        match (&mut open.value, open.key.take()) {
            (Value::List(list), _) => list.push(node),
            (Value::Table(entries), Some(key)) => entries.push((key, node)),
            (Value::Table(entries), None) => {
                let key = node
                    .text()
                    .ok_or_else(|| wrong("a key", &node.kind(), "a word"))?;
                if entries.iter().any(|(name, _)| name == key) {
                    let what = format!("key \"{}\"", shortened(key));
                    return Err(wrong(&what, "it twice in one table", "each key once"));
                }
                open.key = Some(key.to_owned());
            }
            (Value::Text(_), _) => {}
        }
        Ok(())
    }
}

fn too_deep() -> ExchangeProblem {
    let expected = format!("at most {DEPTH}");
    wrong("lists and tables in each other", "more levels", &expected)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_keep_their_lines_and_aliases_share() {
        let root = parse("a: 1.5\nb:\n  c: &x [1, 2e3]\n  d: *x\n").unwrap();
        assert_eq!(root.entry("a").unwrap().line, 1);
        let list = root.path(&["b", "d"]).unwrap();
        assert_eq!(list.line, 3);
        let Value::List(items) = &list.value else {
            panic!("a list")
        };
        assert_eq!(items[1].text(), Some("2e3"));
        assert_eq!(root.entry("b").unwrap().keys(), ["c", "d"]);
    }

    #[test]
    fn twice_the_same_key_and_bad_text_are_reported_with_their_line() {
        assert_eq!(parse("a: 1\nb: 2\na: 3\n").unwrap_err().0, 3);
        assert_eq!(parse("a: [1, 2\nb: 3\n").unwrap_err().0, 2);
        assert!(parse("").is_err());
        assert!(parse("? [1]\n: 2\n").is_err());
    }

    // Neither nested brackets nor a chain of aliases builds a tree too deep to drop.
    #[test]
    fn deep_files_are_refused() {
        let deep = "[".repeat(100_000);
        assert!(parse(&deep).is_err());
        let mut chain = String::from("a0: &a0 [1]\n");
        for i in 1..2000 {
            chain += &format!("a{i}: &a{i} [*a{}]\n", i - 1);
        }
        assert!(parse(&chain).is_err());
        assert!(parse("a: &a [*a]\n").is_err());
    }
}
