//! Diagnostics: the error of an input, its location, and the likely remedy.
//!
//! Every stage has its own typed problem (an enum deriving `thiserror::Error`);
//! [`Explain`] adds the remedy, and [`Diagnostics`] collects all problems of an input so
//! that a user sees them all at once.

use std::collections::{BTreeMap, VecDeque};
use std::fmt;

/// Number of problems of a file that are shown one by one: the others are counted, since
/// many of them follow from the first.
const SHOWN: usize = 50;

/// A typed problem that may have a remedy.
pub trait Explain: std::error::Error {
    /// The remedy in one line, shown after `help:`; `None` if none is known.
    fn help(&self) -> Option<String> {
        None
    }
}

/// A reader that returns no value and has noted no problem.
#[derive(Debug, thiserror::Error)]
#[error("{what} is refused, and no reason was noted")]
struct Unexplained {
    what: String,
}

impl Explain for Unexplained {
    fn help(&self) -> Option<String> {
        let text = "this is a fault of Helicoid, not of the file: please report it with the file";
        Some(text.to_owned())
    }
}

/// Location of a problem: a file, and a line or a byte of it if known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceLocation {
    /// File name as the user gave it.
    pub file: String,
    /// Line, counted from one.
    pub line: Option<usize>,
    /// Offset of a byte in a binary file, which has no lines.
    pub byte: Option<usize>,
}

impl SourceLocation {
    /// The whole of `file`.
    pub fn file(file: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            line: None,
            byte: None,
        }
    }

    /// Line `line` (from one) of `file`.
    pub fn line(file: impl Into<String>, line: usize) -> Self {
        Self {
            file: file.into(),
            line: Some(line),
            byte: None,
        }
    }

    /// Byte `byte` (from zero) of the binary file `file`.
    pub fn byte(file: impl Into<String>, byte: usize) -> Self {
        Self {
            file: file.into(),
            line: None,
            byte: Some(byte),
        }
    }
}

impl fmt::Display for SourceLocation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.line, self.byte) {
            (Some(line), _) => write!(f, "{}:{line}", self.file),
            (None, Some(byte)) => write!(f, "{}: byte {byte}", self.file),
            (None, None) => f.write_str(&self.file),
        }
    }
}

/// One problem at one location, ready to be shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Location.
    pub location: SourceLocation,
    /// The value found and the value expected.
    pub message: String,
    /// The remedy, if one is known.
    pub help: Option<String>,
}

impl Diagnostic {
    /// States `problem` at `location`.
    pub fn new(location: SourceLocation, problem: &impl Explain) -> Self {
        Self {
            location,
            message: problem.to_string(),
            help: problem.help(),
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.location, self.message)?;
        match &self.help {
            Some(help) => write!(f, "\n  help: {help}"),
            None => Ok(()),
        }
    }
}

/// All problems of an input, in the order in which they were found.
///
/// As an error value it is never empty: see [`Diagnostics::into_result`].
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Diagnostics {
    items: Vec<Diagnostic>,
}

impl Diagnostics {
    /// No problems.
    pub fn new() -> Self {
        Self::default()
    }

    /// The list of only `problem` at `location`.
    pub fn one(location: SourceLocation, problem: &impl Explain) -> Self {
        Self {
            items: vec![Diagnostic::new(location, problem)],
        }
    }

    /// Adds `problem` at `location`, if it is not there yet.
    pub fn push(&mut self, location: SourceLocation, problem: &impl Explain) {
        self.add(Diagnostic::new(location, problem));
    }

    /// Appends the problems of `other` that are not there yet.
    pub fn append(&mut self, other: Diagnostics) {
        other.items.into_iter().for_each(|item| self.add(item));
    }

    fn add(&mut self, item: Diagnostic) {
        if !self.items.contains(&item) {
            self.items.push(item);
        }
    }

    /// Returns the value of a good result; appends the problems of a bad one.
    pub fn keep<T>(&mut self, result: Result<T, Diagnostics>) -> Option<T> {
        match result {
            Ok(value) => Some(value),
            Err(other) => {
                self.append(other);
                None
            }
        }
    }

    /// Sorts the problems of each file by line, problems of the file as a whole first;
    /// the order of problems of one line, and the indices of each file in the list, are
    /// kept.
    pub fn sort_by_line(&mut self) {
        let files = self.items.iter().map(|item| item.location.file.clone());
        let files: Vec<_> = files.collect();
        self.items.sort_by_key(|item| item.location.line);
        let mut of_file: BTreeMap<String, VecDeque<Diagnostic>> = BTreeMap::new();
        for item in self.items.drain(..) {
            let items = of_file.entry(item.location.file.clone()).or_default();
            items.push_back(item);
        }
        let next = |file| of_file.get_mut(file).and_then(VecDeque::pop_front);
        self.items = files.iter().filter_map(next).collect();
    }

    /// The same problems, of which the ones of the file `from` are rewritten: for a text that
    /// a program wrote and no user has seen. Problems that are then equal are one.
    pub fn rewritten(self, from: &str, mut rewrite: impl FnMut(&mut Diagnostic)) -> Self {
        let mut all = Self::new();
        for mut item in self.items {
            if item.location.file == from {
                rewrite(&mut item);
            }
            all.add(item);
        }
        all
    }

    /// The same problems, of a file that `by` names: a key and its location, as text.
    pub fn named(mut self, by: &str) -> Self {
        if let Some(first) = self.items.first_mut() {
            first.message += &format!(" (named by {by})");
        }
        self
    }

    /// The same problems, for a reader that returns no value; without problems, a problem
    /// that `what` in `file` is refused without a reason, so that it is not treated as a
    /// success.
    pub fn explained(mut self, file: &str, what: &str) -> Self {
        if self.is_empty() {
            let what = what.to_owned();
            self.push(SourceLocation::file(file), &Unexplained { what });
        }
        self
    }

    /// Whether no problem was found.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The problems, in the order in which they were found.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.items.iter()
    }

    /// `Ok(value)` when no problem was found, else the problems.
    ///
    /// # Errors
    /// The collected problems, when there is at least one.
    pub fn into_result<T>(self, value: T) -> Result<T, Diagnostics> {
        if self.is_empty() {
            Ok(value)
        } else {
            Err(self)
        }
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for (i, item) in self.items.iter().enumerate() {
            let count = counts.entry(&item.location.file).or_default();
            *count += 1;
            if *count > SHOWN {
                continue;
            }
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "error: {item}")?;
        }
        for (file, count) in counts.into_iter().filter(|(_, count)| *count > SHOWN) {
            let more = count - SHOWN;
            write!(f, "\nerror: {file}: and {more} more problems")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}

/// The name of `known` nearest to `found`, if it is near enough to be a typing error: at
/// most a third of the letters differ, and not all; or one begins with the other; or it is the last
/// part of a path, as `tip` of `blade/tip`.
pub fn nearest_name<'a>(found: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = found.to_lowercase();
    known
        .into_iter()
        .map(|name| (distance(&lower, &name.to_lowercase()), name))
        .min_by_key(|(distance, _)| *distance)
        .filter(|(distance, name)| {
            let letters = name.len().max(found.len());
            *distance < letters && distance * 3 <= letters.max(3)
        })
        .map(|(_, name)| name)
}

/// A count and the name of the counted things in the singular: `1 cell`, `2 cells`,
/// `2 bodies`.
pub fn counted(count: usize, name: &str) -> String {
    match (count, name.strip_suffix('y')) {
        (1, _) => format!("1 {name}"),
        (_, Some(stem)) => format!("{count} {stem}ies"),
        (_, None) => format!("{count} {name}s"),
    }
}

/// Names in quotes, joined by commas; "none" for none.
pub fn quoted<T: fmt::Display>(names: &[T]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("\"{name}\"")).collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

/// Words joined by commas, and the last one by "and".
pub fn joined<T: AsRef<str>>(words: &[T]) -> String {
    let words: Vec<_> = words.iter().map(AsRef::as_ref).collect();
    match &words[..] {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Names joined by commas, in lines of a help.
pub fn listed(names: &[String]) -> String {
    const WIDTH: usize = 90;
    let mut text = String::new();
    let mut column = 0;
    for (index, name) in names.iter().enumerate() {
        if index > 0 && column + name.len() > WIDTH {
            text.push_str(",\n    ");
            column = 0;
        } else if index > 0 {
            text.push_str(", ");
        }
        text.push_str(name);
        column += name.len() + 2;
    }
    text
}

/// The beginning of a text, for messages.
pub fn shortened(text: &str) -> String {
    const LETTERS: usize = 40;
    match text.char_indices().nth(LETTERS) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// Edit distance of `found` to a name; a missing or added ending counts as one edit, also
/// beside one error in the letters before it.
fn distance(found: &str, name: &str) -> usize {
    let slips = strsim::damerau_levenshtein(found, name);
    let letters = found.chars().count();
    let beginning: String = name.chars().take(letters).collect();
    let is_last_part = name
        .strip_suffix(found)
        .is_some_and(|rest| rest.ends_with('/'));
    let is_beginning = found.starts_with(name) || name.starts_with(found);
    if found.len().min(name.len()) >= 2 && (is_beginning || is_last_part) {
        slips.min(1)
    } else if letters >= 4 && strsim::damerau_levenshtein(found, &beginning) == 1 {
        slips.min(2)
    } else {
        slips
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, thiserror::Error)]
    #[error("unknown key \"{0}\"")]
    struct Unknown(String);

    impl Explain for Unknown {
        fn help(&self) -> Option<String> {
            nearest_name(&self.0, ["region", "material"]).map(|n| format!("did you mean \"{n}\"?"))
        }
    }

    #[test]
    fn a_problem_is_reported_once() {
        let at = |line| SourceLocation::line("a.toml", line);
        let mut all = Diagnostics::new();
        for line in [3, 4, 3] {
            all.push(at(line), &Unknown("zzz".into()));
        }
        all.append(Diagnostics::one(at(4), &Unknown("zzz".into())));
        assert_eq!(all.items.len(), 2);
        let all = all.rewritten("a.toml", |item| item.location.line = Some(1));
        assert_eq!(all.items.len(), 1);
    }

    #[test]
    fn all_problems_are_shown_with_location_and_remedy() {
        let mut all = Diagnostics::new();
        all.push(
            SourceLocation::line("a.toml", 3),
            &Unknown("materail".into()),
        );
        all.push(SourceLocation::file("b.toml"), &Unknown("zzz".into()));
        assert_eq!(
            all.to_string(),
            "error: a.toml:3: unknown key \"materail\"\n  help: did you mean \"material\"?\n\
             error: b.toml: unknown key \"zzz\""
        );
        assert!(all.into_result(()).is_err());
    }

    #[test]
    fn a_refusal_without_a_reason_is_reported_as_a_fault_of_the_program() {
        let reported = Diagnostics::new().explained("a.htc", "the HAWC2 structural file");
        assert_eq!(
            reported.to_string(),
            "error: a.htc: the HAWC2 structural file is refused, and no reason was noted\n  help: \
             this is a fault of Helicoid, not of the file: please report it with the file"
        );
        let one = Diagnostics::one(SourceLocation::file("a"), &Unknown("b".into()));
        assert_eq!(one.clone().explained("a", "the file"), one);
    }

    #[test]
    fn many_problems_of_a_file_are_counted() {
        let mut all = Diagnostics::new();
        for line in 1..=60 {
            all.push(SourceLocation::line("a.toml", line), &Unknown("zzz".into()));
        }
        all.push(SourceLocation::line("b.toml", 7), &Unknown("zzz".into()));
        let shown = all.to_string();
        assert_eq!(shown.lines().count(), SHOWN + 2);
        for part in [
            "error: a.toml:50: ",
            "error: b.toml:7: unknown key \"zzz\"\n",
            "error: a.toml: and 10 more problems",
        ] {
            assert!(shown.contains(part), "{part}: {shown}");
        }
        assert!(!shown.contains("a.toml:51"));
        assert_eq!(all.iter().count(), 61);
    }

    #[test]
    fn problems_are_sorted_by_line_within_their_file_only() {
        let mut all = Diagnostics::new();
        for (file, line, key) in [
            ("a", Some(9), "first"),
            ("b", Some(7), "second"),
            ("a", Some(2), "third"),
            ("b", Some(1), "fourth"),
            ("a", Some(9), "fifth"),
            ("a", None, "sixth"),
        ] {
            let location = SourceLocation {
                line,
                ..SourceLocation::file(file)
            };
            all.push(location, &Unknown(key.into()));
        }
        all.sort_by_line();
        let shown: Vec<_> = all
            .iter()
            .map(|item| (item.location.to_string(), &item.message[13..]))
            .collect();
        let expected = [
            ("a", "sixth\""),
            ("b:1", "fourth\""),
            ("a:2", "third\""),
            ("b:7", "second\""),
            ("a:9", "first\""),
            ("a:9", "fifth\""),
        ];
        for ((location, message), (file, key)) in shown.iter().zip(expected) {
            assert_eq!((location.as_str(), *message), (file, key));
        }
        assert_eq!(shown.len(), expected.len());
    }

    #[test]
    fn long_texts_are_cut_between_letters() {
        assert_eq!(shortened(&"ä".repeat(40)), "ä".repeat(40));
        assert_eq!(shortened(&"ä".repeat(41)), format!("{}...", "ä".repeat(40)));
    }

    #[test]
    fn names_are_quoted() {
        assert_eq!(quoted(&["a", "b c"]), "\"a\", \"b c\"");
        assert_eq!(quoted::<String>(&[]), "none");
    }

    #[test]
    fn nearest_name_takes_slips_and_endings_but_not_strangers() {
        assert_eq!(nearest_name("inch", ["in", "ft", "m"]), Some("in"));
        assert_eq!(nearest_name("steal", ["steel", "alu"]), Some("steel"));
        assert_eq!(nearest_name("carbon", ["steel", "alu"]), None);
        assert_eq!(nearest_name("q", ["n", "m"]), None);
        assert_eq!(nearest_name("M", ["n", "m"]), Some("m"));
        // an error in the letters before an ending
        assert_eq!(nearest_name("frist", ["time", "first_x"]), Some("first_x"));
        assert_eq!(nearest_name("forts", ["time", "first_x"]), None);
        assert_eq!(nearest_name("Tip", ["b/1", "b/tip"]), Some("b/tip"));
        assert_eq!(nearest_name("ip", ["b/1", "blade/tip"]), None);
    }
}
