//! Words that the project does not use: its readers are engineers, many of whom read English as
//! a second language.

use crate::source::words;
use crate::tree::{File, Tree};

/// Phrases that are out, with the phrase to write, and the number of uses that are left.
const OUT: [(&str, &str, usize); 33] = [
    ("told", "reported, given", 0),
    ("tells", "reports, states", 0),
    ("tell", "report, state", 1),
    ("telling", "reporting", 0),
    ("says", "states, has", 0),
    ("said", "stated, given", 0),
    ("asked", "requested, required", 0),
    ("asks", "requests, requires", 0),
    ("ask", "request, require", 0),
    ("stands for", "expands to, represents, is", 0),
    ("stand for", "expand to, represent", 0),
    ("stands where", "is read where", 0),
    ("for which it stands", "to which it expands", 0),
    ("room", "space, buffer, length", 1),
    ("rooms", "spaces, buffers", 0),
    ("what is", "the noun", 0),
    ("what the", "the noun", 0),
    ("what was", "the noun", 0),
    ("go on", "continue", 0),
    ("that of", "the noun again", 0),
    ("those of", "the noun again", 0),
    ("in words", "as text, described", 0),
    ("in one stroke", "at once", 0),
    ("stands in", "is in", 0),
    ("goes on", "continues", 0),
    ("gives way", "is violated, buckles", 0),
    ("hangs on", "depends on", 0),
    ("hang on", "depend on", 0),
    ("taken for", "treated as", 0),
    ("astray", "the cause", 0),
    ("no news", "known", 0),
    ("/// what", "a noun at the beginning", 0),
    ("//! what", "a noun at the beginning", 0),
];

/// Pages made by a program from strings in the sources.
const MADE: &str = "docs/src/validation-";

/// Phrases that are used more often than is left to them.
pub fn out(tree: &Tree) -> Vec<String> {
    let is_read =
        |file: &&File| !file.path.starts_with(MADE) && !file.path.starts_with("tests/tidy/");
    let lines: Vec<_> = tree.files.iter().filter(is_read).flat_map(texts).collect();
    let mut breaches = Vec::new();
    for (phrase, instead, left) in OUT {
        let found: Vec<_> = uses(&lines, phrase).collect();
        if found.len() > left {
            let advice = format!("\"{phrase}\" is out, write \"{instead}\" ({left} uses are left)");
            breaches.extend(found.iter().map(|(file, line)| file.breach(*line, &advice)));
        }
    }
    breaches
}

/// A file, a line of it (from zero) and the text of the line in lower case.
type Text<'a> = (&'a File, usize, String);

/// The lines of a file that have text.
fn texts(file: &File) -> impl Iterator<Item = Text<'_>> {
    let is_text = file.is_rust() || file.is_markdown() || is_commented(file);
    let lines = file.text.lines().enumerate().filter(move |_| is_text);
    let texts = lines.map(move |(number, line)| (file, number, text_of(file, line).to_lowercase()));
    texts.filter(|(.., text)| !text.trim().is_empty())
}

/// Files and lines whose text has a phrase.
fn uses<'a>(lines: &'a [Text<'a>], phrase: &'a str) -> impl Iterator<Item = (&'a File, usize)> {
    let has = move |(.., text): &&Text<'_>| words(text, phrase).next().is_some();
    lines
        .iter()
        .filter(has)
        .map(|(file, line, _)| (*file, *line))
}

/// Whether this is an input file or a script, of which the comments are read.
fn is_commented(file: &File) -> bool {
    [".toml", ".py"]
        .iter()
        .any(|ending| file.path.ends_with(ending))
}

/// The text of a line that people read: of a source its comment, or its strings without their
/// placeholders; of a page all but code spans; of an input file or a script its comment.
fn text_of(file: &File, line: &str) -> String {
    let start = line.trim_start();
    if is_commented(file) {
        let comment = start.split_once('#').map_or("", |parts| parts.1);
        return comment.split('`').step_by(2).collect();
    }
    if file.is_markdown() || start.starts_with("//") {
        return start.split('`').step_by(2).collect();
    }
    let strings = line.split('"').skip(1).step_by(2);
    let outside = |text: &str| -> String {
        let pieces = text.split('{');
        let after = |piece: &str| piece.split_once('}').map_or(piece, |it| it.1).to_owned();
        pieces.map(after).collect()
    };
    strings.map(outside).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phrases_are_found_in_comments_strings_and_pages_only() {
        let source = "// It tells.\nlet told = f(\"a {told} b\");\nlet a = \"is told\";\n";
        let page = "He told `told` us.\n`told` retold\n";
        let cards = "told = 3  # as told\n";
        let files = [
            ("a/src/b.rs", source),
            ("docs/src/a.md", page),
            ("cases/a.toml", cards),
        ];
        let tree = Tree::of(&files);
        let texts: Vec<_> = tree.files.iter().flat_map(texts).collect();
        let lines = |phrase| {
            let found = uses(&texts, phrase);
            found.map(|(_, line)| line).collect::<Vec<_>>()
        };
        assert_eq!(lines("told"), [2, 0, 0]);
        assert_eq!(lines("tells"), [0]);
    }
}
