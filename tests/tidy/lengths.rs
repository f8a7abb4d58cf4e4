//! Largest lengths of files and functions.

use crate::source::item_end;
use crate::tree::{File, Tree};

/// Lines of a file without its unit tests.
const FILE_LIMIT: usize = 500;

/// Lines of a file with its unit tests.
const FILE_LIMIT_WITH_TESTS: usize = 700;

/// Lines of a function, from its name to its closing brace.
const FUNCTION_LIMIT: usize = 60;

/// On the line above a function that writes a matrix out term by term.
const LONG_MATRIX: &str = "// tidy: long matrix";

/// Files that are too long.
pub fn files(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for file in tree.files.iter().filter(|file| file.is_rust()) {
        let all = file.is_test.len();
        let program = file.program_lines().count();
        if program > FILE_LIMIT {
            let message = format!("{program} lines without tests, at most {FILE_LIMIT} expected");
            breaches.push(file.breach(0, &message));
        } else if all > FILE_LIMIT_WITH_TESTS {
            let message = format!("{all} lines, at most {FILE_LIMIT_WITH_TESTS} expected");
            breaches.push(file.breach(0, &message));
        }
    }
    breaches
}

/// Functions that are too long and not marked as a long matrix.
pub fn functions(tree: &Tree) -> Vec<String> {
    let rust = tree.files.iter().filter(|file| file.is_rust());
    rust.flat_map(functions_of).collect()
}

fn functions_of(file: &File) -> Vec<String> {
    let lines: Vec<&str> = file.code.lines().collect();
    let mut breaches = Vec::new();
    for (start, line) in lines.iter().enumerate() {
        let Some(name) = declared_function(line) else {
            continue;
        };
        let end = item_end(&lines, start).unwrap_or(start);
        let length = end - start + 1;
        if length > FUNCTION_LIMIT && !is_marked(file, start) {
            let message = format!(
                "function \"{name}\" has {length} lines, at most {FUNCTION_LIMIT} expected"
            );
            breaches.push(file.breach(start, &message));
        }
    }
    breaches
}

/// The name of the function whose declaration begins on this line of blanked code.
fn declared_function(line: &str) -> Option<&str> {
    let (before, after) = line.split_once("fn ")?;
    let qualifiers = ["pub", "const", "async", "unsafe", "extern"];
    let is_qualifier = |word: &str| qualifiers.contains(&word) || word.starts_with("pub(");
    if !before.split_whitespace().all(is_qualifier) {
        return None;
    }
    after.split(['(', '<']).next()
}

/// Whether the mark of a long matrix is above line `start`, docs and attributes skipped.
fn is_marked(file: &File, start: usize) -> bool {
    let lines: Vec<&str> = file.text.lines().collect();
    let mut above = lines[..start].iter().rev().map(|line| line.trim());
    above
        .find(|line| !line.starts_with("///") && !line.starts_with("#["))
        .is_some_and(|line| line == LONG_MATRIX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long_function(above: &str) -> String {
        let body = "    let x = 1;\n".repeat(FUNCTION_LIMIT);
        format!("{above}#[inline]\npub(crate) fn long() {{\n{body}}}\n")
    }

    #[test]
    fn long_functions_are_reported_unless_marked() {
        let tree = Tree::of(&[("a.rs", &long_function("")), ("b.rs", "fn f();\n")]);
        assert_eq!(functions(&tree).len(), 1);
        let marked = long_function(&format!("{LONG_MATRIX}\n/// Doc.\n"));
        assert!(functions(&Tree::of(&[("a.rs", &marked)])).is_empty());
    }

    #[test]
    fn only_declarations_count() {
        assert_eq!(
            declared_function("    pub const fn a<T>(x: T) {"),
            Some("a")
        );
        assert_eq!(declared_function("    let f: fn (f64) = g;"), None);
    }

    #[test]
    fn tests_may_lengthen_a_file_but_not_without_end() {
        let program = "fn a() {}\n".repeat(FILE_LIMIT);
        let tests = |n: usize| format!("#[cfg(test)]\nmod t {{\n{}}}\n", "// x\n".repeat(n));
        let with = |n: usize| files(&Tree::of(&[("a.rs", &(program.clone() + &tests(n)))])).len();
        assert_eq!((with(100), with(300)), (0, 1));
        assert_eq!(
            files(&Tree::of(&[("a.rs", &(program + "fn b() {}\n"))])).len(),
            1
        );
    }
}
