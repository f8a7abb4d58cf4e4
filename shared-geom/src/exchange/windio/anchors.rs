//! Anchors of YAML, `&name`, and the aliases that refer to them, `*name`.
//!
//! If the table of an anchor is replaced, the first alias after it becomes the anchor, with the
//! value as it was; the other aliases refer to it, so that all other tables keep their values.

use std::ops::Range;

use super::block::{self, Lines};
use super::flow;

/// Byte at which a line has an anchor or alias `word`.
fn position(line: &str, word: &str) -> Option<usize> {
    let is_end = |next: Option<char>| next.is_none_or(|c| c.is_whitespace() || ",[]{}".contains(c));
    let code = line.split(" #").next().unwrap_or_default();
    let mut found = code.match_indices(word);
    found
        .find(|(at, _)| is_end(code[at + word.len()..].chars().next()))
        .map(|(at, _)| at)
}

/// The value of an anchor.
enum Value {
    /// On its line, or in the flow style.
    Inline(String),
    /// The lines below its key, without the depth of the key.
    Block(Vec<String>),
}

/// Moves the anchors in the lines `range`, of which the first begins at the byte `from`, to their
/// first alias after them.
///
/// # Errors
/// The name of an anchor that cannot be moved.
pub(super) fn rescue(lines: &mut Lines, range: &Range<usize>, from: usize) -> Result<(), String> {
    let mut body = lines[range.clone()].to_vec();
    if let Some(first) = body.first_mut() {
        first.replace_range(..from, &" ".repeat(from));
    }
    let after = lines[range.end..].to_vec();
    let aliases = block::names(&after, '*');
    for name in block::names(&body, '&') {
        if aliases.contains(&name) {
            rescue_one(lines, &body, (range.end, &name)).ok_or(name)?;
        }
    }
    Ok(())
}

fn rescue_one(lines: &mut Lines, body: &Lines, (after, name): (usize, &str)) -> Option<()> {
    let value = value(body, name)?;
    let word = format!("*{name}");
    let found = |(number, line): (usize, &String)| Some((number, position(line, &word)?));
    let (number, at) = lines.iter().enumerate().skip(after).find_map(found)?;
    let line = &lines[number];
    let rest = &line[at + word.len()..];
    match value {
        Value::Inline(text) => lines[number] = format!("{}&{name} {text}{rest}", &line[..at]),
        Value::Block(texts) => {
            let is_alone = rest.trim().is_empty() || rest.trim().starts_with('#');
            let is_value = line[..at].trim_end().ends_with(':');
            if !is_alone || !is_value || line.trim_start().starts_with("- ") {
                return None;
            }
            let margin = " ".repeat(line.len() - line.trim_start().len());
            lines[number] = format!("{}&{name}{rest}", &line[..at]);
            let texts = texts.iter().map(|text| format!("{margin}{text}"));
            lines.splice(number + 1..number + 1, texts);
        }
    }
    Some(())
}

/// The value of an anchor in `body`.
fn value(body: &Lines, name: &str) -> Option<Value> {
    let word = format!("&{name}");
    let found = |(number, line): (usize, &String)| Some((number, position(line, &word)?));
    let (number, at) = body.iter().enumerate().find_map(found)?;
    let line = &body[number];
    let rest = &line[at + word.len()..];
    let text = rest.trim_start();
    let start = line.len() - text.len();
    if let Some((_, text)) = flow::value(body, (number, start)) {
        return Some(Value::Inline(text));
    }
    if text.starts_with(['{', '[', '|', '>', '"', '\'']) {
        return None;
    }
    let scalar = text.split(" #").next().unwrap_or_default();
    let scalar = if scalar.starts_with('#') {
        ""
    } else {
        scalar.split([',', ']', '}']).next().unwrap_or_default()
    };
    if !scalar.trim().is_empty() {
        return Some(Value::Inline(scalar.trim().to_owned()));
    }
    let depth = line.len() - line.trim_start().len();
    let is_inside = |line: &&String| {
        let found = line.len() - line.trim_start().len();
        line.trim().is_empty() || found > depth || line[found..].starts_with("- ")
    };
    let inside = body[number + 1..].iter().take_while(is_inside);
    let texts = inside.map(|line| line.get(depth..).unwrap_or_default().to_owned());
    let texts: Vec<_> = texts.collect();
    (!line.trim_start().starts_with("- ")).then_some(Value::Block(texts))
}
