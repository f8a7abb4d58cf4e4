//! Blocks of a YAML text: the lines below a key. Lines of other blocks are not touched.
//!
//! Tables written as blocks are understood, as in every windIO file: keys on lines of
//! their own, their content deeper, or a list at the same depth.

use std::ops::Range;

/// Depth of the entries of a table in its key, if the file shows no other.
pub(super) const USUAL: usize = 4;

/// Lines of a text, without the line feed.
pub(super) type Lines = Vec<String>;

/// A key and its content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Block {
    /// Index of the line of the key.
    pub key: usize,
    /// Blanks before the key.
    pub indent: usize,
    /// Indices of the lines of its content.
    pub body: Range<usize>,
}

/// Number of blanks before the content of a line; `None` for blank lines and comments.
fn indent(line: &str) -> Option<usize> {
    let content = line.trim_start();
    let is_content = !content.is_empty() && !content.starts_with('#');
    is_content.then_some(line.len() - content.len())
}

/// Whether a line begins with `key` and a colon.
fn has_key(line: &str, key: &str) -> bool {
    let rest = line.trim_start().strip_prefix(key);
    let rest = rest.and_then(|rest| rest.trim_start().strip_prefix(':'));
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace))
}

/// The block of `key` among the entries of the table in the lines `range`.
fn child(lines: &[String], range: &Range<usize>, key: &str) -> Option<Block> {
    let depth = range.clone().find_map(|at| indent(&lines[at]))?;
    let at = range
        .clone()
        .find(|at| indent(&lines[*at]) == Some(depth) && has_key(&lines[*at], key))?;
    let inside = |line: &str| match indent(line) {
        None => true,
        Some(found) => found > depth || found == depth && line.trim_start().starts_with("- "),
    };
    let end = (at + 1..range.end)
        .find(|next| !inside(&lines[*next]))
        .unwrap_or(range.end);
    // Blank lines and comments before the next key belong to it.
    let end = (at + 1..end)
        .rev()
        .find(|last| indent(&lines[*last]).is_some())
        .map_or(at + 1, |last| last + 1);
    Some(Block {
        key: at,
        indent: depth,
        body: at + 1..end,
    })
}

/// The block under `keys`, each in the table of the previous one.
///
/// # Errors
/// The number of keys that were found.
pub(super) fn find(lines: &[String], keys: &[&str]) -> Result<Block, usize> {
    let mut range = 0..lines.len();
    let mut found = Err(0);
    for (count, key) in keys.iter().enumerate() {
        let block = child(lines, &range, key).ok_or(count)?;
        range = block.body.clone();
        found = Ok(block);
    }
    found
}

/// Depth of the entries of the table of `block`; a usual one without entries.
pub(super) fn depth(lines: &[String], block: &Block) -> usize {
    let mut body = block.body.clone();
    let depth = body.find_map(|at| indent(&lines[at]));
    depth.unwrap_or(block.indent + USUAL)
}

/// Byte at which the value on the line of a key begins, after its colon and an anchor.
pub(super) fn value_at(line: &str) -> usize {
    let value = line
        .split_once(':')
        .map_or("", |(_, value)| value.trim_start());
    let value = match value.strip_prefix('&') {
        Some(anchored) => anchored
            .split_once(char::is_whitespace)
            .map_or("", |(_, value)| value.trim_start()),
        None => value,
    };
    line.len() - value.len()
}

/// Text of the value on the line of a key, without comment.
pub(super) fn inline_value(line: &str) -> &str {
    let value = line[value_at(line)..].trim_end();
    if value.starts_with('#') { "" } else { value }
}

/// Names of the anchors (`&name`) or aliases (`*name`) of lines, by their `mark`.
pub(super) fn names(lines: &[String], mark: char) -> Vec<String> {
    let code = lines
        .iter()
        .map(|line| line.split(" #").next().unwrap_or_default());
    let words =
        code.flat_map(|line| line.split(|c: char| c.is_whitespace() || ",[]{}".contains(c)));
    let marked = words.filter_map(|word| word.strip_prefix(mark));
    marked
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "a: 1\nb:\n  # of c\n  c: &x\n    d: [1,\n        2]\n\n  # of e\n  e:\n  \
                        - [1]\n  - [2]\n  f: *x\ng: {h: 1}\n";

    fn lines() -> Lines {
        TEXT.lines().map(str::to_owned).collect()
    }

    #[test]
    fn blocks_end_before_the_comments_of_the_next_key() {
        let lines = lines();
        let c = find(&lines, &["b", "c"]).unwrap();
        assert_eq!((c.key, c.indent, c.body.clone()), (3, 2, 4..6));
        assert_eq!(depth(&lines, &c), 4);
        assert_eq!(find(&lines, &["b", "e"]).unwrap().body, 9..11);
        assert_eq!(find(&lines, &["b", "x"]), Err(1));
        assert_eq!(find(&lines, &["b", "c", "c"]), Err(2));
        // A key inside another table is not found, nor one that begins alike.
        assert_eq!(find(&lines, &["d"]), Err(0));
        assert_eq!(find(&["ab: 1".to_owned()], &["a"]), Err(0));
    }

    #[test]
    fn anchors_and_inline_values_are_seen() {
        let lines = lines();
        assert_eq!(names(&lines, '&'), ["x"]);
        assert_eq!(names(&lines, '*'), ["x"]);
        for (line, value) in [
            ("c: &x", ""),
            ("c:  # e", ""),
            ("g: {h: 1}", "{h: 1}"),
            ("a: &x 2", "2"),
        ] {
            assert_eq!(inline_value(line), value);
        }
    }
}
