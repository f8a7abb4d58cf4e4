//! Problems and remarks of one file.

use std::path::Path;

use shared_geom::error::{Diagnostics, shortened};
use shared_geom::exchange::ExchangeProblem;
use shared_geom::exchange::problem::Problems;
use shared_geom::exchange::text::{not_a_number, number};

/// Most remarks of one kind of a file.
const SHOWN: usize = 20;

/// The problems and remarks of one file, while it is read.
#[derive(Debug)]
pub(super) struct Notes {
    /// Name of the file as shown in messages.
    pub file: String,
    /// Problems: with one of them, the file is refused.
    pub problems: Problems,
    /// Remarks: the file is read.
    pub remarks: Vec<String>,
    unshown: usize,
}

/// A wrong part of a file: its name, the value found, the value expected, and the remedy.
pub(super) type Wrong<'a> = [&'a str; 4];

impl Notes {
    /// Nothing noted, of the file at `path`.
    pub fn new(path: &Path) -> Self {
        let file = path.display().to_string();
        Self {
            problems: Problems::new(&file),
            file,
            remarks: Vec::new(),
            unshown: 0,
        }
    }

    /// Notes the problem of a line, counted from one; 0 for the whole file.
    pub fn wrong(&mut self, line: usize, [what, found, expected, help]: Wrong<'_>) {
        let problem = ExchangeProblem::Other {
            what: what.to_owned(),
            found: found.to_owned(),
            expected: expected.to_owned(),
            help: help.to_owned(),
        };
        self.problems.push(line, &problem);
    }

    /// Notes a missing part.
    pub fn missing(&mut self, line: usize, what: &str, help: &str) {
        let (what, help) = (what.to_owned(), help.to_owned());
        self.problems
            .push(line, &ExchangeProblem::Missing { what, help });
    }

    /// Notes that the file ends within `what`.
    pub fn cut(&mut self, line: usize, what: &str, expected: &str) {
        let (what, expected) = (what.to_owned(), expected.to_owned());
        self.problems
            .push(line, &ExchangeProblem::CutShort { what, expected });
    }

    /// Notes that `text` is of none of the formats with these titles.
    pub fn unknown(&mut self, text: &str, titles: &[&str]) {
        let Some(first) = text.lines().map(str::trim).find(|line| !line.is_empty()) else {
            self.missing(0, "the content", "the file is blank");
            return;
        };
        let found = format!("a file that begins with \"{}\"", shortened(first));
        let expected = format!("one of these formats: {}", titles.join(", "));
        let help = "give a file of one of these formats, complete with its first lines";
        self.wrong(0, ["format of the file", &found, &expected, help]);
    }

    /// The number that `word` writes; notes another word.
    pub fn number(&mut self, line: usize, what: &str, word: &str) -> Option<f64> {
        let value = number(word);
        if value.is_none() {
            self.problems.push(line, &not_a_number(what, word));
        }
        value
    }

    /// The count that `word` writes; notes another word.
    pub fn count(&mut self, line: usize, what: &str, word: &str) -> Option<usize> {
        let value = word.parse().ok();
        if value.is_none() {
            let help = "write the number of lines or tables that follow";
            self.wrong(line, [what, &format!("\"{word}\""), "a whole number", help]);
        }
        value
    }

    /// Adds a remark on a line, counted from one; 0 for the whole file.
    pub fn remark(&mut self, line: usize, text: &str) {
        if self.remarks.len() >= SHOWN {
            self.unshown += 1;
            return;
        }
        self.remarks.push(match line {
            0 => text.to_owned(),
            _ => format!("line {line}: {text}"),
        });
    }

    /// The value and the remarks, if there is a value and no problem.
    ///
    /// # Errors
    /// All problems, in the order of their lines.
    pub fn finish<T>(
        mut self,
        value: Option<T>,
        what: &str,
    ) -> Result<(T, Vec<String>), Diagnostics> {
        if self.unshown > 0 {
            self.remarks
                .push(format!("and {} more remarks", self.unshown));
        }
        let remarks = self.remarks;
        let result = self.problems.finish(value.map(|value| (value, remarks)));
        result.map_err(|problems| problems.explained(&self.file, what))
    }
}
