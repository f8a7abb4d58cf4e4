//! Polar copies of cards: `[[repeat]]` with cards `[[repeat.node]]`, `[[repeat.beam]]`.
//!
//! Copy number i of n consists of the nested cards, with " i" after each name that they
//! define and after each use of it, in a frame turned by `(i - 1)/n` of a turn about the
//! axis.

use std::collections::BTreeSet;

use super::tree::{Entry, Kind, Value};
use super::{Document, DocumentProblem};
use crate::expression::written;

/// Most cards of all copies.
const MOST: usize = 200_000;
/// Keys whose texts are words, not names.
const WORDS: [&str; 15] = [
    "kind",
    "axes",
    "axis_in",
    "inertia",
    "fixed_to",
    "interpolation",
    "outside",
    "shape",
    "file",
    "unit",
    "quantity",
    "component",
    "axis",
    "free",
    "scheme",
];

impl Document {
    /// Makes the copies that `[[repeat]]` requests and leaves the card with its own keys.
    /// Cards of the kinds in `framed` are put into the frame of their copy by the key
    /// `in`; a card `[[frame]]` is added for each. Returns `false` for too many copies:
    /// the problem has been noted, and the file need not be read further.
    pub fn repeat(&mut self, framed: &[&str]) -> bool {
        let mut next = 0;
        let mut made = 0;
        // Copies may hold repeats themselves, which are appended.
        while let Some(card) = take(&mut self.root, next) {
            next += 1;
            let Kind::Table(entries) = card.kind else {
                continue;
            };
            let is_cards = |entry: &Entry| match &entry.value.kind {
                Kind::Array(items) => items.iter().any(|item| matches!(item.kind, Kind::Table(_))),
                _ => false,
            };
            let (cards, own): (Vec<_>, Vec<_>) = entries.into_iter().partition(is_cards);
            let count = self.count(&own);
            made += count * cards.iter().map(size).sum::<usize>().max(1);
            let name = name_of(&own).unwrap_or_else(|| format!("repeat {next}"));
            if made > MOST {
                let problem = DocumentProblem::ManyCopies { name, limit: MOST };
                let line = own.iter().find(|entry| entry.key == "count");
                self.note(line.map_or(card.line, |entry| entry.line), &problem);
                return false;
            }
            let names: BTreeSet<_> = cards.iter().flat_map(names_in).collect();
            for copy in 1..=count {
                let turn = 360.0 * (copy - 1) as f64 / count as f64;
                let frame = frame(&format!("{name} {copy}"), &own, turn, card.line);
                append(&mut self.root, "frame", frame);
                for kind in &cards {
                    let Kind::Array(items) = &kind.value.kind else {
                        continue;
                    };
                    for item in items {
                        let mut item = item.clone();
                        rename(&mut item, &names, copy);
                        if framed.contains(&kind.key.as_str()) {
                            put_in(&mut item, &format!("{name} {copy}"));
                        }
                        append(&mut self.root, &kind.key, item);
                    }
                }
            }
            put_back(&mut self.root, next - 1, Kind::Table(own));
        }
        true
    }

    /// The number of copies; one if it cannot be read, which the reader of the card
    /// reports.
    fn count(&self, own: &[Entry]) -> usize {
        let value = own.iter().find(|entry| entry.key == "count");
        let count = value.and_then(|entry| match &entry.value.kind {
            Kind::Integer(count) => usize::try_from(*count).ok(),
            Kind::Text(text) if written(text).is_some() => {
                self.quietly(text).map(|count| count as usize)
            }
            _ => None,
        });
        count.unwrap_or(1).clamp(1, MOST + 1)
    }
}

/// The card number `index` of the repeats, replaced by an empty one.
fn take(root: &mut [Entry], index: usize) -> Option<Value> {
    let value = repeat(root, index)?;
    let kind = std::mem::replace(&mut value.kind, Kind::Table(Vec::new()));
    let line = value.line;
    Some(Value { line, kind })
}

fn put_back(root: &mut [Entry], index: usize, kind: Kind) {
    if let Some(value) = repeat(root, index) {
        value.kind = kind;
    }
}

fn repeat(root: &mut [Entry], index: usize) -> Option<&mut Value> {
    let entry = root.iter_mut().find(|entry| entry.key == "repeat")?;
    match &mut entry.value.kind {
        Kind::Array(items) => items.get_mut(index),
        _ => None,
    }
}

fn size(cards: &Entry) -> usize {
    match &cards.value.kind {
        Kind::Array(items) => items.len(),
        _ => 0,
    }
}

fn name_of(entries: &[Entry]) -> Option<String> {
    let entry = entries.iter().find(|entry| entry.key == "name")?;
    match &entry.value.kind {
        Kind::Text(name) => Some(name.clone()),
        _ => None,
    }
}

/// Names that cards define.
fn names_in(cards: &Entry) -> Vec<String> {
    let Kind::Array(items) = &cards.value.kind else {
        return Vec::new();
    };
    let name = |item: &Value| match &item.kind {
        Kind::Table(entries) => name_of(entries),
        _ => None,
    };
    items.iter().filter_map(name).collect()
}

/// Appends the number of the copy to each name that the cards define, wherever it is
/// used. A node of a blade is named by the blade: `blade/tip` becomes `blade 2/tip`.
fn rename(value: &mut Value, names: &BTreeSet<String>, copy: usize) {
    match &mut value.kind {
        Kind::Text(text) => {
            let (first, rest) = match text.split_once('/') {
                Some((first, rest)) => (first, format!("/{rest}")),
                None => (text.as_str(), String::new()),
            };
            if names.contains(text.as_str()) {
                *text = format!("{text} {copy}");
            } else if names.contains(first) {
                *text = format!("{first} {copy}{rest}");
            }
        }
        Kind::Array(items) => items.iter_mut().for_each(|item| rename(item, names, copy)),
        Kind::Table(entries) => {
            let named = entries.iter_mut();
            named
                .filter(|entry| !WORDS.contains(&entry.key.as_str()))
                .for_each(|entry| rename(&mut entry.value, names, copy));
        }
        _ => {}
    }
}

/// Puts a card into a frame, unless it is in one already.
fn put_in(card: &mut Value, frame: &str) {
    let line = card.line;
    if let Kind::Table(entries) = &mut card.kind
        && !entries.iter().any(|entry| entry.key == "in")
    {
        entries.push(text("in", frame, line));
    }
}

fn text(key: &str, text: &str, line: usize) -> Entry {
    Entry {
        key: key.to_owned(),
        line,
        value: Value {
            line,
            kind: Kind::Text(text.to_owned()),
        },
    }
}

/// The card of the frame of a copy: turned about the axis of the repeat.
fn frame(name: &str, own: &[Entry], turn: f64, line: usize) -> Value {
    let taken = own.iter();
    let taken = taken.filter(|entry| ["axis", "center", "in"].contains(&entry.key.as_str()));
    let mut entries = vec![
        text("name", name, line),
        text("turn", &format!("{turn} deg"), line),
    ];
    entries.extend(taken.cloned());
    Value {
        line,
        kind: Kind::Table(entries),
    }
}

/// Appends a card to the others of its kind.
fn append(root: &mut Vec<Entry>, kind: &str, card: Value) {
    match root.iter_mut().find(|entry| entry.key == kind) {
        Some(entry) => {
            if let Kind::Array(items) = &mut entry.value.kind {
                items.push(card);
            }
        }
        None => root.push(Entry {
            key: kind.to_owned(),
            line: card.line,
            value: Value {
                line: card.line,
                kind: Kind::Array(vec![card]),
            },
        }),
    }
}
