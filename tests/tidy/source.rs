//! A minimal reader of Rust sources: code and non-code, the end of a block, code compiled
//! for tests only.

use std::iter::repeat_n;

/// The source with comments, strings and characters replaced by spaces, so that lines and
/// columns (counted in characters) are kept.
pub fn blank(source: &str) -> String {
    let chars: Vec<char> = source.chars().collect();
    let mut code = String::with_capacity(source.len());
    let mut at = 0;
    while at < chars.len() {
        let end = opaque_end(&chars, at);
        if end == at {
            code.push(chars[at]);
            at += 1;
        } else {
            let end = end.min(chars.len());
            code.extend(chars[at..end].iter().map(|&c| blanked(c)));
            at = end;
        }
    }
    code
}

fn blanked(c: char) -> char {
    if c == '\n' { '\n' } else { ' ' }
}

/// The end of the comment, string or character that begins at `at`; `at` itself if it is
/// code.
fn opaque_end(chars: &[char], at: usize) -> usize {
    match (chars[at], chars.get(at + 1)) {
        ('/', Some('/')) => find(chars, at, |c| c == '\n'),
        ('/', Some('*')) => block_comment_end(chars, at),
        ('"', _) => string_end(chars, at),
        ('\'', _) => character_end(chars, at),
        ('r', Some('"' | '#')) => raw_string_end(chars, at),
        _ => at,
    }
}

fn find(chars: &[char], from: usize, wanted: impl Fn(char) -> bool) -> usize {
    (from..chars.len())
        .find(|&i| wanted(chars[i]))
        .unwrap_or(chars.len())
}

/// Block comments nest.
fn block_comment_end(chars: &[char], at: usize) -> usize {
    let (mut depth, mut i) = (0, at);
    while i + 1 < chars.len() {
        match (chars[i], chars[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    chars.len()
}

fn string_end(chars: &[char], at: usize) -> usize {
    let mut i = at + 1;
    while i < chars.len() {
        match chars[i] {
            '\\' => i += 2,
            '"' => return i + 1,
            _ => i += 1,
        }
    }
    chars.len()
}

/// A quote opens a character only if another closes it; else it is a lifetime.
fn character_end(chars: &[char], at: usize) -> usize {
    match (chars.get(at + 1), chars.get(at + 2)) {
        (Some('\\'), Some(_)) => find(chars, at + 3, |c| c == '\'') + 1,
        (Some(_), Some('\'')) => at + 3,
        _ => at,
    }
}

fn raw_string_end(chars: &[char], at: usize) -> usize {
    let quote = find(chars, at + 1, |c| c != '#');
    if (at > 0 && is_word(chars[at - 1]) && chars[at - 1] != 'b') || chars.get(quote) != Some(&'"')
    {
        return at;
    }
    let closing: Vec<char> = ['"']
        .into_iter()
        .chain(repeat_n('#', quote - at - 1))
        .collect();
    let end = (quote + 1..chars.len()).find(|&i| chars[i..].starts_with(&closing));
    end.map_or(chars.len(), |i| i + closing.len())
}

/// Whether `c` belongs to an identifier.
pub fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Byte offsets at which the word `wanted` is a whole word in `text`.
pub fn words<'a>(text: &'a str, wanted: &'a str) -> impl Iterator<Item = usize> + 'a {
    text.match_indices(wanted).map(|(at, _)| at).filter(|at| {
        let before = text[..*at].chars().next_back();
        let after = text[at + wanted.len()..].chars().next();
        !before.is_some_and(is_word) && !after.is_some_and(is_word)
    })
}

/// The line (from zero) of byte `at`.
pub fn line_of(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count()
}

/// The line on which the item that begins on line `start` ends: its first closed brace,
/// or a semicolon before any brace.
pub fn item_end(lines: &[&str], start: usize) -> Option<usize> {
    let (mut braces, mut brackets) = (0, 0);
    for (number, line) in lines.iter().enumerate().skip(start) {
        for c in line.chars() {
            match c {
                '{' => braces += 1,
                '}' => braces -= 1,
                '(' | '[' => brackets += 1,
                ')' | ']' => brackets -= 1,
                _ => {}
            }
            let closed = braces == 0 && brackets == 0;
            if (c == '}' || c == ';') && closed {
                return Some(number);
            }
        }
    }
    None
}

/// For each line of blanked code, whether it is compiled for tests only.
pub fn test_lines(code: &str) -> Vec<bool> {
    let lines: Vec<&str> = code.lines().collect();
    let mut is_test = vec![false; lines.len()];
    for start in 0..lines.len() {
        if lines[start].trim_start().starts_with("#[cfg(test)]") {
            let end = item_end(&lines, start).unwrap_or(lines.len() - 1);
            is_test[start..=end].fill(true);
        }
    }
    is_test
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_strings_and_characters_are_blanked_and_lines_stay() {
        let source =
            "let a = \"x // { \\\" }\"; // {\nlet b = '{'; /* { /* */ \n } */ let c: &'a str;";
        let code = blank(source);
        assert_eq!(code.lines().count(), 3);
        assert!(!code.contains(['{', '}', '"']));
        assert!(code.contains("let c: &'a str;"));
        assert_eq!(code.len(), source.len());
    }

    #[test]
    fn raw_strings_are_blanked_and_raw_identifiers_are_not() {
        let code = blank("r#\"a \" {\"# + br\"{\" + r#type + for\"{\"");
        assert!(!code.contains('{'));
        assert!(code.contains("r#type"));
    }

    #[test]
    fn items_end_at_their_brace_or_semicolon() {
        let lines = ["fn a(x: [f64; 3]) {", "    if b {", "    }", "}", "mod c;"];
        assert_eq!(item_end(&lines, 0), Some(3));
        assert_eq!(item_end(&lines, 4), Some(4));
    }

    #[test]
    fn test_modules_are_marked_and_nothing_after_them() {
        let marks = test_lines("fn a() {}\n#[cfg(test)]\nmod tests {\n  fn b() {}\n}\nfn c() {}\n");
        assert_eq!(marks, [false, true, true, true, true, false]);
    }

    #[test]
    fn words_are_alone() {
        assert_eq!(
            words("crate::a $crate mycrate", "crate").collect::<Vec<_>>(),
            [0, 10]
        );
    }
}
