//! Values in the flow style of YAML, `{a: 1, b: [2, 3]}`, on one line or several.

use super::block::Lines;

/// A position in the lines of a text: line and byte.
pub(super) type At = (usize, usize);

/// The depth of brackets after each character of a text that no quotes enclose.
struct Scanner {
    depth: usize,
    quote: Option<char>,
    /// The character before.
    before: char,
}

/// The meaning of a character.
#[derive(PartialEq, Eq)]
enum Sign {
    /// It begins a comment.
    Comment,
    /// It closes the first bracket.
    Last,
    /// A comma inside of the first bracket alone.
    Comma,
    Other,
}

impl Scanner {
    fn new() -> Self {
        Self {
            depth: 0,
            quote: None,
            before: ' ',
        }
    }

    fn take(&mut self, at: char) -> Sign {
        let before = std::mem::replace(&mut self.before, at);
        if let Some(quote) = self.quote {
            if at == quote && !(quote == '"' && before == '\\') {
                self.quote = None;
            }
            return Sign::Other;
        }
        match at {
            '#' if before.is_whitespace() => return Sign::Comment,
            '"' | '\'' if !before.is_alphanumeric() => self.quote = Some(at),
            '{' | '[' => self.depth += 1,
            '}' | ']' => {
                self.depth = self.depth.saturating_sub(1);
                if self.depth == 0 {
                    return Sign::Last;
                }
            }
            ',' if self.depth == 1 => return Sign::Comma,
            _ => {}
        }
        Sign::Other
    }
}

/// The position after the value that begins with a bracket at `start`, and its text on one line;
/// `None` for other values, and for one with a comment inside.
pub(super) fn value(lines: &Lines, start: At) -> Option<(At, String)> {
    let first = lines.get(start.0)?.get(start.1..)?;
    if !first.starts_with(['{', '[']) {
        return None;
    }
    let mut scanner = Scanner::new();
    let mut text = String::new();
    for (number, line) in lines.iter().enumerate().skip(start.0) {
        let from = if number == start.0 { start.1 } else { 0 };
        for (at, letter) in line[from..].char_indices() {
            match scanner.take(letter) {
                Sign::Comment => return None,
                Sign::Last => {
                    let end = from + at + letter.len_utf8();
                    text.push_str(line[from..end].trim_start());
                    return Some(((number, end), text));
                }
                _ => {}
            }
        }
        scanner.take('\n');
        text.push_str(line[from..].trim());
        text.push(' ');
    }
    None
}

/// The entries of a table in the flow style, as text; `None` for another value.
pub(super) fn entries(table: &str) -> Option<Vec<String>> {
    let inside = table.strip_prefix('{')?.strip_suffix('}')?;
    let mut scanner = Scanner::new();
    scanner.take('{');
    let mut entries = vec![String::new()];
    for letter in inside.chars() {
        match scanner.take(letter) {
            Sign::Comma => entries.push(String::new()),
            _ => entries.last_mut()?.push(letter),
        }
    }
    let entries = entries.iter().map(|entry| entry.trim().to_owned());
    let entries: Vec<_> = entries.filter(|entry| !entry.is_empty()).collect();
    // `{"a":1}` has no blank behind its colon: such a table cannot be written as a block
    let is_plain = |entry: &String| entry.contains(": ") || entry.ends_with(':');
    entries.iter().all(is_plain).then_some(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_end_at_their_bracket_and_tables_have_entries() {
        let text = "a: {b: [1, 2], # c\n  d: 1}\ne: {f: 'it''s, }', g: {h: [1,\n   2]},\n i: &x 3,\n} # j\n";
        let lines: Lines = text.split('\n').map(str::to_owned).collect();
        assert_eq!(value(&lines, (0, 3)), None);
        assert_eq!(value(&lines, (0, 7)).map(|found| found.0), Some((0, 13)));
        let (end, table) = value(&lines, (2, 3)).unwrap();
        assert_eq!(end, (5, 1));
        assert_eq!(table, "{f: 'it''s, }', g: {h: [1, 2]}, i: &x 3, }");
        let found = entries(&table).unwrap();
        assert_eq!(found, ["f: 'it''s, }'", "g: {h: [1, 2]}", "i: &x 3"]);
        assert_eq!(entries("{}"), Some(Vec::new()));
        assert_eq!(entries("[1]"), None);
        assert_eq!(entries("{\"a\":1}"), None);
        assert_eq!(value(&lines, (2, 0)), None);
    }
}
