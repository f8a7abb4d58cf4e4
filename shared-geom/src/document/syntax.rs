//! Errors of a text that is not TOML.

use toml::de::{DeTable, DeValue};

use super::DocumentProblem;
use super::tree::Lines;
use crate::error::{Diagnostics, SourceLocation};
use crate::units::parse_any;

/// Errors of syntax that are reported one by one: one mistake causes a few of them, and a
/// file of another kind has one on every line.
pub(super) const SHOWN: usize = 8;
/// The parser's message on a repeated key.
const DUPLICATE: &str = "duplicate key";

/// The errors of syntax, each kind once per line; of many, the first. `root` is the
/// content that the parser could read.
pub(super) fn syntax_problems(
    (root, errors): (&DeTable<'_>, &[toml::de::Error]),
    lines: &Lines,
    text: &str,
    file: &str,
) -> Diagnostics {
    let mut problems = Diagnostics::new();
    if let Some(what) = other_format(text).filter(|_| !errors.is_empty()) {
        problems.push(
            SourceLocation::file(file),
            &DocumentProblem::OtherFormat { what },
        );
        return problems;
    }
    let mut reported: Vec<(usize, String)> = Vec::new();
    // Heads of tables that are repeated: their keys are no further mistake.
    let mut repeated: Vec<usize> = Vec::new();
    for (i, error) in errors.iter().enumerate() {
        let at = error.span().map_or(0, |span| span.start);
        let line = lines.at(at);
        let head = head_of(text, at).filter(|_| error.message() == DUPLICATE);
        let is_head = head.is_some_and(|head| lines.at(head) == line);
        repeated.extend(head.filter(|_| is_head));
        if !is_head && head.is_some_and(|head| repeated.contains(&head)) {
            continue;
        }
        if reported.len() == SHOWN {
            let count = errors.len() - i;
            let problem = DocumentProblem::MoreSyntax { count };
            problems.push(SourceLocation::line(file, line), &problem);
            break;
        }
        let reason = match error.message() {
            DUPLICATE => duplicate(root, lines, text, error),
            message => message.to_owned(),
        };
        let one = (line, reason);
        if !reported.contains(&one) {
            let help = match is_head {
                true => several(text, at),
                false => number(text, at)
                    .or_else(|| comma(text, at))
                    .or_else(|| no_comma(text, at))
                    .or_else(|| unit(text, at)),
            };
            let reason = one.1.clone();
            let problem = DocumentProblem::Syntax { reason, help };
            problems.push(SourceLocation::line(file, line), &problem);
            reported.push(one);
        }
    }
    problems
}

/// Offset of the head of the table with the text at an offset.
fn head_of(text: &str, at: usize) -> Option<usize> {
    let end = at + text.get(at..)?.find('\n').unwrap_or(text.len() - at);
    let mut begin = 0;
    let lines = text.get(..end)?.split_inclusive('\n').map(|line| {
        begin += line.len();
        (begin - line.len(), line)
    });
    let heads = lines.filter(|(_, line)| line.trim_start().starts_with('['));
    heads.last().map(|head| head.0)
}

/// The remedy for the repeated head of a table, at an offset.
fn several(text: &str, at: usize) -> Option<String> {
    let line = text.get(head_of(text, at)?..)?.lines().next()?;
    let head = header(line);
    let name = if head.contains('.') {
        ", or give one another name"
    } else {
        ""
    };
    let is_single = !head.starts_with("[[");
    is_single.then(|| format!("keep one of them{name}; tables of a list are [{head}]"))
}

/// The correct form of a number with a decimal comma, in the line at an offset.
fn comma(text: &str, at: usize) -> Option<String> {
    let begin = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[begin..].lines().next()?;
    let value = line.split(['=', '#']).nth(1)?.trim();
    let (whole, part) = value.split_once(',')?;
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|one| one.is_ascii_digit());
    let is_number = is_digits(whole.trim_start_matches(['+', '-'])) && is_digits(part);
    is_number.then(|| format!("TOML wants a point in a number: {whole}.{part}"))
}

/// Two numbers or texts of a list without a comma between them, in the line at an offset.
fn no_comma(text: &str, at: usize) -> Option<String> {
    let begin = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[begin..].lines().next()?.split('#').next()?;
    let is_text = |word: &str| word.len() > 1 && word.starts_with('"') && word.ends_with('"');
    let is_value = |word: &&str| word.parse::<f64>().is_ok() || is_text(word);
    line.split(['=', ',', '[', ']', '{', '}'])
        .find_map(|value| {
            let words: Vec<&str> = value.split_whitespace().collect();
            let pair = words.windows(2).next()?;
            let are_values = words.iter().all(is_value);
            are_values.then(|| format!("a comma is missing between {} and {}", pair[0], pair[1]))
        })
}

/// A repeated key, and the line of the first.
fn duplicate(root: &DeTable<'_>, lines: &Lines, text: &str, error: &toml::de::Error) -> String {
    let span = error.span().unwrap_or_default();
    let key = text.get(span.clone()).unwrap_or_default();
    let key = key.trim_matches(['"', '\'']);
    let line_of = |at: usize| {
        let begin = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let end = text[at..]
            .find('\n')
            .map_or(text.len(), |length| at + length);
        (begin, text[begin..end].trim())
    };
    let (begin, line) = line_of(span.start);
    let mut before = Vec::new();
    if line.starts_with('[') {
        // Of a table the parser keeps the last.
        let heads = text[..begin].lines().enumerate();
        let same = heads.filter(|(_, other)| header(other) == header(line));
        before.extend(same.map(|(number, _)| number + 1));
    } else {
        // Of keys of that name the previous one, in a list of the same kind: on separate
        // lines, or within braces.
        let is_first = |at: usize| {
            text[line_of(at).0..at]
                .trim_matches([' ', '\t', '"', '\''])
                .is_empty()
        };
        let mut found = Vec::new();
        locations(root, key, &mut found);
        found.retain(|&at| at < span.start && is_first(at) == is_first(span.start));
        before.extend(found.into_iter().max().map(|at| lines.at(at)));
    }
    match before.first() {
        Some(first) => format!("{DUPLICATE} \"{key}\", first on line {first}"),
        None => format!("{DUPLICATE} \"{key}\""),
    }
}

/// The head of a table without blanks and comment; other lines unchanged.
fn header(line: &str) -> String {
    let head = line.rfind(']').map_or(line, |end| &line[..=end]);
    head.split_whitespace().collect()
}

/// Offsets of a key in a table and in its nested tables.
fn locations(table: &DeTable<'_>, wanted: &str, found: &mut Vec<usize>) {
    for (key, value) in table {
        if key.get_ref() == wanted {
            found.push(key.span().start);
        }
        within(value.get_ref(), wanted, found);
    }
}

fn within(value: &DeValue<'_>, wanted: &str, found: &mut Vec<usize>) {
    match value {
        DeValue::Table(table) => locations(table, wanted, found),
        DeValue::Array(items) => {
            for item in items.iter() {
                within(item.get_ref(), wanted, found);
            }
        }
        _ => {}
    }
}

/// The correct form of a number that begins or ends with its point, at an offset.
fn number(text: &str, at: usize) -> Option<String> {
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || "+-._".contains(letter);
    let begin = text.get(..at)?.trim_end_matches(is_part).len();
    let word = &text[begin..];
    let word = &word[..word.find(|letter| !is_part(letter)).unwrap_or(word.len())];
    let digits = word.trim_start_matches(['+', '-']);
    let sign = &word[..word.len() - digits.len()];
    let (whole, part) = digits.split_once('.')?;
    let end = part.find(['e', 'E']).unwrap_or(part.len());
    let (part, power) = part.split_at(end);
    let or_zero = |digits: &str| if digits.is_empty() { "0" } else { digits }.to_owned();
    let meant = format!("{sign}{}.{}{power}", or_zero(whole), or_zero(part));
    (meant != word && meant.parse::<f64>().is_ok())
        .then(|| format!("TOML wants a digit on both sides of the point: {meant}"))
}

/// The correct form of a number with a unit and without quotes, at an offset.
fn unit(text: &str, at: usize) -> Option<String> {
    let begin = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[begin..].lines().next()?;
    let values = line.split(['=', ',', '[', ']', '{', '}', '#']);
    let mut values = values.map(str::trim).filter(|value| !value.is_empty());
    let value = values.find(|value| parse_any(value).is_ok())?;
    Some(format!("a number with a unit is a text: \"{value}\""))
}

/// The format of a text without TOML, from its first character that is no space.
fn other_format(text: &str) -> Option<&'static str> {
    let text = text.trim_start();
    if text.starts_with("$MeshFormat") {
        Some("a gmsh mesh")
    } else if text.starts_with('{') {
        Some("a JSON file, as property files are")
    } else if text.starts_with('<') {
        Some("an XML file")
    } else {
        None
    }
}
