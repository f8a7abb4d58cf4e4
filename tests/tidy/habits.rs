//! Contents that no source may have.

use crate::source::{is_word, line_of, words};
use crate::tree::{File, Tree};

/// Macros that mark unfinished or forgotten code.
const UNFINISHED_MACROS: [&str; 3] = ["todo", "unimplemented", "dbg"];

/// Words of comments that mark unfinished code (written apart: this file is checked too).
const UNFINISHED_WORDS: [&str; 3] = [
    concat!("FIX", "ME"),
    concat!("XX", "X"),
    concat!("TO", "DO"),
];

/// First folders of absolute paths that exist on one machine only.
const MACHINE_FOLDERS: [&str; 5] = ["tmp", "work", "home", "root", "Users"];

/// Calls of `unwrap` outside tests.
pub fn unwraps(tree: &Tree) -> Vec<String> {
    let message = "unwrap outside tests: return the error, or expect with the invariant as text";
    let rust = tree.files.iter().filter(|file| file.is_rust());
    rust.flat_map(|file| {
        let calls = file
            .program_lines()
            .filter(|(_, code)| code.contains(".unwrap()"));
        calls.map(|(line, _)| file.breach(line, message))
    })
    .collect()
}

/// Imports that end in a star, except `use super::*` in tests.
pub fn globs(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for file in tree.files.iter().filter(|file| file.is_rust()) {
        for at in words(&file.code, "use") {
            let end = file.code[at..]
                .find(';')
                .map_or(file.code.len(), |n| at + n);
            let statement = &file.code[at..end];
            let line = line_of(&file.code, at);
            let excused = file.is_test[line] && statement == "use super::*";
            if statement.contains('*') && !excused {
                breaches.push(file.breach(line, "glob import: list the names"));
            }
        }
    }
    breaches
}

/// Macros and words that mark unfinished code.
pub fn unfinished(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for file in &tree.files {
        for name in UNFINISHED_MACROS {
            let calls =
                words(&file.code, name).filter(|at| file.code[at + name.len()..].starts_with('!'));
            let message = format!("\"{name}!\" is left in");
            breaches.extend(calls.map(|at| file.breach(line_of(&file.code, at), &message)));
        }
        if !file.is_rust() && !file.path.ends_with(".toml") {
            continue;
        }
        for word in UNFINISHED_WORDS {
            let message = format!("\"{word}\" is left in");
            let found = words(&file.text, word);
            breaches.extend(found.map(|at| file.breach(line_of(&file.text, at), &message)));
        }
    }
    breaches
}

/// Absolute paths of one machine, in any text file.
pub fn machine_paths(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for file in &tree.files {
        for folder in MACHINE_FOLDERS {
            let path = format!("/{folder}");
            let found = file.text.match_indices(&path).map(|(at, _)| at);
            let absolute = found.filter(|at| is_absolute(file, *at, path.len()));
            let message = format!("path of one machine: \"{path}\"");
            breaches.extend(absolute.map(|at| file.breach(line_of(&file.text, at), &message)));
        }
    }
    breaches
}

/// Whether the folder of `length` bytes at byte `at` begins a path and is whole.
fn is_absolute(file: &File, at: usize, length: usize) -> bool {
    let before = file.text[..at].chars().next_back();
    let after = file.text[at + length..].chars().next();
    let continues = |c: char| is_word(c) || ".-~}/)<".contains(c);
    let goes_on = |c: char| is_word(c) || c == '-';
    !before.is_some_and(continues) && !after.is_some_and(goes_on)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree(text: &str) -> Tree {
        Tree::of(&[("a/src/b.rs", text)])
    }

    #[test]
    fn unwrap_is_for_tests() {
        let text =
            "fn a() { b.unwrap() } // c.unwrap()\n#[cfg(test)]\nmod t { fn d() { e.unwrap() } }\n";
        assert_eq!(
            unwraps(&tree(text)),
            [tree(text).files[0].breach(
                0,
                "unwrap outside tests: return the error, or expect with the invariant as text"
            )]
        );
    }

    #[test]
    fn globs_are_reported_but_for_the_parent_in_tests() {
        assert_eq!(globs(&tree("use a::{\n    b::*,\n    c,\n};\n")).len(), 1);
        assert_eq!(globs(&tree("use super::*;\n")).len(), 1);
        assert_eq!(
            globs(&tree("#[cfg(test)]\nmod t { use super::*; }\n")).len(),
            0
        );
        assert_eq!(globs(&tree("use a::b;\nlet c = d * e;\n")).len(), 0);
    }

    #[test]
    fn unfinished_code_is_reported() {
        let text = format!(
            "fn a() {{ {}!() }} // {}\n",
            UNFINISHED_MACROS[0], UNFINISHED_WORDS[0]
        );
        assert_eq!(unfinished(&tree(&text)).len(), 2);
    }

    #[test]
    fn machine_paths_are_reported_and_relative_ones_are_not() {
        let text = |name: &str| format!("see /{name}/x, docs/{name}/y, (/{name}), /{name}shop\n");
        for folder in MACHINE_FOLDERS {
            assert_eq!(machine_paths(&tree(&text(folder))).len(), 2, "{folder}");
        }
    }
}
