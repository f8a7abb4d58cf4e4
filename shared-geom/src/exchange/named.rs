//! Lines of a value and its name, as in the files of OpenFAST and QBlade.

use std::path::{Path, PathBuf};

use super::problem::{ExchangeProblem, Problems};
use super::text::{not_a_number, number};

/// Value of a named line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Named<'a> {
    /// The value, without quotes.
    pub value: &'a str,
    /// Its line, counted from one.
    pub line: usize,
}

/// The first line whose value is followed by one of `names`, in any case.
pub(super) fn named<'a>(text: &'a str, names: &[&str]) -> Option<Named<'a>> {
    text.lines().enumerate().find_map(|(at, line)| {
        let (value, name) = split(line)?;
        let is_it = names.iter().any(|known| known.eq_ignore_ascii_case(name));
        is_it.then_some(Named {
            value,
            line: at + 1,
        })
    })
}

/// The value and the name of a line; a value in quotes may have blanks.
fn split(line: &str) -> Option<(&str, &str)> {
    let line = line.trim();
    let quote = line.chars().next().filter(|letter| "\"'".contains(*letter));
    let (value, rest) = match quote {
        Some(quote) => line.get(1..)?.split_once(quote)?,
        None => line.split_once(char::is_whitespace)?,
    };
    Some((value.trim(), rest.split_whitespace().next()?))
}

/// The number of the line with one of `names`, the first of which messages use; notes
/// missing lines and other words.
pub(super) fn required(text: &str, names: &[&str], problems: &mut Problems) -> Option<f64> {
    let name = names.first().copied().unwrap_or_default();
    let Some(found) = named(text, names) else {
        problems.push(0, &missing(name));
        return None;
    };
    let value = number(found.value);
    if value.is_none() {
        problems.push(found.line, &not_a_number(name, found.value));
    }
    value
}

/// As [`required`], `default` without such a line.
pub(super) fn optional(
    text: &str,
    names: &[&str],
    default: f64,
    problems: &mut Problems,
) -> Option<f64> {
    match named(text, names) {
        Some(_) => required(text, names, problems),
        None => Some(default),
    }
}

/// The problem that no line has the name.
pub(super) fn missing(name: &str) -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: format!("the line of \"{name}\""),
        help: format!("it has a value and after it the word {name}; is the file cut short?"),
    }
}

/// The path of the file that the line with one of `names` in `file` names; notes a missing
/// line and a missing file.
pub(super) fn companion(
    text: &str,
    names: &[&str],
    file: &Path,
    problems: &mut Problems,
) -> Option<PathBuf> {
    let name = names.first().copied().unwrap_or_default();
    let Some(found) = named(text, names) else {
        problems.push(0, &missing(name));
        return None;
    };
    let written = found.value.replace('\\', "/");
    let path = file.parent().unwrap_or(Path::new("")).join(&written);
    // A folder is no file, nor is an empty name.
    if path.is_dir() {
        problems.push(
            found.line,
            &ExchangeProblem::Other {
                what: name.to_owned(),
                found: format!("\"{}\"", found.value),
                expected: "the name of a file".to_owned(),
                help: "give the name of the file, relative to the folder of this one".to_owned(),
            },
        );
        return None;
    }
    problems
        .finds(&path, name, &written, found.line)
        .then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_may_be_quoted_and_names_are_the_word_after_them() {
        let text = "title CompElast\n \"a b.dat\"   EDFile - name\n2 CompElast - switch\n\"open\n";
        let found = named(text, &["edfile"]).unwrap();
        assert_eq!((found.value, found.line), ("a b.dat", 2));
        assert_eq!(named(text, &["other", "CompElast"]).unwrap().value, "title");
        assert_eq!(named(text, &["open"]), None);
    }
}
